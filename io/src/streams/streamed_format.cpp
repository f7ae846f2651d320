#include "dupin/io/streamed_format.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <utility>

#include "dupin/io/mesh_file.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/io/stl_stream.h"
#include "dupin/kernel/parallel.h"
#include "formats/stl_binary.h"
#include "streams/ply_stream.h"
#include "streams/pvtu_stream.h"
#include "streams/spilled_meshes.h"

namespace dupin {

constinit const MeshFormat kPvtu = {.key = "pvtu",
                                    .name = "VTK pieces",
                                    .extension = ".pvtu",
                                    .coordinates = Coordinates::binary64};

bool is_listed_name(std::string_view name, const std::filesystem::path& pvtu) {
  std::size_t number = 0;
  const std::size_t digits = name.rfind('_') + 1;  // 0 where there is none
  (void)std::from_chars(name.data() + digits, name.data() + name.size(), number);
  return name == streams::listed_name(pvtu, number);
}

bool is_streamed(const MeshFormat& format) {
  return format == kStlBinary || format == kPlyBinary || format == kPvtu;
}

MeshPiece mesh_piece(const Rounded& solid, const MeshFormat& format, std::string_view file) {
  const UsualArithmetic usual;
  if (format == kPvtu) {  // compared as it is written
    return streams::spilled_piece(solid.mesh());
  }
  std::string bytes = verified_bytes(file, solid, format);
  MeshPiece piece = streams::spilled_piece(solid.mesh());
  if (format == kStlBinary) {
    bytes.erase(0, formats::kStlPreamble);
    piece.bytes = std::move(bytes);
  }
  return piece;
}

MeshPiece without(MeshPiece piece, const TriMesh& mesh, const MeshFormat& format,
                  std::span<const std::uint32_t> triangles, std::span<const std::string> names) {
  const UsualArithmetic usual;
  if (format != kStlBinary) {
    return streams::open_piece(mesh, triangles, names);
  }
  std::string left;
  left.reserve(piece.bytes.size());
  std::size_t begin = 0;
  for (const std::uint32_t triangle : triangles) {
    const std::size_t end = triangle * formats::kStlFacet;
    left.append(piece.bytes, begin, end - begin);
    begin = end + formats::kStlFacet;
  }
  left.append(piece.bytes, begin);
  piece.bytes = std::move(left);
  piece.triangles -= static_cast<std::uint32_t>(triangles.size());
  piece.labels -= piece.labels > 0 ? static_cast<std::uint32_t>(triangles.size()) : 0;
  std::erase_if(piece.names,
                [&](const std::string& name) { return std::ranges::count(names, name) > 0; });
  return piece;
}

std::unique_ptr<MeshStream> mesh_stream(const std::filesystem::path& path, const MeshFormat& format,
                                        const Processes* processes) {
  if (format == kPlyBinary) {
    return std::make_unique<streams::PlyStream>(path, processes);
  }
  if (format == kPvtu) {
    return std::make_unique<streams::PvtuStream>(path, processes);
  }
  return std::make_unique<StlStream>(path, processes);
}

}  // namespace dupin
