#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "exchange/module_loader.h"

namespace dupin::exchange {
namespace {

TEST(ModuleLoader, finds_the_module_or_says_what_to_install) {
  std::string why;
  if (const Module* const module = find_module(&why)) {
    EXPECT_EQ(&loaded_module(), module);
    EXPECT_TRUE(why.empty());
    return;
  }
  try {
    (void)loaded_module();
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    EXPECT_THAT(error.message(), testing::HasSubstr("libocct-data-exchange-dev"));
  }
}

}  // namespace
}  // namespace dupin::exchange
