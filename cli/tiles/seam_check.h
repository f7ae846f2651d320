#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "dupin/kernel/check.h"
#include "dupin/kernel/districts.h"

namespace dupin::cli {

/// Tests seams as pieces come, in any order, and keeps of these no more than it takes.
class SeamCheck {
 public:
  explicit SeamCheck(std::span<const Seam> seams);

  /// Those of the piece, in order; their `pieces` are those of all.
  [[nodiscard]] std::vector<Seam> of(std::size_t piece) const;
  /// What a piece has at each of them; its shells follow those of the pieces before.
  void add(std::size_t piece, std::vector<SeamSide> sides, std::size_t shells_before);
  /// Once all are there: the names of those at which the two pieces do not make one solid, or one
  /// of which it is not known how its shells lie in each other.
  [[nodiscard]] const std::set<std::string>& misfits();
  /// The report of all pieces becomes that of what they are together.
  void join(Report& report) const { join_shells(joined_, report); }

 private:
  struct Waiting {
    SeamSide side;
    std::size_t shells_before = 0;
  };

  std::vector<Seam> seams_;
  std::vector<std::vector<std::uint32_t>> of_piece_;
  std::map<std::uint32_t, Waiting> waiting_;  // by seam
  std::vector<SeamShells> joined_;
  std::vector<std::uint32_t> seam_of_joined_;
  std::set<std::string> misfits_;
};

}  // namespace dupin::cli
