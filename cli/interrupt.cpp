#include "interrupt.h"

#include <atomic>
#include <csignal>

#include <unistd.h>

#include "exit_code.h"

namespace dupin::cli {
namespace {

// A signal reaches any thread and takes no argument: only globals tell it where the program is.
std::atomic<bool> is_writing = false;
std::atomic<bool> is_interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

// Only what POSIX allows in a handler.
[[noreturn]] void end() {
  constexpr char kMessage[] = "dupin: interrupted\n";
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, kMessage, sizeof(kMessage) - 1);
  ::_exit(static_cast<int>(ExitCode::interrupted));
}

void on_signal(int) {
  is_interrupted = true;
  if (!is_writing) {
    end();
  }
}

}  // namespace

void end_on_interrupt() {
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    if (::sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) {
      action = {};
      action.sa_handler = on_signal;
      ::sigaction(number, &action, nullptr);
    }
  }
}

Uninterrupted::Uninterrupted() { is_writing = true; }

Uninterrupted::~Uninterrupted() {
  is_writing = false;
  if (is_interrupted) {
    end();
  }
}

}  // namespace dupin::cli
