#include <string>

#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/kernel/error.h"
#include "files/placed_file.h"
#include "support/scratch_directory.h"
#include "support/thread_processes.h"

namespace dupin::files {
namespace {

using PlacedFiles = test::ScratchDirectory;

TEST_F(PlacedFiles, take_bytes_in_any_order) {
  PlacedFile file(path("x"), nullptr);
  file.write(9, "behind");
  file.write(5, "what");
  file.write(15, "");
  EXPECT_FALSE(std::filesystem::exists(path("x")));
  file.commit("first");
  EXPECT_EQ(read_file(path("x")), "firstwhatbehind");
}

TEST_F(PlacedFiles, are_written_by_all_processes) {
  const std::string mine(3'000'000, 'x');
  for (const std::size_t count : {1, 2, 4}) {
    test::ThreadProcesses::run(count, [&](const Processes& processes) {
      PlacedFile file(path("x"), &processes);
      file.write(5 + mine.size() * processes.own(), mine);
      EXPECT_FALSE(std::filesystem::exists(path("x")));
      file.commit("first");
      EXPECT_TRUE(std::filesystem::exists(path("x")));
    });
    std::string expected = "first";
    for (std::size_t i = 0; i < count; ++i) {
      expected += mine;
    }
    EXPECT_TRUE(read_file(path("x")) == expected) << count;
    std::filesystem::remove(path("x"));
    EXPECT_TRUE(std::filesystem::is_empty(directory()));
  }
}

TEST_F(PlacedFiles, are_gone_when_any_process_has_ended_early) {
  test::ThreadProcesses::run(3, [&](const Processes& processes) {
    auto file = std::make_unique<PlacedFile>(path("x"), &processes);
    file->write(10, "y");
    (void)processes.exchanged({});
    if (processes.own() == 1) {
      file.reset();
      EXPECT_TRUE(std::filesystem::is_empty(directory()));
    }
    (void)processes.exchanged({});
  });
}

TEST_F(PlacedFiles, that_others_made_are_removed_with_ours) {
  const AsideFile made(path("x"), "bytes");
  { const AsideFile joined(path("x"), AsidePath{made.path()}); }
  EXPECT_TRUE(std::filesystem::is_empty(directory()));
}

TEST_F(PlacedFiles, begin_where_they_can_be_written) {
  EXPECT_THROW(PlacedFile(path("no/x"), nullptr), Error);
}

}  // namespace
}  // namespace dupin::files
