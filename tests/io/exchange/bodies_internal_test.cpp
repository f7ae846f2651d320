#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"
#include "exchange/bodies.h"
#include "support/source_folder.h"

namespace dupin::exchange {
namespace {

Assembly example(const std::string& name) {
  return read_assembly(test::source_folder() / "examples" / (name + ".json"));
}

struct Made {
  BodyUnion bodies;
  std::vector<Label> labels;
  SurfaceCount count;
};

Made bodies(const Assembly& assembly, bool by_part) {
  Made made;
  Labels labels;
  made.bodies = bodies_of(assembly, resolve(assembly), 0.01, by_part, labels, made.count);
  made.labels = labels.coloured({}, {});
  return made;
}

TEST(Bodies, of_a_run_share_the_rings_between_parts) {
  const Made made = bodies(example("reducer"), false);
  ASSERT_EQ(made.bodies.bodies.size(), 1U);
  const Body& run = made.bodies.bodies.front();
  EXPECT_EQ(run.tubes.size(), 3U);
  EXPECT_EQ(run.rings.size(), 4U);
  EXPECT_EQ(run.discs.size(), 2U);
  EXPECT_EQ(made.count.exact, 4U);
  EXPECT_EQ(made.count.lofted, 1U);
  std::vector<std::string> names;
  for (const Label& label : made.labels) {
    names.push_back(label.name);
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("inlet", "outlet", "blend", "inlet.start",
                                                   "outlet.end"));
}

TEST(Bodies, by_part_close_every_end) {
  const Made made = bodies(example("reducer"), true);
  ASSERT_EQ(made.bodies.bodies.size(), 3U);
  for (const Body& body : made.bodies.bodies) {
    EXPECT_EQ(body.tubes.size(), 1U);
    EXPECT_EQ(body.discs.size(), 2U);
  }
  EXPECT_EQ(made.bodies.bodies[0].name, "inlet");
}

TEST(Bodies, of_a_junction_are_one_with_its_hub) {
  const Made made = bodies(example("junction"), false);
  ASSERT_EQ(made.bodies.bodies.size(), 1U);
  ASSERT_EQ(made.bodies.bodies.front().hubs.size(), 1U);
  EXPECT_EQ(made.bodies.bodies.front().hubs.front().rings.size(), 5U);
  EXPECT_EQ(made.bodies.bodies.front().discs.size(), 5U);
}

// Each piece closed by discs; of the ball what is beyond one disc and before the other, if any.
TEST(Bodies, of_pieces_with_kneecaps_have_sectors_of_balls) {
  const Made made = bodies(example("ucct-arm"), false);
  ASSERT_EQ(made.bodies.bodies.size(), 1U);
  const Body& run = made.bodies.bodies.front();
  EXPECT_EQ(run.discs.size(), 4U);
  ASSERT_EQ(run.sectors.size(), 1U);
  const BallSector& sector = run.sectors.front();
  EXPECT_EQ(sector.center, Vec3(4, 1, 0));
  EXPECT_EQ(sector.radius, 1);
  // A lune: what is left of the sphere is opposite its seam, and its corners are beside the poles.
  const Vec3 corner = sector.cuts[0].normal.cross(sector.cuts[1].normal).normalized();
  EXPECT_NEAR(sector.seam.dot(corner), 0, 1e-12);
  EXPECT_NEAR(sector.pole.dot(corner), 0, 1e-12);
  EXPECT_GT(sector.seam.dot(sector.cuts[0].normal), 0);
  EXPECT_GT(sector.seam.dot(sector.cuts[1].normal), 0);
}

// From the first part to the second, at most so far from the smooth surfaces.
TEST(Bodies, have_fillets_with_their_surfaces) {
  for (const auto& [name, surfaces, radius] :
       std::vector<std::tuple<std::string, std::size_t, std::optional<double>>>{
           {"tee", 1, 3}, {"equal-tee", 2, 4}, {"parallel-cone", 1, {}}}) {
    const Made made = bodies(example(name), false);
    ASSERT_EQ(made.bodies.fillets.size(), 1U) << name;
    EXPECT_EQ(made.bodies.fillets[0].surfaces.size(), surfaces) << name;
    EXPECT_EQ(made.bodies.fillets[0].radius, radius) << name;
    EXPECT_EQ(made.count.lofted, surfaces) << name;
    EXPECT_LE(made.count.error, 0.01) << name;
  }
}

TEST(Bodies, are_scaled_as_a_whole) {
  BodyUnion all = bodies(example("reducer"), false).bodies;
  const RingCurve before = all.bodies.front().rings.front();
  scale(all, 25.4);
  EXPECT_EQ(all.bodies.front().rings.front().first, 25.4 * before.first);
  EXPECT_EQ(all.bodies.front().rings.front().center, 25.4 * before.center);
  BodyUnion tee = bodies(example("tee"), false).bodies;
  const auto point = tee.fillets[0].surfaces[0].net[1][1];
  const double radius = *tee.fillets[0].radius;
  scale(tee, 25.4);
  EXPECT_EQ(tee.fillets[0].surfaces[0].net[1][1][0], 25.4 * point[0]);
  EXPECT_EQ(tee.fillets[0].surfaces[0].net[1][1][3], point[3]);
  EXPECT_EQ(*tee.fillets[0].radius, 25.4 * radius);
  BodyUnion arm = bodies(example("ucct-arm"), false).bodies;
  scale(arm, 25.4);
  const BallSector& sector = arm.bodies.front().sectors.front();
  EXPECT_EQ(sector.radius, 25.4);
  EXPECT_NEAR((sector.cuts[0].center - sector.center).norm(),
              std::sqrt(25.4 * 25.4 - sector.cuts[0].first * sector.cuts[0].first), 1e-9);
}

}  // namespace
}  // namespace dupin::exchange
