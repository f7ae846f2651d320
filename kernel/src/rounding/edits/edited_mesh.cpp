#include "rounding/edits/edited_mesh.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

#include "mesh/surface_distance.h"
#include "mesh/used_points.h"
#include "support/blocks.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

bool has(const Triangle& triangle, std::uint32_t vertex) {
  return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

Triangle replaced(Triangle triangle, std::uint32_t from, std::uint32_t to) {
  std::replace(triangle.begin(), triangle.end(), from, to);
  return triangle;
}

double area(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).norm() / 2; }

/// Over the longest side.
double least_height(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return longest > 0 ? 2 * area(a, b, c) / longest : 0;
}

/// How far the triangles on both sides of c d reach out of the quadrilateral a d b c if it is not
/// convex. One that is turned the wrong way lies beside it, with two sides in common; and no point
/// of a triangle is farther from any two of its sides than its least height.
double overhang(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 normal = (b - a).cross(c - a) + (a - b).cross(d - b);
  const auto reach_out = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    return (q - p).cross(r - p).dot(normal) > 0 ? 0 : least_height(p, q, r);
  };
  return std::max(reach_out(a, d, c), reach_out(d, b, c));
}

/// How far from the triangles on both sides of c d places of those on both sides of a b are, if
/// these lie on each other, folded along a b: no further than a b, anywhere, is from c d, as there
/// all four can be cut into triangles that have two corners in common with one of the others.
double fold(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 along = b - a;
  if (!(along.cross(c - a).dot(along.cross(d - a)) > 0)) {
    return 0;
  }
  const auto distance = [](const Vec3& p, const Vec3& from, const Vec3& to) {
    return (mesh::nearest_on_segment(p, from, to) - p).norm();
  };
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

/// The least height of a tetrahedron: how far the flip of one of its edges moves the surface, if
/// its corners are those of a convex quadrilateral.
double thickness(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double volume = std::abs((b - a).cross(c - a).dot(d - a)) / 6;
  const double base = std::max({area(a, b, c), area(a, b, d), area(a, c, d), area(b, c, d)});
  return base > 0 ? 3 * volume / base : 0;
}

}  // namespace

std::uint32_t third_corner(const Triangle& triangle, std::uint32_t a, std::uint32_t b) {
  for (const std::uint32_t corner : triangle) {
    if (corner != a && corner != b) {
      return corner;
    }
  }
  return a;
}

EditedMesh::EditedMesh(std::span<const Vec3> points, std::span<const Triangle> triangles,
                       std::span<const std::uint32_t> labels,
                       std::span<const std::uint32_t> representatives,
                       std::span<const std::uint8_t> complete)
    : points_(points.begin(), points.end()),
      triangles_(triangles.begin(), triangles.end()),
      labels_(labels),
      representatives_(representatives),
      complete_(complete),
      alive_(triangles_.size(), 1),
      fixed_(points_.size(), 0),
      parent_(triangles_.size()),
      reach_(points_.size(), 0),
      deviation_(triangles_.size(), 0),
      last_edit_(triangles_.size(), 0),
      slice_start_(points_.size() + 1, 0),
      slices_(3 * triangles_.size()),
      own_list_(points_.size(), support::kNone),
      tracker_(points_, triangles_, !complete.empty()) {
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (representatives_[v] != v) {
      fixed_[v] = fixed_[representatives_[v]] = kAtContact;
    }
  }
  for (const Triangle& triangle : triangles_) {
    for (const std::uint32_t v : triangle) {
      ++slice_start_[v + 1];
    }
  }
  for (std::size_t v = 0; v < points_.size(); ++v) {
    slice_start_[v + 1] += slice_start_[v];
  }
  support::BulkVector<std::uint32_t> next(slice_start_.begin(), slice_start_.end() - 1);
  for (std::uint32_t f = 0; f < triangles_.size(); ++f) {
    parent_[f] = f;
    for (const std::uint32_t v : triangles_[f]) {
      slices_[next[v]++] = f;
    }
    if (!all_complete(triangles_[f])) {
      for (const std::uint32_t v : triangles_[f]) {
        fixed_[v] |= kAtBorder;
      }
    }
  }
}

bool EditedMesh::all_complete(std::span<const std::uint32_t> points) const {
  return complete_.empty() ||
         std::ranges::all_of(points, [&](std::uint32_t v) { return complete_[v] != 0; });
}

support::BulkVector<std::uint32_t> EditedMesh::alive_faces() const {
  support::BulkVector<std::uint32_t> faces;
  faces.reserve(triangles_.size());
  for (std::uint32_t f = 0; f < triangles_.size(); ++f) {
    if (alive(f)) {
      faces.push_back(f);
    }
  }
  return faces;
}

std::vector<Fault> EditedMesh::faults_among(std::span<const std::uint32_t> faces) const {
  std::vector<Fault> found = faults();
  for (Fault& fault : found) {
    for (std::uint32_t* face : {&fault.first, &fault.second}) {
      *face = static_cast<std::uint32_t>(std::ranges::lower_bound(faces, *face) - faces.begin());
    }
  }
  return found;
}

TriMesh EditedMesh::mesh_of(std::span<const std::uint32_t> faces) const {
  TriMesh mesh;
  const mesh::UsedPoints used = mesh::used_points(triangles_of(faces), points_.size());
  support::reserve_bulk(mesh.points, used.points.size());
  for (const std::uint32_t v : used.points) {
    mesh.points.push_back(points_[v].array() + 0.0);
  }
  support::reserve_bulk(mesh.triangles, faces.size());
  support::reserve_bulk(mesh.labels, labels_.empty() ? 0 : faces.size());
  for (const std::uint32_t face : faces) {
    mesh.triangles.push_back(used.renumbered(triangles_[face]));
    if (!labels_.empty()) {
      mesh.labels.push_back(labels_[parent_[face]]);
    }
  }
  return mesh;
}

support::BulkVector<Triangle> EditedMesh::triangles_of(std::span<const std::uint32_t> faces) const {
  support::BulkVector<Triangle> triangles;
  triangles.reserve(faces.size());
  for (const std::uint32_t f : faces) {
    triangles.push_back(triangles_[f]);
  }
  return triangles;
}

std::span<const std::uint32_t> EditedMesh::faces(std::uint32_t vertex) const {
  if (own_list_[vertex] != support::kNone) {
    return lists_[own_list_[vertex]];
  }
  return std::span(slices_).subspan(slice_start_[vertex],
                                    slice_start_[vertex + 1] - slice_start_[vertex]);
}

void EditedMesh::set_faces(std::uint32_t vertex, std::vector<std::uint32_t> faces) {
  if (own_list_[vertex] == support::kNone) {
    own_list_[vertex] = static_cast<std::uint32_t>(lists_.size());
    lists_.emplace_back();
  }
  lists_[own_list_[vertex]] = std::move(faces);
}

void EditedMesh::add_face(std::uint32_t vertex, std::uint32_t face) {
  const auto old = faces(vertex);
  std::vector<std::uint32_t> list(old.begin(), old.end());
  list.push_back(face);
  set_faces(vertex, std::move(list));
}

void EditedMesh::drop_face(std::uint32_t vertex, std::uint32_t face) {
  const auto old = faces(vertex);
  std::vector<std::uint32_t> list(old.begin(), old.end());
  std::erase(list, face);
  set_faces(vertex, std::move(list));
}

std::optional<std::uint32_t> EditedMesh::face_with_edge(std::uint32_t a, std::uint32_t b) const {
  for (const std::uint32_t f : faces(a)) {
    const Triangle& t = triangles_[f];
    for (int i = 0; i < 3; ++i) {
      if (t[i] == a && t[(i + 1) % 3] == b) {
        return f;
      }
    }
  }
  return std::nullopt;
}

/// The link condition: contracting the edge keeps a closed 2-manifold.
bool EditedMesh::collapsible(std::uint32_t from, std::uint32_t to) const {
  std::vector<std::uint32_t> around_from, around_to, common;
  std::size_t faces_at_edge = 0;
  for (const std::uint32_t f : faces(from)) {
    around_from.insert(around_from.end(), triangles_[f].begin(), triangles_[f].end());
    faces_at_edge += has(triangles_[f], to) ? 1 : 0;
  }
  for (const std::uint32_t f : faces(to)) {
    around_to.insert(around_to.end(), triangles_[f].begin(), triangles_[f].end());
  }
  support::sort_unique(around_from);
  support::sort_unique(around_to);
  std::set_intersection(around_from.begin(), around_from.end(), around_to.begin(), around_to.end(),
                        std::back_inserter(common));
  if (faces_at_edge != 2 || common.size() != 4) {  // the ends and the two opposite corners
    return false;
  }
  std::erase(common, from);
  std::erase(common, to);
  const auto on_opposite_edge = [&](std::uint32_t f) {
    return has(triangles_[f], common[0]) && has(triangles_[f], common[1]);
  };
  return !(std::ranges::any_of(faces(from), on_opposite_edge) &&
           std::ranges::any_of(faces(to), on_opposite_edge));
}

bool EditedMesh::collapse(std::uint32_t from, std::uint32_t to, const EditRule& rule) {
  const double moved = reach_[from] + (points_[from] - points_[to]).norm();
  const auto all = faces(from);
  // Of points at a contact one may take another's place.
  const bool is_copy =
      points_[from] == points_[to] && representatives_[from] == representatives_[to];
  const bool is_fixed = fixed_[from] == kAtContact ? !is_copy : fixed_[from] != 0;
  if (is_fixed || moved > rule.reach || !tracker_.may_try(now(), all, rule.faults) ||
      !collapsible(from, to)) {
    return false;
  }
  const TriedEdit edit{.kind = TriedEdit::Kind::collapse, .what = from, .how = to};
  if (is_vain(edit, all, rule)) {
    return false;
  }
  std::vector<std::uint32_t> dying, changing;
  for (const std::uint32_t f : all) {
    (has(triangles_[f], to) ? dying : changing).push_back(f);
  }
  for (const std::uint32_t f : dying) {
    alive_[f] = 0;
  }
  for (const std::uint32_t f : changing) {
    triangles_[f] = replaced(triangles_[f], from, to);
  }
  if (!settle(edit, all, changing, rule)) {
    for (const std::uint32_t f : dying) {
      alive_[f] = 1;
    }
    for (const std::uint32_t f : changing) {
      triangles_[f] = replaced(triangles_[f], to, from);
    }
    return false;
  }
  for (const std::uint32_t f : dying) {
    drop_face(to, f);
    drop_face(third_corner(triangles_[f], from, to), f);
  }
  for (const std::uint32_t f : changing) {
    add_face(to, f);
  }
  set_faces(from, {});
  reach_[to] = std::max(reach_[to], moved);
  return true;
}

bool EditedMesh::flip(std::uint32_t face, int edge, const EditRule& rule) {
  const std::uint32_t a = triangles_[face][edge], b = triangles_[face][(edge + 1) % 3],
                      c = triangles_[face][(edge + 2) % 3];
  const auto across = face_with_edge(b, a);
  if (!across || *across == face) {
    return false;
  }
  const std::array<std::uint32_t, 2> pair = {face, *across};
  const std::uint32_t d = third_corner(triangles_[*across], a, b);
  const std::array<std::uint32_t, 4> corners = {a, b, c, d};
  if (!tracker_.may_try(now(), pair, rule.faults) || !all_complete(corners) || c == d ||
      face_with_edge(c, d) || face_with_edge(d, c)) {
    return false;
  }
  const Vec3 &pa = points_[a], &pb = points_[b], &pc = points_[c], &pd = points_[d];
  const double moved = std::max(deviation_[face], deviation_[*across]) + thickness(pa, pb, pc, pd) +
                       overhang(pa, pb, pc, pd) + fold(pa, pb, pc, pd);
  const double mine = area(pa, pb, pc), others = area(pa, pb, pd);
  const bool mixes = !labels_.empty() && labels_[parent_[face]] != labels_[parent_[*across]];
  const bool needle = 2 * std::min(mine, others) <= rule.reach * (pa - pb).norm();
  if (!(moved <= rule.reach) || (mixes && !needle)) {
    return false;
  }
  const TriedEdit edit{
      .kind = TriedEdit::Kind::flip, .what = face, .how = static_cast<std::uint32_t>(edge)};
  if (is_vain(edit, pair, rule)) {
    return false;
  }
  const std::array<Triangle, 2> before = {triangles_[face], triangles_[*across]};
  triangles_[face] = {a, d, c};
  triangles_[*across] = {d, b, c};
  if (!settle(edit, pair, pair, rule)) {
    triangles_[face] = before[0];
    triangles_[*across] = before[1];
    return false;
  }
  if (mixes) {  // the needle's area is taken over by the label of the other one
    parent_[face] = parent_[*across] = mine > others ? parent_[face] : parent_[*across];
  }
  drop_face(b, face);
  drop_face(a, *across);
  add_face(d, face);
  add_face(c, *across);
  deviation_[face] = deviation_[*across] = moved;
  return true;
}

bool EditedMesh::move(std::uint32_t vertex, const Vec3& position, const EditRule& rule) {
  const double moved = reach_[vertex] + (position - points_[vertex]).norm();
  const auto around = faces(vertex);
  if (fixed_[vertex] != 0 || moved > rule.reach || !tracker_.may_try(now(), around, rule.faults)) {
    return false;
  }
  const TriedEdit edit{.kind = TriedEdit::Kind::move, .what = vertex, .place = position};
  if (is_vain(edit, around, rule)) {
    return false;
  }
  const Vec3 before = points_[vertex];
  points_[vertex] = position;
  if (!settle(edit, around, around, rule)) {
    points_[vertex] = before;
    return false;
  }
  reach_[vertex] = moved;
  return true;
}

/// Whether an edit of the faces would be refused as it was before; that counts as a trial, too.
bool EditedMesh::is_vain(const TriedEdit& edit, std::span<const std::uint32_t> faces,
                         const EditRule& rule) {
  const std::size_t faults =
      rule.faults == FaultRule::fewer ? vain_.faults_of(edit, faces, last_edit_) : 0;
  if (faults == 0 || faults < tracker_.count_of(faces)) {
    return false;
  }
  tracker_.count_trial();
  return true;
}

/// Decides on an edit that has been made for trial.
bool EditedMesh::settle(const TriedEdit& edit, std::span<const std::uint32_t> before,
                        std::span<const std::uint32_t> after, const EditRule& rule) {
  const bool accepted = tracker_.accept(now(), before, after, rule.faults);
  if (!accepted && rule.faults == FaultRule::fewer) {
    vain_.refuse(edit, edits_, tracker_.found());
  }
  if (accepted) {
    edited_.insert(edited_.end(), after.begin(), after.end());
    ++edits_;
    std::ranges::for_each(before, [&](std::uint32_t face) { last_edit_[face] = edits_; });
  }
  return accepted;
}

void EditedMesh::remove(std::span<const std::uint32_t> faces) {
  tracker_.remove(faces);
  vain_.clear();
  for (const std::uint32_t f : faces) {
    alive_[f] = 0;
    for (const std::uint32_t v : triangles_[f]) {
      set_faces(v, {});
    }
  }
}

void EditedMesh::take_over(const EditedMesh& part, std::span<const std::uint32_t> faces,
                           std::span<const std::uint32_t> points) {
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (part.last_edit_[f] != 0 || !part.alive(f)) {
      const std::uint32_t face = faces[f];
      const auto& [a, b, c] = part.triangles_[f];
      triangles_[face] = {points[a], points[b], points[c]};
      alive_[face] = part.alive_[f];
      parent_[face] = faces[part.parent_[f]];
      deviation_[face] = part.deviation_[f];
      last_edit_[face] = part.last_edit_[f] == 0 ? 0 : edits_ + part.last_edit_[f];
      edited_.push_back(face);
    }
  }
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (part.own_list_[v] != support::kNone) {
      const std::vector<std::uint32_t>& around = part.lists_[part.own_list_[v]];
      set_faces(points[v], support::selected(faces, around));
    }
    points_[points[v]] = part.points_[v];
    reach_[points[v]] = std::max(reach_[points[v]], part.reach_[v]);
  }
  edits_ += part.edits_;
  tracker_.points_have_moved();
  vain_.clear();
  tracker_.add(renumbered(part.faults(), faces));
}

void EditedMesh::place(std::span<const Vec3> points) {
  support::for_each_block(points.size(), [&](const support::Block& block) {
    for (std::size_t v = block.begin; v < block.end; ++v) {
      reach_[v] += (points[v] - points_[v]).norm();
      points_[v] = points[v];
    }
  });
  tracker_.points_have_moved();
  vain_.clear();
}

std::vector<std::uint32_t> EditedMesh::take_edited() {
  std::vector<std::uint32_t> faces = std::move(edited_);
  edited_.clear();
  support::sort_unique(faces);
  std::erase_if(faces, [&](std::uint32_t f) { return !alive(f); });
  return faces;
}

}  // namespace dupin::rounding
