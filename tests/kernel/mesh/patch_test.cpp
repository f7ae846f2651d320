#include "dupin/kernel/patch.h"

#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "dupin/kernel/solid.h"
#include "support/message_of.h"
#include "support/shapes.h"

namespace dupin {
namespace {

TEST(Patches, measure_the_sides_of_a_box) {
  TriMesh box = test::box({1, 2, 3}, {3, 6, 10});
  box.names = {"unused", "top", "rest"};
  box.labels.reserve(box.triangles.size());
  for (const auto& [a, b, c] : box.triangles) {
    const bool is_top =
        box.points[a].z() == 10 && box.points[b].z() == 10 && box.points[c].z() == 10;
    box.labels.push_back(is_top ? 1 : 2);
  }
  const auto patches = patches_of(box);
  ASSERT_EQ(patches.size(), 2);  // none of a name that no triangle has
  EXPECT_EQ(patches[0].name, "top");
  EXPECT_EQ(patches[0].triangles, 2);
  EXPECT_DOUBLE_EQ(patches[0].area, 8);
  EXPECT_TRUE(patches[0].centroid.isApprox(Vec3(2, 4, 10), 1e-15));
  EXPECT_TRUE(patches[0].vector_area.isApprox(Vec3(0, 0, 8), 1e-15));
  EXPECT_EQ(patches[1].name, "rest");
  EXPECT_DOUBLE_EQ(patches[1].area, 2 * (2 * 7 + 4 * 7) + 8);
  EXPECT_TRUE(patches[1].vector_area.isApprox(Vec3(0, 0, -8), 1e-15));
}

TEST(Patches, without_labels_are_one) {
  const auto patches = patches_of(test::tube(2, 0, 5, 64));
  ASSERT_EQ(patches.size(), 1);
  EXPECT_EQ(patches[0].name, "");
  EXPECT_LT(patches[0].vector_area.norm(), 1e-13 * patches[0].area);
}

TEST(Patches, have_the_area_of_the_solid_together) {
  const TriMesh mesh = test::joined({test::labelled(test::tube(1, 0, 9, 100), "a"),
                                     test::labelled(test::tube(2, 20, 29, 100), "b")});
  const auto patches = patches_of(mesh);
  ASSERT_EQ(patches.size(), 2);
  EXPECT_NEAR(patches[0].area + patches[1].area, Solid::from(mesh).area(), 1e-12 * patches[1].area);
}

TEST(Patches, of_labels_without_a_name_or_a_triangle_are_refused) {
  const auto refusal = [](const TriMesh& mesh) {
    return test::message_of([&] { (void)patches_of(mesh); }, Errc::invalid_argument);
  };
  const TriMesh box = test::labelled(test::box(Vec3::Zero(), Vec3::Ones()), "box");
  TriMesh bad = box;
  bad.labels[3] = 1;
  EXPECT_EQ(refusal(bad), "face 3 has the label 1, but there are 1 names");
  bad = box;
  bad.names.clear();
  EXPECT_EQ(refusal(bad), "face 0 has the label 0, but there are 0 names");
  for (const std::size_t count : {1, 13}) {
    bad = box;
    bad.labels.resize(count, 0);
    EXPECT_EQ(refusal(bad), "there are " + std::to_string(count) +
                                " labels for 12 triangles; give one for each, or none");
  }
  bad = box;
  bad.triangles[5][1] = 8;
  EXPECT_EQ(refusal(bad), "face 5 has the corner 8, but there are 8 points");
}

TEST(ValidMesh, has_points_for_its_corners_and_names_for_its_labels) {
  const TriMesh box = test::labelled(test::box({0, 0, 0}, {1, 1, 1}), "box");
  EXPECT_NO_THROW(validate(box));
  EXPECT_NO_THROW(validate({}));

  TriMesh cornerless = box;
  cornerless.triangles[7][2] = 8;
  TriMesh unlabelled = box;
  unlabelled.labels.pop_back();
  TriMesh nameless = box;
  nameless.labels[3] = 1;
  for (const auto& [mesh, fault] : {std::pair(&cornerless, "face 7 has the corner 8"),
                                    std::pair(&unlabelled, "there are 11 labels for 12"),
                                    std::pair(&nameless, "face 3 has the label 1")}) {
    EXPECT_EQ(test::message_of([&] { require_indices(*mesh); }).find(fault), 0U);
    EXPECT_EQ(test::message_of([&] { validate(*mesh); }).find(fault), 0U);
  }
}

TEST(ValidMesh, has_finite_coordinates) {
  for (const double number :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    TriMesh box = test::box({0, 0, 0}, {1, 1, 1});
    box.points[5].y() = number;
    EXPECT_NO_THROW(require_indices(box));
    EXPECT_EQ(test::message_of([&] { validate(box); }),
              "point 5 has a coordinate that is not finite");
  }
}

}  // namespace
}  // namespace dupin
