#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/solid.h"
#include "support/shapes.h"

// Bodies that are there several times, faces of each turned: as many one way as the other or not,
// one of them is left.
namespace dupin {
namespace {

using test::box;
using test::joined;
using test::moved;
using test::tetrahedron;

mpq_class repaired_volume(const TriMesh& mesh) { return repair(mesh).solid.exact_volume(); }

// Those faces turned whose bits are set.
TriMesh turned(TriMesh mesh, std::uint32_t faces) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if ((faces >> i & 1) != 0) {
      std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
    }
  }
  return mesh;
}

TEST(TiedCopies, of_two_tetrahedra_in_one_place_one_is_left_whichever_faces_are_turned) {
  const TriMesh one = tetrahedron({0, 0, 0}, 2), beside = tetrahedron({9, 0, 0}, 2);
  const mpq_class volume = Solid::from(one).exact_volume();
  for (std::uint32_t first = 0; first < 16; ++first) {
    for (std::uint32_t second = 0; second < 16; ++second) {
      SCOPED_TRACE(testing::Message() << first << ' ' << second);
      const TriMesh both = joined({turned(one, first), turned(one, second)});
      EXPECT_EQ(repaired_volume(both), volume);
      EXPECT_EQ(repaired_volume(joined({beside, both})), 2 * volume);
    }
  }
}

TEST(TiedCopies, of_boxes_in_one_place_one_is_left_whichever_faces_are_turned) {
  std::mt19937 random(31);
  const TriMesh one = box({0, 0, 0}, {1, 1, 1});
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    const auto faces = static_cast<std::uint32_t>(random());
    EXPECT_EQ(repaired_volume(joined({turned(one, faces), turned(one, faces)})), 1);
    std::vector<TriMesh> copies;
    for (int i = 0; i < 2 + round % 3; ++i) {
      copies.push_back(turned(one, static_cast<std::uint32_t>(random())));
    }
    EXPECT_EQ(repaired_volume(joined(copies)), 1);
  }
}

// A corner, an edge and a side in common: what hangs together is more than the one.
TEST(TiedCopies, of_a_body_that_touches_another_one_is_left_whichever_faces_are_turned) {
  std::mt19937 random(32);
  const TriMesh one = box({0, 0, 0}, {1, 1, 1});
  for (const Vec3& low : {Vec3(1, 1, 1), Vec3(1, 1, 0), Vec3(1, 0, 0)}) {
    const TriMesh other = box(low, low + Vec3::Ones());
    for (int round = 0; round < 200; ++round) {
      SCOPED_TRACE(testing::Message() << low.transpose() << ' ' << round);
      const auto faces = static_cast<std::uint32_t>(random());
      const TriMesh twice = joined({turned(one, faces), turned(one, faces)});
      EXPECT_EQ(repaired_volume(joined({twice, other})), 2);
    }
  }
}

// Over and under one base: the wall between them is there as often as both are.
TEST(TiedCopies, of_bodies_with_a_face_in_common_one_each_is_left_whichever_faces_are_turned) {
  std::mt19937 random(33);
  TriMesh over = tetrahedron({0, 0, 0}, 2), under = test::reversed(over);
  under.points[3].z() = -2;
  const mpq_class volume = 2 * Solid::from(over).exact_volume();
  for (int round = 0; round < 500; ++round) {
    SCOPED_TRACE(round);
    std::vector<TriMesh> meshes;
    for (const TriMesh& body : {over, under}) {
      const auto faces = static_cast<std::uint32_t>(random());
      meshes.push_back(turned(body, faces));
      for (int i = round % 3; i > 0; --i) {
        meshes.push_back(turned(body, faces));
      }
    }
    EXPECT_EQ(repaired_volume(joined(meshes)), volume);
  }
}

// Bodies over one base that cross beside it: of each the base has a copy, whichever way that is.
std::vector<TriMesh> bodies_over_one_base(std::mt19937& random, std::size_t count) {
  const auto coordinate = [&] { return static_cast<double>(random() % 8) - 2; };
  std::vector<TriMesh> bodies;
  while (bodies.size() < count) {
    TriMesh body = tetrahedron({0, 0, 0}, 4);
    body.points[3] = Vec3(coordinate(), coordinate(), coordinate());
    if (body.points[3].z() != 0) {
      bodies.push_back(body.points[3].z() > 0 ? body : test::reversed(body));
    }
  }
  return bodies;
}

mpq_class united_volume(std::span<const TriMesh> meshes) {
  std::vector<Solid> solids;
  for (const TriMesh& mesh : meshes) {
    solids.push_back(Solid::from(mesh));
  }
  return unite(solids).exact_volume();
}

TEST(TiedCopies, of_bodies_over_one_base_none_is_lost_whichever_faces_are_turned) {
  std::mt19937 random(34);
  for (int round = 0; round < 1000; ++round) {
    SCOPED_TRACE(round);
    const auto bodies = bodies_over_one_base(random, 2 + static_cast<std::size_t>(round % 4));
    std::vector<TriMesh> meshes;
    for (const TriMesh& body : bodies) {
      meshes.push_back(turned(body, static_cast<std::uint32_t>(random() & random())));
    }
    EXPECT_EQ(repaired_volume(joined(meshes)), united_volume(bodies));
  }
}

// What is inside another as a whole, and inside out, is a cavity of it.
TEST(TiedCopies, of_bodies_over_one_base_none_is_lost_whichever_are_inside_out) {
  std::mt19937 random(35);
  for (int round = 0; round < 1000; ++round) {
    SCOPED_TRACE(round);
    const auto bodies = bodies_over_one_base(random, 2 + static_cast<std::size_t>(round % 4));
    std::vector<TriMesh> meshes;
    for (const TriMesh& body : bodies) {
      meshes.push_back(random() % 2 == 0 ? body : test::reversed(body));
    }
    const Repaired repaired = repair(joined(meshes));
    if (repaired.report.cavities == 0) {
      EXPECT_EQ(repaired.solid.exact_volume(), united_volume(bodies));
    }
  }
}

// They are no copies, but bound the same: neither is a cavity in the other.
TEST(TiedCopies, of_boxes_in_one_place_with_other_diagonals_one_is_left_whichever_is_inside_out) {
  const TriMesh one = box({0, 0, 0}, {1, 1, 1}), other = test::cut_otherwise(one);
  const TriMesh around = box({-1, -1, -1}, {2, 2, 2});
  for (const TriMesh& first : {one, test::reversed(one)}) {
    for (const TriMesh& second : {other, test::reversed(other)}) {
      EXPECT_EQ(repaired_volume(joined({first, second})), 1);
      EXPECT_EQ(repaired_volume(joined({first, second, moved(one, Vec3(5, 0, 0))})), 2);
    }
  }
  // A cavity that is there twice is one.
  EXPECT_EQ(repaired_volume(joined({around, test::reversed(one), test::reversed(other)})), 26);
}

}  // namespace
}  // namespace dupin
