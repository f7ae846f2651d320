#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/tiles/facet_scene.h"
#include "tiles/shell_parts.h"

namespace dupin::tiles {
namespace {

using testing::ElementsAre;

ShellPart part(std::uint32_t first_face, std::size_t triangles, int volume) {
  ShellPart result;
  result.first_face = first_face;
  result.triangles = triangles;
  result.volume = volume;
  result.test_face = first_face;
  result.test_cost = 1;
  return result;
}

TEST(ShellParts, are_put_together_in_order_of_first_face) {
  ShellParts parts;
  parts.add(part(9, 2, 5));
  parts.add(part(4, 1, 7));
  parts.add(part(2, 3, -1));
  parts.add(part(7, 1, 1));
  parts.unite(3, 0);
  parts.unite(2, 0);
  const JoinedShells joined = std::move(parts).joined();
  ASSERT_EQ(joined.shells.size(), 2);
  EXPECT_THAT(joined.of_part, ElementsAre(0, 1, 0, 0));
  EXPECT_EQ(joined.shells[0].first_face, 2);
  EXPECT_EQ(joined.shells[0].triangles, 6);
  EXPECT_EQ(joined.shells[0].volume, 5);
  EXPECT_EQ(joined.shells[0].test_face, 2) << "the lowest of those that cost as much";
  EXPECT_EQ(joined.shells[1].volume, 7);
}

ShellPart shell_of(const std::vector<Facet>& facets) {
  ShellPart result = part(0, facets.size(), 1);
  for (const Facet& facet : facets) {
    for (std::size_t k = 0; k < 9; k += 3) {
      result.box.extend(Eigen::Vector3f(facet[k], facet[k + 1], facet[k + 2]));
    }
  }
  result.test_facet = facets.front();
  return result;
}

TEST(ShellDepths, are_known_where_boxes_do_not_nest_and_else_counted) {
  std::vector<std::vector<Facet>> facets(4);
  test::append_facets(test::box({0, 0, 0}, {9, 9, 9}), facets[0]);
  test::append_facets(test::box({1, 1, 1}, {8, 8, 8}), facets[1]);
  test::append_facets(test::box({2, 2, 2}, {3, 3, 3}), facets[2]);
  test::append_facets(test::box({20, 2, 2}, {23, 3, 3}), facets[3]);
  std::vector<ShellPart> shells;
  for (const auto& own : facets) {
    shells.push_back(shell_of(own));
  }
  EXPECT_TRUE(ShellDepths(std::span(shells).subspan(2)).are_known());
  ShellDepths depths(shells);
  EXPECT_FALSE(depths.are_known());
  for (std::size_t i = 12; i-- > 0;) {
    for (std::uint32_t shell = 0; shell < 4; ++shell) {
      depths.add(shell, facets[shell][i]);
    }
  }
  EXPECT_THAT(depths.depths(), ElementsAre(0, 1, 2, 0));
}

}  // namespace
}  // namespace dupin::tiles
