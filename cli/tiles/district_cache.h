#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace dupin::cli {

/// A folder of what districts came out as, each under the digest (sha256()) of all that decides
/// about it: what was begun is gone on with, and what did not change is not made again. Files
/// appear whole, but need not outlast a power cut; whoever reads them finds out. An entry that
/// cannot be used, whatever is in its place, never stands in the way of a result.
class DistrictCache {
 public:
  /// Opens the folder, or makes it; others may do so at the same time. Throws OutputError for one
  /// with other things in it, and where the system refuses.
  explicit DistrictCache(std::filesystem::path folder);

  /// The bytes kept under the key, if there are any; they have been used now. What cannot be read,
  /// is no file, was written under another key or is longer or shorter than it was is unusable.
  [[nodiscard]] std::optional<std::string> find(const std::string& key) const;
  /// Threads may keep several at a time. What is in the key's place and cannot be replaced, a
  /// folder for one, stays, and is unusable. Throws OutputError where the cache's folder cannot be
  /// written to, on a full disk for one.
  void keep(const std::string& key, std::string_view bytes) const;
  /// Notes that the entry is unusable, and why, unless that is known.
  void distrust(const std::string& key, const std::string& reason) const;
  /// In a line, where entries were unusable: which, and why; empty else.
  [[nodiscard]] std::string warning() const;
  /// Removes entries that have not been used for longest, until at most so many bytes of them are
  /// left, and what builds that were killed have left half written, after a day. Files that are
  /// called otherwise stay.
  void trim(std::uint64_t most) const;

 private:
  std::filesystem::path folder_;
  mutable std::mutex exclusive_;
  mutable std::map<std::string, std::string> unusable_;  // keys, and why
};

}  // namespace dupin::cli
