#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "dupin/io/atomic_file.h"
#include "dupin/io/processes.h"

namespace dupin::files {

/// A file aside that the first of several processes makes, and all look after; `processes` null for
/// one alone.
[[nodiscard]] std::unique_ptr<AsideFile> joint_aside(const std::filesystem::path& target,
                                                     const Processes* processes);

/// A file aside whose bytes are put in their places in any order and read back at once, by this
/// process alone or by several, each of which has the same object. Throws what AsideFile does.
class PlacedFile {
 public:
  /// By all processes; null for one alone.
  PlacedFile(const std::filesystem::path& target, const Processes* processes);

  /// By whichever process has the bytes.
  void write(std::uint64_t at, std::string_view bytes);
  /// What was written is on the disk; where there are several processes, commit() sees to it.
  void flush();
  /// By all, when each has written what it has: the first one writes the bytes that come first in
  /// the file, and puts it in its place. None returns before that is done.
  void commit(std::string_view first_bytes);
  /// By all: nothing takes its place.
  void abandon();

 private:
  [[nodiscard]] bool holds_at(std::uint64_t at, std::string_view bytes) const;

  std::string shown_;
  const Processes* processes_;  // several, or null
  std::unique_ptr<AsideFile> file_;
  std::unique_ptr<JointFile> joint_;
};

}  // namespace dupin::files
