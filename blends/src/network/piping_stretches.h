#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "dupin/blends/part_shape.h"
#include "network/piping_chain.h"

namespace dupin::network {

/// A cylinder or cone on a leg's axis.
struct Stretch {
  std::string name;
  std::size_t component = 0;
  std::array<double, 2> levels{}, radii{};
  bool is_solid = false;
  std::optional<std::size_t> span = {};  ///< that it is; none: a step, or a piece of a bend
  /// The joint that it begins at; none: an end, a bend, or inside of its component.
  std::optional<std::size_t> joint_before = {};
  bool is_behind_gap = false;  ///< a gap along the axis lies between it and the one before
  [[nodiscard]] double length() const { return levels[1] - levels[0]; }
};

/// The arc at a corner between two legs.
struct Arc {
  std::size_t component = 0;
  double tangent = 0;  ///< from the corner to its ends
  double radius = 0;   ///< of the pipe
  bool is_left_out = false;
};

/// What becomes of a chain, leg by leg.
struct ChainPlan {
  std::vector<std::vector<Stretch>> stretches;  ///< of each leg
  std::vector<std::optional<Arc>> arcs;         ///< at each seam
  /// Of each leg's elements, the levels where they begin and end, before any is set back for what
  /// lies between it and the next; none: nothing is made of it.
  std::vector<std::vector<std::optional<std::array<double, 2>>>> places;
};

/// The stretch as a part that begins nowhere but at its own place.
[[nodiscard]] PartShape shape_of(const Leg& leg, const Stretch& stretch);

/// Cuts legs into stretches, without those shorter than `snap`: bends take a tangent as long as
/// their legs, or as their bend radius says where that leaves straight pieces. Cones are put where
/// radii differ. What was stepped is marked in `states`, by joints.
[[nodiscard]] ChainPlan plan(const PipingLine& line, const PipingOptions& options,
                             const PipingSpans& spans, const Chain& chain,
                             std::vector<PipingJoint>& joints, LineNotes& notes);

}  // namespace dupin::network
