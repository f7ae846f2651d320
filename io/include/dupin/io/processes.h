#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dupin {

/// A file that is there, open in several processes, each of which writes and reads places of its
/// own. All throw Error{io_failed}.
class JointFile {
 public:
  JointFile() = default;
  virtual ~JointFile() = default;
  JointFile(const JointFile&) = delete;
  JointFile& operator=(const JointFile&) = delete;

  virtual void write(std::uint64_t at, std::string_view bytes) = 0;
  /// How many bytes were read, the first ones: fewer at the file's end.
  [[nodiscard]] virtual std::uint64_t read(std::uint64_t at, std::span<char> bytes) = 0;
  /// What was written is on the disk, and the file closed; all processes call it.
  virtual void close() = 0;
};

/// The processes of one job, which see the same files, on one machine or several. All throw
/// Error{io_failed}.
class Processes {
 public:
  Processes() = default;
  virtual ~Processes() = default;
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  [[nodiscard]] virtual std::size_t count() const = 0;
  /// This one's number, below count().
  [[nodiscard]] virtual std::size_t own() const = 0;
  [[nodiscard]] bool is_first() const { return own() == 0; }

  /// The bytes of every process, in the order of their numbers; all call it, and none goes on
  /// before all have.
  [[nodiscard]] virtual std::vector<std::string> exchanged(std::string_view bytes) const = 0;
  /// All call it, with the same path. Messages name `shown`.
  [[nodiscard]] virtual std::unique_ptr<JointFile> open(const std::filesystem::path& path,
                                                        const std::string& shown) const = 0;
  /// Called where another process ends the job, and says why: may wait for that, and return if
  /// nothing comes of it.
  virtual void let_another_speak() const {}
};

}  // namespace dupin
