#include "tiles/district_cache.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "dupin/io/sha256.h"
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

TEST(DistrictCache, notes_what_is_unusable_and_never_fails_because_of_it) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "cache";
  const DistrictCache cache(path);
  EXPECT_EQ(cache.warning(), "");
  EXPECT_EQ(cache.find("none"), std::nullopt);
  EXPECT_EQ(cache.warning(), "") << "what is not there is no fault";
  for (const std::string key : {"shorter", "longer", "huge", "fifo"}) {
    cache.keep(key, "bytes of " + key);
  }
  std::filesystem::resize_file(path / "shorter", 30);
  std::filesystem::resize_file(path / "longer", 200);
  std::filesystem::resize_file(path / "huge", std::uintmax_t{1} << 38U);  // more than memory
  std::filesystem::remove(path / "fifo");
  ASSERT_EQ(::mkfifo((path / "fifo").c_str(), 0600), 0);
  std::filesystem::create_symlink("loop", path / "loop");
  std::filesystem::create_symlink("nowhere", path / "dangling");
  for (const std::string key : {"shorter", "longer", "huge", "fifo", "loop", "dangling"}) {
    const DistrictCache other(path);
    EXPECT_EQ(other.find(key), std::nullopt) << key;
    EXPECT_THAT(other.warning(), HasSubstr((path / key).string()));
    other.keep(key, "again");
    EXPECT_EQ(other.find(key), "again") << key;
  }
  std::filesystem::create_directories(path / "folder" / "with.more");
  EXPECT_EQ(cache.find("folder"), std::nullopt);
  EXPECT_NO_THROW(cache.keep("folder", "bytes"));
  EXPECT_THAT(cache.warning(), HasSubstr("folder"));
  EXPECT_TRUE(std::filesystem::exists(path / "folder" / "with.more"));
  cache.trim(1000);
  EXPECT_EQ(cache.find("loop"), "again") << "a folder counts for nothing";
}

// Several builds may begin at once, or be killed at any moment.
TEST(DistrictCache, is_made_by_many_at_once) {
  for (int round = 0; round < 50; ++round) {
    const test::TemporaryFolder folder;
    std::atomic<int> failures{0};
    {
      std::vector<std::jthread> threads;
      for (int i = 0; i < 4; ++i) {
        threads.emplace_back([&, i] {
          try {
            const DistrictCache cache(folder.path() / "cache");
            cache.keep("key" + std::to_string(i), "bytes");
          } catch (const OutputError&) {
            ++failures;
          }
        });
      }
    }
    EXPECT_EQ(failures, 0);
  }
  const test::TemporaryFolder folder;
  folder.write("dupin-cache.17-0.part", "");  // of one that was killed at once
  EXPECT_NO_THROW(DistrictCache(folder.path()));
}

TEST(DistrictCache, drops_what_was_not_used_for_longest) {
  const test::TemporaryFolder folder;
  const DistrictCache cache(folder.path() / "cache");
  const std::string a = sha256("a"), b = sha256("b"), c = sha256("c"), d = sha256("d"),
                    killed = a + ".1-0.part", running = a + ".2-0.part";
  const auto age = [&](const std::string& name, int hours) {
    std::filesystem::last_write_time(
        folder.path() / "cache" / name,
        std::filesystem::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  for (const auto& [key, hours] : {std::pair(a, 4), {b, 3}, {c, 2}, {d, 1}}) {
    cache.keep(key, std::string(100, 'x'));
    age(key, hours);
  }
  for (const auto& [name, hours] : {std::pair(killed, 30), {running, 1}}) {
    folder.write("cache/" + name, "half");
    age(name, hours);
  }
  EXPECT_TRUE(cache.find(a)) << "and so it is used now";
  cache.trim(400);  // of two, with their headings
  EXPECT_TRUE(cache.find(a));
  EXPECT_FALSE(cache.find(b));
  EXPECT_FALSE(cache.find(c));
  EXPECT_TRUE(cache.find(d));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "cache" / killed));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "cache" / running));
  cache.trim(0);
  EXPECT_FALSE(cache.find(a));
  EXPECT_NO_THROW(DistrictCache(folder.path() / "cache")) << "it is known as a cache still";
}

TEST(DistrictCache, leaves_what_is_not_its_own) {
  const test::TemporaryFolder folder;
  const DistrictCache cache(folder.path() / "cache");
  const std::string digest = sha256("x");
  const std::vector<std::string> others{"plant.json",    "plant.stl",      "old.part",
                                        digest + ".stl", digest.substr(1), digest + "0"};
  for (const std::string& name : others) {
    folder.write("cache/" + name, "precious");
    std::filesystem::last_write_time(
        folder.path() / "cache" / name,
        std::filesystem::file_time_type::clock::now() - std::chrono::hours(48));
  }
  cache.keep(digest, "bytes");
  cache.trim(0);
  EXPECT_FALSE(cache.find(digest));
  for (const std::string& name : others) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "cache" / name)) << name;
  }
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
