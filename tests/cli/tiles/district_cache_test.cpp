#include "tiles/district_cache.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

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

TEST(DistrictCache, believes_no_file_that_it_did_not_write_under_the_key) {
  const test::TemporaryFolder folder;
  const DistrictCache cache(folder.path());
  cache.keep("a", "of a");
  cache.keep("b", "of b");
  std::filesystem::copy_file(folder.path() / "a", folder.path() / "b",
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(cache.find("b"), std::nullopt);
  EXPECT_EQ(cache.find("a"), "of a");
  std::filesystem::create_directory(folder.path() / "c");
  EXPECT_EQ(cache.find("c"), std::nullopt);
  folder.write("d", "");
  EXPECT_EQ(cache.find("d"), std::nullopt);
  cache.keep("b", "of b again");
  EXPECT_EQ(cache.find("b"), "of b again");
}

TEST(DistrictCache, drops_what_was_not_used_for_longest) {
  const test::TemporaryFolder folder;
  const DistrictCache cache(folder.path() / "cache");
  const auto age = [&](const std::string& name, int hours) {
    std::filesystem::last_write_time(
        folder.path() / "cache" / name,
        std::filesystem::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  for (const auto& [key, hours] : {std::pair("a", 4), {"b", 3}, {"c", 2}, {"d", 1}}) {
    cache.keep(key, std::string(100, 'x'));
    age(key, hours);
  }
  for (const auto& [name, hours] : {std::pair("killed.1-0.part", 30), {"running.2-0.part", 1}}) {
    folder.write(std::string("cache/") + name, "half");
    age(name, hours);
  }
  EXPECT_TRUE(cache.find("a")) << "and so it is used now";
  cache.trim(250);
  EXPECT_TRUE(cache.find("a"));
  EXPECT_FALSE(cache.find("b"));
  EXPECT_FALSE(cache.find("c"));
  EXPECT_TRUE(cache.find("d"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "cache" / "killed.1-0.part"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "cache" / "running.2-0.part"));
  cache.trim(0);
  EXPECT_FALSE(cache.find("a"));
  EXPECT_NO_THROW(DistrictCache(folder.path() / "cache")) << "it is known as a cache still";
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
