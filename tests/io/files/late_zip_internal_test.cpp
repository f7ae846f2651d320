#include <string>

#include <gtest/gtest.h>

#include "files/late_zip.h"

namespace dupin::files {
namespace {

TEST(LateZip, has_every_function_that_it_names) {
#define DUPIN_ZIP_EXPECT(name) EXPECT_NE(zip().name, nullptr) << #name;
  DUPIN_ZIP_FUNCTIONS(DUPIN_ZIP_EXPECT)
#undef DUPIN_ZIP_EXPECT
  zip_error_t error;
  zip().error_init(&error);
  EXPECT_EQ(std::string(zip().error_strerror(&error)), "No error");
  zip().error_fini(&error);
}

}  // namespace
}  // namespace dupin::files
