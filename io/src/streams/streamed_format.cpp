#include "dupin/io/streamed_format.h"

#include "dupin/io/mesh_file.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/io/stl_stream.h"
#include "formats/stl_binary.h"
#include "streams/ply_stream.h"
#include "streams/pvtu_stream.h"
#include "streams/spilled_meshes.h"

namespace dupin {

constinit const MeshFormat kPvtu = {.key = "pvtu",
                                    .name = "VTK pieces",
                                    .extension = ".pvtu",
                                    .coordinates = Coordinates::binary64};

bool is_streamed(const MeshFormat& format) {
  return format == kStlBinary || format == kPlyBinary || format == kPvtu;
}

MeshPiece mesh_piece(const Rounded& solid, const MeshFormat& format, std::string_view file) {
  if (format == kPvtu) {  // compared as it is written
    return {streams::piece_bytes(solid.mesh()), solid.mesh().names};
  }
  std::string bytes = verified_bytes(file, solid, format);
  if (format == kStlBinary) {
    bytes.erase(0, formats::kStlPreamble);
  } else {
    bytes = streams::piece_bytes(solid.mesh());
  }
  return {std::move(bytes), solid.mesh().names};
}

std::unique_ptr<MeshStream> mesh_stream(const std::filesystem::path& path,
                                        const MeshFormat& format) {
  if (format == kPlyBinary) {
    return std::make_unique<streams::PlyStream>(path);
  }
  if (format == kPvtu) {
    return std::make_unique<streams::PvtuStream>(path);
  }
  return std::make_unique<StlStream>(path);
}

}  // namespace dupin
