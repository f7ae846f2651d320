#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "arrangement/crowding.h"
#include "kernel/arrangement/stages_internal.h"
#include "support/pipe_cases.h"
#include "support/shapes.h"

namespace dupin::arrangement {
namespace {

bool is_crowded(const std::vector<TriMesh>& meshes) {
  const test::Stages stages(meshes);
  return crowded(stages.input, stages.candidates());
}
bool is_crowded(const char* name) { return is_crowded(test::pipe_case(name)); }

// Tetrahedra with a vertex in common, each across a part of all directions.
std::vector<TriMesh> around_a_point(std::size_t count) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<TriMesh> all;
  while (all.size() < count) {
    std::array<Vec3, 3> p;
    for (Vec3& point : p) {
      point = Vec3(coordinate(random), coordinate(random), coordinate(random));
    }
    if (p[0].cross(p[1]).dot(p[2]) < 0) {
      std::swap(p[0], p[1]);
    }
    TriMesh mesh;
    mesh.points = {Vec3::Zero(), p[0], p[1], p[2]};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    all.push_back(std::move(mesh));
  }
  return all;
}

TEST(Crowding, is_where_many_meet_each_other_in_one_place) {
  for (const char* name : {"star_12", "star_12_rot", "star_general_12", "coaxial_10"}) {
    EXPECT_TRUE(is_crowded(name)) << name;
  }
}

// Two of them meet in a handful of their triangles, of which a sample sees one in some of the pairs
// only. Arranged at once, 160 of these took twenty times as long as in steps.
TEST(Crowding, is_known_of_operands_of_few_triangles) {
  for (const std::size_t count : {60U, 80U, 160U, 240U}) {
    EXPECT_TRUE(is_crowded(around_a_point(count))) << count;
  }
  EXPECT_FALSE(is_crowded(around_a_point(12)));
}

// Around a box in the middle of a row there are as many as overlap it, of which some are taken, the
// same whatever the order; around those of a shorter row there are too few.
TEST(Crowding, samples_are_of_places) {
  std::vector<TriMesh> row;
  for (int i = 0; i < 200; ++i) {
    row.push_back(test::box(Vec3(i, i % 3, 0), Vec3(i + 30.5, 4, 1)));
  }
  const auto places = [](const std::vector<TriMesh>& meshes) {
    std::vector<std::set<double>> low;
    std::vector<double> times;
    const test::Stages stages(meshes);
    for (const OperandSample& sample : samples_around(stages.input, 15)) {
      std::set<double>& of_sample = low.emplace_back();
      for (const std::uint32_t operand : sample.operands) {
        of_sample.insert(meshes[operand].points[0].x());
      }
      times.push_back(sample.times);
    }
    return std::pair(low, times);
  };
  const auto [low, times] = places(row);
  ASSERT_EQ(low.size(), 2U);
  EXPECT_DOUBLE_EQ(times.at(0), 55.0 / 15) << "near an end";
  EXPECT_DOUBLE_EQ(times.at(1), 60.0 / 15);
  for (const std::set<double>& of_sample : low) {
    EXPECT_EQ(of_sample.size(), 16U);
    EXPECT_GT(*of_sample.rbegin() - *of_sample.begin(), 50);
  }
  std::mt19937 random(8);
  std::shuffle(row.begin(), row.end(), random);
  EXPECT_EQ(places(row), std::pair(low, times));
  row.resize(20);
  EXPECT_TRUE(samples_around(test::Stages(row).input, 15).empty());
}

// A few operands are, by the points in their faces, not by what meets in a line or has one plane.
TEST(Crowding, of_faces_is_where_their_cuts_cross) {
  const auto is = [](const char* name) {
    const test::Stages stages(test::pipe_case(name));
    return are_faces_crowded(stages.input, stages.candidates());
  };
  for (const char* name : {"coaxial_6", "coaxial_8_rot", "coaxial_9"}) {
    EXPECT_TRUE(is(name)) << name;
  }
  for (const char* name : {"coaxial_4", "coaxial_flush_9", "star_9", "star_9_rot", "star_general_9",
                           "rack_eq_small", "coaxial_10"}) {
    EXPECT_FALSE(is(name)) << name;
  }
}

// However many cross each other in places apart; boxes of turned racks overlap all over.
TEST(Crowding, is_not_where_few_meet_the_same) {
  for (const char* name :
       {"star_5", "coaxial_5", "rack_eq_small", "rack_eq_small_rot", "header_10", "chain_10_fan"}) {
    EXPECT_FALSE(is_crowded(name)) << name;
  }
}

}  // namespace
}  // namespace dupin::arrangement
