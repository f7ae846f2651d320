#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace dupin::cli {

/// How a run of the tool ended, and what it said.
struct ChildResult {
  int exit_code = 0;  ///< 128 and the signal's number for one that a signal ended
  std::string out, err;
};

/// The tool itself as another process: what it does of one document can neither stop nor harm what
/// is done of the next one. It ends with its parent.
class ChildProcess {
 public:
  /// Starts it with these arguments; where it is `captured`, what it says is kept and it reads
  /// nothing, else it has its parent's terminal. Throws Error{io_failed}.
  ChildProcess(const std::vector<std::string>& arguments, bool captured);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] pid_t id() const { return id_; }
  /// Its result, where waitpid has told the end with this status.
  [[nodiscard]] ChildResult finished(int status);
  /// Waits for the end.
  [[nodiscard]] ChildResult wait();
  /// Whether it has ended: its result.
  [[nodiscard]] std::optional<ChildResult> poll();
  /// Asks it to end, and waits until it has.
  void stop();

 private:
  pid_t id_ = -1;
  int out_ = -1, err_ = -1;  ///< files without a name
  bool ended_ = false;
};

}  // namespace dupin::cli
