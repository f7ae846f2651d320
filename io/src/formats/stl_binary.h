#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "dupin/io/mesh_header.h"
#include "dupin/kernel/mesh.h"
#include "dupin/kernel/tiled_check.h"
#include "text/point_merger.h"

namespace dupin::formats {

constexpr std::size_t kStlHeader = 80;
constexpr std::size_t kStlPreamble = kStlHeader + 4;   // the header and the count of triangles
constexpr std::size_t kStlVector = 12;                 // a normal or a point
constexpr std::size_t kStlFacet = 4 * kStlVector + 2;  // with two bytes of attributes

/// How many triangles a binary STL of so many bytes has. Throws Error{parse_failed} where the bytes
/// are not as many as those before the first facet say, or not even these.
[[nodiscard]] std::uint32_t stl_triangles(std::string_view preamble, std::uint64_t size,
                                          std::string_view file);

/// The facet whose bytes begin at `at`, with 0 for -0; it is at `place` in the file. Throws
/// Error{parse_failed} for coordinates that are not finite.
[[nodiscard]] Facet stl_facet(std::string_view bytes, std::size_t at, std::uint64_t place,
                              std::string_view file);

/// The unit that the first 80 bytes of our own files state; empty if none, or of others'.
[[nodiscard]] std::string stl_unit(std::string_view header);

/// Makes the mesh that read_stl_binary() gives of facets in their order.
class StlMesh {
 public:
  explicit StlMesh(std::size_t facets);

  void add(const Facet& facet);
  /// With the name that the first 80 bytes of the file give it.
  [[nodiscard]] TriMesh take(std::string_view header) &&;

 private:
  text::PointMerger points_;
  TriMesh mesh_;
};

/// Whether the file is a binary STL of the triangles of `mesh`, in their order and with the very
/// same numbers. If the points of the mesh are in different places, `read_stl_binary` then joins
/// the triangles as the mesh does; this comparison merges no points and takes a tenth of the time.
[[nodiscard]] bool stl_binary_lists(const TriMesh& mesh, std::string_view bytes);

/// The bytes before the first facet. `name` is that of the only label, empty if there is none.
[[nodiscard]] std::string stl_binary_preamble(const std::string& name, const MeshHeader& header,
                                              std::uint32_t triangles);

}  // namespace dupin::formats
