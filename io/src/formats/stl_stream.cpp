#include "dupin/io/stl_stream.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "formats/stl_binary.h"

namespace dupin {
using formats::kStlFacet, formats::kStlPreamble;

std::uint64_t StlFacets::count() const { return bytes.size() / kStlFacet; }

StlStream::StlStream(const std::filesystem::path& path) : shown_(path.string()), file_(path) {
  file_.append(std::string(kStlPreamble, '\0'));
}

StlFacets stl_facets(const Rounded& solid, std::string_view file) {
  std::string bytes = verified_bytes(file, solid, kStlBinary);
  bytes.erase(0, kStlPreamble);
  return {std::move(bytes), solid.mesh().names};
}

void StlStream::append(const StlFacets& solid) {
  if (triangles_ + solid.count() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(Errc::limit_exceeded, "binary STL holds at most 4294967295 triangles", {}, shown_);
  }
  file_.append(solid.bytes);
  if (!file_.holds_at(kStlPreamble + kStlFacet * triangles_, solid.bytes)) {
    throw Error(Errc::io_failed, "what was written is not what is read back", {}, shown_);
  }
  triangles_ += solid.count();
  // The header has a name if there is one only.
  for (const std::string& name : solid.names) {
    if (names_.size() < 2 && !std::ranges::count(names_, name)) {
      names_.push_back(name);
    }
  }
}

void StlStream::commit(const MeshHeader& header) {
  const std::string preamble =
      formats::stl_binary_preamble(names_.size() == 1 ? names_.front() : std::string(), header,
                                   static_cast<std::uint32_t>(triangles_));
  file_.replace(0, preamble);
  if (!file_.holds_at(0, preamble)) {
    throw Error(Errc::io_failed, "what was written is not what is read back", {}, shown_);
  }
  file_.commit();
}

}  // namespace dupin
