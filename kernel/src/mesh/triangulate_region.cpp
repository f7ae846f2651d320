#include "dupin/kernel/triangulate_region.h"

#include <algorithm>
#include <string>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

using Traits = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Traits>;
enum class Side { unknown, outside, inside };
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<Side, Traits,
                                              CGAL::Constrained_triangulation_face_base_2<Traits>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Traits, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;

[[noreturn]] void refuse_touching() {
  throw Error(Errc::self_intersecting, "the polygons that bound a region cross or touch");
}

using Polygon = std::vector<std::uint32_t>;

class Region {
 public:
  explicit Region(std::span<const Vec2> points) : points_(points), vertices_(points.size()) {}

  void insert_corners(const Polygon& polygon) {
    if (polygon.size() < 3) {
      throw Error(Errc::invalid_argument,
                  "a polygon needs at least three corners, not " + std::to_string(polygon.size()));
    }
    for (const std::uint32_t corner : polygon) {
      insert(corner);
    }
  }

  void insert_sides(const Polygon& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::uint32_t from = polygon[i], to = polygon[(i + 1) % polygon.size()];
      try {
        triangulation_.insert_constraint(vertices_[from], vertices_[to]);
      } catch (const Triangulation::Intersection_of_constraints_exception&) {
        refuse_touching();
      }
    }
    sides_ += polygon.size();
  }

  std::vector<Triangle> triangles() {
    // A side that another corner lies on was divided there.
    const auto edges = triangulation_.constrained_edges();
    if (static_cast<std::size_t>(std::distance(edges.begin(), edges.end())) != sides_) {
      refuse_touching();
    }
    tell_sides();
    std::vector<Triangle> result;
    for (const auto& face : triangulation_.finite_face_handles()) {
      if (face->info() == Side::inside) {
        Triangle corners{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::ranges::rotate(corners, std::ranges::min_element(corners));
        result.push_back(corners);
      }
    }
    std::ranges::sort(result);
    return result;
  }

 private:
  using Face = Triangulation::Face_handle;

  void insert(std::uint32_t corner) {
    if (vertices_[corner] != Triangulation::Vertex_handle()) {
      return;  // polygons have it in common
    }
    const Vec2& point = points_[corner];
    if (!point.allFinite()) {
      throw Error(Errc::invalid_argument, "the corner of a region is not finite");
    }
    const Face hint = inserted_ == 0 ? Face() : last_->face();
    const auto vertex = triangulation_.insert({point.x(), point.y()}, hint);
    last_ = vertex;
    if (inserted_++ != triangulation_.number_of_vertices() - 1) {
      refuse_touching();  // two corners in one place
    }
    vertex->info() = corner;
    vertices_[corner] = vertex;
  }

  // From the outside in.
  void tell_sides() {
    for (const auto& face : triangulation_.all_face_handles()) {
      face->info() = Side::unknown;
    }
    triangulation_.infinite_face()->info() = Side::outside;
    std::vector<Face> open{triangulation_.infinite_face()};
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Face next = face->neighbor(i);
        if (next->info() == Side::unknown) {
          const bool is_inside = (face->info() == Side::inside) != face->is_constrained(i);
          next->info() = is_inside ? Side::inside : Side::outside;
          open.push_back(next);
        }
      }
    }
  }

  std::span<const Vec2> points_;
  Triangulation triangulation_;
  std::vector<Triangulation::Vertex_handle> vertices_;
  Triangulation::Vertex_handle last_;
  std::size_t inserted_ = 0, sides_ = 0;
};

}  // namespace

std::vector<Triangle> triangulate_region(std::span<const Vec2> points,
                                         std::span<const std::vector<std::uint32_t>> polygons) {
  Region region(points);
  for (const Polygon& polygon : polygons) {
    region.insert_corners(polygon);
  }
  for (const Polygon& polygon : polygons) {
    region.insert_sides(polygon);
  }
  return region.triangles();
}

}  // namespace dupin
