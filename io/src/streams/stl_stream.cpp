#include "dupin/io/stl_stream.h"

#include <algorithm>
#include <cerrno>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>

#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "files/descriptor.h"
#include "formats/stl_binary.h"
#include "text/little_endian.h"

namespace dupin {
using formats::kStlFacet, formats::kStlHeader, formats::kStlPreamble;
namespace {

[[noreturn]] void fail(const std::string& file, int reason) {
  throw Error(Errc::io_failed, "cannot read the file: " + std::generic_category().message(reason),
              {}, file);
}

/// Whether a file of so many bytes that begins like this is taken for a binary STL.
bool is_taken_for_stl(std::string_view start, std::uint64_t size, const std::string& file) {
  const bool has_size =
      size >= kStlPreamble &&
      size ==
          kStlPreamble + std::uint64_t{text::load<std::uint32_t>(start, kStlHeader)} * kStlFacet;
  if (has_size) {
    return std::ranges::none_of(mesh_formats(), [&](const MeshFormat& format) {
      return format.recognises(start) == Evidence::signature;
    });
  }
  const MeshFormat* const format = format_of_content(start, file);
  return format != nullptr && *format == kStlBinary;
}

}  // namespace

StlStream::StlStream(const std::filesystem::path& path) : shown_(path.string()), file_(path) {
  file_.append(std::string(kStlPreamble, '\0'));
}

void StlStream::append(const MeshPiece& piece, std::size_t) {
  const std::uint64_t count = piece.bytes.size() / kStlFacet;
  if (triangles_ + count > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(Errc::limit_exceeded, "binary STL holds at most 4294967295 triangles", {}, shown_);
  }
  file_.append(piece.bytes);
  if (!file_.holds_at(kStlPreamble + kStlFacet * triangles_, piece.bytes)) {
    throw Error(Errc::io_failed, "what was written is not what is read back", {}, shown_);
  }
  triangles_ += count;
  // The header has a name if all facets have it.
  const std::vector<std::string> none(count > 0 ? 1 : 0);
  for (const std::string& name : piece.names.empty() ? none : piece.names) {
    if (names_.size() < 2 && !std::ranges::count(names_, name)) {
      names_.push_back(name);
    }
  }
}

void StlStream::commit(const MeshHeader& header, const Normals&) {
  const std::string preamble =
      formats::stl_binary_preamble(names_.size() == 1 ? names_.front() : std::string(), header,
                                   static_cast<std::uint32_t>(triangles_));
  file_.replace(0, preamble);
  if (!file_.holds_at(0, preamble)) {
    throw Error(Errc::io_failed, "what was written is not what is read back", {}, shown_);
  }
  file_.commit();
}

StlFile::StlFile(const std::filesystem::path& path)
    : shown_(path.string()),
      file_(std::make_shared<const files::Descriptor>(
          ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))) {
  struct stat status {};
  if (file_->number() < 0 || ::fstat(file_->number(), &status) != 0) {
    fail(shown_, errno);
  }
  if (S_ISDIR(status.st_mode)) {
    fail(shown_, EISDIR);
  }
  if (!S_ISREG(status.st_mode)) {
    throw Error(Errc::invalid_argument, "is read more than once, and so has to be a regular file",
                {}, shown_);
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  constexpr std::uint64_t kStart = 1024;  // as is_binary_stl() looks at
  const std::string start = bytes_at(0, std::min(size, kStart));
  if (!is_taken_for_stl(start, size, shown_)) {
    throw Error(Errc::invalid_argument, "is no binary STL, the only format read in tiles", {},
                shown_);
  }
  count_ = formats::stl_triangles(start, size, shown_);
}

void StlFile::visit(const std::function<void(std::span<const Facet>)>& visit) const {
  constexpr std::uint64_t kAtOnce = 1 << 14;
  std::vector<Facet> facets;
  for (std::uint64_t first = 0; first < count_; first += kAtOnce) {
    const std::size_t some = std::min(kAtOnce, count_ - first);
    const std::uint64_t place = kStlPreamble + first * kStlFacet;
    const std::string bytes = bytes_at(place, some * kStlFacet);
    facets.clear();
    for (std::size_t at = 0; at < bytes.size(); at += kStlFacet) {
      facets.push_back(formats::stl_facet(bytes, at, place + at, shown_));
    }
    visit(facets);
  }
}

std::string StlFile::bytes_at(std::uint64_t at, std::size_t size) const {
  std::string bytes(size, '\0');
  const int reason = files::read_at(*file_, at, bytes);
  if (reason == files::kEnded) {
    throw Error(Errc::io_failed, "became shorter while it was read", {}, shown_);
  }
  if (reason != 0) {
    fail(shown_, reason);
  }
  return bytes;
}

}  // namespace dupin
