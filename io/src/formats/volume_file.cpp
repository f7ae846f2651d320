#include "dupin/io/volume_file.h"

#include <algorithm>
#include <array>

#include "dupin/io/msh.h"
#include "dupin/io/vtu.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "formats/same_mesh.h"

namespace dupin {

std::span<const VolumeFormat> volume_formats() {
  static const std::array formats = {kMshVolume, kVtu};
  return formats;
}

const VolumeFormat* find_volume_format(std::string_view key_or_extension) {
  const auto formats = volume_formats();
  const auto found = std::ranges::find_if(formats, [&](const VolumeFormat& format) {
    return format.key == key_or_extension || format.extension == key_or_extension;
  });
  return found == formats.end() ? nullptr : &*found;
}

std::string verified_volume_bytes(const VolumeMesh& mesh, const VolumeFormat& format,
                                  const MeshHeader& header, std::string_view file) {
  const UsualArithmetic usual;
  std::string bytes = format.write(mesh, header);
  const VolumeMesh read = format.read(bytes, file);
  // Corners are numbered in the order in which triangles have them, so places are compared.
  const auto same_places = [&](const Tetrahedron& a, const Tetrahedron& b) {
    return std::ranges::equal(
        a, b, [&](std::uint32_t v, std::uint32_t w) { return mesh.point(v) == read.point(w); });
  };
  if (formats::first_difference(mesh.surface, read.surface) ||
      !std::ranges::equal(mesh.tetrahedra, read.tetrahedra, same_places)) {
    throw Error(Errc::unroundable, "the file gives back another mesh than it was given", {},
                std::string(file));
  }
  return bytes;
}

}  // namespace dupin
