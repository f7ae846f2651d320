#include "dupin/io/streamed_format.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <utility>

#include "dupin/io/mesh_file.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/io/stl_stream.h"
#include "dupin/kernel/error.h"
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

namespace {

[[noreturn]] void refuse_triangle(std::uint32_t triangle, const std::string& reason) {
  throw Error(Errc::invalid_argument,
              "triangle " + std::to_string(triangle) + " cannot be left out: " + reason);
}

// That they are triangles of the piece, ascending; of formats with borders, that each is of one.
void require_ends(std::uint64_t count, const TriMesh& mesh, bool have_borders,
                  std::span<const std::uint32_t> triangles, std::span<const std::string> names) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::uint32_t triangle = triangles[i];
    if (triangle >= count) {
      refuse_triangle(triangle, "there are " + std::to_string(count));
    }
    if (i > 0 && triangle <= triangles[i - 1]) {
      refuse_triangle(triangle, "the numbers have to ascend, each given once");
    }
    if (!have_borders) {
      continue;
    }
    if (triangle >= mesh.labels.size() || mesh.labels[triangle] >= mesh.names.size() ||
        std::ranges::count(names, mesh.names[mesh.labels[triangle]]) == 0) {
      refuse_triangle(triangle, "its label is none of the names");
    }
  }
}

}  // namespace

MeshPiece without(MeshPiece piece, const TriMesh& mesh, const MeshFormat& format,
                  std::span<const std::uint32_t> triangles, std::span<const std::string> names) {
  const UsualArithmetic usual;
  const bool is_stl = format == kStlBinary;
  require_ends(is_stl ? piece.bytes.size() / formats::kStlFacet : mesh.triangles.size(), mesh,
               !is_stl, triangles, names);
  if (!is_stl) {
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
