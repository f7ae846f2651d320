#include "dupin/blends/part_measures.h"

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "blends/ringed/ringed_blends.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/elliptic_tube.h"
#include "dupin/blends/resolve.h"
#include "dupin/blends/tessellate.h"
#include "dupin/io/assembly_json.h"
#include "support/cyclide_cases.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

using Eigen::Matrix3d;
using std::numbers::pi;

constexpr double kClosed = 1e-12;

// The one part of a document in millimetres, without "name" and braces.
PartMeasures of_part(const std::string& part) {
  return measures(resolve(parse_assembly(R"({"units": "mm", "tolerance": 0.01, "parts": [{"name":
    "part", )" + part + "}]}",
                                         "test"))
                      .parts.front()
                      .shape);
}

void expect_near(const Matrix3d& a, const Matrix3d& b, double tolerance) {
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), tolerance * b.cwiseAbs().maxCoeff()) << a << "\n\n" << b;
}

TEST(PartMeasures, of_a_cylinder) {
  const double r = 2, h = 6, mass = pi * r * r * h;
  const PartMeasures m = of_part(R"("pipe": {"from": [1, 2, 3], "to": [1, 2, 9], "radius": 2})");
  EXPECT_NEAR(m.area, 2 * pi * r * h, kClosed * m.area);
  EXPECT_NEAR(*m.length, h, kClosed * h);
  EXPECT_NEAR(m.solid->volume, mass, kClosed * mass);
  EXPECT_LT((m.solid->centroid - Vec3(1, 2, 6)).norm(), kClosed);
  const double across = mass * (3 * r * r + h * h) / 12;
  expect_near(inertia(*m.solid), Vec3(across, across, mass * r * r / 2).asDiagonal(), kClosed);
}

TEST(PartMeasures, of_a_frustum) {
  const double a = 3, b = 1, h = 4, volume = pi * h / 3 * (a * a + a * b + b * b);
  const PartMeasures m =
      of_part(R"("cone": {"from": [0, 0, 0], "to": [0, 0, 4], "radii": [3, 1]})");
  EXPECT_NEAR(m.area, pi * (a + b) * std::hypot(h, a - b), kClosed * m.area);
  EXPECT_NEAR(m.solid->volume, volume, kClosed * volume);
  const double height = h / 4 * (a * a + 2 * a * b + 3 * b * b) / (a * a + a * b + b * b);
  EXPECT_LT((m.solid->centroid - Vec3(0, 0, height)).norm(), kClosed);
  const double axial = pi * h / 10 * (std::pow(a, 5) - std::pow(b, 5)) / (a - b);
  EXPECT_NEAR(inertia(*m.solid)(2, 2), axial, kClosed * axial);
}

// Pappus, and the moments of a torus segment about its axis.
TEST(PartMeasures, of_an_elbow) {
  const double r = 1, bend = 3, angle = pi / 2;
  const PartMeasures m = of_part(
      R"("elbow": {"from": [3, 0, 0], "direction": [0, 1, 0], "radius": 1,
         "bend_radius": 3, "angle": 90, "toward": [-1, 0, 0]})");
  EXPECT_NEAR(*m.length, bend * angle, kClosed * bend);
  EXPECT_NEAR(m.area, 2 * pi * r * bend * angle, kClosed * m.area);
  const double volume = pi * r * r * bend * angle;
  EXPECT_NEAR(m.solid->volume, volume, kClosed * volume);
  const double off = 2 / pi * (bend + r * r / (4 * bend));
  EXPECT_LT((m.solid->centroid - Vec3(off, off, 0)).norm(), kClosed * bend);
  const double about_axis = volume * (bend * bend + 3. / 4 * r * r);
  EXPECT_NEAR(inertia(*m.solid)(2, 2) + volume * 2 * off * off, about_axis, kClosed * about_axis);
}

TEST(PartMeasures, of_a_ball) {
  const PartMeasures m = of_part(R"("sphere": {"center": [4, 5, 6], "radius": 2})");
  EXPECT_NEAR(m.area, 16 * pi, kClosed * m.area);
  EXPECT_FALSE(m.length.has_value());
  EXPECT_NEAR(m.solid->volume, 32 * pi / 3, kClosed * m.solid->volume);
  EXPECT_EQ(m.solid->centroid, Vec3(4, 5, 6));
  expect_near(inertia(*m.solid), 0.4 * m.solid->volume * 4 * Matrix3d::Identity(), kClosed);
}

// Circles stay level: volume as of the right cone, the centre on the line between the centres.
TEST(PartMeasures, of_an_oblique_cone) {
  const PartMeasures m = measures(oblique_tube(Vec3(0, 0, 0), Vec3(2, 1, 4), Vec3::UnitZ(), 3, 1));
  const double volume = pi * 4 / 3 * 13;
  EXPECT_NEAR(m.solid->volume, volume, kClosed * volume);
  const double share = 18. / 13 / 4;
  EXPECT_LT((m.solid->centroid - share * Vec3(2, 1, 4)).norm(), kClosed);
  // Shearing adds the moments along z to those across.
  const PartMeasures right =
      measures(oblique_tube(Vec3(0, 0, 0), Vec3(0, 0, 4), Vec3::UnitZ(), 3, 1));
  Matrix3d shear = Matrix3d::Identity();
  shear.col(2) = Vec3(0.5, 0.25, 1);
  expect_near(m.solid->spread, shear * right.solid->spread * shear.transpose(), kClosed);
}

TEST(PartMeasures, of_an_elliptic_cylinder) {
  const PartMeasures m = of_part(R"("pipe": {"from": [0, 0, 0], "to": [0, 0, 5],
    "semi_axes": [3, 2], "axis": [1, 0, 0]})");
  const double volume = pi * 6 * 5;
  EXPECT_NEAR(m.solid->volume, volume, kClosed * volume);
  expect_near(m.solid->spread, volume * Vec3(9. / 4, 1, 25. / 12).asDiagonal().toDenseMatrix(),
              kClosed);
  EXPECT_NEAR(m.area, 5 * 4 * 3 * std::comp_ellint_2(std::sqrt(5.) / 3), kClosed * m.area);
}

// The mathematics' tables.
TEST(PartMeasures, of_ringed_blends_are_those_of_the_tables) {
  const auto of = [](const RationalRingedSurface& surface) {
    return measures(RationalRingedTube{{}, {}, surface});
  };
  const PartMeasures oblique = of(test::cone_to_cylinder()), general = of(test::general_ends());
  EXPECT_NEAR(oblique.solid->volume, 17.5269642058763, 1e-12);
  EXPECT_NEAR(oblique.area, 35.557668023709, 1e-11);
  EXPECT_NEAR(general.solid->volume, 15.3753836314577, 1e-12);
  EXPECT_NEAR(general.area, 34.305879365158, 1e-11);
}

TEST(PartMeasures, of_cyclides_are_those_of_the_tables) {
  const Chain hook = cyclide_tube(test::crane_hook());
  const PartMeasures first = measures(Chain(hook.pieces[0])),
                     third = measures(Chain(hook.pieces[2]));
  EXPECT_NEAR(first.solid->volume, 3.90374548074486, 1e-12);
  EXPECT_NEAR(first.area, 13.6064833508378, 1e-11);
  EXPECT_NEAR(third.solid->volume, 4.87132459860074, 1e-12);
  EXPECT_NEAR(third.area, 11.1636849862705, 1e-11);
}

// A ball between two cylinders of its radius in line has no kneecap: all is one cylinder.
TEST(PartMeasures, of_kneecaps_are_those_of_the_bodies_they_are_made_of) {
  const PartMeasures straight = measures(kneecap_chain(test::corner_spheres(0)));
  EXPECT_NEAR(straight.solid->volume, 8 * pi, 1e-11);
  const PartMeasures bent = measures(kneecap_chain(test::corner_spheres(pi / 2)));
  EXPECT_FALSE(bent.solid.has_value());
  EXPECT_EQ(bent.missing, "its pieces penetrate each other at a joint");
}

// Rigid motions turn the tensors; lengths by s are volumes by s^3 and moments by s^5.
TEST(PartMeasures, move_and_grow_with_the_part) {
  const Vec3 shift(120, -40, 9);
  const double s = 2.5;
  const Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  const auto placed = [&](const Vec3& p) { return Vec3(s * turn * p + shift); };
  std::vector<PeVector> spheres = test::crane_hook_spheres();
  const PartMeasures before = measures(cyclide_tube(test::crane_hook()));
  for (PeVector& sphere : spheres) {
    sphere = {placed(sphere.m), s * sphere.r};
  }
  const PartMeasures after =
      measures(cyclide_tube(compose(spheres, {Vec3(turn * -Vec3::UnitY()), 0})));
  constexpr double kTurned = 1e-10;
  EXPECT_NEAR(after.area, s * s * before.area, kTurned * after.area);
  EXPECT_NEAR(*after.length, s * *before.length, kTurned * *after.length);
  EXPECT_NEAR(after.solid->volume, s * s * s * before.solid->volume, kTurned * after.solid->volume);
  EXPECT_LT((after.solid->centroid - placed(before.solid->centroid)).norm(), 1e-9);
  expect_near(inertia(*after.solid),
              std::pow(s, 5) * turn * inertia(*before.solid) * turn.transpose(), kTurned);
}

TEST(SolidMoments, of_halves_together_are_those_of_the_whole) {
  const auto pipe = [](double from, double to) {
    const Vec3 a(from, 7, 1), b(to, 7, 1);
    return *measures(oblique_tube(a, b, Vec3::UnitX(), 2, 2)).solid;
  };
  const SolidMoments whole = pipe(0, 10), sum = pipe(0, 3) + pipe(3, 10), rest = whole - pipe(0, 3);
  EXPECT_NEAR(sum.volume, whole.volume, 1e-12 * whole.volume);
  EXPECT_LT((sum.centroid - whole.centroid).norm(), 1e-12);
  expect_near(sum.spread, whole.spread, 1e-12);
  expect_near(rest.spread, pipe(3, 10).spread, 1e-12);
}

// Of a closed mesh.
double enclosed(const TriMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.points[a].dot(mesh.points[b].cross(mesh.points[c])) / 6;
  }
  return sum;
}

double meshed_volume(const Chain& chain, double tolerance) {
  const RingSampling sampling{segments_for(chain, tolerance)};
  double sum = enclosed(tessellate(chain, sampling, {tolerance}).mesh);
  for (const End end : {End::start, End::end}) {
    if (!chain.closed) {
      sum += enclosed(end_cap_mesh(end_ring(chain, end), sampling));
    }
  }
  return sum;
}

// The mesh keeps within the tolerance, so that its volume differs by no more than that of a layer
// as thick; the tolerance is of second order in the lengths of edges.
TEST(PartMeasures, are_the_limits_of_those_of_meshes) {
  int chains = 0;
  for (const char* name : {"reducer", "oval-duct", "ringed-canal", "crane-hook-twisted", "u-bend",
                           "way-points", "two-cones", "cyclide-blends", "oblique-nozzle"}) {
    const Assembly assembly =
        read_assembly(test::source_folder() / "examples" / (std::string(name) + ".json"));
    for (const ResolvedPart& part : resolve(assembly).parts) {
      const auto* chain = std::get_if<Chain>(&part.shape);
      if (chain == nullptr || chain->wall > 0 || chain->joints != Joints::smooth) {
        continue;
      }
      const PartMeasures m = measures(part.shape);
      double before = 0;
      for (const double tolerance : {assembly.tolerance, assembly.tolerance / 16}) {
        const double error = std::abs(meshed_volume(*chain, tolerance) - m.solid->volume);
        EXPECT_LT(error, m.area * tolerance) << name << ": " << part.name;
        if (before > 0) {
          EXPECT_LT(error, before / 8) << name << ": " << part.name;
        }
        before = error;
      }
      ++chains;
    }
  }
  EXPECT_GT(chains, 25);
}

}  // namespace
}  // namespace dupin
