#pragma once

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include <unistd.h>

namespace dupin::files {

/// An open file; closed on every way out.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) {
      ::close(number_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }
  /// Of the open file, which somebody else closes.
  [[nodiscard]] int release() { return std::exchange(number_, -1); }
  /// Closes, and tells the reason if the system refuses (a full disk may say so only here).
  [[nodiscard]] int close() { return ::close(release()) == 0 ? 0 : errno; }

 private:
  int number_;
};

/// What read_at() returns where the file ends too early.
constexpr int kEnded = -1;

/// Fills the bytes with those of the file from `at` on. 0, the system's reason, or kEnded.
[[nodiscard]] inline int read_at(const Descriptor& file, std::uint64_t at, std::span<char> bytes) {
  while (!bytes.empty()) {
    const ssize_t taken =
        ::pread(file.number(), bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (taken == 0 || (taken < 0 && errno != EINTR)) {
      return taken == 0 ? kEnded : errno;
    }
    const std::size_t step = taken > 0 ? static_cast<std::size_t>(taken) : 0;
    at += step;
    bytes = bytes.subspan(step);
  }
  return 0;
}

/// All of a file, which grows beyond the size that the system says by so many bytes at most: pipes
/// and devices may have no end.
[[nodiscard]] std::string read_whole(const std::filesystem::path& path, std::uint64_t most);

}  // namespace dupin::files
