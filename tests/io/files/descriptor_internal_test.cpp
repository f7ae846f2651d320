#include <csignal>
#include <string>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "dupin/io/atomic_file.h"
#include "dupin/kernel/error.h"
#include "files/descriptor.h"
#include "support/message_of.h"
#include "support/scratch_directory.h"

namespace dupin {
namespace {

using WholeFiles = test::ScratchDirectory;

TEST_F(WholeFiles, what_does_not_end_is_not_read_for_ever) {
  const std::uint64_t most = 100'000;
  EXPECT_EQ(
      test::message_of([] { (void)files::read_whole("/dev/zero", most); }, Errc::limit_exceeded),
      "/dev/zero: is a pipe, a device or grows, and has not ended after 0.131072 MB; allowed "
      "are 0.1 MB, or a regular file of any size");
  write_file(path("large"), std::string(3 * most, 'x'));
  EXPECT_EQ(files::read_whole(path("large"), most).size(), 3 * most);
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  for (const std::size_t size : {most, 2 * most}) {
    std::thread writer([&] {  // that goes on until nobody reads
      ::signal(SIGPIPE, SIG_IGN);
      const int pipe = ::open(path("pipe").c_str(), O_WRONLY | O_CLOEXEC);
      const std::string bytes(size, 'x');
      (void)!::write(pipe, bytes.data(), bytes.size());
      ::close(pipe);
    });
    if (size == most) {
      EXPECT_EQ(files::read_whole(path("pipe"), most).size(), size);
    } else {
      EXPECT_THROW((void)files::read_whole(path("pipe"), most), Error);
    }
    writer.join();
  }
}

}  // namespace
}  // namespace dupin
