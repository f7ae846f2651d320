#include "arrangement/piece_merging.h"
#include "kernel/arrangement/stages_internal.h"
#include "kernel/exact_validity_internal.h"

namespace dupin::arrangement {
namespace {

using test::cube;

mesh::ExactMesh united(const std::vector<const mesh::ExactMesh*>& operands) {
  return arrange_and_merge(operands, union_rule(operands.size()));
}

// Its triangles as sources of their own.
mesh::ExactMesh operand(const TriMesh& solid, std::uint32_t number) {
  mesh::ExactMesh mesh = Solid::from(solid).exact();
  for (std::uint32_t i = 0; i < mesh.sources.size(); ++i) {
    mesh.sources[i] = {number, i};
  }
  return mesh;
}

mpq_class volume(const mesh::ExactMesh& mesh) {
  return Solid(std::make_shared<const mesh::ExactMesh>(mesh)).exact_volume();
}

// Tetrahedra stand on a cube, and cut its lid into many pieces; then a box swallows them.
TEST(MergePieces, leaves_no_trace_of_cuts_that_are_gone) {
  const mesh::ExactMesh cube = operand(test::cube(0, 0, 0, 100), 0);
  std::vector<mesh::ExactMesh> parts;
  for (std::uint32_t i = 0; i < 10; ++i) {
    parts.push_back(operand(
        test::moved(test::slanted_tetrahedron(), Vec3(9.0 * i + 5, 7.0 * i + 12, 99)), i + 1));
  }
  std::vector<const mesh::ExactMesh*> operands = {&cube};
  for (const mesh::ExactMesh& part : parts) {
    operands.push_back(&part);
  }
  mesh::ExactMesh crowd = united(operands);
  EXPECT_GT(crowd.triangles.size(), 12U + 10U * 6U);
  std::vector<Source> sources = crowd.sources;
  for (Source& source : sources) {
    source = operands[source.operand]->sources[source.triangle];
  }
  crowd.sources = sources;
  for (const TriMesh& box :
       {test::box({1, 1, 98}, {99, 99, 120}), test::box({-1, 0, 90}, {101, 100, 120})}) {
    const mesh::ExactMesh lid = operand(box, 11);
    const mesh::ExactMesh straight = united({&cube, &lid}), detour = united({&crowd, &lid});
    EXPECT_EQ(detour.triangles.size(), straight.triangles.size());
    EXPECT_EQ(volume(detour), volume(straight));
    EXPECT_TRUE(test::is_closed_manifold(detour));
    EXPECT_EQ(test::self_intersections(detour), 0U);
  }
}

TEST(MergePieces, keeps_pieces_of_different_triangles_apart) {
  const mesh::ExactMesh low = operand(cube(0, 0, 0), 0), high = operand(cube(0, 0, 2), 1);
  const mesh::ExactMesh tower = united({&low, &high});
  EXPECT_EQ(tower.triangles.size(), 20U) << "flush, but of two cubes";
  EXPECT_EQ(volume(tower), 16);
}

// A cube along one of its edges, another at a vertex.
TEST(MergePieces, keeps_points_at_which_the_surface_touches_itself) {
  const std::vector<TriMesh> meshes = {cube(0, 0, 0, 8), cube(8, 8, 3), cube(-2, -2, -2)};
  std::vector<mesh::ExactMesh> parts;
  for (const TriMesh& solid : meshes) {
    parts.push_back(operand(solid, static_cast<std::uint32_t>(parts.size())));
  }
  const std::vector<const mesh::ExactMesh*> operands = {&parts[0], &parts[1], &parts[2]};
  const mesh::ExactMesh plain = arrange(operands, union_rule(3)), mesh = united(operands);
  EXPECT_EQ(mesh.contacts.size(), plain.contacts.size());
  EXPECT_FALSE(mesh.contacts.empty());
  EXPECT_TRUE(test::is_closed_manifold(mesh));
}

}  // namespace
}  // namespace dupin::arrangement
