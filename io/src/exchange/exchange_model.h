#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/nurbs.h"
#include "dupin/kernel/vec.h"

// What the exchange formats' library is told of an assembly, and what it says of the file: plain
// values, so that it can be a module that is loaded only where it is needed. Lengths in
// millimetres.

namespace dupin::exchange {

/// center + cos u first axis + sin u second (normal x axis).
struct RingCurve {
  Vec3 center, normal, axis;  ///< both unit
  double first = 1, second = 1;
};

/// Whether they are right circular is known from the rings.
struct CylinderOrCone {};
/// An elbow, turning right-handed about the axis.
struct TorusArc {
  Vec3 center, axis;
  double angle = 0;
};
/// An annulus, flat or conical, from the ring outside to that inside.
struct Rim {
  Vec3 outward;
};

/// A surface from ring to ring.
struct TubeFace {
  std::uint32_t label = 0;
  std::size_t start = 0, end = 0;  ///< in Body::rings
  std::variant<CylinderOrCone, TorusArc, Rim, NurbsSurface> surface;
  bool is_inside_out = false;  ///< the inner skin of a wall
};

/// What closes an end.
struct DiscFace {
  std::uint32_t label = 0;
  std::size_t ring = 0;
  Vec3 outward;
};

/// A sphere less a cap for each of these rings, whose normals point away from its centre.
struct HubFace {
  std::uint32_t label = 0;
  Vec3 center;
  double radius = 1;
  std::vector<std::size_t> rings;  ///< none: a whole ball
};

/// A ball less what is beyond the planes of two circles on it, where their normals point.
struct BallSector {
  std::uint32_t label = 0;
  Vec3 center;
  double radius = 1;
  std::array<RingCurve, 2> cuts;
  Vec3 pole, seam;  ///< of the sphere's parameters, unit and across each other
};

/// The union of closed surfaces, each of what hangs together by rings, and of sectors of balls.
struct Body {
  std::string name;
  std::vector<RingCurve> rings;
  std::vector<TubeFace> tubes;
  std::vector<DiscFace> discs;
  std::vector<HubFace> hubs;
  std::vector<BallSector> sectors;
};

/// A fillet: what a ball that rolls along the edges in which the faces of two labels meet goes
/// round.
struct RollingBall {
  std::string name;
  std::uint32_t label = 0;
  std::array<std::uint32_t, 2> between{};
  std::optional<double> radius;  ///< none: it changes on the way
  /// Around from the faces of the first label to those of the second.
  std::vector<NurbsSurface> surfaces = {};
  double error = 0;  ///< how far they may be from what they stand for
};

/// The union of some bodies.
struct BodyUnion {
  std::vector<Body> bodies;
  std::vector<RollingBall> fillets;
};

struct Label {
  std::string name;
  std::array<std::uint8_t, 3> colour{};  ///< sRGB
};

enum class Operation : std::uint8_t { none, subtract, intersect };

struct Model {
  std::string name;
  std::vector<Label> labels;
  BodyUnion whole;
  /// What is taken away from the whole, or what it is intersected with: `tools` less `kept`.
  Operation operation = Operation::none;
  BodyUnion tools, kept;
  bool is_united = true;  ///< else every body is a solid of its own
};

/// A solid of the file.
struct WrittenSolid {
  std::string name;
  double volume = 0, area = 0;
  std::size_t faces = 0, shells = 0;
  std::int64_t euler_number = 0;  ///< of all its shells
};

/// What was written, as it was read back.
struct Written {
  std::string bytes;
  std::vector<WrittenSolid> solids;
  std::map<std::string, std::size_t> faces;  ///< how many are of a name
  double tolerance = 0;                      ///< the largest of an edge or vertex
  std::string fault;                         ///< why nothing was written; empty otherwise
  std::string at;                            ///< the body or fillet at fault
};

/// A surface with a name, in millimetres.
struct NamedSurface {
  std::string name;
  NurbsSurface surface;
};

/// What the module exports, under the name `kEntryPoint`.
struct Module {
  Written (*write_solids)(const Model&);
  Written (*write_surfaces)(const std::string& name, const std::vector<NamedSurface>&, bool iges);
  Written (*read_solids)(const std::string& step);
};

constexpr const char* kModuleFile = "libdupin_occt.so";
/// Says which version of these structs the module was compiled with.
constexpr const char* kEntryPoint = "dupin_occt_module_3";

}  // namespace dupin::exchange
