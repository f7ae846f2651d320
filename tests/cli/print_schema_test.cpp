#include <string>

#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/schema.h"

namespace dupin::test {
namespace {

using Schema = Tool;

TEST_F(Schema, is_printed_as_it_is_in_the_sources) {
  EXPECT_EQ(dupin({"schema"}).out, assembly_schema());
  EXPECT_EQ(dupin({"schema", "assembly"}).out, assembly_schema());
  EXPECT_EQ(dupin({"schema", "certificate"}).out, certificate_schema());
  EXPECT_EQ(dupin({"schema", "mesh"}).exit_code, 2);
}

}  // namespace
}  // namespace dupin::test
