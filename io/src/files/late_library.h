#pragma once

#include <string>

namespace dupin::files {

/// A library of the system's that is loaded where it is first needed, and stays for as long as the
/// program runs: every run would have to load it otherwise, with all that it needs itself, which
/// takes longer than many a union.
class LateLibrary {
 public:
  /// `file` as the system's loader looks for it: its name, with the version of its interface.
  explicit LateLibrary(const char* file);

  /// Sets `function` to that of this name, null if there is none.
  template <typename Function>
  void find(Function*& function, const char* name) {
    function = reinterpret_cast<Function*>(address(name));
  }

  /// What the loader says of the first thing that it has not found; empty if it has found all.
  [[nodiscard]] const std::string& missing() const { return missing_; }

 private:
  [[nodiscard]] void* address(const char* name);

  void* handle_;
  std::string missing_;
};

}  // namespace dupin::files
