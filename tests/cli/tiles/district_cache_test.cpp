#include "district_cache.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exit_code.h"
#include "support/process.h"

namespace dupin::cli {
namespace {

using testing::HasSubstr;

TEST(DistrictCache, keeps_what_it_is_given) {
  const test::TemporaryFolder folder;
  const DistrictCache cache(folder.path() / "a" / "b");
  EXPECT_EQ(cache.find("key"), std::nullopt);
  cache.keep("key", std::string("one\0two", 7));
  EXPECT_EQ(cache.find("key"), std::string("one\0two", 7));
  cache.keep("key", "three");
  EXPECT_EQ(DistrictCache(folder.path() / "a" / "b").find("key"), "three");
}

TEST(DistrictCache, takes_no_folder_of_others) {
  const test::TemporaryFolder folder;
  folder.write("thesis.tex", "");
  try {
    const DistrictCache cache(folder.path());
    FAIL();
  } catch (const OutputError& error) {
    EXPECT_THAT(error.message(), HasSubstr("other things"));
    EXPECT_EQ(error.where(), folder.path().string());
  }
}

TEST(DistrictCache, says_what_the_system_refuses) {
  const test::TemporaryFolder folder;
  folder.write("file", "");
  EXPECT_THROW(DistrictCache(folder.path() / "file" / "cache"), OutputError);
  const DistrictCache cache(folder.path() / "cache");
  std::filesystem::remove_all(folder.path() / "cache");
  EXPECT_THROW(cache.keep("key", "bytes"), OutputError);
}

}  // namespace
}  // namespace dupin::cli
