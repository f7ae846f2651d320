#pragma once

#include <memory>
#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "dupin/kernel/view.h"

namespace dupin {

/// A stretch of a polyline: i + s is the point at the fraction s of its i-th segment.
struct Stretch {
  double from = 0, to = 0;
};

/// Where a polyline lies with respect to a solid that somebody looks at. Stretches are ascending
/// and apart.
struct SeenLine {
  std::vector<Stretch> covered;  ///< behind some triangle
  std::vector<Stretch> inside;   ///< where the surface winds around the line
};

/// What of lines in space a mesh hides from a viewer. Each segment is cut at the triangles'
/// outlines in the picture, in closed form; nothing is sampled. In doubles: lines that lie in a
/// triangle's plane may count either way, so move them off the surface first.
class HiddenLines {
 public:
  /// O(n log n). Throws as `validate`, and Error{invalid_argument} for a view that is not finite.
  HiddenLines(const TriMesh& mesh, const View& view);
  ~HiddenLines();
  HiddenLines(const HiddenLines&) = delete;
  HiddenLines& operator=(const HiddenLines&) = delete;

  /// Gaps and stretches shorter than `least` are left out, gaps first. Expected O(log n + triangles
  /// that cover it or are covered). Throws Error{invalid_argument} for what is not finite.
  [[nodiscard]] SeenLine seen(std::span<const Vec3> polyline, double least) const;

 private:
  struct Scene;
  std::unique_ptr<const Scene> scene_;
};

}  // namespace dupin
