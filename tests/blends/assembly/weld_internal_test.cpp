#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/weld.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/solid.h"

namespace dupin::assembly {
namespace {

using testing::ElementsAre;

const RingSampling kSquare{4, 0, 0};

// A pipe "a" of radius 2 from z = 0 to 3, a cone "b" of radius 1 at z = 5 on it, whose end is a
// cap "lid", and a sphere "c" by itself.
ResolvedAssembly example() {
  const auto at = [](double z) { return Vec3(0, 0, z); };
  const auto tube = [&](double from, double to, double start, double end) {
    return RingedSurface{{at(from), at(-1), start},
                         {at(to), at(1), end},
                         LineSpine{at(from), at(to)},
                         LinearRadius{start, end}};
  };
  ResolvedAssembly assembly;
  assembly.parts.resize(3);
  assembly.parts[0].name = "a";
  assembly.parts[0].shape = tube(0, 3, 2, 2);
  assembly.parts[0].joined[1] = EndIndex{1, End::start};
  assembly.parts[0].end_names = {"a.start", "a.end"};
  assembly.parts[1].name = "b";
  assembly.parts[1].shape = tube(3, 5, 2, 1);
  assembly.parts[1].joined[0] = EndIndex{0, End::end};
  assembly.parts[1].end_names = {"b.start", "lid"};
  assembly.parts[2].name = "c";
  assembly.parts[2].shape = Sphere{Vec3(9, 9, 9), 1};
  assembly.parts[2].end_names = {"c.start", "c.end"};
  return assembly;
}

TriMesh welded_parts(const std::vector<std::uint32_t>& parts) {
  const ResolvedAssembly assembly = example();
  std::vector<TriMesh> tubes;
  for (const ResolvedPart& part : assembly.parts) {
    tubes.push_back(
        std::visit([](const auto& shape) { return tessellate(shape, kSquare).mesh; }, part.shape));
  }
  return welded(assembly, parts, tubes, kSquare, BuriedEnds(assembly), {}, {});
}

// Of the triangles with a label, by names.
std::map<std::string, std::size_t> counts(const TriMesh& mesh) {
  std::map<std::string, std::size_t> result;
  for (const std::uint32_t label : mesh.labels) {
    ++result[mesh.names.at(label)];
  }
  return result;
}

TEST(Weld, parts_share_the_vertices_of_their_ring) {
  for (const std::vector<std::uint32_t>& parts : {std::vector{0U, 1U}, std::vector{1U, 0U}}) {
    const TriMesh mesh = welded_parts(parts);
    EXPECT_TRUE(check(mesh).is_solid());
    EXPECT_EQ(mesh.points.size(), 3 * 4U);
    EXPECT_EQ(mesh.triangles.size(), 2 * 8 + 2 * 2U);
    // A square prism, and a frustum of a square pyramid: of diagonals 4 and 2.
    EXPECT_NEAR(Solid::from(mesh).volume(), 8 * 3 + 2.0 / 3 * (8 + 4 + 2), 1e-12);
    EXPECT_EQ(counts(mesh),
              (std::map<std::string, std::size_t>{{"a", 8}, {"a.start", 2}, {"b", 8}, {"lid", 2}}));
  }
}

// Where a neighbour is not welded to it, the disc will be inside the union with it and belongs to
// the part.
TEST(Weld, each_end_without_a_neighbour_gets_a_disc) {
  const TriMesh pipe = welded_parts({0}), cone = welded_parts({1});
  EXPECT_NEAR(Solid::from(pipe).volume(), 8 * 3, 1e-12);
  EXPECT_NEAR(Solid::from(cone).volume(), 2.0 / 3 * (8 + 4 + 2), 1e-12);
  EXPECT_EQ(counts(pipe), (std::map<std::string, std::size_t>{{"a", 8 + 2}, {"a.start", 2}}));
  EXPECT_EQ(counts(cone), (std::map<std::string, std::size_t>{{"b", 8 + 2}, {"lid", 2}}));
}

TEST(Weld, closed_parts_have_no_discs) {
  const TriMesh ball = welded_parts({2});
  EXPECT_TRUE(check(ball).is_solid());
  EXPECT_THAT(counts(ball), ElementsAre(testing::Pair("c", ball.triangles.size())));
}

// A hollow chain's mesh has labels for its skins and its rims.
TEST(Weld, closed_parts_may_have_ends) {
  ResolvedAssembly assembly;
  assembly.parts.resize(1);
  assembly.parts[0].name = "shell";
  assembly.parts[0].shape = Sphere{Vec3::Zero(), 1};
  assembly.parts[0].end_names = {"shell.start", "shell.end"};
  const TriMesh labelled{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
                         {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}},
                         {2, 0, 0, 1},
                         {"skins", "start", "end"}};
  const TriMesh mesh =
      welded(assembly, std::vector{0U}, {labelled}, kSquare, BuriedEnds(assembly), {}, {});
  EXPECT_EQ(mesh.triangles, labelled.triangles);
  std::vector<std::string> names;
  for (const std::uint32_t label : mesh.labels) {
    names.push_back(mesh.names.at(label));
  }
  EXPECT_THAT(names, ElementsAre("shell.end", "shell", "shell", "shell.start"));
}

TEST(Weld, a_mesh_falls_into_its_connected_parts) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.points.emplace_back(i, 0, 0);
  }
  mesh.names = {"x", "y"};
  mesh.triangles = {{5, 6, 7}, {0, 1, 2}, {7, 6, 4}, {2, 1, 3}};
  mesh.labels = {1, 0, 0, 1};
  const std::vector<TriMesh> parts = connected_parts(mesh);
  ASSERT_EQ(parts.size(), 2U);
  const std::vector<std::vector<double>> places[] = {{{5, 6, 7}, {7, 6, 4}},
                                                     {{0, 1, 2}, {2, 1, 3}}};
  const std::vector<std::uint32_t> labels[] = {{1, 0}, {0, 1}};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(parts[i].points.size(), 4U);
    EXPECT_EQ(parts[i].labels, labels[i]);
    EXPECT_EQ(parts[i].names, mesh.names);
    ASSERT_EQ(parts[i].triangles.size(), 2U);
    for (std::size_t t = 0; t < 2; ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(parts[i].points.at(parts[i].triangles[t][k]).x(), places[i][t][k]);
      }
    }
  }
  EXPECT_TRUE(connected_parts({}).empty());
}

}  // namespace
}  // namespace dupin::assembly
