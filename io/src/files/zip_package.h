#pragma once

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

/// The contents of one entry, its checksum verified; the name is matched in any case, as packages
/// want it. `file` is named in errors. Throws Error{parse_failed}, or Error{limit_exceeded} for an
/// entry that expands beyond 64 MiB and 200 times its compressed size.
[[nodiscard]] std::string unzip(std::string_view archive, std::string_view name,
                                std::string_view file);

}  // namespace dupin::files
