#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "network/line_notes.h"
#include "network/port_pairs.h"

namespace dupin::network {

enum class SpanRole {
  straight,  ///< becomes a cylinder or cone
  bend_leg,  ///< from an end of a bend to its corner
};

/// Where a span ends.
struct SpanEnd {
  Vec3 point = Vec3::Zero();
  std::optional<std::size_t> port = {};   ///< in PipingSpans::ports; none: inside of a fitting
  std::optional<std::size_t> joint = {};  ///< in PipingSpans::pairs
  bool is_in_run = false;                 ///< in that of another component, to be reached
  bool is_hidden = false;                 ///< inside of another part, and no end of the line
};

/// A straight stretch of a component: itself, an arm of it, or a leg of a bend.
struct Span {
  std::string name;
  std::size_t component = 0;
  SpanRole role = SpanRole::straight;
  std::array<SpanEnd, 2> ends;  ///< a bend's legs end at its corner
  std::array<double, 2> radii{};
  bool is_solid = false, is_eccentric = false;
  std::optional<std::size_t> other_leg = {};  ///< of the bend

  [[nodiscard]] double length() const { return (ends[1].point - ends[0].point).norm(); }
};

/// What the arms of a fitting run into where they do not lie on one line.
struct FittingBall {
  std::string name;
  std::size_t component = 0;
  Vec3 center;
  double radius = 0;
};

/// A straight run of a fitting and what branches off it, or crosses it.
struct FittingBranch {
  std::size_t run = 0, branch = 0;  ///< in PipingSpans::spans
};

/// A line taken apart, and how its stretches belong together.
struct PipingSpans {
  std::vector<LinePort> ports;
  std::vector<PortPair> pairs;
  std::vector<Span> spans;
  std::vector<FittingBall> balls;
  std::vector<FittingBranch> branches;
  /// For each port, the span and its end that it is; none: of a plate, or of what was left out.
  std::vector<std::optional<std::array<std::size_t, 2>>> span_of_port;

  /// The span, and its end, that an end is joined to.
  [[nodiscard]] std::optional<std::array<std::size_t, 2>> joined(const SpanEnd& end) const;
};

/// Throws as assembly_of(PipingLine).
[[nodiscard]] PipingSpans spans_of(const PipingLine& line, const PipingOptions& options,
                                   LineNotes& notes);

}  // namespace dupin::network
