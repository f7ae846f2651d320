#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>

#include "mesh/exact_mesh.h"
#include "mesh/point_winding.h"

namespace dupin::mesh {

/// The faces of a closed surface of doubles, for winding numbers about many points: a tree over
/// their boxes is made when so many have been asked for that it pays. From any threads. The mesh
/// and the list outlive it.
class RayFaces {
 public:
  RayFaces(const MeshView& mesh, std::span<const std::uint32_t> faces);
  ~RayFaces();
  RayFaces(const RayFaces&) = delete;
  RayFaces& operator=(const RayFaces&) = delete;

  /// As mesh::winding_number. O(faces) at first, then O(log n) and the faces that a ray from about
  /// the point meets.
  [[nodiscard]] int winding_number(const WindingPoint& point) const;

 private:
  struct Tree;
  MeshView mesh_;
  std::span<const std::uint32_t> faces_;
  mutable std::atomic<std::uint32_t> asked_ = 0;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const Tree> tree_;
};

}  // namespace dupin::mesh
