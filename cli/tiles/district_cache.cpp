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

#include "dupin/io/atomic_file.h"
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

/// Before the bytes of an entry: what it is of, lest a file that was renamed is believed.
std::string heading_of(const std::string& key) { return key + "\n"; }

[[noreturn]] void fail(const std::string& what, const fs::path& path) {
  throw OutputError(Error(Errc::io_failed, what, {}, path.string()));
}

}  // namespace

DistrictCache::DistrictCache(fs::path folder) : folder_(std::move(folder)) {
  std::error_code reason;
  fs::create_directories(folder_, reason);
  if (reason) {
    fail("cannot make the folder for --cache: " + reason.message(), folder_);
  }
  const bool is_known = fs::exists(folder_ / kMark, reason);
  if (!is_known && !fs::is_empty(folder_, reason)) {
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
  std::error_code reason;
  if (!fs::is_regular_file(folder_ / key, reason)) {
    return std::nullopt;
  }
  std::string bytes = read_file(folder_ / key);
  const std::string heading = heading_of(key);
  if (!bytes.starts_with(heading)) {
    return std::nullopt;
  }
  fs::last_write_time(folder_ / key, fs::file_time_type::clock::now(), reason);
  bytes.erase(0, heading.size());
  return bytes;
}

void DistrictCache::keep(const std::string& key, std::string_view bytes) const {
  static std::atomic<unsigned> files{0};
  const fs::path aside = folder_ / (key + "." + std::to_string(::getpid()) + "-" +
                                    std::to_string(files++) + kHalfWritten);
  std::error_code reason;
  {
    std::ofstream file(aside, std::ios::binary);
    file << heading_of(key);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
      reason = {errno, std::generic_category()};
    }
  }
  if (!reason) {
    fs::rename(aside, folder_ / key, reason);
  }
  if (reason) {
    std::error_code ignored;
    fs::remove(aside, ignored);
    fail("cannot write to the folder for --cache: " + reason.message(), folder_ / key);
  }
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
    const Entry entry{file.last_write_time(ignored), file.path(), file.file_size(ignored)};
    if (entry.path.filename() == kMark) {
      continue;
    }
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
