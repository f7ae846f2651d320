#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "blends/random_blends.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

TEST(Certificate, never_claims_embedded_what_meets_itself) { test::compare_prover_and_mesh(1, 40); }

TEST(Certificate, holds_whatever_work_its_searches_may_take) {
  const auto pipe = [](const std::string& name, const Vec3& from, const Vec3& to) {
    return Part{name, PipeBetween{from, to, 1}};
  };
  const Assembly assembly{
      "pipes.json",
      Unit::millimetre,
      0.05,
      {},
      {pipe("one", Vec3(-5, 0, 0), Vec3(5, 0, 0)), pipe("across", Vec3(0, -5, 1), Vec3(0, 5, 1)),
       pipe("far", Vec3(0, 0, 9), Vec3(5, 0, 9)),
       pipe("crossed", Vec3(3, -5, 0.5), Vec3(3, 5, 0.5))}};
  const Certificate found = certify(assembly), first_looks = certify(assembly, {.work = 0});
  verify(found);
  verify(first_looks);
  EXPECT_EQ(found.findings(), 0U);
  const auto all = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(certify(assembly, {.work = all}).findings(), 0U) << "no limit";
  EXPECT_EQ(first_looks.findings(), 2U) << "those that overlap";
  // The far one is the third.
  for (const std::size_t i : {1U, 3U, 5U}) {
    EXPECT_EQ(first_looks.clearances[i].verdict, Verdict::proved);
  }
}

TEST(Certificate, is_told_of_and_can_be_ended) {
  const Assembly assembly{"pipe.json",
                          Unit::millimetre,
                          0.05,
                          {},
                          {Part{"a", PipeBetween{Vec3::Zero(), Vec3(5, 0, 0), 1}}}};
  std::vector<std::string> stages;
  (void)certify(assembly, {.progress = [&](std::string_view stage, double) {
                  stages.emplace_back(stage);
                  return true;
                }});
  EXPECT_EQ(stages,
            (std::vector<std::string>{"certify parts", "certify meshes", "certify clearances"}));
  for (const std::string& last : stages) {
    try {
      (void)certify(assembly,
                    {.progress = [&](std::string_view stage, double) { return stage != last; }});
      ADD_FAILURE() << last;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::cancelled);
    }
  }
}

// A random direction and place each; nothing of it was found within the work that a claim may take.
TEST(Certificate, of_bends_hardly_wider_than_their_pipe_is_found) {
  std::mt19937_64 random(15);
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  for (const double ratio : {1 + 1e-6, 1.0001, 1.01, 1.2}) {
    for (const double angle : {90., 135., 180.}) {
      SCOPED_TRACE(std::to_string(ratio) + " " + std::to_string(angle));
      const double radius = std::exp(normal(random));
      const double turned = angle * std::numbers::pi / 180;
      const Place from{1e3 * vector(), vector(), radius};
      const Certificate found =
          certify({"bend.json",
                   Unit::millimetre,
                   radius / 50,
                   {},
                   {{"inlet", PipeAlong{from, 3 * radius}},
                    {"bend", ElbowTurning{PortReference{"inlet", End::end}, ratio * radius, turned,
                                          vector()}},
                    {"outlet", PipeAlong{PortReference{"bend", End::end}, 3 * radius}}}});
      verify(found);
      EXPECT_EQ(found.claims[1].embedded->verdict, Verdict::proved);
      for (const std::size_t joint : {0, 2}) {
        EXPECT_EQ(found.clearances[joint].verdict, Verdict::proved) << joint;
      }
    }
  }
}

// Directions about equally far from each other. Of six arms hardly anything was found within the
// work that a certificate may take.
TEST(Certificate, of_hubs_of_many_arms_is_found) {
  for (const int arms : {5, 6}) {
    SCOPED_TRACE(arms);
    Assembly assembly{"hub.json", Unit::millimetre, .1, {}, {}};
    JunctionOfPorts junction;
    for (int i = 0; i < arms; ++i) {
      const double z = 1 - (2 * i + 1.) / arms, turn = 2 * i * std::numbers::pi / std::numbers::phi;
      const Vec3 along(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn),
                       z);
      const std::string name = std::to_string(i);
      assembly.parts.push_back({name, PipeBetween{40 * along, 15 * along, 3}});
      junction.ends.push_back({name, End::end});
    }
    assembly.parts.push_back({"hub", junction});
    const Certificate found = certify(assembly);
    verify(found);
    EXPECT_EQ(found.findings(), 0U);
  }
}

// Rounding to the grid does not widen what their triangles span by a segment.
TEST(Certificate, of_filleted_pipes_bounds_their_meshes_as_build_does) {
  for (const double radius : {9.0, 10.0, 12.5, 14.0}) {
    const Assembly assembly{"tee.json",
                            Unit::millimetre,
                            0.02,
                            {},
                            {{"run", PipeBetween{{-60, 0, 0}, {60, 0, 0}, 15}},
                             {"branch", PipeBetween{{0, 0, 0}, {0, 0, 45}, radius}},
                             {"throat", FilletBetween{{"run", "branch"}, 0.6}}}};
    const Certificate found = certify(assembly);
    verify(found);
    for (const PartClaims& claims : found.claims) {
      ASSERT_TRUE(claims.mesh);
      EXPECT_LE(claims.mesh->error_bound, 0.02) << radius;
    }
  }
}

// Stacks of pipes, 10 from each other along both axes.
Assembly field_of_pipes(int side) {
  Assembly assembly{"field.json", Unit::millimetre, 0.05, {}, {}};
  for (int i = 0; i < side * side; ++i) {
    const Vec3 foot(10 * (i / side), 10 * (i % side), 0);
    assembly.parts.push_back(
        {"pipe " + std::to_string(i), PipeBetween{foot, foot + Vec3(0, 0, 30), 1}});
  }
  return assembly;
}

// Of a tight bound the checker has not the work to be convinced; one that is not as tight will do.
TEST(Certificate, of_a_coil_of_many_points_bounds_its_mesh) {
  constexpr int kPoints = 200;
  const auto place = [](int i) {
    const double turned = 2 * std::numbers::pi * i / 20;
    return Vec3(20 * std::cos(turned), 20 * std::sin(turned), .4 * i);
  };
  Assembly assembly{"coil.json", Unit::millimetre, 0.05, {}, {}};
  assembly.parts.push_back({"in", PipeBetween{place(0) - Vec3(0, 5, 0), place(0), 1.5}});
  assembly.parts.push_back(
      {"out", PipeBetween{place(kPoints), place(kPoints) + Vec3(0, 5, 0), 1.5}});
  SplineBetween spline{PortReference{"in", End::end}, PortReference{"out", End::start}, {}};
  for (int i = 1; i < kPoints; ++i) {
    spline.through.push_back({place(i), 1.5});
  }
  assembly.parts.push_back({"coil", spline});
  const Certificate found = certify(assembly);
  ASSERT_TRUE(found.claims[2].mesh.has_value());
  EXPECT_LE(found.claims[2].mesh->error_bound, 1.1 * assembly.tolerance);
  EXPECT_EQ(found.findings(), 0U);
  EXPECT_NO_THROW(verify(found));
}

// Boxes along the axes of coordinates are nearer than any distance to all others.
TEST(Certificate, of_many_long_parts_askew_has_boxes_along_these) {
  const Vec3 along = Vec3(1, 2, 3).normalized(), across = along.unitOrthogonal(),
             up = along.cross(across);
  Assembly assembly{"rack.json", Unit::millimetre, 0.05, {}, {}};
  for (int i = 0; i < 81; ++i) {
    const Vec3 middle = 3 * (i / 9) * across + 3 * (i % 9) * up;
    assembly.parts.push_back({"p" + std::to_string(i),
                              PipeBetween{middle - 200 * along, middle + (200 - i) * along, 1}});
  }
  const Certificate found = certify(assembly);
  ASSERT_TRUE(found.axes);
  EXPECT_NEAR(std::abs(found.axes->at(0).normalized().dot(along)), 1, 1e-9);
  EXPECT_EQ(found.findings(), 0U);
  EXPECT_EQ(found.clearances.size(), 0U);
  EXPECT_NO_THROW(verify(found));
  Certificate without = found;
  without.axes.reset();
  EXPECT_THROW(verify(without), Error);
}

TEST(Certificate, of_many_parts_has_claims_of_neighbours_only) {
  Assembly assembly = field_of_pipes(9);
  assembly.parts.push_back({"near", PipeBetween{{2.05, 0, 0}, {2.05, 0, 9}, 1}});
  assembly.parts.push_back({"across", PipeBetween{{10, 35, 5}, {20, 35, 5}, 1}});
  const Certificate found = certify(assembly);
  EXPECT_EQ(found.apart, 0.1) << "twice the tolerance";
  EXPECT_FALSE(found.axes) << "parts lie along the axes of coordinates";
  EXPECT_EQ(found.findings(), 0U);
  ASSERT_EQ(found.clearances.size(), 1U);
  EXPECT_EQ(found.parts[found.clearances[0].second].name, "near");
  EXPECT_GE(found.clearances[0].distance, .9 * .05);
  EXPECT_NO_THROW(verify(found));
  const Certificate wider = certify(assembly, {.apart = 7.9}),
                    all = certify(assembly, {.apart = 0});
  EXPECT_GT(wider.clearances.size(), 4U);
  EXPECT_EQ(all.clearances.size(), 83U * 82 / 2);
  EXPECT_NO_THROW(verify(wider));
  EXPECT_NO_THROW(verify(all));
  EXPECT_THROW(static_cast<void>(certify(assembly, {.apart = -1})), Error);
  EXPECT_EQ(certify(field_of_pipes(8)).apart, 0) << "all pairs of 64";
}

}  // namespace
}  // namespace dupin
