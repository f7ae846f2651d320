#include <gtest/gtest.h>

#include "io/occt/body_shapes_internal.h"
#include "occt/body_booleans.h"

namespace dupin::occt {
namespace {

TEST(BodyBooleans, keep_the_labels_of_faces) {
  const LabelledShape made = united({{bent_pipe(), branch()}, {}});
  EXPECT_TRUE(is_valid(made.shape));
  std::set<std::uint32_t> labels;
  for (FaceLabels::Iterator face(made.labels); face.More(); face.Next()) {
    labels.insert(face.Value());
  }
  EXPECT_EQ(labels, (std::set<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7}));
}

TEST(BodyBooleans, fillets_add_to_both) {
  const exchange::BodyUnion sharp{{bent_pipe(), branch()}, {}};
  exchange::BodyUnion round = sharp;
  round.fillets = {{"round", 8, {2, 5}, 0.2}};
  const LabelledShape made = united(round);
  EXPECT_TRUE(is_valid(made.shape));
  EXPECT_GT(volume(made.shape), volume(united(sharp).shape));
  round.fillets.front().between = {0, 5};  // which do not meet
  try {
    (void)united(round);
    FAIL();
  } catch (const Refusal& refusal) {
    EXPECT_EQ(refusal.at(), "round");
  }
}

}  // namespace
}  // namespace dupin::occt
