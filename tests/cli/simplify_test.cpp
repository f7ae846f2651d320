#include <string>

#include <gtest/gtest.h>

#include "cli/tool.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using MeshCommands = Tool;

TEST_F(MeshCommands, simplify_leaves_fewer_triangles) {
  put("a.off", tube(10, 0, 50, 256));
  const auto before = json({"check", "a.off"}, 0);
  const auto report = json({"simplify", "a.off", "b.off", "--tolerance", "0.5mm"}, 0);
  const int left = report.at("check").at("triangles");
  EXPECT_LT(left, before.at("triangles").get<int>() / 4);
  EXPECT_EQ(report.at("simplification").at("removed_triangles"),
            before.at("triangles").get<int>() - left);
  EXPECT_LE(report.at("simplification").at("deviation"), 0.5);
  EXPECT_EQ(report.at("check").at("solid"), true);
}

}  // namespace
}  // namespace dupin::test
