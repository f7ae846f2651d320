#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "formats/same_mesh.h"
#include "formats/stl_binary.h"

namespace dupin {
namespace {

constexpr std::size_t kFindingsTold = 3;

std::string place_text(const Vec3& place) {
  return "(" + std::to_string(place.x()) + ", " + std::to_string(place.y()) + ", " +
         std::to_string(place.z()) + ")";
}

std::string first_findings(const Report& report) {
  std::string text;
  std::size_t told = 0;
  for (const Finding& finding : report.findings) {
    if (told < kFindingsTold && is_fatal(finding.defect)) {
      text += (told++ == 0 ? "" : ", ") + std::string(name(finding.defect)) + " at " +
              place_text(finding.place);
    }
  }
  return text;
}

/// A mesh file beside its place, and the bytes that it is to give back.
struct Written {
  Written(const std::filesystem::path& path, const TriMesh& mesh, const MeshFormat& format,
          const MeshHeader& header)
      : bytes(mesh_bytes(mesh, format, header)), file(path, bytes) {}

  void require_bytes(const std::filesystem::path& path) const {
    if (!file.holds(bytes)) {
      throw Error(Errc::io_failed, "the bytes read back are not those that were written", {},
                  path.string());
    }
  }

  std::string bytes;
  AsideFile file;
};

/// Whether the bytes are a list of triangles as the mesh has them. Its points are in different
/// places if the solid has no contacts, so that readers who merge equal points find its neighbours.
bool list_triangles(const std::string& bytes, const Rounded& rounded, const MeshFormat& format) {
  return format == kStlBinary && rounded.contacts().empty() &&
         formats::stl_binary_lists(rounded.mesh(), bytes);
}

/// The first triangle that our own reader does not find in the bytes as the mesh has it.
std::optional<std::uint32_t> first_lost(const Rounded& rounded, const std::string& bytes,
                                        std::string_view file, const MeshFormat& format) {
  if (list_triangles(bytes, rounded, format)) {
    return std::nullopt;
  }
  return formats::first_difference(rounded.mesh(), format.read(bytes, std::string(file)));
}

// Readers of STL and the like make points in the same place one.
void refuse_contacts(const Rounded& rounded, std::string_view file, const MeshFormat& format) {
  if (!format.merges_points || rounded.contacts().empty()) {
    return;
  }
  throw Error(Errc::contact,
              "the solid touches itself, first at " + place_text(rounded.contacts().front().from) +
                  ", and readers of " + std::string(format.name) +
                  " would weld it there; write another format, or separate or bridge it before",
              {}, std::string(file));
}

void require_same(const Rounded& rounded, const std::string& bytes, std::string_view file,
                  const MeshFormat& format) {
  if (const auto face = first_lost(rounded, bytes, file, format)) {
    const TriMesh& mesh = rounded.mesh();
    throw Error(Errc::unroundable,
                "as " + std::string(format.name) + " this mesh is another one: triangle " +
                    std::to_string(*face) + " at " +
                    place_text(mesh.points[mesh.triangles[*face][0]]) +
                    " does not come back as it is; round to the coordinates of the format",
                {}, std::string(file));
  }
}

}  // namespace

Report write_verified(const std::filesystem::path& path, const TriMesh& mesh,
                      const MeshFormat& format, const MeshHeader& header,
                      const Progress& progress) {
  const UsualArithmetic usual;
  tell(progress, "write");
  Written written(path, mesh, format, header);
  tell(progress, "verify");
  written.require_bytes(path);
  const TriMesh read_back = format.read(written.bytes, path.string());
  Report report = check(read_back);
  if (read_back.triangles.size() != mesh.triangles.size() || !report.is_solid()) {
    throw Error(Errc::unroundable,
                "as " + std::string(format.name) +
                    " this mesh is no longer a solid: " + first_findings(report) +
                    "; write a format with binary64 coordinates, move the model's origin closer, "
                    "or skip the verification",
                {}, path.string());
  }
  written.file.commit();
  return report;
}

Report write_verified(const std::filesystem::path& path, const TriMesh& mesh) {
  return write_verified(path, mesh, format_of(path));
}

void write_verified(const std::filesystem::path& path, const Rounded& rounded,
                    const MeshFormat& format, const MeshHeader& header, const Progress& progress) {
  const UsualArithmetic usual;
  refuse_contacts(rounded, path.string(), format);
  tell(progress, "write");
  Written written(path, rounded.mesh(), format, header);
  tell(progress, "verify");
  for_each_in_parallel(2, [&](std::size_t i) {
    const UsualArithmetic workers;
    i == 0 ? written.require_bytes(path)
           : require_same(rounded, written.bytes, path.string(), format);
  });
  written.file.commit();
}

std::string verified_bytes(std::string_view file, const Rounded& rounded, const MeshFormat& format,
                           const MeshHeader& header, const Progress& progress) {
  const UsualArithmetic usual;
  refuse_contacts(rounded, file, format);
  tell(progress, "write");
  std::string bytes = mesh_bytes(rounded.mesh(), format, header);
  tell(progress, "verify");
  require_same(rounded, bytes, file, format);
  return bytes;
}

}  // namespace dupin
