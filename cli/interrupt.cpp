#include "interrupt.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <initializer_list>
#include <string_view>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "dupin/io/atomic_file.h"
#include "exit_code.h"

namespace dupin::cli {
namespace {

// A signal reaches any thread and takes no argument: only globals tell what came before it.
constinit std::atomic<bool> was_interrupted = false;
constinit std::atomic<bool> lost_reader = false;
constinit std::atomic<bool> is_silent = false;
constinit std::atomic<const std::string*> the_words = nullptr;  // never destroyed
constinit std::array<std::atomic<pid_t>, 256> the_children{};

struct ExpectedFile {
  std::array<char, 4096> path{};  // as many as the system takes
  dev_t device = 0;
  ino_t number = 0;  // of what is there before; none has 0
};
constinit std::array<ExpectedFile, 16> the_expected{};
constinit std::atomic<std::size_t> expected_count = 0;
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<std::size_t>::is_always_lock_free);
static_assert(std::atomic<const std::string*>::is_always_lock_free);
static_assert(std::atomic<pid_t>::is_always_lock_free);

// What follows calls only what POSIX allows in a handler. All other signals wait in its thread.

void end_children() {
  for (const std::atomic<pid_t>& child : the_children) {
    if (child > 0) {
      ::kill(child, SIGTERM);
    }
  }
  for (const std::atomic<pid_t>& child : the_children) {
    if (child > 0) {
      ::waitpid(child, nullptr, 0);
    }
  }
}

void say_interrupted() {
  constexpr std::string_view kMessage = "dupin: interrupted\n";
  const std::string* const told = the_words;
  const std::string_view words = told != nullptr ? std::string_view(*told) : kMessage;
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, words.data(), words.size());
}

/// A file that takes its place is a new one; what is written into, as a pipe, tells nothing.
bool is_in_place(const ExpectedFile& expected) {
  struct stat status {};
  return ::stat(expected.path.data(), &status) == 0 &&
         (!S_ISREG(status.st_mode) || status.st_dev != expected.device ||
          status.st_ino != expected.number);
}

bool are_all_in_place() {
  const std::size_t count = expected_count;
  return std::all_of(the_expected.begin(), the_expected.begin() + count, is_in_place);
}

void on_interrupt(int) {
  if (!abandon_files()) {
    was_interrupted = true;
    return;
  }
  end_children();
  if (was_interrupted && are_all_in_place()) {
    ::_exit(static_cast<int>(ExitCode::ok));
  }
  if (!is_silent) {
    say_interrupted();
  }
  ::_exit(static_cast<int>(ExitCode::interrupted));
}

void on_end(int number) {
  if (number == SIGPIPE && (lost_reader || was_interrupted || !abandon_files())) {
    lost_reader = true;
    return;
  }
  if (number != SIGPIPE && !abandon_files()) {
    (void)abandon_files();  // it does when asked again
  }
  ::signal(number, SIG_DFL);
  ::raise(number);
}

bool is_one_of(int number, std::initializer_list<int> numbers) {
  for (const int one : numbers) {
    if (number == one) {
      return true;
    }
  }
  return false;
}

/// What is to be done at a signal; null for those that end no program.
void (*handler_of(int number))(int) {
  if (is_one_of(number, {SIGKILL, SIGSTOP, SIGTSTP, SIGTTIN, SIGTTOU, SIGCONT, SIGCHLD, SIGURG,
                         SIGWINCH, SIGTRAP})) {
    return nullptr;
  }
  if (number == SIGXFSZ) {
    return SIG_IGN;
  }
  const bool ends_itself =
      is_one_of(number, {SIGPIPE, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV, SIGSYS});
  return ends_itself ? on_end : on_interrupt;
}

}  // namespace

void end_on_signals() {
  for (int number = 1; number <= SIGRTMAX; ++number) {
    struct sigaction action {};
    const auto handler = handler_of(number);
    if (handler != nullptr && ::sigaction(number, nullptr, &action) == 0 &&
        action.sa_handler == SIG_DFL) {
      action = {};
      action.sa_handler = handler;
      ::sigfillset(&action.sa_mask);
      ::sigaction(number, &action, nullptr);
    }
  }
}

void say_on_interrupt(const std::string& text) { delete the_words.exchange(new std::string(text)); }

void expect_file(const std::string& path) {
  const std::size_t count = expected_count;
  if (count == the_expected.size() || path.size() >= the_expected[count].path.size()) {
    return;
  }
  ExpectedFile& expected = the_expected[count];
  std::ranges::copy(path, expected.path.begin());
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    expected.device = status.st_dev;
    expected.number = status.st_ino;
  }
  expected_count = count + 1;
}

void end_before(pid_t child) {
  for (std::atomic<pid_t>& place : the_children) {
    pid_t none = 0;
    if (place.compare_exchange_strong(none, child)) {
      return;
    }
  }
}

void forget_child(pid_t child) {
  for (std::atomic<pid_t>& place : the_children) {
    pid_t held = child;
    if (place.compare_exchange_strong(held, 0)) {
      return;
    }
  }
}

void end_without_words() { is_silent = true; }

bool has_lost_reader() { return lost_reader; }

}  // namespace dupin::cli
