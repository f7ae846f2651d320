#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "checking/self_intersection.h"
#include "dupin/kernel/connected_components.h"
#include "dupin/kernel/districts.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "support/disjoint_sets.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin {
namespace {

/// 0.0 and -0.0 are the same place.
struct PlaceOrder {
  bool operator()(const Vec3& a, const Vec3& b) const {
    return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
  }
};

constexpr PlaceOrder kLess;

using Corners = std::array<Vec3, 3>;

Corners corners_of(const TriMesh& mesh, std::size_t face) {
  const auto& [a, b, c] = mesh.triangles[face];
  return {mesh.points[a], mesh.points[b], mesh.points[c]};
}

/// The same triangles in the same order, whatever corner they begin with.
std::vector<Vec3> ordered(std::vector<Corners> triangles) {
  for (Corners& corners : triangles) {
    std::ranges::rotate(corners, std::ranges::min_element(corners, kLess));
  }
  std::ranges::sort(triangles, [](const Corners& a, const Corners& b) {
    return std::ranges::lexicographical_compare(a, b, kLess);
  });
  std::vector<Vec3> result;
  for (const Corners& corners : triangles) {
    result.insert(result.end(), corners.begin(), corners.end());
  }
  return result;
}

std::vector<Vec3> turned(const std::vector<Vec3>& triangles) {
  std::vector<Corners> result;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    result.push_back({triangles[i], triangles[i + 2], triangles[i + 1]});
  }
  return ordered(std::move(result));
}

/// What lies beside both sides of a seam, those in one place being one point.
class BothSides {
 public:
  BothSides(std::span<const Vec3> one, std::span<const Vec3> other) {
    const std::vector<Vec3> own = places_of(one), others = places_of(other);
    std::ranges::set_intersection(own, others, std::back_inserter(common_), kLess);
    std::ranges::set_union(own, others, std::back_inserter(places_), kLess);
    append(one, 0);
    append(other, 1);
  }

  [[nodiscard]] static std::vector<Vec3> places_of(std::span<const Vec3> triangles) {
    std::vector<Vec3> places(triangles.begin(), triangles.end());
    std::ranges::sort(places, kLess);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }

  /// The points of both, ascending.
  [[nodiscard]] const std::vector<Vec3>& common() const { return common_; }

  /// Whether no edge is one of more than two triangles, nor run through twice the same way.
  [[nodiscard]] bool are_edges_of_two() const {
    std::vector<std::array<std::uint32_t, 3>> edges;
    edges.reserve(3 * triangles_.size());
    for (const Triangle& corners : triangles_) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = corners.at(k), to = corners.at((k + 1) % 3);
        edges.push_back({std::min(from, to), std::max(from, to), from < to ? 0U : 1U});
      }
    }
    std::ranges::sort(edges);  // two turned against each other differ
    return std::ranges::adjacent_find(edges) == edges.end();
  }

  /// Whether a triangle of the one meets one of the other, but as neighbours do.
  [[nodiscard]] bool meet() const {
    std::vector<std::uint32_t> own_places(places_.size());
    std::iota(own_places.begin(), own_places.end(), 0U);
    return !checking::find_self_intersections(
                places_, triangles_,
                {.limit = 0, .representatives = own_places, .groups = side_of_})
                .none();
  }

 private:
  void append(std::span<const Vec3> triangles, std::uint32_t side) {
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
      triangles_.push_back({point(triangles[i]), point(triangles[i + 1]), point(triangles[i + 2])});
      side_of_.push_back(side);
    }
  }
  [[nodiscard]] std::uint32_t point(const Vec3& place) const {
    const auto found = std::ranges::lower_bound(places_, place, kLess);
    return static_cast<std::uint32_t>(found - places_.begin());
  }

  std::vector<Vec3> common_, places_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> side_of_;
};

/// How often each edge of the triangles is run through more one way than the other, by its ends.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edge_counts(const TriMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> counts;
  for (const Triangle& corners : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = corners.at(k), to = corners.at((k + 1) % 3);
      counts[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  return counts;
}

/// The points of borders that are closed curves without common points, each from its least place
/// on, in the order of these; none of any others.
std::vector<std::vector<std::uint32_t>> borders_of(const TriMesh& mesh) {
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [ends, count] : edge_counts(mesh)) {
    const auto& [low, high] = ends;
    if (count < -1 || count > 1 ||
        (count != 0 && !next.try_emplace(count > 0 ? low : high, count > 0 ? high : low).second)) {
      return {};
    }
  }
  const auto is_before = [&](std::uint32_t a, std::uint32_t b) {
    return kLess(mesh.points[a], mesh.points[b]);
  };
  std::vector<std::vector<std::uint32_t>> borders;
  while (!next.empty()) {
    std::vector<std::uint32_t>& border = borders.emplace_back();
    for (auto step = next.begin(); step != next.end(); step = next.find(border.back())) {
      border.push_back(step->second);
      next.erase(step);
    }
    std::ranges::rotate(border, std::ranges::min_element(border, is_before));
  }
  std::ranges::sort(borders, is_before, [](const auto& border) { return border.front(); });
  return borders;
}

/// Points in one place being different ones; a disc or an annulus: connected, with one border or
/// two, and with these a sphere.
bool is_end(const TriMesh& mesh, std::size_t borders) {
  const std::vector<std::uint32_t> parts = connected_components(mesh.triangles, mesh.points.size());
  const bool is_one =
      std::ranges::all_of(parts, [&](std::uint32_t part) { return part == parts[0]; });
  std::vector<Vec3> places = mesh.points;
  std::ranges::sort(places, kLess);
  const bool are_apart = std::ranges::adjacent_find(places) == places.end();
  const auto euler = static_cast<std::ptrdiff_t>(mesh.points.size() + mesh.triangles.size()) -
                     static_cast<std::ptrdiff_t>(edge_counts(mesh).size());
  return is_one && are_apart && (borders == 1 || borders == 2) &&
         euler + static_cast<std::ptrdiff_t>(borders) == 2;
}

/// Of places that have lost the origin; however the sum is rounded.
Eigen::AlignedBox3d box_of(const Corners& corners, const Vec3& origin) {
  Eigen::AlignedBox3d box;
  for (const Vec3& corner : corners) {
    box.extend(corner + origin);
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    box.min()[k] = std::nextafter(box.min()[k], -kInfinity);
    box.max()[k] = std::nextafter(box.max()[k], kInfinity);
  }
  return box;
}

/// The triangles of one label, with points of their own.
struct EndMesh {
  TriMesh mesh;
  std::vector<std::uint32_t> points;  // those of `mesh`, in the whole's

  void add(const Triangle& corners, std::span<const Vec3> places) {
    Triangle& own = mesh.triangles.emplace_back(corners);
    for (std::uint32_t& corner : own) {
      const auto [entry, is_new] =
          known_.try_emplace(corner, static_cast<std::uint32_t>(points.size()));
      if (is_new) {
        points.push_back(corner);
        mesh.points.push_back(places[corner]);
      }
      corner = entry->second;
    }
  }

 private:
  std::map<std::uint32_t, std::uint32_t> known_;
};

class Opener {
 public:
  Opener(const TriMesh& mesh, const Vec3& origin, std::span<const Seam> seams)
      : mesh_(mesh),
        origin_(origin),
        seams_(seams),
        part_of_(connected_components(mesh.triangles, mesh.points.size())),
        ends_(seams.size()) {
    std::map<std::string, std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < seams.size(); ++i) {
      numbers.emplace(seams[i].name, i);
    }
    std::vector<std::uint32_t> of_label(mesh.names.size(), support::kNone);
    for (std::size_t label = 0; label < of_label.size(); ++label) {
      const auto found = numbers.find(mesh.names[label]);
      of_label[label] = found == numbers.end() ? support::kNone : found->second;
    }
    for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
      const std::uint32_t seam = mesh.labels.empty() ? support::kNone : of_label[mesh.labels[face]];
      if (seam == support::kNone) {
        left_.push_back(mesh.triangles[face]);
        left_faces_.push_back(face);
      } else {
        ends_[seam].add(mesh.triangles[face], mesh.points);
        end_faces_.push_back(face);
      }
    }
  }

  OpenPiece run(Report report) {
    OpenPiece result;
    result.sides = sides(report.shells);
    open_shells(result.sides, report);
    take_ends(report);
    result.end_faces = std::move(end_faces_);
    result.report = std::move(report);
    return result;
  }

 private:
  /// Without shells.
  [[nodiscard]] std::vector<SeamSide> sides(std::span<const ShellReport> shells) {
    std::vector<SeamSide> result(seams_.size());
    for (std::size_t i = 0; i < left_.size(); ++i) {
      const Corners corners = corners_of(mesh_, left_faces_[i]);
      const Eigen::AlignedBox3d box = box_of(corners, origin_);
      for (std::size_t seam = 0; seam < seams_.size(); ++seam) {
        if (box.intersects(seams_[seam].meeting)) {
          result[seam].near.insert(result[seam].near.end(), corners.begin(), corners.end());
        }
      }
    }
    std::map<std::uint32_t, int> in_part;  // shells
    std::map<std::uint32_t, int> depth;    // of the last of them
    for (const ShellReport& shell : shells) {
      const std::uint32_t part = part_of_[mesh_.triangles[shell.first_face][0]];
      ++in_part[part];
      depth[part] = shell.depth;
    }
    for (std::size_t seam = 0; seam < seams_.size(); ++seam) {
      const EndMesh& end = ends_[seam];
      std::vector<Corners> triangles;
      for (std::size_t face = 0; face < end.mesh.triangles.size(); ++face) {
        triangles.push_back(corners_of(end.mesh, face));
      }
      result[seam].end = ordered(std::move(triangles));
      borders_.push_back(borders_of(end.mesh));
      if (!end.points.empty() && is_end(end.mesh, borders_.back().size())) {
        const std::uint32_t part = part_of_[end.points.front()];
        result[seam].is_end = in_part[part] == 1 && depth[part] == 0;
      }
    }
    return result;
  }

  /// The report's shells become those that are left.
  void open_shells(std::vector<SeamSide>& sides, Report& report) const {
    const mesh::EdgeTable edges(left_, mesh_.points.size());
    const mesh::Shells left = mesh::shells(left_.size(), edges);
    const std::vector<std::int64_t> eulers =
        mesh::euler_numbers(left, edges, mesh::corner_fans(left_, edges));
    std::map<std::uint32_t, ShellReport> closed;  // by first face
    for (const ShellReport& shell : report.shells) {
      closed.emplace(shell.first_face, shell);
      report.euler_number -= shell.euler_number;
    }
    const std::map<std::uint32_t, std::vector<Triangle>> cones = cones_of(left, sides);
    report.shells.clear();
    bool has_others = false;
    for (std::uint32_t i = 0; i < left.count; ++i) {
      const std::span<const std::uint32_t> faces = left.faces_of(i);
      ShellReport shell{faces.front(), faces.size(), 0, 0, eulers[i]};
      const auto whole = closed.find(left_faces_[faces.front()]);
      if (whole != closed.end() && whole->second.triangles == faces.size()) {
        shell.volume = whole->second.volume;
        shell.depth = whole->second.depth;
        has_others = has_others || shell.depth % 2 == 0;
      } else if (const auto own = cones.find(i); own != cones.end()) {
        std::vector<Triangle> triangles =
            support::selected(std::span<const Triangle>(left_), faces);
        triangles.insert(triangles.end(), own->second.begin(), own->second.end());
        shell.volume = mesh::nearest_volume({mesh_.points, triangles});
      }
      report.euler_number += shell.euler_number;
      report.shells.push_back(shell);
    }
    for (SeamSide& side : sides) {
      side.has_others = has_others;
    }
  }

  /// What closes shells, one by one: cones over borders, from their least places. The other side
  /// has the same ones, so that volumes add up to those of shells without them. Notes in the sides
  /// which shells borders are of.
  [[nodiscard]] std::map<std::uint32_t, std::vector<Triangle>> cones_of(
      const mesh::Shells& left, std::vector<SeamSide>& sides) const {
    std::map<std::array<std::uint32_t, 2>, SeamBorder*> along;  // by the first edge, turned
    std::map<const SeamBorder*, std::vector<Triangle>> cone_of;
    for (std::size_t seam = 0; seam < sides.size(); ++seam) {
      sides[seam].borders.resize(sides[seam].is_end ? borders_[seam].size() : 0);
      for (std::size_t k = 0; k < sides[seam].borders.size(); ++k) {
        const std::vector<std::uint32_t>& border = borders_[seam][k];
        const auto at = [&](std::size_t i) { return ends_[seam].points[border[i]]; };
        SeamBorder& own = sides[seam].borders[k];
        own.points = static_cast<std::uint32_t>(border.size());
        along[{at(1), at(0)}] = &own;
        for (std::size_t i = 1; i + 1 < border.size(); ++i) {
          cone_of[&own].push_back({at(0), at(i), at(i + 1)});
        }
      }
    }
    std::map<std::uint32_t, std::vector<Triangle>> result;
    for (std::size_t face = 0; face < left_.size() && !along.empty(); ++face) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto found = along.find({left_[face].at(k), left_[face].at((k + 1) % 3)});
        if (found != along.end()) {
          SeamBorder& border = *found->second;
          border.shell = left.of_face[face];
          const std::vector<Triangle>& cone = cone_of[&border];
          std::vector<Triangle>& all = result[border.shell];
          all.insert(all.end(), cone.begin(), cone.end());
        }
      }
    }
    return result;
  }

  /// Points within ends go, too.
  void take_ends(Report& report) const {
    std::vector<std::uint8_t> is_left(mesh_.points.size(), 0);
    for (const Triangle& corners : left_) {
      for (const std::uint32_t corner : corners) {
        is_left[corner] = 1;
      }
    }
    for (const EndMesh& end : ends_) {
      report.points -= static_cast<std::size_t>(std::ranges::count_if(
          end.points, [&](std::uint32_t point) { return is_left[point] == 0; }));
    }
    report.triangles -= end_faces_.size();
    for (const std::uint32_t face : end_faces_) {
      const auto& [a, b, c] = corners_of(mesh_, face);
      report.area -= (b - a).cross(c - a).norm() / 2;
    }
  }

  const TriMesh& mesh_;
  const Vec3& origin_;
  std::span<const Seam> seams_;
  std::vector<std::uint32_t> part_of_;  // by point
  std::vector<Triangle> left_;
  std::vector<std::uint32_t> left_faces_, end_faces_;             // in the mesh
  std::vector<EndMesh> ends_;                                     // by seam
  std::vector<std::vector<std::vector<std::uint32_t>>> borders_;  // likewise, points of ends_
};

/// What the shells of a report that are joined make: those that borders join are one, and those
/// that the same ends close bound the same material.
struct JoinedShells {
  explicit JoinedShells(std::span<const SeamShells> seams) {
    std::size_t count = 0;
    for (const SeamShells& seam : seams) {
      for (const ShellPair& pair : seam.pairs) {
        count = std::max({count, pair.shells[0] + 1, pair.shells[1] + 1});
      }
    }
    support::DisjointSets shells(count), materials(count);
    const auto number = [](std::size_t shell) { return static_cast<std::uint32_t>(shell); };
    std::vector<std::uint8_t> is_joined(count, 0);
    for (const SeamShells& seam : seams) {
      for (const ShellPair& pair : seam.pairs) {
        shells.unite(number(pair.shells[0]), number(pair.shells[1]));
        for (const std::size_t shell : pair.shells) {
          materials.unite(number(shell), number(seam.pairs.front().shells[0]));
          is_joined[shell] = 1;
        }
      }
    }
    shell_of = shells.representatives();
    material_of = materials.representatives();
    for (std::uint32_t i = 0; i < count; ++i) {
      if (is_joined[i] == 1 && shell_of[i] == i) {
        of_material[material_of[i]].push_back(i);
      }
    }
  }

  std::vector<std::uint32_t> shell_of, material_of;                 // the first of each
  std::map<std::uint32_t, std::vector<std::uint32_t>> of_material;  // shells
};

}  // namespace

OpenPiece opened(const TriMesh& mesh, const Vec3& origin, Report report,
                 std::span<const Seam> seams) {
  return Opener(mesh, origin, seams).run(std::move(report));
}

// Each side is a solid with its end. So its triangles do not meet the end, and are on its outer or
// inner side near the borders; if they do not meet those of the other side, either, both solids
// have nothing in common but the end.
bool fit(const SeamSide& one, const SeamSide& other) {
  if (!one.is_end || !other.is_end || one.end != turned(other.end)) {
    return false;
  }
  const BothSides both(one.near, other.near);
  return std::ranges::includes(BothSides::places_of(one.end), both.common(), kLess) &&
         both.are_edges_of_two() && !both.meet();
}

// What one piece of material is bounded by is one shell around it, and others around voids.
std::vector<std::size_t> doubtful(std::span<const SeamShells> seams) {
  const JoinedShells joined(seams);
  std::set<std::uint32_t> in_doubt;  // materials
  const auto material = [&](const SeamShells& seam) {
    return joined.material_of[seam.pairs.front().shells[0]];
  };
  for (const SeamShells& seam : seams) {
    if (seam.has_others && joined.of_material.at(material(seam)).size() > 1) {
      in_doubt.insert(material(seam));
    }
  }
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < seams.size(); ++i) {
    if (in_doubt.contains(material(seams[i]))) {
      result.push_back(i);
    }
  }
  return result;
}

void join_shells(std::span<const SeamShells> seams, Report& report) {
  std::vector<ShellReport>& shells = report.shells;
  const JoinedShells joined(seams);
  for (const SeamShells& seam : seams) {
    for (const ShellPair& pair : seam.pairs) {
      report.points -= pair.points;  // as many as edges: Euler numbers are those that are added
    }
  }
  for (std::size_t i = 0; i < joined.shell_of.size(); ++i) {
    if (joined.shell_of[i] != i) {
      ShellReport& whole = shells[joined.shell_of[i]];
      whole.first_face = std::min(whole.first_face, shells[i].first_face);
      whole.triangles += shells[i].triangles;
      whole.volume += shells[i].volume;
      whole.euler_number += shells[i].euler_number;
    }
  }
  for (const auto& [material, own] : joined.of_material) {
    const std::uint32_t around =
        *std::ranges::max_element(own, {}, [&](std::uint32_t i) { return shells[i].volume; });
    const int outside = shells[around].depth / 2 * 2;  // of shells that others are around
    for (const std::uint32_t i : own) {
      shells[i].depth = outside + (i == around ? 0 : 1);
    }
  }
  std::vector<ShellReport> left;
  report.components = 0;
  report.genus = 0;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (i >= joined.shell_of.size() || joined.shell_of[i] == i) {
      left.push_back(shells[i]);
      report.components += shells[i].depth % 2 == 0 ? 1 : 0;
      report.genus += (2 - shells[i].euler_number) / 2;
    }
  }
  shells = std::move(left);
}

}  // namespace dupin
