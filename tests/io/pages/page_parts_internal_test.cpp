#include <gtest/gtest.h>

#include "pages/page_parts.h"
#include "support/shapes.h"

namespace dupin::pages {
namespace {

TEST(PageParts, own_the_labels_that_begin_with_their_name) {
  TriMesh mesh;
  mesh.names = {"run", "run.start", "run.bore.end", "runner", "hub.1", "hub", "lid", "", "unused"};
  mesh.labels = {0, 1, 2, 3, 4, 5, 6, 7};
  const auto parts =
      page_parts(mesh, {{"hub", "junction"}, {"run", "pipe"}, {"hub.1", "pipe"}, {"gone", "pipe"}});
  ASSERT_EQ(parts.size(), 7);
  using Labels = std::vector<std::uint32_t>;
  EXPECT_EQ(parts[0].labels, (Labels{5, 8}));
  EXPECT_EQ(parts[1].labels, (Labels{0, 1, 2}));
  EXPECT_EQ(parts[2].labels, Labels{4});
  EXPECT_TRUE(parts[3].labels.empty());
  EXPECT_EQ(parts[4].name, "runner");
  EXPECT_EQ(parts[4].labels, Labels{3});
  EXPECT_EQ(parts[5].name, "lid");
  EXPECT_EQ(parts[6].name, "(no name)");
}

TEST(PageParts, of_a_mesh_without_names_are_one) {
  const auto parts = page_parts(test::box({0, 0, 0}, {1, 1, 1}), {});
  ASSERT_EQ(parts.size(), 1);
  EXPECT_EQ(parts[0].labels, std::vector<std::uint32_t>{0});
}

}  // namespace
}  // namespace dupin::pages
