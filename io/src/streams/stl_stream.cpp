#include "dupin/io/stl_stream.h"

#include <algorithm>
#include <cerrno>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>

#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "dupin/io/system_error.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "files/descriptor.h"
#include "files/placed_file.h"
#include "formats/stl_binary.h"
#include "text/little_endian.h"

namespace dupin {
using formats::kStlFacet, formats::kStlHeader, formats::kStlPreamble;
namespace {

[[noreturn]] void fail(const std::string& file, int reason) {
  throw SystemError("cannot read the file", reason, file);
}

/// As many bytes as is_binary_stl() looks at.
constexpr std::uint64_t kStart = 1024;

/// A pipe is not waited for.
int opened(const std::filesystem::path& path) {
  return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

/// Of a regular file.
std::optional<std::uint64_t> size_of(const files::Descriptor& file, const std::string& shown) {
  struct stat status {};
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0) {
    fail(shown, errno);
  }
  if (S_ISDIR(status.st_mode)) {
    fail(shown, EISDIR);
  }
  return S_ISREG(status.st_mode) ? std::optional(static_cast<std::uint64_t>(status.st_size))
                                 : std::nullopt;
}

std::string bytes_at(const files::Descriptor& file, std::uint64_t at, std::size_t size,
                     const std::string& shown) {
  std::string bytes(size, '\0');
  const int reason = files::read_at(file, at, bytes);
  if (reason == files::kEnded) {
    throw Error(Errc::io_failed, "became shorter while it was read", {}, shown);
  }
  if (reason != 0) {
    fail(shown, reason);
  }
  return bytes;
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

StlStream::StlStream(const std::filesystem::path& path, const Processes* processes)
    : shown_(path.string()), file_(std::make_unique<files::PlacedFile>(path, processes)) {}

StlStream::~StlStream() = default;

namespace {

void require_open(const std::unique_ptr<files::PlacedFile>& file, const std::string& shown) {
  if (!file) {
    throw Error(Errc::invalid_argument,
                "the file is committed: nothing can be appended, and it is committed once", {},
                shown);
  }
}

}  // namespace

void StlStream::append(const MeshPiece& piece, std::size_t) {
  require_open(file_, shown_);
  const std::uint64_t count = piece.triangles;
  if (triangles_ + count > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(Errc::limit_exceeded, "binary STL holds at most 4294967295 triangles", {}, shown_);
  }
  if (!piece.is_elsewhere) {
    if (piece.bytes.size() != kStlFacet * count) {
      throw Error(Errc::invalid_argument,
                  "a piece of " + std::to_string(count) + " triangles has " +
                      std::to_string(piece.bytes.size()) + " bytes, not " +
                      std::to_string(kStlFacet * count) +
                      "; append what mesh_piece() or without() has made for the same format",
                  {}, shown_);
    }
    file_->write(kStlPreamble + kStlFacet * triangles_, piece.bytes);
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

void StlStream::flush() {
  require_open(file_, shown_);
  file_->flush();
}

void StlStream::commit(const MeshHeader& header, const Normals&) {
  require_open(file_, shown_);
  const std::string preamble =
      formats::stl_binary_preamble(names_.size() == 1 ? names_.front() : std::string(), header,
                                   static_cast<std::uint32_t>(triangles_));
  file_->commit(preamble);
  file_.reset();
}

void StlStream::abandon() {
  if (file_) {
    file_->abandon();
  }
}

StlFile::StlFile(const std::filesystem::path& path)
    : shown_(path.string()), file_(std::make_shared<const files::Descriptor>(opened(path))) {
  const auto size = size_of(*file_, shown_);
  if (!size) {
    throw Error(Errc::invalid_argument, "is read more than once, and so has to be a regular file",
                {}, shown_);
  }
  const std::string start = bytes_at(*file_, 0, std::min(*size, kStart), shown_);
  if (!is_taken_for_stl(start, *size, shown_)) {
    throw Error(Errc::invalid_argument, "is no binary STL, the only format read in tiles", {},
                shown_);
  }
  count_ = formats::stl_triangles(start, *size, shown_);
}

void StlFile::visit(const std::function<void(std::span<const Facet>)>& visit) const {
  const UsualArithmetic usual;
  constexpr std::uint64_t kAtOnce = 1 << 14;
  std::vector<Facet> facets;
  for (std::uint64_t first = 0; first < count_; first += kAtOnce) {
    const std::size_t some = std::min(kAtOnce, count_ - first);
    const std::uint64_t place = kStlPreamble + first * kStlFacet;
    const std::string bytes = bytes_at(*file_, place, some * kStlFacet, shown_);
    facets.clear();
    for (std::size_t at = 0; at < bytes.size(); at += kStlFacet) {
      facets.push_back(formats::stl_facet(bytes, at, place + at, shown_));
    }
    visit(facets);
  }
}

TriMesh StlFile::mesh() const {
  const UsualArithmetic usual;
  formats::StlMesh mesh(count_);
  visit([&](std::span<const Facet> facets) {
    for (const Facet& facet : facets) {
      mesh.add(facet);
    }
  });
  return std::move(mesh).take(bytes_at(*file_, 0, kStlHeader, shown_));
}

std::string StlFile::unit() const {
  return formats::stl_unit(bytes_at(*file_, 0, kStlHeader, shown_));
}

bool is_stl_file(const std::filesystem::path& path) {
  const std::string shown = path.string();
  const files::Descriptor file(opened(path));
  const auto size = size_of(file, shown);
  return size && is_taken_for_stl(bytes_at(file, 0, std::min(*size, kStart), shown), *size, shown);
}

}  // namespace dupin
