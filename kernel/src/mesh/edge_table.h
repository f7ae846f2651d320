#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::mesh {

/// Half-edge 3f + k runs from corner k of face f to the next one.
[[nodiscard]] inline std::uint32_t next_half_edge(std::uint32_t half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}

/// An undirected edge with all the half-edges along it, both ways.
struct Edge {
  std::uint32_t low = 0, high = 0;  ///< points, low < high
  std::span<const std::uint32_t> half_edges;
};

/// The edges of triangles whose three indices differ and are below `point_count`, ordered by their
/// points. O(n) but for sorting within the edges of one point.
class EdgeTable {
 public:
  EdgeTable(std::span<const Triangle> triangles, std::size_t point_count);

  [[nodiscard]] std::size_t size() const { return starts_.size() - 1; }
  [[nodiscard]] Edge operator[](std::size_t edge) const;
  [[nodiscard]] std::uint32_t origin(std::uint32_t half_edge) const {
    return triangles_[half_edge / 3][half_edge % 3];
  }
  [[nodiscard]] std::uint32_t target(std::uint32_t half_edge) const {
    return origin(next_half_edge(half_edge));
  }

 private:
  std::span<const Triangle> triangles_;
  std::vector<std::uint32_t> half_edges_;  // by edge
  std::vector<std::uint32_t> starts_;      // of each edge in half_edges_, and the end
};

/// For each corner (3f + k) the lowest corner of its fan: the faces around a point that hang
/// together by edges.
[[nodiscard]] std::vector<std::uint32_t> corner_fans(std::span<const Triangle> triangles,
                                                     const EdgeTable& edges);

/// Faces that hang together by edges, numbered by their lowest face.
struct Shells {
  std::size_t count = 0;
  std::vector<std::uint32_t> of_face;
  std::vector<std::uint32_t> faces;   ///< by shell, ascending in each
  std::vector<std::uint32_t> starts;  ///< of each shell in faces, and the end

  [[nodiscard]] std::span<const std::uint32_t> faces_of(std::size_t shell) const {
    return std::span(faces).subspan(starts[shell], starts[shell + 1] - starts[shell]);
  }
};

[[nodiscard]] Shells shells(std::size_t face_count, const EdgeTable& edges);

/// Sets of faces as shells: per face the lowest one of its set is given.
[[nodiscard]] Shells grouped(std::vector<std::uint32_t> lowest_faces);

/// The shells of a closed manifold, where faces hang together by edges if they do by points;
/// `component`: per point the lowest one that faces connect it to.
[[nodiscard]] Shells shells_by_points(std::span<const Triangle> triangles,
                                      std::span<const std::uint32_t> component);

/// What is counted of a mesh that is one part of several that overlap; all if empty.
struct Counted {
  std::span<const std::uint8_t> points;  ///< per point 1, if it is; an edge like its lower point
  std::span<const std::uint8_t> faces;   ///< per face likewise

  [[nodiscard]] bool point(std::uint32_t i) const { return points.empty() || points[i] != 0; }
  [[nodiscard]] bool face(std::uint32_t i) const { return faces.empty() || faces[i] != 0; }
};

/// V - E + F of each shell, points counted once per fan.
[[nodiscard]] std::vector<std::int64_t> euler_numbers(const Shells& shells, const EdgeTable& edges,
                                                      std::span<const std::uint32_t> fans,
                                                      const Counted& counted = {});

}  // namespace dupin::mesh
