// The union of mesh files by Manifold, as one would write it today: no proofs, no verification.
// Usage: manifold_files OUT IN... Reads binary STL as its readers do (three points for each
// triangle, merged by Manifold), the rest with our readers; writes with ours.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "manifold_mesh.h"

namespace dupin {
namespace {

manifold::Manifold solid_of_stl(const std::string& bytes) {
  constexpr std::size_t kHeader = 84, kRecord = 50, kNormal = 12, kCorners = 36;
  manifold::MeshGL mesh;
  const std::size_t triangles = (bytes.size() - kHeader) / kRecord;
  mesh.vertProperties.resize(9 * triangles);
  mesh.triVerts.resize(3 * triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    std::memcpy(&mesh.vertProperties[9 * t], &bytes[kHeader + kRecord * t + kNormal], kCorners);
  }
  for (std::size_t v = 0; v < mesh.triVerts.size(); ++v) {
    mesh.triVerts[v] = static_cast<std::uint32_t>(v);
  }
  mesh.Merge();
  return manifold::Manifold(mesh);
}

manifold::Manifold solid_of(const std::string& path) {
  const std::string bytes = read_file(path);
  return path.ends_with(".stl") ? solid_of_stl(bytes)
                                : manifold::Manifold(bench::manifold_mesh(read_mesh(bytes, path)));
}

void unite_files(const std::string& out, const std::vector<std::string>& in) {
  std::vector<manifold::Manifold> operands(in.size());
  for_each_in_parallel(in.size(), [&](std::size_t i) { operands[i] = solid_of(in[i]); });
  const auto united = manifold::Manifold::BatchBoolean(operands, manifold::OpType::Add);
  const TriMesh mesh = bench::tri_mesh(united.GetMeshGL64());
  if (const std::string fault = bench::manifold_fault(united); !fault.empty()) {
    throw Error(Errc::boolean_failed, fault);
  }
  write_mesh(out, mesh, format_of(out));
}

}  // namespace
}  // namespace dupin

int main(int count, char** arguments) {
  try {
    dupin::unite_files(arguments[1], {arguments + 2, arguments + count});
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
}
