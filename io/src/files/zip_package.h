#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dupin::files {

struct ZipEntry {
  std::string name;
  std::string bytes;
};

/// A ZIP archive of these entries, in their order, with the same date in each: the same entries
/// give the same bytes.
[[nodiscard]] std::string zip_archive(const std::vector<ZipEntry>& entries);

/// A ZIP archive whose entries are read one by one. `file` is named in errors; the bytes have to
/// outlive this. Throws Error{parse_failed}.
class ZipPackage {
 public:
  ZipPackage(std::string_view bytes, std::string_view file);
  ~ZipPackage();
  ZipPackage(const ZipPackage&) = delete;
  ZipPackage& operator=(const ZipPackage&) = delete;

  /// The contents of one entry, its checksum verified; the name is matched in any case, as packages
  /// want it. Throws Error{parse_failed}, or Error{limit_exceeded} for an entry that expands beyond
  /// 64 MiB and 200 times its compressed size, or entries that together do so beyond the archive's
  /// (entries may overlap).
  [[nodiscard]] std::string read(std::string_view name);

 private:
  struct Archive;

  std::string file_;
  std::uint64_t size_;
  std::uint64_t expanded_ = 0;
  std::unique_ptr<Archive> archive_;
};

/// One entry of an archive.
[[nodiscard]] std::string unzip(std::string_view archive, std::string_view name,
                                std::string_view file);

}  // namespace dupin::files
