#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "remeshing/features.h"
#include "support/none.h"

namespace dupin::remeshing {

struct Face {
  Triangle corners{};
  std::array<Span, 3> spans;  ///< of the edge from each corner on, if it is sharp
  std::uint32_t region = 0;
  std::uint32_t parent = 0;  ///< the triangle given that it has label and source of

  [[nodiscard]] int corner(std::uint32_t point) const {
    return corners[0] == point ? 0 : corners[1] == point ? 1 : corners[2] == point ? 2 : -1;
  }
};

/// A point of the mesh as it is edited.
struct WorkingPoint {
  Vec3 place = Vec3::Zero();
  Freedom freedom = Freedom::region;
  double wish = 0;  ///< how long edges should be here, as far as this place alone says
  double size = 0;  ///< the same with regard to the sizes around
};

/// Stands for the point that an edit adds.
inline constexpr std::uint32_t kAdded = support::kNone - 1;

/// Some faces, which become others.
struct Edit {
  std::vector<std::uint32_t> before;
  std::vector<Face> after;
  std::optional<WorkingPoint> added;
  std::optional<std::pair<std::uint32_t, Vec3>> moved;
};

/// What has to be known to take an edit back.
struct Applied {
  std::vector<std::pair<std::uint32_t, Face>> before;
  std::vector<std::uint32_t> after;
  std::uint32_t added = support::kNone;
  std::optional<std::pair<std::uint32_t, Vec3>> moved;
};

/// A closed manifold of triangles that is edited.
class WorkingMesh {
 public:
  WorkingMesh(const TriMesh& mesh, const Features& features);

  [[nodiscard]] std::uint32_t point_count() const {
    return static_cast<std::uint32_t>(points_.size());
  }
  [[nodiscard]] std::uint32_t face_count() const {
    return static_cast<std::uint32_t>(faces_.size());
  }
  [[nodiscard]] WorkingPoint& point(std::uint32_t v) { return points_[v]; }
  [[nodiscard]] const WorkingPoint& point(std::uint32_t v) const { return points_[v]; }
  [[nodiscard]] const Vec3& place(std::uint32_t v) const { return points_[v].place; }
  [[nodiscard]] const Face& face(std::uint32_t f) const { return faces_[f]; }
  [[nodiscard]] bool alive(std::uint32_t f) const { return alive_[f] != 0; }
  [[nodiscard]] std::size_t alive_count() const { return alive_count_; }
  /// Whether the point has faces.
  [[nodiscard]] bool is_used(std::uint32_t v) const { return !around_[v].empty(); }
  [[nodiscard]] std::span<const std::uint32_t> around(std::uint32_t v) const { return around_[v]; }
  [[nodiscard]] std::array<Vec3, 3> places(const Triangle& t) const {
    return {place(t[0]), place(t[1]), place(t[2])};
  }
  /// The face with the directed edge from a to b, and the place of a in it.
  struct Side {
    std::uint32_t face;
    int corner;
  };
  [[nodiscard]] std::optional<Side> side(std::uint32_t a, std::uint32_t b) const;
  /// The points that share an edge with one, ascending.
  [[nodiscard]] std::vector<std::uint32_t> neighbours(std::uint32_t v) const;
  [[nodiscard]] double length(std::uint32_t a, std::uint32_t b) const {
    return (place(a) - place(b)).norm();
  }
  /// How long an edge is to be.
  [[nodiscard]] double wanted_length(std::uint32_t a, std::uint32_t b) const {
    return (points_[a].size + points_[b].size) / 2;
  }

  Applied apply(const Edit& edit);
  void undo(const Applied& applied);

  /// Makes no size differ from another one by more than `gradation` times their distance.
  void grade_sizes(double gradation);

  /// Of the faces that are marked, or touch others there; closed meshes only. Faces, ascending,
  /// that cross others, touch them or are degenerate.
  [[nodiscard]] std::vector<std::uint32_t> faulty(std::span<const std::uint32_t> marked) const;

  /// The mesh without what is not used; per triangle its number here.
  [[nodiscard]] std::pair<TriMesh, std::vector<std::uint32_t>> compact() const;

 private:
  void put(std::uint32_t slot, const Face& face);
  void take(std::uint32_t slot);

  std::vector<WorkingPoint> points_;
  std::vector<Face> faces_;
  std::vector<std::uint8_t> alive_;
  std::size_t alive_count_ = 0;
  std::vector<std::uint32_t> free_;
  std::vector<std::vector<std::uint32_t>> around_;
  std::vector<std::uint32_t> representatives_;  // of the points given, which contacts may share
};

}  // namespace dupin::remeshing
