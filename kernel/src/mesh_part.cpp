#include "mesh_part.h"

#include <algorithm>
#include <map>

#include "arrangement/blocks.h"
#include "arrangement/bulk_vector.h"

namespace dupin::detail {
namespace {

/// A part with more of the triangles than one in so many saves little, and so it does where edits
/// may change many.
constexpr std::size_t kShare = 4, kLargestCore = 8192;

/// Edits change the triangles of bad items, those around them, and those that share points with
/// these.
constexpr int kRings = 2;

/// The triangles that share points with others, and these.
std::vector<std::uint32_t> ring(const BrokenMesh& mesh, std::span<const std::uint32_t> faces) {
  std::vector<std::uint8_t> marks(mesh.doubles.size(), 0);
  for (const std::uint32_t face : faces) {
    for (const std::uint32_t v : mesh.triangles[face]) {
      marks[v] = 1;
    }
  }
  return collect_in_order<std::uint32_t>(mesh.triangles.size(),
                                         [&](std::size_t i, std::vector<std::uint32_t>& found) {
                                           const auto& [a, b, c] = mesh.triangles[i];
                                           if ((marks[a] | marks[b] | marks[c]) != 0) {
                                             found.push_back(static_cast<std::uint32_t>(i));
                                           }
                                         });
}

template <class Item>
std::vector<Item> items(std::span<const Item> of_whole, std::span<const std::uint32_t> numbers) {
  std::vector<Item> chosen;
  chosen.reserve(numbers.size());
  for (const std::uint32_t i : numbers) {
    chosen.push_back(of_whole[i]);
  }
  return chosen;
}

/// Ascending.
std::vector<std::uint32_t> corners(std::span<const Triangle> triangles,
                                   std::span<const std::uint32_t> faces) {
  std::vector<std::uint32_t> points;
  points.reserve(3 * faces.size());
  for (const std::uint32_t face : faces) {
    points.insert(points.end(), triangles[face].begin(), triangles[face].end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::uint32_t position(const std::vector<std::uint32_t>& ascending, std::uint32_t number) {
  return static_cast<std::uint32_t>(std::ranges::lower_bound(ascending, number) -
                                    ascending.begin());
}

Bounds bounds(std::span<const Vec3> points, const Triangle& triangle) {
  const Vec3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

/// Calls visit(face, near, found) for the faces in blocks whose boxes meet zones, with the numbers
/// of these zones. Returns what that appends to `found`, in the order of the faces.
template <class Visit>
std::vector<std::uint32_t> visit_near(std::span<const Vec3> points,
                                      std::span<const Triangle> triangles,
                                      std::span<const Bounds> zones, const Visit& visit) {
  constexpr std::size_t kBlock = 512;  // mostly neighbours, far from all zones but few
  std::vector<std::vector<std::uint32_t>> parts(block_count(triangles.size(), kBlock));
  const auto visit_block = [&](const Block& block) {
    Bounds all = bounds(points, triangles[block.begin]);
    for (std::size_t i = block.begin; i < block.end; ++i) {
      all.join(bounds(points, triangles[i]));
    }
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < zones.size(); ++i) {
      if (zones[i].meets(all)) {
        near.push_back(i);
      }
    }
    for (std::size_t i = block.begin; i < block.end && !near.empty(); ++i) {
      visit(static_cast<std::uint32_t>(i), near, parts[block.number]);
    }
  };
  for_each_block(triangles.size(), visit_block, kBlock);
  return joined(std::move(parts));
}

/// The triangles whose rounded ones have boxes that meet a zone.
std::vector<std::uint32_t> faces_in(const BrokenMesh& whole, std::span<const Bounds> zones) {
  return visit_near(
      whole.on_lattice, whole.triangles, zones,
      [&](std::uint32_t face, const std::vector<std::uint32_t>& near,
          std::vector<std::uint32_t>& found) {
        const Bounds own = bounds(whole.on_lattice, whole.triangles[face]);
        if (std::ranges::any_of(near, [&](std::uint32_t i) { return zones[i].meets(own); })) {
          found.push_back(face);
        }
      });
}

}  // namespace

std::optional<MeshPart> MeshPart::around(const BrokenMesh& whole,
                                         std::span<const std::uint32_t> broken, double reach,
                                         double step) {
  std::vector<std::uint32_t> core(broken.begin(), broken.end());
  for (int i = 0; i < kRings; ++i) {
    core = ring(whole, core);
    if (core.size() > kLargestCore) {
      return std::nullopt;
    }
  }
  MeshPart part;
  for (const std::uint32_t face : core) {
    Bounds zone = bounds(whole.doubles, whole.triangles[face]);
    zone.low.array() -= 2 * (reach + step);
    zone.high.array() += 2 * (reach + step);
    part.zones_.push_back(zone);
  }
  part.faces_ = faces_in(whole, part.zones_);
  if (part.faces_.size() * kShare > whole.triangles.size()) {
    return std::nullopt;
  }
  part.copy(whole);
  for (const std::uint32_t v : corners(whole.triangles, core)) {
    part.complete_[position(part.points_, v)] = 1;
  }
  return part;
}

void MeshPart::copy(const BrokenMesh& whole) {
  triangles_ = items(whole.triangles, faces_);
  points_ = corners(whole.triangles, faces_);
  for (Triangle& triangle : triangles_) {
    for (std::uint32_t& v : triangle) {
      v = position(points_, v);
    }
  }
  doubles_ = items(whole.doubles, points_);
  on_lattice_ = items(whole.on_lattice, points_);
  inexact_ = items(whole.inexact, points_);
  complete_.resize(points_.size(), 0);
  if (!whole.labels.empty()) {
    labels_ = items(whole.labels, faces_);
  }
  std::map<std::uint32_t, std::uint32_t> first;  // in the part, of those of the whole
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    twins_.push_back(first.try_emplace(whole.twins[points_[i]], i).first->second);
  }
}

BrokenMesh MeshPart::view() const {
  return {doubles_, on_lattice_, inexact_, triangles_, labels_, twins_, complete_};
}

std::uint32_t MeshPart::face(std::uint32_t of_whole) const { return position(faces_, of_whole); }

bool MeshPart::meets_rest(const RepairMesh& repaired, const Embedding& whole) const {
  std::vector<std::uint32_t> edited;
  std::vector<Bounds> outside;  // of the zones, which only triangles of the part meet
  for (std::uint32_t f = 0; f < triangles_.size(); ++f) {
    const Triangle& after = repaired.triangle(f);
    const auto moved = [&](std::uint32_t v) { return repaired.point(v) != on_lattice_[v]; };
    if (!repaired.alive(f) || (triangles_[f] == after && std::ranges::none_of(after, moved))) {
      continue;
    }
    const Bounds own = bounds(repaired.points(), after);
    if (std::ranges::none_of(zones_, [&](const Bounds& zone) { return zone.contains(own); })) {
      edited.push_back(faces_[f]);
      outside.push_back(own);
    }
  }
  if (outside.empty()) {
    return false;
  }
  const auto meets = [&](std::uint32_t face, const std::vector<std::uint32_t>& near,
                         std::vector<std::uint32_t>& found) {
    const Bounds own = bounds(whole.points, whole.triangles[face]);
    for (const std::uint32_t i : near) {
      if (outside[i].meets(own) && !std::ranges::binary_search(faces_, face) &&
          is_bad_pair(whole, edited[i], face)) {
        found.push_back(face);
      }
    }
  };
  return !visit_near(whole.points, whole.triangles, outside, meets).empty();
}

void MeshPart::put(const RepairMesh& repaired, TriMesh& whole, std::vector<Source>& sources) const {
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    whole.points[points_[v]] = repaired.point(v).array() + 0.0;
  }
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      whole.triangles[faces_[f]][i] = points_[repaired.triangle(f)[i]];
    }
  }
  const auto own_sources = items(std::span<const Source>(sources), faces_);
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const std::uint32_t parent = repaired.parent(f);
    sources[faces_[f]] = own_sources[parent];
    if (!labels_.empty()) {
      whole.labels[faces_[f]] = labels_[parent];
    }
  }
}

void MeshPart::put_back(std::vector<Vec3>& points) const {
  for (std::size_t v = 0; v < points_.size(); ++v) {
    points[points_[v]] = on_lattice_[v];
  }
}

void erase_points(std::span<const std::uint32_t> unused, TriMesh& mesh) {
  if (unused.empty()) {
    return;
  }
  BulkVector<std::uint32_t> place(mesh.points.size());
  for_each_block(place.size(), [&](const Block& block) {
    auto next = std::ranges::lower_bound(unused, static_cast<std::uint32_t>(block.begin));
    for (std::size_t i = block.begin; i < block.end; ++i) {
      while (next != unused.end() && *next < i) {
        ++next;
      }
      place[i] = static_cast<std::uint32_t>(i - static_cast<std::size_t>(next - unused.begin()));
    }
  });
  for_each_block(mesh.triangles.size(), [&](const Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      for (std::uint32_t& v : mesh.triangles[i]) {
        v = place[v];
      }
    }
  });
  erase_at(unused, mesh.points);
}

}  // namespace dupin::detail
