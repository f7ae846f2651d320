#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dupin::test {

struct ProcessResult {
  int exit_code = -1;  ///< 128 + signal for a process that was killed
  std::string out, err;
};

/// Runs a program with its arguments in `folder`, feeds it `input` and waits for its end.
[[nodiscard]] ProcessResult run_process(const std::vector<std::string>& command,
                                        const std::filesystem::path& folder,
                                        const std::string& input = {});

/// A new empty folder, removed with everything in it at the end of the object's life.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Names of all files in it, sorted.
  [[nodiscard]] std::vector<std::string> files() const;
  void write(const std::string& name, const std::string& text) const;
  [[nodiscard]] std::string read(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

}  // namespace dupin::test
