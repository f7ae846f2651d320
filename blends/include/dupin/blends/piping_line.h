#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/build.h"
#include "dupin/kernel/gap.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// An end of a component, as a file has it.
struct PipingPort {
  Vec3 center = Vec3::Zero();
  std::optional<double> radius = {};  ///< outside; none: that of its neighbours
  std::size_t line = 0;               ///< of the file, from 1
};

enum class PipingShape {
  straight,  ///< from the first port to the second: a cylinder, or a cone
  bend,      ///< the same, turned on an arc that is tangent to both legs from `center`
  fitting,   ///< arms from `center` to the ports: tees, crosses, angle valves, stubs
  closure,   ///< ends a line: solid between its ports, or a plate at its only one
};

/// One component of a piping line.
struct PipingComponent {
  std::string name;  ///< of the part that it becomes; all differ, and have no '.'
  std::string kind;  ///< what the file calls it
  std::size_t line = 0;
  PipingShape shape = PipingShape::straight;
  std::vector<PipingPort> ports;
  std::optional<Vec3> center = {};
  std::optional<double> bend_radius = {};
  std::optional<double> wall = {};  ///< none: the line's, or that of its neighbours
  /// A straight component's ends may lie off each other's axes: between parallel circles.
  bool is_eccentric = false;
};

/// A piping line as it was read: components that say nothing of each other. Lengths are
/// millimetres.
struct PipingLine {
  std::string source;  ///< the file's name, for messages; may be empty
  std::vector<PipingComponent> components;
  std::vector<SourceNote> notes = {};  ///< of what was left out when it was read
};

struct PipingOptions {
  double snap = 0.05;               ///< ends up to this far apart are the same point
  double bridge = 0;                ///< ends up to this far apart are joined by a part of their own
  double tolerance = 0.05;          ///< the assembly's
  std::optional<double> wall = {};  ///< of all components that say none
  WallSide wall_side = WallSide::inwards;
  std::optional<double> insulation = {};
  /// Of the ball of fillets between runs and branches; 0: chosen for each; none: no fillets.
  std::optional<double> fillet = {};
  /// Else nothing is made between ends that have a kink or a gap, for who wants the notes alone: it
  /// takes most of the time, and says nothing of components but of bends that it replaces, which
  /// are looked at in any case.
  bool blends_kinks = true;
  bool keep_going = false;  ///< components that are refused are left out, and noted
  std::map<std::string, std::string> refused = {};  ///< components by name, with the reason
  Progress progress = {};                           ///< may be empty
};

/// What was made of two ends that belong together.
enum class JointState {
  met,      ///< they share a ring
  stepped,  ///< a cone between their radii was made in the thicker pipe
  blended,  ///< their directions differ: a blend was made between them
  bridged,  ///< they lie further apart than `snap`: a part of its own was made between them
  apart,    ///< nothing was made: both end here
};

[[nodiscard]] std::string_view name(JointState state);

/// Two ends that belong together, with what the file says of them.
struct PipingJoint {
  std::array<std::string, 2> components;
  std::array<std::size_t, 2> lines{};
  double distance = 0;  ///< between the points
  double step = 0;      ///< between the radii
  double kink = 0;      ///< between the directions, in radians; 0 if one has none of its own
  JointState state = JointState::apart;
  std::string part;  ///< that was made between them; empty if there is none
};

/// The assembly of a piping line, and what became of the line on the way.
struct PipingNetwork {
  Assembly assembly;
  std::vector<std::string> origins;  ///< of each part, the component's name
  std::vector<PipingJoint> joints;   ///< in the order of the file
  std::vector<SourceNote> notes;     ///< by line
  std::size_t components = 0;        ///< that became parts
  std::size_t open_ends = 0;         ///< ports that nothing belongs to, and that end in no run
  /// How far a point of the file lies from where its part's ring is, at most.
  double largest_move = 0;
};

/// Makes a solid's parts of the components and joins them: ends within `snap` share a ring on a
/// common axis, from corner to corner; the steps, kinks and gaps that are left get parts of their
/// own, or are said. docs/pcf.md has the rules.
///
/// Throws Error{invalid_argument} with "file:line" for a component that cannot be one (no radius, a
/// bend sharper than its pipe), unless told to keep going, for a line of which no component is
/// left, and for options that are negative or not finite. O(n log n) unless many ends crowd in one
/// place.
[[nodiscard]] PipingNetwork assembly_of(const PipingLine& line, const PipingOptions& options = {});

/// Builds `network`, which assembly_of has made of the line with these options. Told to keep going,
/// leaves out the component of a part that `build` refuses, makes the network anew and builds
/// again, fifty times at most. Throws as `build`.
[[nodiscard]] Built build(const PipingLine& line, const PipingOptions& options,
                          PipingNetwork& network, const BuildOptions& build_options = {});

/// The components' ends as the file has them, to be paired and measured, with the radius of what
/// they are joined to where they have none; those without a direction or any radius are left out.
[[nodiscard]] std::vector<Port> ports(const PipingLine& line);

}  // namespace dupin
