#include <cmath>
#include <filesystem>
#include <numbers>

#include <gmock/gmock.h>

#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "support/single_piece.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

Assembly example(const std::string& name) {
  return read_assembly(test::source_folder() / "examples" / name);
}

Assembly document(const std::string& parts) {
  return parse_assembly(R"({"units": "mm", "tolerance": 0.02, "parts": [)" + parts + "]}", "doc");
}

struct Volume {
  double operator()(const RingedSurface& surface) const { return volume(surface); }
  double operator()(const EllipticTube& tube) const { return volume(tube); }
  double operator()(const RationalRingedTube& tube) const { return volume(tube.surface); }
  double operator()(const Chain& chain) const {
    double sum = 0;
    for (const Piece& piece : chain.pieces) {
      sum += std::visit(*this, piece);
    }
    return sum;
  }
  template <class Other>
  double operator()(const Other&) const {
    ADD_FAILURE() << "no part of these examples";
    return 0;
  }
};

TEST(RingedParts, build_to_solids_of_their_volumes) {
  for (const std::string name : {"oval-duct.json", "way-points.json", "pipe-ring.json",
                                 "oblique-nozzle.json", "two-cones.json"}) {
    const Assembly assembly = example(name);
    double smooth = 0;
    for (const ResolvedPart& part : resolve(assembly).parts) {
      smooth += std::visit(Volume(), part.shape);
    }
    const Built built = build(assembly);
    const Report report = check(to_mesh(built.solid).mesh());
    EXPECT_TRUE(report.is_solid()) << name;
    // A mesh within e of a surface of area A encloses a volume within about e A.
    EXPECT_NEAR(report.volume, smooth, 1.1 * assembly.tolerance * report.area) << name;
    EXPECT_EQ(report.euler_number, name == "pipe-ring.json" ? 0 : name == "two-cones.json" ? 4 : 2);
    for (const PartReport& part : built.parts) {
      EXPECT_LE(part.error_bound, assembly.tolerance) << name << " " << part.name;
      EXPECT_GT(part.margin_lower.value(), 0) << name << " " << part.name;
    }
  }
}

TEST(RingedParts, go_on_tangentially) {
  for (const std::string name : {"oval-duct.json", "two-cones.json", "way-points.json"}) {
    for (const PartReport& part : build(example(name)).parts) {
      EXPECT_LT(part.start_tangency.value_or(0), 1e-14) << name << " " << part.name;
      EXPECT_LT(part.end_tangency.value_or(0), 1e-14) << name << " " << part.name;
    }
  }
}

TEST(RingedParts, keep_the_ellipse_of_a_port_round_a_bend) {
  const auto parts = resolve(document(R"(
      {"name": "a", "pipe": {"from": [0, 0, 0], "to": [2, 0, 0], "semi_axes": [0.5, 1], "axis": [7, 3, 4]}},
      {"name": "b", "elbow": {"from": "a.end", "bend_radius": 3, "angle": 90, "toward": [0, 1, 0]}},
      {"name": "c", "pipe": {"from": "b.end", "length": 2}})"))
                         .parts;
  const Ring* bent = port_ring(parts[1].shape, End::end);
  EXPECT_LT((bent->ellipse->axis - Vec3(-.6, 0, .8)).norm(), 1e-15);
  EXPECT_EQ(bent->radius, .5);
  EXPECT_EQ(across(*bent), 1);
  EXPECT_EQ(flipped(*bent), *port_ring(parts[2].shape, End::start));
}

TEST(RingedParts, elliptic_cones_hold_their_volume) {
  // Between similar ellipses the volume of a frustum, pi/3 h (A + sqrt(A B) + B).
  const auto parts = resolve(document(R"(
      {"name": "a", "cone": {"from": [0, 0, 0], "to": [0, 0, 3], "semi_axes": [[2, 1], [4, 2]], "axis": [1, 0, 0]}},
      {"name": "b", "cone": {"from": "a.end", "length": 1, "end_semi_axes": [1, 1]}})"))
                         .parts;
  const auto& cone = test::single_piece<EllipticTube>(parts[0].shape);
  EXPECT_NEAR(volume(cone), kPi / 3 * 3 * (2 + 4 + 8), 1e-12);
  EXPECT_NEAR(cone.end.slope, 2. / 3, 1e-15);
  EXPECT_NEAR(across_slope(cone.end), 1. / 3, 1e-15);
}

struct Refusal {
  const char* name;
  const char* parts;
  Errc code;
  const char* where;
  const char* message;
};

TEST(RingedParts, refuse_bad_input_with_its_place_and_a_way_out) {
  const std::string pipes = R"(
      {"name": "a", "pipe": {"from": [-3, 0, 0], "to": [0, 0, 0], "radius": 1}},
      {"name": "b", "pipe": {"from": [9, 0, 0], "to": [12, 0, 0], "radius": 1}},
      {"name": "back", "pipe": {"from": [0, 6, 0], "to": [-3, 6, 0], "radius": 1}},
      {"name": "flat", "pipe": {"from": [0, 9, 0], "to": [3, 9, 0], "semi_axes": [2, 1], "axis": [0, 0, 1]}},
      {"name": "slanted", "oblique": {"from": [0, 20, 0], "to": [1, 20, 4], "normal": [0, 0, 1], "radii": [1, 1]}},
      {"name": "steep", "cone": {"from": [9, 0, 9], "to": [10, 0, 9], "radii": [9, 1]}},
      )";
  const Refusal rows[] = {
      {"ellipse collapsed",
       R"({"name": "x", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [1, 0], "axis": [0, 0, 1]}})",
       Errc::invalid_argument, "doc#/parts/6/pipe/semi_axes/1", "positive"},
      {"axis along the pipe",
       R"({"name": "x", "pipe": {"from": [0, 0, 0], "to": [1, 0, 0], "semi_axes": [2, 1], "axis": [3, 0, 0]}})",
       Errc::invalid_argument, "doc#/parts/6/pipe/axis", "across"},
      {"elliptic pipe of no length",
       R"({"name": "x", "pipe": {"from": [1, 0, 0], "to": [1, 0, 0], "semi_axes": [2, 1], "axis": [0, 0, 1]}})",
       Errc::invalid_argument, "doc#/parts/6/pipe/to", "1e-12 or more away"},
      {"elliptic end of a circle without an axis",
       R"({"name": "x", "cone": {"from": "a.end", "length": 1, "end_semi_axes": [2, 1]}})",
       Errc::invalid_argument, "doc#/parts/6/cone/end_semi_axes", "axis"},
      {"second axis",
       R"({"name": "x", "cone": {"from": "flat.end", "length": 1, "end_semi_axes": [2, 1], "axis": [0, 0, 1]}})",
       Errc::invalid_argument, "doc#/parts/6/cone/axis", "keeps"},
      {"oblique part against its normal",
       R"({"name": "x", "oblique": {"from": [0, 0, 0], "to": [0, 0, 1], "normal": [0, 0, -1], "radii": [1, 1]}})",
       Errc::invalid_argument, "doc#/parts/6", "90 degrees"},
      {"cyclic blend from an oblique port",
       R"({"name": "x", "cyclic_blend": {"from": "slanted.end", "to": "b.start", "radius_law": "R1", "k": "auto", "l": "auto"}})",
       Errc::invalid_argument, "doc#/parts/6/cyclic_blend/from", "ringed_blend"},
      {"ringed blend of an ellipse",
       R"({"name": "x", "ringed_blend": {"from": "flat.end", "to": "b.start"}})",
       Errc::invalid_argument, "doc#/parts/6/ringed_blend/from", "circles"},
      {"opposite normals",
       R"({"name": "x", "ringed_blend": {"from": "a.end", "to": "back.start"}})",
       Errc::infeasible_blend, "doc#/parts/6", "opposite"},
      {"low degree from a plate",
       R"({"name": "x", "ringed_blend": {"from": {"center": [0, 0, 0], "direction": [0, 0, 1], "radius": 2, "plate": "narrowing"}, "to": "b.start", "bidegree": [5, 2]}})",
       Errc::invalid_argument, "doc#/parts/6/ringed_blend/bidegree", "[9, 2]"},
      {"ring off its sphere's axis",
       R"({"name": "x", "ringed_blend": {"from": {"center": [0, 0, 0], "direction": [0, 0, 1], "radius": 2, "sphere": [1, 0, 0]}, "to": "b.start"}})",
       Errc::invalid_argument, "doc#/parts/6", "sphere"},
      {"cone steeper than the law allows",
       R"({"name": "x", "cyclic_blend": {"from": "steep.end", "to": "b.start", "radius_law": "R1", "k": 1, "l": 9}})",
       Errc::irregular_surface, "doc#/parts/6", "cones"},
      {"points that coincide",
       R"({"name": "x", "spline": {"from": "a.end", "to": "b.start", "through": [{"point": [4, 1, 0], "radius": 1}, {"point": [4, 1, 0], "radius": 1}]}})",
       Errc::invalid_argument, "doc#/parts/6", "coincide"},
      {"way-point without a radius",
       R"({"name": "x", "spline": {"from": "a.end", "to": "b.start", "through": [{"point": [4, 1, 0], "radius": 0}]}})",
       Errc::invalid_argument, "doc#/parts/6/spline/through/0/radius", "positive"},
      {"spline from a cone",
       R"({"name": "x", "spline": {"from": "steep.end", "to": "b.start", "through": []}})",
       Errc::invalid_argument, "doc#/parts/6", "cylinders"},
      {"spline bent too sharply",
       R"({"name": "x", "spline": {"from": "a.end", "to": "b.start", "through": [{"point": [4, 1, 0], "radius": 1}, {"point": [4.2, 1.5, 0], "radius": 1}]}})",
       Errc::irregular_surface, "doc#/parts/6", "sharply"},
      {"spline that turns back on a line",
       R"({"name": "x", "spline": {"from": "a.end", "to": "b.start", "through": [{"point": [5, 0, 0], "radius": 1}, {"point": [2, 0, 0], "radius": 1}]}})",
       Errc::irregular_surface, "doc#/parts/6", "nearly stops"},
      {"no reach",
       R"({"name": "x", "two_cone_blend": {"from": "a.end", "to": "b.start", "reach": [0, 1]}})",
       Errc::invalid_argument, "doc#/parts/6/two_cone_blend/reach/0", "positive"},
      {"two cones from a cone",
       R"({"name": "x", "two_cone_blend": {"from": "steep.end", "to": "b.start", "reach": [1, 1]}})",
       Errc::invalid_argument, "doc#/parts/6/two_cone_blend/from", "cylinders"},
  };
  for (const Refusal& row : rows) {
    SCOPED_TRACE(row.name);
    try {
      (void)build(document(pipes + row.parts));
      ADD_FAILURE() << "not refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), row.code) << error.what();
      EXPECT_EQ(error.part(), "x");
      EXPECT_THAT(error.where(), testing::StartsWith(row.where));
      EXPECT_THAT(error.message(), testing::HasSubstr(row.message));
    }
  }
}

TEST(RingedParts, closed_pipes_have_no_ports) {
  const std::string ring = R"(
      {"name": "ring", "spline": {"closed": true, "through": [
        {"point": [4, 0, 0], "radius": 1}, {"point": [0, 4, 0], "radius": 1}, {"point": [-4, -4, 0], "radius": 1}]}},
      {"name": "x", "pipe": {"from": "ring.end", "length": 1}})";
  EXPECT_THROW((void)resolve(document(ring)), Error);
}

}  // namespace
}  // namespace dupin
