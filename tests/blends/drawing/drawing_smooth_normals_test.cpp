#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/blends/drawing.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

Vec3 vec(const Direction& d) { return {double(d[0]), double(d[1]), double(d[2])}; }

TriMesh mesh_of(const Solid& solid) {
  return {solid.nearest_points(), solid.triangles(), solid.labels(), solid.names()};
}

// A built assembly with the normals of its mesh.
struct Shaded {
  explicit Shaded(Assembly a, const BuildOptions& options = {})
      : assembly(std::move(a)),
        built(build(assembly, options)),
        mesh(mesh_of(built.solid)),
        normals(smooth_normals(assembly, built, mesh)) {}

  Assembly assembly;
  Built built;
  TriMesh mesh;
  CornerNormals normals;

  // Visits the corners of all triangles of a name; returns how many there are.
  std::size_t corners(const std::string& name,
                      const std::function<void(std::uint32_t, const Vec3&)>& visit) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (mesh.names[mesh.labels[i]] == name) {
        for (std::size_t k = 0; k < 3; ++k) {
          visit(mesh.triangles[i].at(k), vec(normals[i].at(k)));
          ++count;
        }
      }
    }
    return count;
  }

  // The normals are those that the function gives at points that lie on the surface.
  void expect(const std::string& name, const std::function<Vec3(const Vec3&)>& exact,
              double bound = 2e-7) const {
    EXPECT_GT(corners(name,
                      [&](std::uint32_t point, const Vec3& normal) {
                        const Vec3& at = mesh.points[point];
                        EXPECT_LT((normal - exact(at)).norm(), bound) << name << " " << at;
                      }),
              0U)
        << name;
  }

  // How many normals there are at each point.
  [[nodiscard]] std::map<std::uint32_t, std::set<Direction>> at_points() const {
    std::map<std::uint32_t, std::set<Direction>> result;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        result[mesh.triangles[i].at(k)].insert(normals[i].at(k));
      }
    }
    return result;
  }

  // Points with so many normals.
  [[nodiscard]] std::size_t with(std::size_t count) const {
    std::size_t result = 0;
    for (const auto& [point, directions] : at_points()) {
      result += directions.size() == count ? 1 : 0;
    }
    return result;
  }
};

Assembly assembly_of(const std::string& parts, const std::string& more = {}) {
  return parse_assembly(R"({"units": "mm", "tolerance": 0.01, "segments": 48, )" + more +
                            R"("parts": [)" + parts + "]}",
                        "test");
}

Assembly example(const std::string& name) {
  return read_assembly(test::source_folder() / "examples" / (name + ".json"));
}

Vec3 radial(const Vec3& at) { return Vec3(at.x(), at.y(), 0).normalized(); }

const std::string kPipe =
    R"({"name": "p", "pipe": {"from": [0, 0, 0], "to": [0, 0, 9], "radius": 2}})";

// Points of meshes are on a lattice, so that they are off the surface by as little.
constexpr double kOfLattice = 1e-4;

TEST(SmoothNormals, of_a_pipe_are_radial_and_its_rims_are_sharp) {
  const Shaded pipe(assembly_of(kPipe));
  pipe.expect("p", radial);
  pipe.expect("p.start", [](const Vec3&) { return Vec3(-Vec3::UnitZ()); });
  pipe.expect("p.end", [](const Vec3&) { return Vec3::UnitZ(); });
  EXPECT_EQ(pipe.with(2), pipe.mesh.points.size());  // all points are on rims
}

TEST(SmoothNormals, of_a_cone_lean_by_its_angle) {
  const Shaded cone(assembly_of(
      R"({"name": "c", "cone": {"from": [0, 0, 0], "to": [0, 0, 4], "radii": [3, 1]}})"));
  cone.expect("c", [](const Vec3& at) {
    return Vec3((radial(at) + Vec3(0, 0, 0.5)).normalized());  // the radius falls by 2 in 4
  });
}

TEST(SmoothNormals, of_a_sphere_point_from_its_centre) {
  const Shaded ball(assembly_of(R"({"name": "s", "sphere": {"center": [1, 2, 3], "radius": 2}})"));
  ball.expect("s", [](const Vec3& at) { return (at - Vec3(1, 2, 3)).normalized(); });
  EXPECT_EQ(ball.with(1), ball.mesh.points.size());
}

// The elbow is a torus about the line through (5, 0, 9) along y; both its joints are tangent.
TEST(SmoothNormals, of_an_elbow_are_those_of_a_torus_and_go_on_in_the_pipes) {
  const Shaded bend(assembly_of(kPipe + R"(,
      {"name": "e", "elbow": {"from": "p.end", "bend_radius": 5, "angle": 90, "toward": [1, 0, 0]}},
      {"name": "q", "pipe": {"from": "e.end", "length": 4}})"));
  const auto torus = [](const Vec3& at) {
    const Vec3 center(5, 0, 9);
    const Vec3 flat(at.x() - center.x(), 0, at.z() - center.z());
    return Vec3((at - center - 5 * flat.normalized()).normalized());
  };
  bend.expect("e", torus, kOfLattice);
  bend.expect("p", radial);
  EXPECT_EQ(bend.with(2), 2U * 48);  // the rims of both open ends
  EXPECT_EQ(bend.with(1), bend.mesh.points.size() - 2U * 48);
}

TEST(SmoothNormals, of_a_cone_on_a_pipe_turn_in_their_ring) {
  const Shaded reducer(assembly_of(
      kPipe + R"(, {"name": "c", "cone": {"from": "p.end", "length": 10, "end_radius": 3}})"));
  EXPECT_EQ(reducer.with(2), 3U * 48);
}

// Triangles turn from the surface by no more than its mesh has steps, all over.
TEST(SmoothNormals, come_near_to_those_of_the_triangles_as_meshes_are_finer) {
  for (const char* name : {"skew-pipes", "u-bend-cyclide", "oval-duct", "oblique-nozzle",
                           "junction", "tee", "crane-hook", "jet-engine", "ucct-arm"}) {
    BuildOptions fine;
    const Assembly assembly = example(name);
    fine.tolerance = assembly.tolerance / 4;
    const Shaded coarse(assembly), shaded(assembly, fine);
    const auto largest = [](const Shaded& of) {
      double angle = 0;
      for (std::size_t i = 0; i < of.mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = of.mesh.triangles[i];
        const Vec3 facet =
            (of.mesh.points[b] - of.mesh.points[a]).cross(of.mesh.points[c] - of.mesh.points[a]);
        for (const Direction& normal : of.normals[i]) {
          angle = std::max(angle, std::acos(std::min(1.0, vec(normal).dot(facet.normalized()))));
        }
      }
      return angle;
    };
    // Sagittas fall as the square of angles do.
    EXPECT_LT(largest(coarse), 0.4) << name;
    EXPECT_LT(largest(shaded), 0.65 * largest(coarse)) << name;
  }
}

TEST(SmoothNormals, keep_the_edge_of_a_union) {
  const Shaded cross(assembly_of(
      R"({"name": "a", "pipe": {"from": [0, 0, -9], "to": [0, 0, 9], "radius": 2}},
         {"name": "b", "pipe": {"from": [0, 0, 0], "to": [9, 0, 0], "radius": 1}})"));
  const auto of_b = [](const Vec3& at) { return Vec3(0, at.y(), at.z()).normalized(); };
  cross.expect("a", radial, 0.01);
  cross.expect("b", of_b, 0.01);
  std::set<std::uint32_t> edge;
  std::set<std::uint32_t> of_a;
  cross.corners("a", [&](std::uint32_t point, const Vec3&) { of_a.insert(point); });
  cross.corners("b", [&](std::uint32_t point, const Vec3&) {
    if (of_a.contains(point)) {
      edge.insert(point);
    }
  });
  const auto directions = cross.at_points();
  EXPECT_GT(edge.size(), 20U);
  for (const std::uint32_t point : edge) {
    EXPECT_EQ(directions.at(point).size(), 2U);
  }
}

// Neither fillets nor hubs have edges: only open ends do.
TEST(SmoothNormals, run_on_over_fillets_and_hubs) {
  for (const char* name : {"tee", "equal-tee", "junction"}) {
    const Shaded shaded(example(name));
    std::set<std::uint32_t> on_discs;
    for (const Port& port : shaded.built.ports) {
      shaded.corners(port.name, [&](std::uint32_t point, const Vec3&) { on_discs.insert(point); });
    }
    EXPECT_EQ(shaded.with(1), shaded.mesh.points.size() - on_discs.size()) << name;
    EXPECT_EQ(shaded.with(2), on_discs.size()) << name;
  }
}

TEST(SmoothNormals, of_bores_point_into_them_and_out_of_fluids) {
  const Assembly assembly = assembly_of(kPipe, R"("wall": 0.5, )");
  BuildOptions options;
  for (const auto& [region, sign] : {std::pair(Region::metal, -1), std::pair(Region::fluid, 1)}) {
    options.region = region;
    const Shaded shaded(assembly, options);
    shaded.expect("p.bore", [sign = sign](const Vec3& at) { return Vec3(sign * radial(at)); });
    shaded.expect("p.end", [](const Vec3&) { return Vec3::UnitZ(); });
  }
}

// A chain with a wall of its own: two skins, and rims that are strips of cones.
TEST(SmoothNormals, of_hollow_chains_have_edges_at_their_rims_alone) {
  const Shaded engine(example("jet-engine"));
  const PartReport& shell = engine.built.parts.front();
  EXPECT_EQ(engine.with(2), 4 * shell.segments);
  EXPECT_EQ(engine.with(1), engine.mesh.points.size() - engine.with(2));
  const SmoothRegion region = smooth_region(engine.assembly, engine.built);
  const Ring start = end_ring(std::get<Chain>(region.whole.parts.front().shape), End::start);
  engine.expect(
      "shell.start",
      [&](const Vec3& at) {
        const Vec3 away = at - start.center;
        const Vec3 across = (away - away.dot(start.normal) * start.normal).normalized();
        return Vec3((start.normal + start.slope * across).normalized());
      },
      kOfLattice);
}

TEST(SmoothNormals, of_insulation_are_those_of_both_its_sides) {
  BuildOptions options;
  options.region = Region::insulation;
  const Shaded shaded(assembly_of(kPipe, R"("insulation": 0.5, )"), options);
  shaded.expect("p", [](const Vec3& at) { return Vec3(-radial(at)); });
  shaded.expect("p.insulation", radial);
}

TEST(SmoothNormals, know_patches_by_their_other_names) {
  const Shaded shaded(assembly_of(kPipe, R"("patches": {"p": "wall", "p.end": "outlet"}, )"));
  shaded.expect("wall", radial);
  shaded.expect("outlet", [](const Vec3&) { return Vec3::UnitZ(); });
}

// Whatever the mesh is.
TEST(SmoothNormals, are_never_far_from_the_triangles_own) {
  const Assembly assembly = assembly_of(kPipe);
  const Built built = build(assembly);
  TriMesh mesh = mesh_of(built.solid);
  for (std::size_t i = 0; i < mesh.points.size(); i += 5) {
    mesh.points[i] += Vec3(std::sin(double(i)), std::cos(double(i)), 0.3);
  }
  const CornerNormals normals = smooth_normals(assembly, built, mesh, 2);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3 facet =
        (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]).normalized();
    for (const Direction& normal : normals[i]) {
      EXPECT_NEAR(vec(normal).norm(), 1, 2e-7);
      EXPECT_GT(vec(normal).dot(facet), kLeastNormalCosine - 1e-6);
    }
  }
}

TEST(SmoothNormals, are_of_meshes_and_moves_that_are_some) {
  const Assembly assembly = assembly_of(kPipe);
  const Built built = build(assembly);
  const TriMesh mesh = mesh_of(built.solid);
  const auto refused = [&](const TriMesh& other, double moved) {
    EXPECT_THROW((void)smooth_normals(assembly, built, other, moved), Error);
  };
  TriMesh bad = mesh;
  bad.triangles[0][1] = static_cast<std::uint32_t>(mesh.points.size());
  refused(bad, 0);
  bad = mesh;
  bad.labels[0] = static_cast<std::uint32_t>(mesh.names.size());
  refused(bad, 0);
  bad = mesh;
  bad.points[0].x() = std::nan("");
  refused(bad, 0);
  refused(mesh, std::nan(""));
  refused(mesh, -1);
}

}  // namespace
}  // namespace dupin
