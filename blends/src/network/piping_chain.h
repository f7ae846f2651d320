#pragma once

#include <array>
#include <optional>
#include <vector>

#include "network/piping_spans.h"

namespace dupin::network {

/// A span in the direction of travel.
struct ChainElement {
  std::size_t span = 0;
  bool is_reversed = false;
};

/// What lies between two legs, or at an end of a chain.
enum class SeamKind {
  end,     ///< nothing
  corner,  ///< a bend that is tangent to both
  kink,    ///< their directions differ: a blend, if one fits
  bridge,  ///< their ends lie apart: the same
  bend,    ///< a bend that is not tangent to both: a blend instead
  offset,  ///< nothing: an eccentric part, which is a leg of its own, begins or ends
};

/// Whether a blend, if one fits, lies between the legs.
[[nodiscard]] bool is_blended(SeamKind kind);

struct Seam {
  SeamKind kind = SeamKind::end;
  /// In PipingSpans::pairs: that of a kink or bridge, or those at the ends of a bend.
  std::array<std::optional<std::size_t>, 2> joints = {};
  std::optional<std::size_t> component = {};  ///< of a bend that a blend replaces
};

/// Spans on one axis, which pass over into each other.
struct Leg {
  std::vector<ChainElement> elements;
  Vec3 origin, direction;
  std::vector<double> nodes;  ///< along the axis: where elements begin, and where the last one ends
  bool is_offset = false;     ///< an eccentric part
  std::array<Vec3, 2> circles = {};  ///< its ends' centres, where it is one
};

/// Legs in the order of travel, and the seams before, between and behind them.
struct Chain {
  std::vector<Leg> legs;
  std::vector<Seam> seams;
  bool is_closed = false;  ///< ends where it begins
};

[[nodiscard]] Vec3 point_at(const Leg& leg, double level);

/// The element's end in, or against, the direction of travel.
[[nodiscard]] const SpanEnd& begin_of(const PipingSpans& spans, const ChainElement& element);
[[nodiscard]] const SpanEnd& end_of(const PipingSpans& spans, const ChainElement& element);

/// All spans, each in one chain. Stubs are added to `spans` where a blend takes the place of a bend
/// that has no straight neighbour. An axis leads from the first point of its leg to the last one,
/// or beside an eccentric part in the direction of what is longest there. It takes no end on it
/// further than `snap`.
[[nodiscard]] std::vector<Chain> chains_of(PipingSpans& spans, double snap);

}  // namespace dupin::network
