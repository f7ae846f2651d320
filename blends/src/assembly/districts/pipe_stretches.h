#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/districts.h"

namespace dupin::assembly {

/// Places on the axes of pipes, along the axis of coordinates that `cuttable` says, in the order in
/// which the pipe runs through them; by the pipe's place in ResolvedAssembly::parts.
using PipeCuts = std::map<std::uint32_t, std::vector<double>>;

/// How it can be cut, if it is a straight pipe of one circular section.
[[nodiscard]] std::optional<Cuttable> cuttable(const ResolvedPart& part);

/// Places of such pipes, ascending, by part; none of others.
[[nodiscard]] PipeCuts pipe_cuts(const ResolvedAssembly& resolved,
                                 std::span<const std::uint32_t> parts,
                                 std::vector<std::vector<double>> places);

/// An assembly some pipes of which are in stretches, welded at rings like parts of a run.
struct PipeStretches {
  /// A pipe's first stretch is where it was itself, others are behind all parts. They are called
  /// like the pipe; so is a fillet's pipe the stretch that it is on. Between stretches, ends have
  /// names that nothing else has.
  ResolvedAssembly resolved;
  std::map<std::uint32_t, std::vector<std::uint32_t>> of_pipe;  ///< from the pipe's start
};

/// No cut is where a fillet of the pipe is. O(parts).
[[nodiscard]] PipeStretches in_stretches(ResolvedAssembly whole, const PipeCuts& cuts);

/// What names of cuts of this part begin with, and no others do.
[[nodiscard]] std::string cut_prefix(const ResolvedPart& part);

/// Whether the end is one between stretches.
[[nodiscard]] bool is_cut(const ResolvedPart& part, End end);

}  // namespace dupin::assembly
