#include <algorithm>

#include "dupin/blends/tessellate.h"

namespace dupin {
namespace {

// The mesh's last row and the piece's first one are the same polygon, counted from different
// corners: vertices of the piece in the mesh.
std::vector<std::uint32_t> appended_vertices(TriMesh& mesh, const TriMesh& piece,
                                             std::uint32_t segments) {
  const auto row = std::uint32_t(mesh.points.size()) - segments;
  const auto first =
      std::find(piece.points.begin(), piece.points.begin() + segments, mesh.points[row]);
  const auto offset = std::uint32_t(first - piece.points.begin());
  std::vector<std::uint32_t> vertices(piece.points.size());
  for (std::uint32_t i = 0; i < segments; ++i) {
    vertices[(i + offset) % segments] = row + i;
  }
  for (std::uint32_t i = segments; i < piece.points.size(); ++i) {
    vertices[i] = std::uint32_t(mesh.points.size());
    mesh.points.push_back(piece.points[i]);
  }
  return vertices;
}

// The last row's points become those of the first.
void close(TriMesh& mesh, std::uint32_t segments) {
  const auto row = std::uint32_t(mesh.points.size()) - segments;
  const auto first =
      std::find(mesh.points.begin(), mesh.points.begin() + segments, mesh.points[row]);
  const auto offset = std::uint32_t(first - mesh.points.begin());
  for (auto& triangle : mesh.triangles) {
    for (auto& vertex : triangle) {
      vertex = vertex < row ? vertex : (vertex - row + offset) % segments;
    }
  }
  mesh.points.resize(row);
}

}  // namespace

std::uint32_t segments_for(const SplinePipe& pipe, double tolerance, double grid) {
  std::uint32_t most = 0;
  for (const RingedSurface& piece : pipe.pieces) {
    most = std::max(most, segments_for(piece, tolerance, grid));
  }
  return most;
}

Tessellation tessellate(const SplinePipe& pipe, const RingSampling& sampling,
                        const TessellationOptions& options) {
  Tessellation result = tessellate(pipe.pieces.front(), sampling, options);
  for (std::size_t i = 1; i < pipe.pieces.size(); ++i) {
    const Tessellation piece = tessellate(pipe.pieces[i], sampling, options);
    const auto vertices = appended_vertices(result.mesh, piece.mesh, sampling.segments);
    for (const auto& [a, b, c] : piece.mesh.triangles) {
      result.mesh.triangles.push_back({vertices[a], vertices[b], vertices[c]});
    }
    for (std::size_t k = 1; k < piece.knots.size(); ++k) {
      result.knots.push_back(double(i) + piece.knots[k]);
    }
    result.bands += piece.bands;
    result.error_bound = std::max(result.error_bound, piece.error_bound);
  }
  if (pipe.closed) {
    close(result.mesh, sampling.segments);
  }
  return result;
}

}  // namespace dupin
