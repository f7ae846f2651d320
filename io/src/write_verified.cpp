#include <algorithm>
#include <string>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/error.h"

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

}  // namespace

Report write_verified(const std::filesystem::path& path, const TriMesh& mesh, MeshFormat format,
                      const MeshHeader& header) {
  const std::string bytes = mesh_bytes(mesh, format, header);
  AsideFile file(path, bytes);
  const std::string on_disk = read_file(file.path());
  if (on_disk != bytes) {
    throw Error(Errc::io_failed, "the bytes read back are not those that were written", {},
                path.string());
  }
  const TriMesh read_back = read_mesh(on_disk, path.string(), format);
  Report report = check(read_back);
  if (read_back.triangles.size() != mesh.triangles.size() || !report.is_solid()) {
    throw Error(Errc::unroundable,
                "as " + std::string(name(format)) +
                    " this mesh is no longer a solid: " + first_findings(report) +
                    "; write a format with binary64 coordinates, move the model's origin closer, "
                    "or skip the verification",
                {}, path.string());
  }
  file.commit();
  return report;
}

}  // namespace dupin
