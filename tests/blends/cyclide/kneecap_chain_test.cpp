#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/resolve.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "support/cyclide_cases.h"

namespace dupin {
namespace {

using std::numbers::pi;
using test::corner_spheres;
using test::cylinder_to_cone_spheres;
using test::lune_spheres;

using Spheres = std::vector<PeVector>;

Assembly document(const Spheres& spheres, double tolerance) {
  CyclideChainThrough chain;
  chain.spheres = spheres;
  chain.joints = ChainJoints::kneecaps;
  return {"", Unit::millimetre, tolerance, {}, {{"chain", chain}}};
}

struct Measure {
  double area = 0, volume = 0;
};

Measure measure(const TriMesh& mesh) {
  Measure sum;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    sum.area += (q - p).cross(r - p).norm() / 2;
    sum.volume += p.dot(q.cross(r)) / 6;
  }
  return sum;
}

double disc_area(const Ring& ring) { return pi * ring.radius * ring.radius; }

// The pieces' own, with the discs at the chain's ends.
Measure of_pieces(const Chain& chain) {
  Measure sum{disc_area(end_ring(chain, End::start)) + disc_area(end_ring(chain, End::end)), 0};
  for (const PeArc& piece : cyclide_pieces(chain)) {
    sum.area += area(piece);
    sum.volume += volume(piece);
  }
  return sum;
}

template <class MeasureAt>
void expect_second_order(const Measure& exact, const MeasureAt& measure_at) {
  constexpr int kHalvings = 2;
  std::array<Measure, 2> errors;
  for (std::size_t i = 0; i < 2; ++i) {
    const double tolerance = 0.004 / std::pow(4, i == 0 ? 0 : kHalvings);
    const Measure found = measure_at(tolerance);
    errors.at(i) = {std::abs(found.area - exact.area), std::abs(found.volume - exact.volume)};
    EXPECT_LT(errors.at(i).volume, 1.5 * tolerance * exact.area);
  }
  const auto order = [](double coarse, double fine) {
    return std::log2(coarse / fine) / kHalvings;
  };
  EXPECT_GE(order(errors[0].volume, errors[1].volume), 1.85);
  EXPECT_GE(order(errors[0].area, errors[1].area), 1.85);
}

Measure built(const Spheres& spheres, double tolerance) {
  const Solid solid = build(document(spheres, tolerance)).solid;
  return {solid.area(), solid.volume()};
}

// The inner halves of the pipes up to the plane between them are hoofs: of volume 2/3 tan(bend / 2)
// and lateral area 2 tan(bend / 2). Both lose theirs, and one of the volumes counts twice.
TEST(KneecapChain, corner_of_two_pipes_has_a_sector_of_a_ball) {
  for (const double bend : {0.3, pi / 2, 2.0}) {
    SCOPED_TRACE(bend);
    const double t = std::tan(bend / 2);
    const Measure exact{2 * pi * 8 + 2 * pi + 2 * bend - 4 * t, pi * 8 + 2 * bend / 3 - 4 * t / 3};
    expect_second_order(exact,
                        [&](double tolerance) { return built(corner_spheres(bend), tolerance); });
  }
}

// Mathematics B13, B14: the tubes meet the sphere in circles that do not cross.
TEST(KneecapChain, band_joint_has_the_area_and_volume_of_its_parts) {
  for (const double bend : {0.0, 0.15}) {
    SCOPED_TRACE(bend);
    const Spheres spheres = cylinder_to_cone_spheres(-0.2, bend);
    const Chain chain = kneecap_chain(spheres);
    const std::vector<PeArc> pieces = cyclide_pieces(chain);
    const SphericalJoint knee = spherical_joint(pieces[0], pieces[1]);
    ASSERT_TRUE(knee.is_clean());
    Measure exact = of_pieces(chain);
    exact.area += knee.exposed_area;
    const auto segment = [](double angle) {
      const double h = 1 - std::cos(angle);
      return pi * h * h * (3 - h) / 3;
    };
    exact.volume += 4 * pi / 3 - segment(knee.before) - segment(knee.after);
    expect_second_order(exact, [&](double tolerance) { return built(spheres, tolerance); });
  }
}

// The cone leaves the cylinder where it gets wider, behind the common sphere's centre.
TEST(KneecapChain, hidden_joint_is_the_union_of_the_pieces) {
  const double sine = 0.2, angle = std::asin(sine), x = std::tan(angle / 2);
  const Chain chain = kneecap_chain(cylinder_to_cone_spheres(sine, 0));
  const double end_x = end_ring(chain, End::end).center.x(),
               end_r = end_ring(chain, End::end).radius, height = end_x + x;
  const Measure exact{2 * pi * (4 - x) + pi * (1 + end_r) * height / std::cos(angle) +
                          disc_area(end_ring(chain, End::start)) +
                          disc_area(end_ring(chain, End::end)),
                      pi * (4 - x) + pi / 3 * height * (1 + end_r + end_r * end_r)};
  expect_second_order(
      exact, [&](double tolerance) { return built(cylinder_to_cone_spheres(sine, 0), tolerance); });
}

TEST(KneecapChain, pieces_of_one_torus_meet_in_one_circle) {
  Spheres spheres;
  for (const int degrees : {0, 25, 40, 70, 90}) {
    const double a = degrees * pi / 180;
    spheres.push_back({3 * Vec3(std::cos(a), std::sin(a), 0), 1});
  }
  const Measure exact{3 * pi * pi + 2 * pi, 1.5 * pi * pi};
  expect_second_order(exact, [&](double tolerance) { return built(spheres, tolerance); });
}

// Of a disc, beyond the chord of an arc.
double segment_area(const Ring& circle, double arc) {
  return circle.radius * circle.radius / 2 * (arc - std::sin(arc));
}

// The angle of the part of circle u.n1 = h1 of the unit sphere with u.n2 < h2.
double arc_behind(double h1, double h2, double n12) {
  return 2 * std::acos((n12 * h1 - h2) / std::sqrt((1 - h1 * h1) * (1 - n12 * n12)));
}

// The mesh of the pieces, before they are united: the kneecap is a lune, its sector of the ball is
// the cone over it from the centre with those over the discs' segments.
TEST(KneecapChain, pieces_with_the_oracles_kneecap_converge_at_second_order) {
  const Chain chain = kneecap_chain(lune_spheres());
  const std::vector<PeArc> pieces = cyclide_pieces(chain);
  const SphericalJoint knee = spherical_joint(pieces[0], pieces[1]);
  const Ring before = circle_at(pieces[0], 1), after = circle_at(pieces[1], 0);
  const double h1 = (before.center - knee.sphere.m).dot(before.normal);
  const double h2 = (after.center - knee.sphere.m).dot(after.normal);
  const double n12 = before.normal.dot(after.normal);
  const double segment1 = segment_area(before, arc_behind(h1, h2, n12));
  const double segment2 = segment_area(after, arc_behind(-h2, -h1, n12));
  Measure exact = of_pieces(chain);
  // The discs close the pieces, their segments the sector of the ball.
  exact.area += knee.exposed_area + disc_area(before) + disc_area(after) + segment1 + segment2;
  exact.volume += (knee.exposed_area - h1 * segment1 + h2 * segment2) / 3;
  EXPECT_NEAR(knee.exposed_area, 1.77031001528072, 1e-12);
  expect_second_order(exact, [&](double tolerance) {
    const RingSampling sampling{segments_for(chain, tolerance)};
    const Tessellation result = tessellate(chain, sampling, {tolerance});
    EXPECT_LE(result.error_bound, tolerance);
    Measure found = measure(result.mesh);
    for (const Ring& ring : {end_ring(chain, End::start), end_ring(chain, End::end)}) {
      const Measure end = measure(end_cap_mesh(ring, sampling));
      found.area += end.area;
      found.volume += end.volume;
    }
    return found;
  });
}

// Outside positive. The joint's ball is one of both pieces' own.
double distance_to(const Chain& chain, const Vec3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const PeArc& arc : cyclide_pieces(chain)) {
    least = std::min(least, signed_distance(arc, point));
  }
  return least;
}

TEST(KneecapChain, solid_is_as_near_to_the_smooth_one_as_the_report_says) {
  const Spheres spheres = lune_spheres();
  const Chain chain = kneecap_chain(spheres);
  const Built result = build(document(spheres, 0.01));
  const double bound = result.parts[0].error_bound;
  EXPECT_LE(bound, 0.01);
  EXPECT_EQ(result.parts[0].construction, "2 pieces with kneecaps");
  EXPECT_EQ(result.pieces, 3U);
  const TriMesh mesh = to_mesh(result.solid).mesh();
  double largest = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 7) {
    if (mesh.names.at(mesh.labels.at(i)) == "chain") {
      const auto& [a, b, c] = mesh.triangles[i];
      const Vec3 middle = (mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3;
      largest = std::max(largest, std::abs(distance_to(chain, middle)));
    }
  }
  EXPECT_LE(largest, bound);
  EXPECT_GE(largest, bound / 10) << "the bound would be useless";
}

TEST(KneecapChain, ends_in_its_stored_rings_bitwise) {
  const Chain chain = kneecap_chain(lune_spheres());
  const RingSampling sampling{64, 0.25, std::ldexp(1.0, -20)};
  const TriMesh mesh = tessellate(chain, sampling, {0.01}).mesh;
  const auto first = sample(flipped(end_ring(chain, End::start)), sampling);
  EXPECT_TRUE(std::equal(first.begin(), first.end(), mesh.points.begin()));
  const auto last = sample(end_ring(chain, End::end), sampling);
  EXPECT_TRUE(std::is_permutation(mesh.points.end() - 64, mesh.points.end(), last.begin()));
}

void expect_ball(const Spheres& spheres, double tolerance) {
  const Solid solid = build(document(spheres, tolerance)).solid;
  for (const Coordinates coordinates : {Coordinates::binary64, Coordinates::binary32}) {
    const Report report = check(to_mesh(solid, coordinates).mesh());
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(report.count(Defect::self_intersection), 0U);
    EXPECT_EQ(report.euler_number, 2);
    EXPECT_EQ(report.components, 1U);
  }
}

TEST(KneecapChain, every_kind_of_joint_is_watertight_before_and_after_float32) {
  for (const Spheres& spheres :
       {lune_spheres(), corner_spheres(1), cylinder_to_cone_spheres(-0.1, 0),
        cylinder_to_cone_spheres(-0.2, 0.1), cylinder_to_cone_spheres(0.2, 0.1),
        cylinder_to_cone_spheres(-0.2, 1), cylinder_to_cone_spheres(0.3, 2), corner_spheres(1e-9),
        corner_spheres(1e-4), corner_spheres(0.02)}) {
    expect_ball(spheres, 0.02);
  }
}

// Circles that all but touch, from both sides.
TEST(KneecapChain, circles_that_nearly_touch_are_watertight) {
  const double sine = -0.2, touching = std::asin(-sine);
  for (const double off : {-1e-3, -1e-6, -1e-12, 0.0, 1e-12, 1e-6, 1e-3}) {
    SCOPED_TRACE(off);
    expect_ball(cylinder_to_cone_spheres(sine, touching + off), 0.02);
    expect_ball(cylinder_to_cone_spheres(-sine, touching + off), 0.02);
  }
}

// Random walks whose directions stay within 60 degrees of the x axis, so that they do not come
// back to themselves.
TEST(KneecapChain, random_chains_are_watertight) {
  std::mt19937_64 random(1994);
  std::uniform_real_distribution<double> aside(-1.2, 1.2), radius(0.6, 1);
  int chains = 0;
  for (int i = 0; chains < 12 && i < 400; ++i) {
    Spheres spheres;
    Vec3 place = Vec3::Zero();
    for (int k = 0; k < 7; ++k) {
      spheres.push_back({place, radius(random)});
      place += Vec3(2.2, aside(random), aside(random));
    }
    try {
      (void)kneecap_chain(spheres);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::infeasible_blend);
      continue;
    }
    SCOPED_TRACE(i);
    ++chains;
    expect_ball(spheres, 0.05);
  }
  EXPECT_EQ(chains, 12);
}

TEST(KneecapChain, refuses_a_piece_that_turns_back_into_the_one_before) {
  Spheres spheres = cylinder_to_cone_spheres(-0.2, pi - 0.1);
  spheres[0].r = 2.2;
  spheres[1].r = 1.6;
  try {
    (void)kneecap_chain(spheres);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    EXPECT_EQ(error.part(), "piece 1");
    EXPECT_THAT(error.message(), testing::HasSubstr("turns back"));
  }
}

TEST(KneecapChain, documents_errors_have_their_places) {
  struct Row {
    const char* place;
    CyclideChainThrough chain;
  };
  const auto with = [](const auto& change) {
    CyclideChainThrough chain;
    chain.spheres = lune_spheres();
    chain.joints = ChainJoints::kneecaps;
    change(chain);
    return chain;
  };
  const Row rows[] = {
      {"direction", with([](auto& chain) {
         chain.from = ChainDirection{Vec3::Zero(), 0};
       })},
      {"tangents", with([](auto& chain) {
         chain.tangents = {{2, {Vec3::UnitX(), 0}}};
       })},
      {"spheres/4", with([](auto& chain) { chain.wall = 0.75; })},
      {"spheres", with([](auto& chain) { chain.spheres.pop_back(); })},
      {"spheres/1", with([](auto& chain) { chain.spheres[1].r = -1; })},
      {"spheres/4", with([](auto& chain) { chain.spheres[3].r = 5; })},
  };
  for (const Row& row : rows) {
    try {
      (void)build({"c.json", Unit::millimetre, 0.01, {}, {{"chain", row.chain}}});
      FAIL() << row.place;
    } catch (const Error& error) {
      EXPECT_EQ(error.part(), "chain");
      EXPECT_EQ(error.where(), "c.json#/parts/0/cyclide_chain/" + std::string(row.place));
    }
  }
}

// A pipe to the origin, from there the first piece of lune_spheres() as a straight one, then a
// bend: the same solid as the pipe and the chain that begins with a sphere of its own where the
// pipe ends.
TEST(KneecapChain, begins_at_a_port_tangent_to_it_and_shares_its_ring) {
  CyclideChainThrough chain;
  chain.joints = ChainJoints::kneecaps;
  const Spheres all = corner_spheres(1);
  chain.spheres = {all.begin() + 1, all.end()};
  chain.from = PortReference{"pipe", End::end};
  const PipeBetween pipe{Vec3(-6, 0, 0), Vec3(-4, 0, 0), 1};
  const Assembly assembly{"c.json", Unit::millimetre, 0.01, {}, {{"pipe", pipe}, {"chain", chain}}};
  const ResolvedAssembly resolved = resolve(assembly);
  const Ring *from = port_ring(resolved.parts[0].shape, End::end),
             *own = port_ring(resolved.parts[1].shape, End::start);
  ASSERT_TRUE(from != nullptr && own != nullptr);
  EXPECT_EQ(flipped(*own), *from);
  EXPECT_EQ(cyclide_pieces(resolved.parts[1].shape).front().start_tangent().m.normalized(),
            Vec3::UnitX());
  const Built result = build(assembly);
  EXPECT_EQ(result.runs, 1U);
  EXPECT_EQ(result.solid.euler_number(), 2);
  EXPECT_NEAR(result.solid.volume(), build(document(all, 0.01)).solid.volume() + 2 * pi,
              0.01 * 2 * pi * 2);

  // The first piece bends to where its third sphere is; its second one does not count.
  chain.spheres = {
      test::sphere(-2, 9, 9, 1), {Vec3(-1, 1, 0), 1}, {Vec3(-1, 3, 1), 1}, {Vec3(0, 5, 1), 1}};
  const Chain bent = std::get<Chain>(
      resolve({"c.json", Unit::millimetre, 0.01, {}, {{"pipe", pipe}, {"chain", chain}}})
          .parts[1]
          .shape);
  EXPECT_LT((cyclide_pieces(bent).front().start_tangent().m.normalized() - Vec3::UnitX()).norm(),
            1e-15);
  EXPECT_GT(cyclide_pieces(bent).front().end_tangent().m.normalized().y(), .5);
}

TEST(KneecapChain, begins_along_a_direction_that_is_given) {
  CyclideChainThrough chain;
  chain.joints = ChainJoints::kneecaps;
  chain.spheres = lune_spheres();
  chain.from = ChainDirection{Vec3(1, 0, 0), .25};
  const ResolvedAssembly resolved =
      resolve({"c.json", Unit::millimetre, 0.01, {}, {{"chain", chain}}});
  const PeVector tangent = cyclide_pieces(resolved.parts[0].shape).front().start_tangent();
  EXPECT_LT((tangent.m - std::hypot(1, .25) * Vec3::UnitX()).norm(), 1e-15);
  EXPECT_EQ(tangent.r, .25);
}

// The wall of a bend of cylinders with a spherical joint: outside minus inside, both closed forms;
// their lens at the joint is what the pieces' own volumes count twice.
TEST(KneecapChain, is_hollow_with_the_volume_between_its_skins) {
  for (const double bend : {.4, 1.2}) {
    Assembly assembly = document(corner_spheres(bend), .001);
    const double wall = .25;
    std::get<CyclideChainThrough>(assembly.parts[0].shape).wall = wall;
    const Built hollow_one = build(assembly);
    Spheres inner = corner_spheres(bend);
    std::ranges::for_each(inner, [&](PeVector& s) { s.r -= wall; });
    const double expected = build(document(corner_spheres(bend), .001)).solid.volume() -
                            build(document(inner, .001)).solid.volume();
    // Either mesh keeps the bound, and its area is that of 8 long cylinders and some.
    EXPECT_NEAR(hollow_one.solid.volume(), expected, .001 * 2 * (8 + 2) * 2 * pi) << bend;
    EXPECT_EQ(hollow_one.solid.euler_number(), 0) << bend;
    EXPECT_TRUE(hollow_one.ports.empty());
    const TriMesh mesh = to_mesh(hollow_one.solid).mesh();
    EXPECT_TRUE(check(mesh).is_solid());
    EXPECT_EQ(mesh.names, (std::vector<std::string>{"chain", "chain.start", "chain.end"}));
    for (const Vec3& p : mesh.points) {
      EXPECT_TRUE(p.x() > -.5 || std::hypot(p.y(), p.z()) > .7) << "a disc is left";
    }
  }
}

TEST(KneecapChain, is_hollow_where_cones_end_in_conical_rims) {
  Assembly assembly = document(cylinder_to_cone_spheres(.2, .8), .01);
  std::get<CyclideChainThrough>(assembly.parts[0].shape).wall = .1;
  const Built built = build(assembly);
  EXPECT_EQ(built.solid.euler_number(), 0);
  EXPECT_TRUE(check(to_mesh(built.solid).mesh()).is_solid());
  EXPECT_LE(built.parts[0].error_bound, .01);
}

TEST(KneecapChain, is_welded_to_the_parts_at_its_ends) {
  CyclideChainThrough chain;
  chain.spheres = corner_spheres(1);
  chain.joints = ChainJoints::kneecaps;
  const Assembly assembly{"",
                          Unit::millimetre,
                          0.01,
                          {},
                          {{"a", PipeAlong{PortReference{"chain", End::start}, 1}},
                           {"chain", chain},
                           {"b", PipeAlong{PortReference{"chain", End::end}, 2}}}};
  const Built result = build(assembly);
  EXPECT_EQ(result.runs, 1U);
  EXPECT_EQ(result.pieces, 3U);
  EXPECT_EQ(result.solid.euler_number(), 2);
  EXPECT_NEAR(result.solid.volume(),
              build(document(corner_spheres(1), 0.01)).solid.volume() + 3 * pi, 0.01 * 2 * pi * 3);
}

}  // namespace
}  // namespace dupin
