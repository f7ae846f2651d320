#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "kernel/rounding/edits/edit_fixture_internal.h"
#include "kernel/torus.h"
#include "rounding/edits/vain_edits.h"

namespace dupin::rounding {
namespace {

TEST(VainEdits, are_refused_until_a_face_of_theirs_is_edited) {
  const std::array<std::uint32_t, 2> faces = {1, 2};
  const std::vector<Fault> faults = {{1, 5}, {2, 6}, {2, 7}};
  const TriedEdit flip{.kind = TriedEdit::Kind::flip, .what = 1, .how = 2};
  VainEdits vain;
  std::vector<std::uint64_t> last_edit(9, 0);
  last_edit[5] = 3;
  EXPECT_EQ(vain.faults_of(flip, faces, last_edit), 0);
  vain.refuse(flip, 3, faults);
  EXPECT_EQ(vain.faults_of(flip, faces, last_edit), 3);
  TriedEdit other = flip;
  other.how = 1;
  EXPECT_EQ(vain.faults_of(other, faces, last_edit), 0) << "of another edge";
  last_edit[8] = 4;
  EXPECT_EQ(vain.faults_of(flip, faces, last_edit), 3) << "a face that is not in it";
  for (const std::uint32_t face : {1, 2, 5, 6, 7}) {
    std::vector<std::uint64_t> edited = last_edit;
    edited[face] = 4;
    EXPECT_EQ(vain.faults_of(flip, faces, edited), 0) << face;
  }
  vain.refuse(flip, 4, std::span(faults).first(1));
  EXPECT_EQ(vain.faults_of(flip, faces, last_edit), 1) << "refused once more, for another reason";
  vain.clear();
  EXPECT_EQ(vain.faults_of(flip, faces, last_edit), 0);
}

TEST(VainEdits, of_points_tell_places) {
  const std::vector<Fault> faults = {{1, 5}};
  const std::array<std::uint32_t, 1> faces = {1};
  const std::vector<std::uint64_t> last_edit(9, 0);
  VainEdits vain;
  vain.refuse({.what = 4, .place = Vec3(1, 2, 3)}, 0, faults);
  EXPECT_EQ(vain.faults_of({.what = 4, .place = Vec3(1, 2, 3)}, faces, last_edit), 1);
  EXPECT_EQ(vain.faults_of({.what = 4, .place = Vec3(1, 3, 2)}, faces, last_edit), 0);
  EXPECT_EQ(vain.faults_of({.what = 5, .place = Vec3(1, 2, 3)}, faces, last_edit), 0);
}

// Each is tried three times, with others in between that change something, and decided as in a mesh
// that knows of none before.
TEST_F(Edit, is_decided_alike_however_often_it_was_tried) {
  take(test::torus(12, 24, 2, 1));
  std::mt19937 random(7);
  test::shake(shape, 0.25, random);
  const std::vector<std::uint8_t> all(shape.triangles.size(), 1);
  const auto placed = [&](std::span<const Vec3> points) {
    EditedMesh result = mesh();
    result.place(points);
    result.find_faults(all);
    return result;
  };
  rule = {FaultRule::fewer, 1e3};
  EditedMesh torus = placed(shape.points);
  int accepted = 0, refused = 0;
  const std::vector<Fault> faults = torus.faults();
  for (const Fault& fault : std::span(faults).first(std::min<std::size_t>(faults.size(), 24))) {
    const std::uint32_t v = shape.triangles[fault.first][0];
    const Vec3 start = torus.point(v);
    for (int i = 0; i < 18; ++i) {
      Vec3 place = start;
      place[i % 3] += i % 2 == 0 ? 0.125 : -0.125;
      const bool is_better = placed(torus.points()).move(v, place, rule);
      ASSERT_EQ(torus.move(v, place, rule), is_better) << v << ' ' << i;
      (is_better ? accepted : refused) += 1;
    }
  }
  EXPECT_GT(accepted, 3);
  EXPECT_GT(refused, 100);
  EXPECT_TRUE(torus.faults() == placed(torus.points()).faults());
}

TEST_F(Edit, that_is_refused_again_is_a_trial) {
  shape.points[0] = Vec3(0, 0, 5);
  EditedMesh tube = mesh();
  tube.find_faults(std::vector<std::uint8_t>(shape.triangles.size(), 1));
  const Vec3 worse(0, 0, 6);
  const std::uint64_t before = tube.trials();
  EXPECT_FALSE(tube.move(0, worse, {FaultRule::fewer, 10}));
  EXPECT_FALSE(tube.move(0, worse, {FaultRule::fewer, 10}));
  EXPECT_EQ(tube.trials(), before + 2) << "so that the search for edits ends when it did";
}

}  // namespace
}  // namespace dupin::rounding
