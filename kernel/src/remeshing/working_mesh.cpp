#include "remeshing/working_mesh.h"

#include <algorithm>
#include <functional>
#include <queue>

#include "checking/self_intersection.h"
#include "mesh/coincident_points.h"
#include "support/sequences.h"

namespace dupin::remeshing {

WorkingMesh::WorkingMesh(const TriMesh& mesh, const Features& features)
    : around_(mesh.points.size()), representatives_(mesh::coincident_representatives(mesh.points)) {
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    points_.push_back({mesh.points[v], features.freedoms[v], 0, 0});
  }
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    faces_.push_back({mesh.triangles[f], features.spans[f], features.regions[f], f});
    for (const std::uint32_t v : mesh.triangles[f]) {
      around_[v].push_back(f);
    }
  }
  alive_.assign(faces_.size(), 1);
  alive_count_ = faces_.size();
}

std::optional<WorkingMesh::Side> WorkingMesh::side(std::uint32_t a, std::uint32_t b) const {
  for (const std::uint32_t f : around_[a]) {
    const int i = faces_[f].corner(a);
    if (faces_[f].corners[(i + 1) % 3] == b) {
      return Side{f, i};
    }
  }
  return std::nullopt;
}

std::vector<std::uint32_t> WorkingMesh::neighbours(std::uint32_t v) const {
  std::vector<std::uint32_t> ring;
  for (const std::uint32_t f : around_[v]) {
    ring.push_back(faces_[f].corners[(faces_[f].corner(v) + 1) % 3]);
  }
  std::sort(ring.begin(), ring.end());
  return ring;
}

void WorkingMesh::put(std::uint32_t slot, const Face& face) {
  faces_[slot] = face;
  alive_[slot] = 1;
  ++alive_count_;
  for (const std::uint32_t v : face.corners) {
    around_[v].push_back(slot);
  }
}

void WorkingMesh::take(std::uint32_t slot) {
  alive_[slot] = 0;
  --alive_count_;
  for (const std::uint32_t v : faces_[slot].corners) {
    std::erase(around_[v], slot);
  }
}

Applied WorkingMesh::apply(const Edit& edit) {
  Applied applied;
  if (edit.added) {
    applied.added = point_count();
    points_.push_back(*edit.added);
    around_.emplace_back();
  }
  if (edit.moved) {
    applied.moved = {edit.moved->first, place(edit.moved->first)};
    points_[edit.moved->first].place = edit.moved->second;
  }
  for (const std::uint32_t f : edit.before) {
    applied.before.emplace_back(f, faces_[f]);
    take(f);
  }
  for (std::size_t i = 0; i < edit.after.size(); ++i) {
    Face face = edit.after[i];
    std::replace(face.corners.begin(), face.corners.end(), kAdded, applied.added);
    std::uint32_t slot = 0;
    if (i < edit.before.size()) {
      slot = edit.before[i];
    } else if (!free_.empty()) {
      slot = free_.back();
      free_.pop_back();
    } else {
      slot = face_count();
      faces_.emplace_back();
      alive_.push_back(0);
    }
    put(slot, face);
    applied.after.push_back(slot);
  }
  for (std::size_t i = edit.after.size(); i < edit.before.size(); ++i) {
    free_.push_back(edit.before[i]);
  }
  return applied;
}

void WorkingMesh::undo(const Applied& applied) {
  for (const std::uint32_t f : applied.after) {
    take(f);
  }
  for (const auto& [f, face] : applied.before) {
    put(f, face);
    std::erase(free_, f);
  }
  for (std::size_t i = applied.before.size(); i < applied.after.size(); ++i) {
    free_.push_back(applied.after[i]);
  }
  if (applied.moved) {
    points_[applied.moved->first].place = applied.moved->second;
  }
}

void WorkingMesh::grade_sizes(double gradation) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::uint32_t v = 0; v < point_count(); ++v) {
    points_[v].size = points_[v].wish;
    if (is_used(v)) {
      queue.emplace(points_[v].size, v);
    }
  }
  while (!queue.empty()) {
    const auto [size, v] = queue.top();
    queue.pop();
    if (size > points_[v].size) {
      continue;
    }
    for (const std::uint32_t f : around_[v]) {
      for (const std::uint32_t w : faces_[f].corners) {
        const double most = size + gradation * length(v, w);
        if (most < points_[w].size) {
          points_[w].size = most;
          queue.emplace(most, w);
        }
      }
    }
  }
}

std::vector<std::uint32_t> WorkingMesh::faulty(std::span<const std::uint32_t> marked) const {
  std::vector<std::uint32_t> numbers, position(face_count()), representatives(point_count());
  std::vector<Triangle> triangles;
  std::vector<Vec3> places;
  places.reserve(point_count());
  for (std::uint32_t v = 0; v < point_count(); ++v) {
    places.push_back(place(v));
    representatives[v] = v < representatives_.size() ? representatives_[v] : v;
  }
  for (std::uint32_t f = 0; f < face_count(); ++f) {
    if (alive(f)) {
      position[f] = static_cast<std::uint32_t>(numbers.size());
      numbers.push_back(f);
      triangles.push_back(faces_[f].corners);
    }
  }
  std::vector<std::uint8_t> active(triangles.size(), 0);
  for (const std::uint32_t f : marked) {
    active[position[f]] = 1;
  }
  const checking::SelfIntersections found = checking::find_self_intersections(
      places, triangles, {.active = active, .representatives = representatives, .closed = true});
  std::vector<std::uint32_t> faults;
  for (const std::uint32_t face : found.degenerate) {
    faults.push_back(numbers[face]);
  }
  for (const checking::FacePair& pair : found.pairs) {
    if (pair.kind != checking::FacePair::Kind::contact) {
      faults.push_back(numbers[pair.first]);
      faults.push_back(numbers[pair.second]);
    }
  }
  support::sort_unique(faults);
  return faults;
}

std::pair<TriMesh, std::vector<std::uint32_t>> WorkingMesh::compact() const {
  TriMesh mesh;
  std::vector<std::uint32_t> numbers, position(point_count());
  for (std::uint32_t v = 0; v < point_count(); ++v) {
    position[v] = static_cast<std::uint32_t>(mesh.points.size());
    if (is_used(v)) {
      mesh.points.push_back(place(v));
    }
  }
  for (std::uint32_t f = 0; f < face_count(); ++f) {
    if (alive(f)) {
      const auto& [a, b, c] = faces_[f].corners;
      mesh.triangles.push_back({position[a], position[b], position[c]});
      numbers.push_back(f);
    }
  }
  return {std::move(mesh), std::move(numbers)};
}

}  // namespace dupin::remeshing
