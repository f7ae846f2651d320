#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace dupin::cli {

/// A folder of what districts came out as, each under the digest of all that decides about it: what
/// was begun is gone on with, and what did not change is not made again. Files appear whole, but
/// need not outlast a power cut; whoever reads them finds out.
class DistrictCache {
 public:
  /// Opens the folder, or makes it. Throws OutputError for one with other things in it, and where
  /// the system refuses.
  explicit DistrictCache(std::filesystem::path folder);

  /// The bytes kept under the key, if there are any; they have been used now. A file that was
  /// written under another key is none.
  [[nodiscard]] std::optional<std::string> find(const std::string& key) const;
  /// Threads may keep several at a time. Throws OutputError, of a full disk for one.
  void keep(const std::string& key, std::string_view bytes) const;
  /// Removes what has not been used for longest, until at most so many bytes are left, and what
  /// builds that were killed have left half written, after a day.
  void trim(std::uint64_t most) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace dupin::cli
