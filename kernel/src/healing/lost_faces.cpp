#include "healing/lost_faces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "healing/lost_cells.h"
#include "healing/sorted_copies.h"
#include "mesh/edge_table.h"
#include "mesh/point_winding.h"
#include "mesh/ray_faces.h"
#include "mesh/self_contact.h"
#include "support/blocks.h"
#include "support/sequences.h"

namespace dupin::healing {
namespace {

using Faces = std::vector<std::uint32_t>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The faces of a soup without copies, and what is known of each of them and its copies.
struct DistinctFaces {
  std::vector<Triangle> triangles;
  std::vector<std::uint8_t> is_known;  ///< on the boundary, or a cavity's
  std::vector<std::uint32_t> copies;   ///< how many
  std::vector<std::uint32_t> of_face;  ///< per face of the soup the one that it is a copy of
};

DistinctFaces distinct_faces(const PolygonSoup& soup, std::span<const std::uint8_t> is_known) {
  DistinctFaces distinct;
  distinct.of_face.resize(soup.triangles.size());
  for (const Copy& copy : sorted_copies(soup.triangles)) {
    if (distinct.triangles.empty() || distinct.triangles.back() != copy.corners) {
      distinct.triangles.push_back(copy.corners);
      distinct.is_known.push_back(0);
      distinct.copies.push_back(0);
    }
    ++distinct.copies.back();
    distinct.of_face[copy.face] = static_cast<std::uint32_t>(distinct.copies.size() - 1);
    distinct.is_known.back() |= is_known[soup.sources[copy.face]];
  }
  return distinct;
}

/// Drops faces that bound nothing: all those left at an edge, where they lie on each other there.
/// Others may be dropped before.
class FinFinder {
 public:
  FinFinder(const mesh::MeshView& mesh, const mesh::EdgeTable& edges,
            std::vector<std::uint8_t> is_dropped)
      : mesh_(mesh),
        edges_(edges),
        edges_of_(mesh.triangles.size()),
        is_fin_(std::move(is_dropped)) {}

  /// Per face.
  std::vector<std::uint8_t> find() {
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      for (const std::uint32_t h : edges_[edge].half_edges) {
        edges_of_[h / 3][h % 3] = edge;
      }
    }
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      look_at(edge);
    }
    for (std::size_t at = 0; at < queue_.size(); ++at) {
      for (const std::uint32_t edge : edges_of_[queue_[at]]) {
        look_at(edge);
      }
    }
    return std::move(is_fin_);
  }

 private:
  void look_at(std::uint32_t edge) {
    const mesh::Edge around = edges_[edge];
    std::vector<std::uint32_t> left;
    for (const std::uint32_t h : around.half_edges) {
      if (is_fin_[h / 3] == 0) {
        left.push_back(h);
      }
    }
    if (std::ranges::all_of(left, [&](std::uint32_t h) {
          return h == left.front() ||
                 mesh::in_one_half_plane(mesh_, edges_, around, left.front(), h);
        })) {
      for (const std::uint32_t h : left) {
        is_fin_[h / 3] = 1;
        queue_.push_back(h / 3);
      }
    }
  }

  mesh::MeshView mesh_;
  const mesh::EdgeTable& edges_;
  std::vector<std::array<std::uint32_t, 3>> edges_of_;
  std::vector<std::uint8_t> is_fin_;
  std::vector<std::uint32_t> queue_;
};

bool are_coplanar(std::span<const Vec3> points, const Triangle& plane, const Triangle& t) {
  const auto point = [&](std::uint32_t i) {
    return Kernel::Point_3(points[i].x(), points[i].y(), points[i].z());
  };
  return std::ranges::all_of(t, [&](std::uint32_t corner) {
    return CGAL::orientation(point(plane[0]), point(plane[1]), point(plane[2]), point(corner)) ==
           CGAL::COPLANAR;
  });
}

// Whether faces in one plane have inner points in common: no side of either is between them.
bool overlap(std::span<const Vec3> points, const Triangle& first, const Triangle& second) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto point = [&](std::uint32_t i) {
      return Kernel::Point_2(points[i][(axis + 1) % 3], points[i][(axis + 2) % 3]);
    };
    const auto turn = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      return CGAL::orientation(point(a), point(b), point(c));
    };
    const auto are_apart = [&](const Triangle& t, const Triangle& other) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto inward = turn(t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
        if (std::ranges::none_of(other, [&](std::uint32_t corner) {
              return turn(t[k], t[(k + 1) % 3], corner) == inward;
            })) {
          return true;
        }
      }
      return false;
    };
    if (turn(first[0], first[1], first[2]) != CGAL::COLLINEAR) {
      return !are_apart(first, second) && !are_apart(second, first);
    }
  }
  return true;
}

// Inside the face, near a corner: the middle between it and that of the opposite edge.
mesh::WindingPoint point_near(const mesh::MeshView& mesh, std::uint32_t face, std::size_t near) {
  exact::ExactVector point;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& corner = mesh.points[mesh.triangles[face][k]];
    for (int i = 0; i < 3; ++i) {
      point[i] = point[i] + CGAL::Mpzf(corner[i]) + CGAL::Mpzf(k == near ? corner[i] : 0);
    }
  }
  return {point, 4, mesh::bounds_of(mesh, face)};
}

// Those of which no point is wound around, as far as some tell: one could lie on another face.
Faces find_outside(std::span<const Vec3> points, const DistinctFaces& distinct,
                   const PolygonSoup& settled) {
  const mesh::MeshView mesh(points, distinct.triangles);
  const mesh::MeshView surface(settled.points, settled.triangles);
  const Faces all = support::numbers_below(settled.triangles.size());
  const mesh::RayFaces rays(surface, all);
  std::vector<std::uint8_t> is_outside(distinct.triangles.size(), 0);
  support::for_each_in_parallel(distinct.triangles.size(), [&](std::size_t i) {
    const auto face = static_cast<std::uint32_t>(i);
    bool is_wound_around = distinct.is_known[i] != 0;
    for (std::size_t near = 0; near < 3 && !is_wound_around; ++near) {
      is_wound_around = rays.winding_number(point_near(mesh, face, near)) > 0;
    }
    is_outside[i] = is_wound_around ? 0 : 1;
  });
  Faces outside;
  for (std::uint32_t i = 0; i < is_outside.size(); ++i) {
    if (is_outside[i] != 0) {
      outside.push_back(i);
    }
  }
  return outside;
}

// What lies in one plane with a face that is known may be covered by it: if it lies on that, or is
// beside it, too.
void drop_covered(std::span<const Vec3> points, const DistinctFaces& distinct, bool beside,
                  Faces& faces) {
  const mesh::MeshView mesh(points, distinct.triangles);
  std::erase_if(faces, [&](std::uint32_t face) {
    const Triangle& t = distinct.triangles[face];
    const auto box = mesh::bounds_of(mesh, face);
    for (std::uint32_t i = 0; i < distinct.triangles.size(); ++i) {
      const Triangle& other = distinct.triangles[i];
      if (distinct.is_known[i] != 0 && mesh::bounds_of(mesh, i).intersects(box) &&
          are_coplanar(points, other, t) && (beside || overlap(points, other, t))) {
        return true;
      }
    }
    return false;
  });
}

// Those of an even number of copies may be sheets, unless they bound something with others that are
// there several times.
void drop_fins(std::span<const Vec3> points, const DistinctFaces& distinct,
               const mesh::EdgeTable& edges, Faces& faces) {
  std::vector<std::uint8_t> is_single;
  is_single.reserve(distinct.copies.size());
  for (const std::uint32_t copies : distinct.copies) {
    is_single.push_back(copies == 1 ? 1 : 0);
  }
  const mesh::MeshView mesh(points, distinct.triangles);
  const std::vector<std::uint8_t> is_fin =
      FinFinder(mesh, edges, std::vector<std::uint8_t>(distinct.copies.size(), 0)).find();
  const std::vector<std::uint8_t> is_sheet = FinFinder(mesh, edges, std::move(is_single)).find();
  std::erase_if(faces, [&](std::uint32_t face) {
    return is_fin[face] != 0 || (distinct.copies[face] % 2 == 0 && is_sheet[face] != 0);
  });
}

bool is_odd(const Triangle& t) { return ((t[0] > t[1]) != (t[1] > t[2])) != (t[0] > t[2]); }

// Faces that are `outside` have nothing of the solid on either side.
std::vector<LostCell> lost_cells(const PolygonSoup& given, const PolygonSoup& settled,
                                 const DistinctFaces& distinct, const mesh::ExactMesh& solid,
                                 const KnownFaces& known, const Faces& outside) {
  std::vector<std::uint8_t> is_boundary(known.is_of_cavity.size(), 0);
  for (const Source& source : solid.sources) {
    is_boundary[source.triangle] = 1 - known.is_of_cavity[source.triangle];
  }
  std::vector<std::uint32_t> place(known.is_of_cavity.size(), 0);  // of a face of the mesh
  for (std::uint32_t i = 0; i < given.sources.size(); ++i) {
    place[given.sources[i]] = i;
  }
  std::vector<std::uint8_t> front(distinct.triangles.size(), 0), behind = front, turned = front;
  for (std::size_t i = 0; i < settled.triangles.size(); ++i) {
    if (is_boundary[settled.sources[i]] != 0) {
      const std::uint32_t before = place[settled.sources[i]], face = distinct.of_face[before];
      (is_odd(settled.triangles[i]) ? front : behind)[face] = 1;
      if (is_odd(settled.triangles[i]) != is_odd(given.triangles[before])) {
        turned[face] = 1;
      }
    }
  }
  if (!known.were_closed) {
    turned.clear();
  }
  std::vector<std::uint8_t> is_outside(distinct.triangles.size(), 0);
  for (const std::uint32_t face : outside) {
    is_outside[face] = 1;
  }
  for (std::size_t i = 0; i < is_outside.size(); ++i) {
    if (is_outside[i] == 0 && front[i] == 0 && behind[i] == 0) {
      front[i] = behind[i] = 1;  // or not known: then it is not lost
    }
  }
  return find_lost_cells({given.points, distinct.triangles, front, behind, turned});
}

// As one more surface, which all of them are inside of.
void add_walls(const PolygonSoup& given, const DistinctFaces& distinct,
               const std::vector<LostCell>& cells, PolygonSoup& settled) {
  std::vector<std::uint32_t> source(distinct.triangles.size(), 0);
  for (std::size_t i = 0; i < given.sources.size(); ++i) {
    source[distinct.of_face[i]] = given.sources[i];
  }
  for (const LostCell& cell : cells) {
    for (const auto& [face, is_turned] : cell.walls) {
      const auto& [a, b, c] = distinct.triangles[face];
      settled.triangles.push_back(is_turned ? Triangle{a, c, b} : Triangle{a, b, c});
      settled.sources.push_back(source[face]);
    }
  }
}

// A face without copies that is inside out may be that of a body, or one so thin that rounding has
// put a corner of it beyond another face.
std::string remedy(bool is_single) {
  const std::string of_bodies =
      "where bodies are there several times or overlap, their faces have to be turned alike";
  return of_bodies +
         (is_single ? "; where the mesh crosses itself beside this face, as at a sliver that was "
                      "rounded, two of its corners have to be put into one place"
                    : "");
}

[[noreturn]] void refuse(const PolygonSoup& given, const DistinctFaces& distinct,
                         const Faces& lost) {
  const Triangle& t = distinct.triangles[lost.front()];
  throw Error(Errc::not_oriented,
              "the mesh cannot be repaired: what " + std::to_string(lost.size()) +
                  " faces bound would be lost, first the one with the corners " +
                  decimal(given.points[t[0]]) + ", " + decimal(given.points[t[1]]) + " and " +
                  decimal(given.points[t[2]]) + "; " + remedy(distinct.copies[lost.front()] == 1));
}

}  // namespace

bool add_or_refuse_lost(const PolygonSoup& given, PolygonSoup& settled,
                        const mesh::ExactMesh& solid, const KnownFaces& known, bool may_add) {
  std::vector<std::uint8_t> is_known = known.is_of_cavity;
  for (const Source& source : solid.sources) {
    is_known[source.triangle] = 1;
  }
  const DistinctFaces distinct = distinct_faces(given, is_known);
  Faces lost = find_outside(given.points, distinct, settled);
  drop_covered(given.points, distinct, false, lost);
  if (lost.empty()) {
    return false;
  }
  std::vector<LostCell> cells = lost_cells(given, settled, distinct, solid, known, lost);
  const auto of_bodies = std::stable_partition(
      cells.begin(), cells.end(), [](const LostCell& cell) { return cell.is_of_bodies; });
  const std::vector<LostCell> others(of_bodies, cells.end());
  if (may_add && others.size() < cells.size()) {
    cells.resize(cells.size() - others.size());
    add_walls(given, distinct, cells, settled);
    return true;
  }
  const Faces outside = lost;
  drop_covered(given.points, distinct, true, lost);
  if (!lost.empty()) {
    const mesh::EdgeTable edges(distinct.triangles, given.points.size());
    drop_fins(given.points, distinct, edges, lost);
  }
  for (const LostCell& cell : cells) {
    for (const CellFace& wall : cell.walls) {
      if (std::ranges::binary_search(outside, wall.face)) {
        lost.push_back(wall.face);
      }
    }
  }
  support::sort_unique(lost);
  if (!lost.empty()) {
    refuse(given, distinct, lost);
  }
  return false;
}

}  // namespace dupin::healing
