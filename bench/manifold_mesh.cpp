#include "manifold_mesh.h"

namespace dupin::bench {

manifold::MeshGL64 manifold_mesh(const TriMesh& mesh) {
  manifold::MeshGL64 result;
  result.vertProperties.reserve(3 * mesh.points.size());
  for (const Vec3& p : mesh.points) {
    result.vertProperties.insert(result.vertProperties.end(), p.begin(), p.end());
  }
  result.triVerts.reserve(3 * mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    result.triVerts.insert(result.triVerts.end(), t.begin(), t.end());
  }
  return result;
}

TriMesh tri_mesh(const manifold::MeshGL64& mesh) {
  TriMesh result;
  result.points.reserve(mesh.NumVert());
  for (std::size_t v = 0; v < mesh.NumVert(); ++v) {
    const auto p = mesh.GetVertPos(v);
    result.points.emplace_back(p.x, p.y, p.z);
  }
  result.triangles.reserve(mesh.NumTri());
  for (std::size_t t = 0; t < mesh.NumTri(); ++t) {
    const auto corners = mesh.GetTriVerts(t);
    result.triangles.push_back({static_cast<std::uint32_t>(corners.x),
                                static_cast<std::uint32_t>(corners.y),
                                static_cast<std::uint32_t>(corners.z)});
  }
  return result;
}

std::string manifold_fault(const manifold::Manifold& solid) {
  const manifold::Manifold::Error status = solid.Status();
  // Their names are in its debug builds only.
  return status == manifold::Manifold::Error::NoError
             ? std::string()
             : "error " + std::to_string(static_cast<int>(status));
}

}  // namespace dupin::bench
