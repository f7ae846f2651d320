#include "tiles/district_cache.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

#include "dupin/kernel/error.h"
#include "exit_code.h"

namespace dupin::cli {
namespace {

namespace fs = std::filesystem;

/// In the folder, to tell that it is one of ours.
constexpr std::string_view kMark = "dupin-cache";

/// What is being written, or was when its build was killed.
constexpr const char* kHalfWritten = ".part";
constexpr std::chrono::hours kKilledFor{24};

/// Whether a file is called as entries are, by a digest, or as what is half written: what others
/// have put here is not ours to remove.
bool is_ours(const fs::path& path) {
  constexpr std::size_t kDigits = 64;
  const std::string name = path.filename().string(), key = name.substr(0, name.find('.'));
  const bool is_digest =
      key.size() == kDigits && key.find_first_not_of("0123456789abcdef") == std::string::npos;
  return name == key ? is_digest : (is_digest || key == kMark) && name.ends_with(kHalfWritten);
}

/// Before the bytes of an entry: what it is of, lest a file that was renamed is believed, and how
/// many there are, always in as many digits, lest much that is none of them is read.
std::string heading_of(const std::string& key, std::uint64_t size) {
  constexpr std::size_t kDigits = 20;
  const std::string digits = std::to_string(size);
  return key + " " + std::string(kDigits - digits.size(), '0') + digits + "\n";
}

[[noreturn]] void fail(const std::string& what, const fs::path& path) {
  throw OutputError(Error(Errc::io_failed, what, {}, path.string()));
}

/// Whether there is anything that no cache has made, or is about to make.
bool has_other_things(const fs::path& folder) {
  std::error_code reason;
  for (const auto& file : fs::directory_iterator(folder, reason)) {
    const std::string name = file.path().filename().string();
    if (name == kMark) {
      return false;
    }
    if (!(name.starts_with(kMark) && name.ends_with(kHalfWritten))) {
      // Somebody else may have made the mark, and an entry, meanwhile.
      return !fs::exists(folder / kMark, reason);
    }
  }
  if (reason) {
    fail("cannot read the folder for --cache: " + reason.message(), folder);
  }
  return false;
}

/// The bytes behind the heading; empty if it is another one, or they are fewer or more than it
/// says.
std::optional<std::string> content_of(const fs::path& path, const std::string& key) {
  const std::uint64_t size = fs::file_size(path);
  std::string heading = heading_of(key, 0);
  if (size < heading.size()) {
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  file.read(heading.data(), static_cast<std::streamsize>(heading.size()));
  if (!file) {
    throw fs::filesystem_error("", std::error_code(errno, std::generic_category()));
  }
  std::uint64_t rest = size - heading.size();
  if (heading != heading_of(key, rest)) {
    return std::nullopt;
  }
  std::string bytes(rest, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(rest));
  return file ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace

DistrictCache::DistrictCache(fs::path folder) : folder_(std::move(folder)) {
  std::error_code reason;
  fs::create_directories(folder_, reason);
  if (reason) {
    fail("cannot make the folder for --cache: " + reason.message(), folder_);
  }
  const bool is_known = fs::exists(folder_ / kMark, reason);
  if (!is_known && has_other_things(folder_)) {
    fail(
        "the folder for --cache has other things in it; give an empty one, or one that does not "
        "exist yet",
        folder_);
  }
  if (!is_known) {
    keep(std::string(kMark), "Made by dupin build --cache. May be deleted whenever none runs.\n");
  }
}

std::optional<std::string> DistrictCache::find(const std::string& key) const {
  const fs::path path = folder_ / key;
  std::error_code reason;
  if (fs::symlink_status(path, reason).type() == fs::file_type::not_found) {
    return std::nullopt;
  }
  const fs::file_status status = fs::status(path, reason);
  if (!fs::is_regular_file(status)) {
    distrust(key, status.type() == fs::file_type::none ? "cannot be read: " + reason.message()
                                                       : "is no regular file");
    return std::nullopt;
  }
  try {
    auto bytes = content_of(path, key);
    if (bytes) {
      fs::last_write_time(path, fs::file_time_type::clock::now(), reason);
    } else {
      distrust(key, "is damaged");
    }
    return bytes;
  } catch (const fs::filesystem_error& error) {
    distrust(key, "cannot be read: " + error.code().message());
    return std::nullopt;
  }
}

void DistrictCache::keep(const std::string& key, std::string_view bytes) const {
  static std::atomic<unsigned> files{0};
  const fs::path aside = folder_ / (key + "." + std::to_string(::getpid()) + "-" +
                                    std::to_string(files++) + kHalfWritten);
  std::error_code reason;
  {
    std::ofstream file(aside, std::ios::binary);
    file << heading_of(key, bytes.size());
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
      reason = {errno, std::generic_category()};
    }
  }
  std::error_code ignored;
  if (reason) {
    fs::remove(aside, ignored);
    fail("cannot write to the folder for --cache: " + reason.message(), folder_ / key);
  }
  fs::rename(aside, folder_ / key, reason);
  if (reason) {
    fs::remove(aside, ignored);
    distrust(key, "cannot be replaced: " + reason.message());
  }
}

void DistrictCache::distrust(const std::string& key, const std::string& reason) const {
  const std::lock_guard lock(exclusive_);
  unusable_.emplace(key, reason);
}

std::string DistrictCache::warning() const {
  const std::lock_guard lock(exclusive_);
  if (unusable_.empty()) {
    return {};
  }
  const auto& [key, reason] = *unusable_.begin();
  const std::size_t others = unusable_.size() - 1;
  return (folder_ / key).string() + ": an entry of --cache was of no use and made again: it " +
         reason + (others > 0 ? "; and " + std::to_string(others) + " more" : "");
}

void DistrictCache::trim(std::uint64_t most) const {
  struct Entry {
    fs::file_time_type used;
    fs::path path;
    std::uint64_t size = 0;
  };
  const auto now = fs::file_time_type::clock::now();
  std::vector<Entry> entries;
  std::uint64_t all = 0;
  std::error_code ignored;  // another build may tidy up, too
  for (const auto& file : fs::directory_iterator(folder_, ignored)) {
    if (!file.is_regular_file(ignored) || !is_ours(file.path())) {
      continue;
    }
    const std::uint64_t size = file.file_size(ignored);
    if (ignored) {
      continue;
    }
    const Entry entry{file.last_write_time(ignored), file.path(), size};
    if (entry.path.extension() == kHalfWritten) {
      if (now - entry.used > kKilledFor) {
        fs::remove(entry.path, ignored);
      }
      continue;
    }
    all += entry.size;
    entries.push_back(entry);
  }
  std::ranges::sort(entries, {}, &Entry::used);
  for (const Entry& entry : entries) {
    if (all <= most) {
      break;
    }
    fs::remove(entry.path, ignored);
    all -= entry.size;
  }
}

}  // namespace dupin::cli
