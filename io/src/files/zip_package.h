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

/// The name of the part that a relationship of a package as a whole points to, which begins with no
/// slash: "/3D/a.model", "3D/a.model" and "./b/../3D/a.model" are one (RFC 3986).
[[nodiscard]] std::string part_name(std::string_view target);

/// A ZIP archive whose entries are read one by one. `file` is named in errors; the bytes have to
/// outlive this. Throws Error{parse_failed}.
class ZipPackage {
 public:
  ZipPackage(std::string_view bytes, std::string_view file);
  ~ZipPackage();
  ZipPackage(const ZipPackage&) = delete;
  ZipPackage& operator=(const ZipPackage&) = delete;

  /// The contents of one entry, its checksum verified; the name is matched in any case, as packages
  /// want it, and if there is none with "%20" and the like read as what they stand for. Throws
  /// Error{parse_failed}, or Error{limit_exceeded} for an entry that expands beyond 64 MiB and 200
  /// times its compressed size, or entries that together do so beyond the archive's (entries may
  /// overlap).
  [[nodiscard]] std::string read(std::string_view name);

 private:
  struct Archive;

  [[nodiscard]] std::int64_t place_of(const std::string& name) const;

  std::string file_;
  std::uint64_t size_;
  std::uint64_t expanded_ = 0;
  std::unique_ptr<Archive> archive_;
};

/// One entry of an archive.
[[nodiscard]] std::string unzip(std::string_view archive, std::string_view name,
                                std::string_view file);

}  // namespace dupin::files
