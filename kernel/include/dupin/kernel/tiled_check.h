#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "dupin/kernel/check.h"

namespace dupin {

/// A triangle of a file without indices: the finite coordinates of its corners, none of them -0.
using Facet = std::array<float, 9>;

/// Facets that are too many to be held, such as those of a file.
class FacetSource {
 public:
  FacetSource() = default;
  virtual ~FacetSource() = default;
  FacetSource(const FacetSource&) = delete;
  FacetSource& operator=(const FacetSource&) = delete;

  [[nodiscard]] virtual std::uint32_t count() const = 0;
  /// Calls visit(facets) for all in their order, some at a time; the same ones every time.
  virtual void visit(const std::function<void(std::span<const Facet>)>& visit) const = 0;
};

/// Where bytes are put that are not to be in memory.
class Scratch {
 public:
  Scratch() = default;
  virtual ~Scratch() = default;
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  virtual void write(std::uint64_t at, std::span<const char> bytes) = 0;
  /// Of bytes that have been written.
  virtual void read(std::uint64_t at, std::span<char> bytes) const = 0;
};

struct TiledCheckOptions {
  std::size_t tiles = 1;  ///< at most; there are no more than there are places to divide
  /// If not 0, there are as many tiles as that many bytes take, besides what the program is.
  std::uint64_t memory = 0;
  std::size_t limit = 100;  ///< findings kept per defect
};

/// What check() reports of the facets' mesh, corners at the same place being one point and points
/// in the order in which they appear: the same to the last bit, whatever the number of tiles.
///
/// Space is divided into tiles of about as many facets each. One after the other is looked at with
/// all facets that reach into it, so that memory is bounded by the largest, kTileBytes for each of
/// its facets. For each facet of the whole it takes 0.4 bytes more, for each in several tiles 32,
/// and for each shell what it reports of it and 300 at most; of shells that are inside out, it
/// lists the faces. Facets are put aside with 48 bytes for each tile that they reach into. O(n log
/// n).
///
/// Throws Error{limit_exceeded} where the memory does not do, or a tile has more facets than can be
/// numbered, and what the source and the scratch throw.
[[nodiscard]] Report check_in_tiles(const FacetSource& source, Scratch& scratch,
                                    const TiledCheckOptions& options);

/// See check_in_tiles(); measured (docs/cli.md).
inline constexpr double kTileBytes = 400;

}  // namespace dupin
