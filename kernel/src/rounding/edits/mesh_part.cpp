#include "rounding/edits/mesh_part.h"

#include <algorithm>
#include <iterator>

#include "boxes/boxes_near.h"
#include "mesh/used_points.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

/// A part with more of the triangles than one in so many saves little.
constexpr std::size_t kShare = 4;

/// Edits change the triangles of faults, those around them, and those that share points with
/// these.
constexpr int kRings = 2;

/// Marks the points of triangles.
std::vector<std::uint8_t> points_of(const BrokenMesh& mesh, std::span<const std::uint32_t> faces) {
  std::vector<std::uint8_t> marks(mesh.doubles.size(), 0);
  for (const std::uint32_t face : faces) {
    for (const std::uint32_t v : mesh.triangles[face]) {
      marks[v] = 1;
    }
  }
  return marks;
}

/// The triangles that share points with others, and these.
std::vector<std::uint32_t> ring(const BrokenMesh& mesh, std::span<const std::uint32_t> faces) {
  const support::BulkVector<std::uint8_t> marked =
      marked_faces(mesh.triangles, points_of(mesh, faces));
  return support::indices_where(marked.size(),
                                [&](std::uint32_t face) { return marked[face] != 0; });
}

boxes::FramedTriangle framed(const boxes::BoxQuantizer& frame, std::span<const Vec3> points,
                             const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  return frame.map(points[a], points[b], points[c]);
}

/// The triangles with boxes near those in the tree.
std::vector<std::uint32_t> faces_near(const boxes::BoxTree& tree, const boxes::BoxQuantizer& frame,
                                      std::span<const Vec3> points,
                                      std::span<const Triangle> triangles) {
  const support::BulkVector<boxes::FramedPoint> mapped = frame.map(points);
  return boxes::boxes_near(tree, triangles.size(), [&](std::uint32_t face) {
    const auto& [a, b, c] = triangles[face];
    return frame.around({mapped[a], mapped[b], mapped[c]});
  });
}

}  // namespace

std::optional<MeshPart> MeshPart::around(const BrokenMesh& whole,
                                         std::span<const std::uint32_t> broken, double reach,
                                         double step) {
  std::vector<std::uint32_t> core(broken.begin(), broken.end());
  for (int i = 0; i < kRings; ++i) {
    core = ring(whole, core);
    if (core.size() * kShare > whole.triangles.size()) {
      return std::nullopt;
    }
  }
  const boxes::BoxQuantizer frame(whole.doubles, whole.triangles);
  std::vector<boxes::Box> zones;
  zones.reserve(core.size());
  for (const std::uint32_t face : core) {
    zones.push_back(
        frame.around(framed(frame, whole.doubles, whole.triangles[face]), 2 * (reach + step)));
  }
  boxes::BoxTree tree(zones);
  std::vector<std::uint32_t> faces = faces_near(tree, frame, whole.on_lattice, whole.triangles);
  if (faces.size() * kShare > whole.triangles.size()) {
    return std::nullopt;
  }
  const std::vector<std::uint8_t> in_core = points_of(whole, core);
  MeshPart part(whole, std::move(faces), [&](std::uint32_t v) { return in_core[v] != 0; });
  part.zones_ = Zones{frame, std::move(zones), std::move(tree)};
  return part;
}

MeshPart::MeshPart(const BrokenMesh& whole, std::vector<std::uint32_t> faces,
                   const std::function<bool(std::uint32_t)>& is_complete)
    : faces_(std::move(faces)) {
  triangles_ = support::selected(whole.triangles, faces_);
  mesh::UsedPoints used = mesh::used_points(triangles_, whole.doubles.size());
  for (Triangle& triangle : triangles_) {
    triangle = used.renumbered(triangle);
  }
  points_ = std::move(used.points);
  complete_.reserve(points_.size());
  for (const std::uint32_t point : points_) {
    complete_.push_back(is_complete(point) ? 1 : 0);
  }
  doubles_ = support::selected(whole.doubles, points_);
  on_lattice_ = support::selected(whole.on_lattice, points_);
  if (!whole.labels.empty()) {
    labels_ = support::selected(whole.labels, faces_);
  }
  representatives_ = representatives_among(points_, whole.representatives);
}

std::vector<std::uint32_t> representatives_among(std::span<const std::uint32_t> points,
                                                 std::span<const std::uint32_t> representatives) {
  support::BulkVector<std::uint32_t> first(representatives.size(), support::kNone);
  std::vector<std::uint32_t> result;
  result.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    std::uint32_t& representative = first[representatives[points[i]]];
    representative = std::min(representative, i);
    result.push_back(representative);
  }
  return result;
}

BrokenMesh MeshPart::view() const {
  return {doubles_, on_lattice_, triangles_, labels_, representatives_, complete_};
}

std::uint32_t MeshPart::face(std::uint32_t of_whole) const {
  return static_cast<std::uint32_t>(std::ranges::lower_bound(faces_, of_whole) - faces_.begin());
}

std::vector<std::uint32_t> MeshPart::numbered(std::span<const std::uint32_t> of_whole) const {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(of_whole.size());
  std::ranges::transform(of_whole, std::back_inserter(numbers),
                         [&](std::uint32_t f) { return face(f); });
  return numbers;
}

std::vector<Fault> MeshPart::numbered(std::span<const Fault> of_whole) const {
  std::vector<Fault> faults;
  faults.reserve(of_whole.size());
  for (const auto& [first, second] : of_whole) {
    faults.push_back({face(first), face(second)});
  }
  return faults;
}

bool MeshPart::meets_rest(const EditedMesh& repaired, const Embedding& whole) const {
  const Zones& zones = *zones_;
  std::vector<std::uint32_t> edited;
  std::vector<boxes::Box> outside;  // of the zones, which only triangles of the part meet
  for (std::uint32_t f = 0; f < triangles_.size(); ++f) {
    const Triangle& after = repaired.triangle(f);
    const auto moved = [&](std::uint32_t v) { return repaired.point(v) != on_lattice_[v]; };
    if (!repaired.alive(f) || (triangles_[f] == after && std::ranges::none_of(after, moved))) {
      continue;
    }
    const boxes::Box own = zones.frame.around(framed(zones.frame, repaired.points(), after));
    bool in_zone = false;
    zones.tree.visit(own,
                     [&](std::uint32_t i) { in_zone = in_zone || zones.boxes[i].contains(own); });
    if (!in_zone) {
      edited.push_back(faces_[f]);
      outside.push_back(own);
    }
  }
  if (outside.empty()) {
    return false;
  }
  const boxes::BoxTree tree(outside);
  bool meets = false;
  for (const std::uint32_t face : faces_near(tree, zones.frame, whole.points, whole.triangles)) {
    if (!std::ranges::binary_search(faces_, face)) {
      tree.visit(zones.frame.around(framed(zones.frame, whole.points, whole.triangles[face])),
                 [&](std::uint32_t i) { meets = meets || is_faulty_pair(whole, edited[i], face); });
    }
  }
  return meets;
}

void MeshPart::put(const EditedMesh& repaired, TriMesh& whole, std::vector<Source>& sources) const {
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    whole.points[points_[v]] = repaired.point(v).array() + 0.0;
  }
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      whole.triangles[faces_[f]][i] = points_[repaired.triangle(f)[i]];
    }
  }
  const auto own_sources = support::selected(std::span<const Source>(sources), faces_);
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
  support::BulkVector<std::uint32_t> place(mesh.points.size());
  support::for_each_block(place.size(), [&](const support::Block& block) {
    auto next = std::ranges::lower_bound(unused, static_cast<std::uint32_t>(block.begin));
    for (std::size_t i = block.begin; i < block.end; ++i) {
      while (next != unused.end() && *next < i) {
        ++next;
      }
      place[i] = static_cast<std::uint32_t>(i - static_cast<std::size_t>(next - unused.begin()));
    }
  });
  support::for_each_block(mesh.triangles.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      for (std::uint32_t& v : mesh.triangles[i]) {
        v = place[v];
      }
    }
  });
  erase_at(unused, mesh.points);
}

}  // namespace dupin::rounding
