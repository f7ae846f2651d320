#include <algorithm>
#include <string>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/error.h"
#include "same_mesh.h"

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

/// A mesh file beside its place, and what our own reader finds in it.
struct Written {
  Written(const std::filesystem::path& path, const TriMesh& mesh, MeshFormat format,
          const MeshHeader& header)
      : Written(path, mesh_bytes(mesh, format, header), format) {}

  AsideFile file;
  TriMesh read_back;

 private:
  Written(const std::filesystem::path& path, const std::string& bytes, MeshFormat format)
      : file(path, bytes) {
    const std::string on_disk = read_file(file.path());
    if (on_disk != bytes) {
      throw Error(Errc::io_failed, "the bytes read back are not those that were written", {},
                  path.string());
    }
    read_back = read_mesh(on_disk, path.string(), format);
  }
};

}  // namespace

Report write_verified(const std::filesystem::path& path, const TriMesh& mesh, MeshFormat format,
                      const MeshHeader& header) {
  Written written(path, mesh, format, header);
  Report report = check(written.read_back);
  if (written.read_back.triangles.size() != mesh.triangles.size() || !report.is_solid()) {
    throw Error(Errc::unroundable,
                "as " + std::string(name(format)) +
                    " this mesh is no longer a solid: " + first_findings(report) +
                    "; write a format with binary64 coordinates, move the model's origin closer, "
                    "or skip the verification",
                {}, path.string());
  }
  written.file.commit();
  return report;
}

void write_verified(const std::filesystem::path& path, const Rounded& rounded, MeshFormat format,
                    const MeshHeader& header) {
  const TriMesh& mesh = rounded.mesh();
  Written written(path, mesh, format, header);
  if (const auto face = first_difference(mesh, written.read_back)) {
    throw Error(Errc::unroundable,
                "as " + std::string(name(format)) + " this mesh is another one: triangle " +
                    std::to_string(*face) + " at " +
                    place_text(mesh.points[mesh.triangles[*face][0]]) +
                    " does not come back as it is; round to the coordinates of the format, and "
                    "write a format with indices where the solid touches itself",
                {}, path.string());
  }
  written.file.commit();
}

}  // namespace dupin
