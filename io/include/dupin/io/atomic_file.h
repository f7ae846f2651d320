#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace dupin {

/// All bytes of a file. Throws Error{io_failed} with the system's reason, and Error{limit_exceeded}
/// for what is no regular file and has not ended after a quarter of the machine's memory.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);
/// The same of standard input, from where it stands; errors say `shown` as its name.
[[nodiscard]] std::string read_standard_input(const std::string& shown);

/// Where a file is aside.
struct AsidePath {
  std::filesystem::path path;
};

/// A file that is written aside, in the directory of its target, and takes the target's place in
/// one step: whoever looks, at any moment, finds the old file or the whole new one. Without
/// `commit` the destructor removes it and the target stays untouched.
///
/// A symbolic link stays and what it points to is written, there or not yet. An existing file keeps
/// its permissions. A target that is no regular file (a device, a pipe) cannot be replaced and is
/// written directly by `commit`; its file aside is among the system's temporary ones.
/// All functions throw Error{io_failed} with the system's reason.
class AsideFile {
 public:
  AsideFile(const std::filesystem::path& target, std::string_view bytes);
  /// Empty yet.
  explicit AsideFile(const std::filesystem::path& target) : AsideFile(target, std::string_view()) {}
  /// One that another process has made for this target, and looks after as this one does: whichever
  /// ends early removes it, and only one commits. It is gone for the others then.
  AsideFile(const std::filesystem::path& target, const AsidePath& made);
  ~AsideFile();
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;

  /// Where the bytes are until `commit`.
  [[nodiscard]] const std::filesystem::path& path() const { return aside_; }
  /// Reads the file from disk: whether it is there with these bytes and no others.
  [[nodiscard]] bool holds(std::string_view bytes) const;
  /// The same of those from `at` on, whatever is behind them.
  [[nodiscard]] bool holds_at(std::uint64_t at, std::string_view bytes) const;
  /// Puts bytes behind those that are there.
  void append(std::string_view bytes);
  /// Puts bytes in the place of some that are there.
  void replace(std::uint64_t at, std::string_view bytes);
  /// What was written is on the disk, as commit() makes sure, too.
  void sync();
  void commit();

 private:
  void write(int flags, std::uint64_t at, std::string_view bytes);

  std::filesystem::path target_;
  std::filesystem::path aside_;
  bool replaceable_ = true;  // target is a regular file or does not exist
  bool pending_ = false;     // the aside file exists and is ours to remove
  bool is_synced_ = true;
  std::uint64_t unsent_ = 0;  // bytes that the disk has not been told of
};

/// For the handler of a signal that is to end the process, in whatever thread it runs: calls only
/// what POSIX allows there. Either removes every file that is aside, after which no file takes its
/// place any more and the process has to end at once; or, if a file has taken its place, does
/// nothing and returns false, so that the process can go on and say so. Asked again, it removes the
/// others all the same.
[[nodiscard]] bool abandon_files() noexcept;

/// Where a file of this name is, or would be: at the end of a chain of links.
[[nodiscard]] std::filesystem::path end_of_links(std::filesystem::path path);

/// Writes aside and commits.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace dupin
