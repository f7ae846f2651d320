#include "child_process.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "dupin/io/scratch_file.h"
#include "dupin/kernel/error.h"
#include "exit_code.h"
#include "interrupt.h"

namespace dupin::cli {
namespace {

// What this process cannot begin is no fault of what it reads.
[[noreturn]] void fail(const std::string& action, const std::string& place = {}) {
  const int reason = errno;
  throw OutputError(Error(Errc::io_failed,
                          "cannot " + action + ": " + std::generic_category().message(reason), {},
                          place));
}

int file_without_a_name() {
  const std::filesystem::path folder = temporary_folder();
  std::string path = folder / "dupin-XXXXXX";
  const int file = ::mkostemp(path.data(), O_CLOEXEC);
  if (file < 0) {
    fail("make a temporary file", folder);
  }
  ::unlink(path.c_str());
  return file;
}

std::string text_in(int file) {
  std::string text;
  char piece[1 << 14];
  ::lseek(file, 0, SEEK_SET);
  for (ssize_t size = 0; (size = ::read(file, piece, sizeof piece)) > 0;) {
    text.append(piece, static_cast<std::size_t>(size));
  }
  return text;
}

// Signals wait while there is one.
class WithoutSignals {
 public:
  WithoutSignals() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~WithoutSignals() { end(); }
  WithoutSignals(const WithoutSignals&) = delete;
  WithoutSignals& operator=(const WithoutSignals&) = delete;

  void end() const { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

/// What its parent does at signals, as to end its other children and to say so, a child does not.
void forget_handlers() {
  for (int number = 1; number <= SIGRTMAX; ++number) {
    struct sigaction action {};
    if (::sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) {
      ::signal(number, SIG_DFL);
    }
  }
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& arguments, bool captured) {
  std::vector<char*> words;
  std::string tool = "dupin";
  words.push_back(tool.data());
  std::vector<std::string> copies = arguments;
  for (std::string& copy : copies) {
    words.push_back(copy.data());
  }
  words.push_back(nullptr);
  if (captured) {
    out_ = file_without_a_name();
    err_ = file_without_a_name();
  }
  const pid_t parent = ::getpid();
  const WithoutSignals quiet;
  id_ = ::fork();
  if (id_ < 0) {
    fail("start another process");
  }
  if (id_ == 0) {  // only what POSIX allows after fork
    forget_handlers();
    quiet.end();
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) {
      ::_exit(1);
    }
    if (captured) {
      const int nothing = ::open("/dev/null", O_RDONLY);
      ::dup2(nothing, STDIN_FILENO);
      ::dup2(out_, STDOUT_FILENO);
      ::dup2(err_, STDERR_FILENO);
    }
    ::execv("/proc/self/exe", words.data());
    ::_exit(127);
  }
  end_before(id_);
}

ChildProcess::~ChildProcess() {
  stop();
  for (const int file : {out_, err_}) {
    if (file >= 0) {
      ::close(file);
    }
  }
}

ChildResult ChildProcess::finished(int status) {
  ended_ = true;
  forget_child(id_);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          out_ < 0 ? "" : text_in(out_), err_ < 0 ? "" : text_in(err_)};
}

ChildResult ChildProcess::wait() {
  int status = 0;
  while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  return finished(status);
}

std::optional<ChildResult> ChildProcess::poll() {
  int status = 0;
  if (::waitpid(id_, &status, WNOHANG) != id_) {
    return std::nullopt;
  }
  return finished(status);
}

void ChildProcess::stop() {
  if (id_ > 0 && !ended_) {
    ::kill(id_, SIGTERM);
    (void)wait();
  }
}

}  // namespace dupin::cli
