#include <string>

#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using MeshCommands = Tool;

TEST_F(MeshCommands, an_interrupt_ends_at_once_and_leaves_no_file) {
  const ProcessResult result = shell("timeout --preserve-status -s INT 0.5 " DUPIN_TOOL
                                     " convert - out.off < <(sleep 20); echo $?; ls -A");
  EXPECT_EQ(result.out, "130\nexamples\n");
  EXPECT_EQ(result.err, "dupin: interrupted\n");
}

}  // namespace
}  // namespace dupin::test
