#pragma once

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "dupin/blends/blend_parts.h"
#include "dupin/blends/part_key.h"
#include "dupin/blends/spline_pipe.h"
#include "dupin/kernel/vec.h"

namespace dupin {

/// What makes a section an ellipse: its radius is the semi-axis along `axis` (whose part across the
/// direction of travel counts), `across` the other one.
struct SectionAxes {
  Vec3 axis = Vec3::UnitX();
  double across = 1;
};

/// The circle or ellipse a part begins with, where it does not begin at another part's port.
struct Place {
  Vec3 point = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();  ///< of travel, of any length but zero
  double radius = 1;
  std::optional<SectionAxes> axes = {};
};

/// Where a part begins. A port is shared bitwise with the part that owns it.
using PartStart = std::variant<PortReference, Place>;

/// A cylinder about the segment from -> to.
struct PipeBetween {
  Vec3 from, to;
  double radius = 1;
  std::optional<SectionAxes> axes = {};
};

/// A cylinder of a given length.
struct PipeAlong {
  PartStart from;
  double length = 1;
};

/// A cylinder that goes on from a port until level with `to`, which must lie on its axis within the
/// assembly's tolerance.
struct PipeTo {
  PortReference from;
  Vec3 to;
};

/// A cylinder that begins on the axis of a straight part, `at` along it from its start.
struct PipeOn {
  std::string run;
  double at = 0;
  Vec3 direction = Vec3::UnitZ();  ///< of any length but zero
  double length = 1, radius = 1;
};

/// A frustum about the segment from -> to.
struct ConeBetween {
  Vec3 from, to;
  double start_radius = 1, end_radius = 1;
  std::optional<SectionAxes> start_axes = {};
  std::optional<double> end_across = {};  ///< none: a circle
};

/// A frustum of a given length. The axes of its ends agree; an elliptic end of one that begins at a
/// circular port needs an axis.
struct ConeAlong {
  PartStart from;
  double length = 1, end_radius = 1;
  std::optional<double> end_across = {};  ///< none: a circle
  std::optional<Vec3> axis = {};
};

/// Circles in planes orthogonal to `normal` from centre to centre: an oblique cylinder or cone.
struct ObliqueBetween {
  Vec3 from, to, normal;
  double start_radius = 1, end_radius = 1;
};

/// Circles parallel to that of the port, from its centre to `to`.
struct ObliqueTo {
  PortReference from;
  Vec3 to;
  double end_radius = 1;
};

/// A pipe from port to port through points; see spline_pipe.h. One that avoids something goes
/// through as many points more as that takes.
struct SplineBetween {
  PortReference from, to;
  std::vector<Waypoint> through;
  std::optional<Avoidance> avoid = {};
};

/// A closed pipe through points.
struct SplineRound {
  std::vector<Waypoint> through;
};

/// A torus segment that turns by `angle` radians towards `toward` (its part across the direction of
/// travel counts).
struct ElbowTurning {
  PartStart from;
  double bend_radius = 2, angle = 1;
  Vec3 toward = Vec3::UnitX();
};

/// The torus segment that leaves tangentially and ends with its centre at `to`.
struct ElbowTo {
  PartStart from;
  Vec3 to;
};

/// The torus segment that rounds the corner where its straight neighbours' axes meet, towards `to`.
/// The legs to and from the corner have to be equally long within the assembly's tolerance, and the
/// corner on the axis of the port or place.
struct ElbowCorner {
  PartStart from;
  Vec3 corner, to;
};

struct SphereAt {
  Vec3 center = Vec3::Zero();
  double radius = 1;
};

/// Half an ellipsoid of revolution that closes a pipe.
struct EllipsoidalHead {
  PartStart from;
  std::optional<double> depth = {};  ///< none: half the radius, the standard 2:1
};

/// Of a torispherical head: the radii of DIN 28011 (the crown's is the outside diameter, the
/// knuckle's a tenth of it), of DIN 28013 (0.8 and 0.154), or those given.
enum class HeadForm { kloepper, korbbogen, free };

/// A spherical crown and a knuckle, part of a torus, tangent to it and to the pipe.
struct TorisphericalHead {
  PartStart from;
  HeadForm form = HeadForm::kloepper;
  double crown = 0, knuckle = 0;  ///< radii of a free one
};

/// Closes and names a flat end. Ends that nothing is joined to are closed too, but nameless.
struct CapAt {
  PortReference at;
};

/// The one table of a document's keys, in the order in which messages list them. What a key means
/// is in the file of its name in blends/src/assembly/parts, how it is read in io/src/json/parts
/// (docs/extending.md).
using PartKeys = PartKeyTable<PartKey<"pipe", PipeBetween, PipeAlong, PipeTo, PipeOn>,  //
                              PartKey<"cone", ConeBetween, ConeAlong>,                  //
                              PartKey<"oblique", ObliqueBetween, ObliqueTo>,            //
                              PartKey<"elbow", ElbowTurning, ElbowTo, ElbowCorner>,     //
                              PartKey<"sphere", SphereAt>,                              //
                              PartKey<"spline", SplineBetween, SplineRound>,            //
                              PartKey<"cyclic_blend", CyclicBlendBetween>,              //
                              PartKey<"two_cone_blend", TwoConeBlendBetween>,           //
                              PartKey<"ringed_blend", RingedBlendBetween>,              //
                              PartKey<"cyclide_blend", CyclideBlendBetween>,            //
                              PartKey<"cyclide_chain", CyclideChainThrough>,            //
                              PartKey<"fillet", FilletBetween>,                         //
                              PartKey<"cope", CopeOfEnd>,                               //
                              PartKey<"junction", JunctionOfPorts>,                     //
                              PartKey<"flange", FlangeAt, FlangeOfEnd, FlangeOn>,       //
                              PartKey<"head", EllipsoidalHead, TorisphericalHead>,      //
                              PartKey<"cap", CapAt>>;

/// A variant of all their shapes.
using PartShape = PartKeys::Shape;

/// "pipe", "cone", "elbow", ...: its key in a document.
[[nodiscard]] std::string_view kind(const PartShape& shape);

}  // namespace dupin
