#include "interrupt.h"

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/tool.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/report_json.h"
#include "dupin/kernel/error.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using MeshCommands = Tool;
using Interrupt = Tool;

constexpr int kOtherHandler = 77;  // a sanitiser's

/// How a process ends that gets a signal between writing its file aside and renaming it, or after.
int ended(const std::filesystem::path& file, int number, bool is_committed) {
  const pid_t child = ::fork();
  if (child == 0) {
    struct sigaction before {};
    ::sigaction(number, nullptr, &before);
    if (before.sa_handler != SIG_DFL) {
      ::_exit(kOtherHandler);
    }
    ::close(STDERR_FILENO);
    cli::end_on_signals();
    AsideFile aside(file, "bytes");
    if (is_committed) {
      aside.commit();
    }
    ::raise(number);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST_F(Interrupt, no_signal_that_can_be_caught_leaves_a_file_aside) {
  for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGALRM, SIGTERM, SIGUSR1, SIGUSR2, SIGXCPU,
                           SIGVTALRM, SIGPROF, SIGIO, SIGPWR, SIGSTKFLT, SIGRTMIN, SIGRTMAX}) {
    EXPECT_EQ(ended(folder_.path() / "x", number, false), 130) << number;
    EXPECT_THAT(folder_.files(), IsEmpty()) << number;
  }
  for (const int number : {SIGPIPE, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS}) {
    const int code = ended(folder_.path() / "x", number, false);
    EXPECT_TRUE(code == 128 + number || code == kOtherHandler) << number << ": " << code;
    EXPECT_THAT(folder_.files(), IsEmpty()) << number;
  }
}

TEST_F(Interrupt, a_signal_after_the_file_took_its_place_is_no_failure) {
  for (const int number : {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU, SIGPIPE, SIGXFSZ}) {
    EXPECT_EQ(ended(folder_.path() / "x", number, true), 0) << number;
    EXPECT_EQ(folder_.read("x"), "bytes") << number;
  }
}

/// What a process that is to put `x` and `y` in their places, and has got so far, does at two
/// signals: its exit code and what it says.
std::string ended_at_once(const std::filesystem::path& folder, bool has_begun, bool is_complete) {
  const std::filesystem::path said = folder / "said";
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(::open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), STDERR_FILENO);
    cli::end_on_signals();
    cli::expect_file(folder / "x");
    cli::expect_file(folder / "y");
    AsideFile first(folder / "x", "bytes");
    std::optional<AsideFile> second;
    if (has_begun) {
      second.emplace(folder / "y", "bytes");
    }
    first.commit();
    if (is_complete) {
      second->commit();
    }
    ::raise(SIGTERM);
    ::raise(SIGINT);
    ::_exit(1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  const std::string words = read_file(said);
  std::filesystem::remove(said);
  return std::to_string(WEXITSTATUS(status)) + " " + words;
}

TEST_F(Interrupt, a_second_signal_says_whether_all_that_was_asked_for_is_in_place) {
  const std::filesystem::path folder = folder_.path();
  EXPECT_EQ(ended_at_once(folder, false, false), "130 dupin: interrupted\n");
  EXPECT_THAT(folder_.files(), ElementsAre("x"));
  EXPECT_EQ(ended_at_once(folder, true, false), "130 dupin: interrupted\n");
  EXPECT_THAT(folder_.files(), ElementsAre("x"));
  EXPECT_EQ(ended_at_once(folder, true, true), "0 ");
  EXPECT_THAT(folder_.files(), ElementsAre("x", "y"));
  // That of an earlier run is none.
  EXPECT_EQ(ended_at_once(folder, true, false), "130 dupin: interrupted\n");
  EXPECT_THAT(folder_.files(), ElementsAre("x", "y"));
}

TEST_F(Interrupt, a_crash_leaves_no_file_aside_once_one_is_in_its_place) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(STDERR_FILENO);
    cli::end_on_signals();
    AsideFile first(folder_.path() / "x", "bytes");
    const AsideFile second(folder_.path() / "y", "bytes");
    first.commit();
    ::abort();
  }
  ::waitpid(child, nullptr, 0);
  EXPECT_THAT(folder_.files(), ElementsAre("x"));
}

TEST_F(Interrupt, signals_that_end_no_program_end_none) {
  for (const int number : {SIGCHLD, SIGURG, SIGWINCH, SIGCONT, SIGXFSZ}) {
    EXPECT_EQ(ended(folder_.path() / "x", number, false), 0) << number;
    for (const std::string& name : folder_.files()) {
      std::filesystem::remove(folder_.path() / name);  // ended without leaving the scope
    }
  }
}

TEST_F(MeshCommands, an_interrupt_ends_at_once_and_leaves_no_file) {
  const ProcessResult result = shell("timeout --preserve-status -s INT 0.5 " + tool_path() +
                                     " convert - out.off < <(sleep 20); echo $?; ls -A");
  EXPECT_EQ(result.out, "130\nexamples\n");
  EXPECT_EQ(result.err, "dupin: interrupted\n");
}

TEST_F(MeshCommands, an_interrupt_is_an_object_for_programs) {
  const ProcessResult result = shell("timeout --preserve-status -s TERM 0.5 " + tool_path() +
                                     " check - --json < <(sleep 20); echo $?");
  EXPECT_EQ(result.out, "130\n");
  EXPECT_EQ(result.err,
            error_json(Error(Errc::cancelled, "interrupted"), "interrupted", 130) + "\n");
}

TEST_F(MeshCommands, an_interrupted_batch_ends_after_its_processes) {
  // Documents that are never read to their end.
  const ProcessResult result = shell(
      "mkfifo a.json b.json; timeout --preserve-status -s TERM 1 " + tool_path() +
      " build a.json b.json --out-dir out -j 2 > /dev/null; echo $?; pgrep -f 'out/[ab].stl'");
  EXPECT_EQ(result.out, "130\n");
  EXPECT_EQ(result.err, "dupin: interrupted\n");
}

TEST_F(MeshCommands, an_interrupt_while_nobody_reads_what_is_written_leaves_no_file) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  for (const std::string name : {"HUP", "TERM", "XCPU"}) {
    const ProcessResult result =
        shell("mkdir aside; mkfifo out.off; TMPDIR=$PWD/aside timeout --preserve-status -s " +
              name + " 0.5 " + tool_path() +
              " convert a.off out.off; echo $?; ls -A aside; rm -r aside out.off");
    EXPECT_EQ(result.out, "130\n") << name;
  }
}

TEST_F(MeshCommands, a_report_that_nobody_reads_makes_no_failure_of_a_file_that_is_there) {
  put("a.off", box({0, 0, 0}, {1, 1, 1}));
  const ProcessResult result =
      shell("{ sleep 0.3; dupin convert a.off b.off; echo $? >&2; } | true");
  EXPECT_EQ(result.err, "0\n");
  EXPECT_THAT(folder_.files(), ElementsAre("a.off", "b.off", "examples"));
}

}  // namespace
}  // namespace dupin::test
