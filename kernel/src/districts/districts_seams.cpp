#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "dupin/kernel/connected_components.h"
#include "dupin/kernel/districts.h"
#include "support/disjoint_sets.h"
#include "support/none.h"

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

/// Triangles given by their corners, those in one place being one point.
class Soup {
 public:
  void append(std::span<const Vec3> triangles) {
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
      mesh_.triangles.push_back(
          {point(triangles[i]), point(triangles[i + 1]), point(triangles[i + 2])});
    }
  }
  [[nodiscard]] const TriMesh& mesh() const { return mesh_; }

 private:
  std::uint32_t point(const Vec3& place) {
    const auto [entry, is_new] =
        known_.try_emplace(place, static_cast<std::uint32_t>(mesh_.points.size()));
    if (is_new) {
      mesh_.points.push_back(place);
    }
    return entry->second;
  }

  std::map<Vec3, std::uint32_t, PlaceOrder> known_;
  TriMesh mesh_;
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

/// The points of a border that is one closed curve; none of any other.
std::vector<std::uint32_t> border_of(const TriMesh& mesh) {
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [ends, count] : edge_counts(mesh)) {
    const auto& [low, high] = ends;
    if (count < -1 || count > 1 ||
        (count != 0 && !next.try_emplace(count > 0 ? low : high, count > 0 ? high : low).second)) {
      return {};
    }
  }
  std::vector<std::uint32_t> border;
  if (!next.empty()) {
    const std::uint32_t first = next.begin()->first;
    std::uint32_t point = first;
    do {
      border.push_back(point);
      const auto step = next.find(point);
      point = step == next.end() ? first : step->second;
    } while (point != first && border.size() < next.size());
  }
  return border.size() == next.size() ? border : std::vector<std::uint32_t>();
}

/// Connected, with one border, and of Euler number 1.
bool is_disc(const std::vector<Vec3>& triangles) {
  Soup soup;
  soup.append(triangles);
  const TriMesh& mesh = soup.mesh();
  const std::vector<std::uint32_t> parts = connected_components(mesh.triangles, mesh.points.size());
  const bool is_one =
      std::ranges::all_of(parts, [&](std::uint32_t part) { return part == parts[0]; });
  const auto euler = static_cast<std::ptrdiff_t>(mesh.points.size() + mesh.triangles.size()) -
                     static_cast<std::ptrdiff_t>(edge_counts(mesh).size());
  return is_one && euler == 1 && border_of(mesh).size() >= 3;
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

class Opener {
 public:
  Opener(const TriMesh& mesh, const Vec3& origin, std::span<const Seam> seams)
      : mesh_(mesh),
        origin_(origin),
        seams_(seams),
        seam_of_(mesh.triangles.size(), support::kNone),
        part_of_(connected_components(mesh.triangles, mesh.points.size())) {
    std::map<std::string, std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < seams.size(); ++i) {
      numbers.emplace(seams[i].name, i);
    }
    std::vector<std::uint32_t> of_label(mesh.names.size(), support::kNone);
    for (std::size_t label = 0; label < of_label.size(); ++label) {
      const auto found = numbers.find(mesh.names[label]);
      of_label[label] = found == numbers.end() ? support::kNone : found->second;
    }
    for (std::size_t face = 0; face < mesh.labels.size(); ++face) {
      seam_of_[face] = of_label[mesh.labels[face]];
    }
  }

  OpenPiece run(Report report) {
    OpenPiece result;
    for (std::uint32_t face = 0; face < seam_of_.size(); ++face) {
      if (seam_of_[face] != support::kNone) {
        result.disc_faces.push_back(face);
      }
    }
    result.sides = sides();
    place_shells(report.shells, result.sides);
    take_discs(result.disc_faces, report);
    result.report = std::move(report);
    return result;
  }

 private:
  [[nodiscard]] std::uint32_t part_of(std::size_t face) const {
    return part_of_[mesh_.triangles[face][0]];
  }

  [[nodiscard]] std::vector<SeamSide> sides() const {
    std::vector<std::vector<Corners>> discs(seams_.size());
    std::vector<SeamSide> result(seams_.size());
    for (std::size_t face = 0; face < seam_of_.size(); ++face) {
      const Corners corners = corners_of(mesh_, face);
      if (seam_of_[face] != support::kNone) {
        discs[seam_of_[face]].push_back(corners);
        continue;
      }
      const Eigen::AlignedBox3d box = box_of(corners, origin_);
      for (std::size_t i = 0; i < seams_.size(); ++i) {
        if (box.intersects(seams_[i].meeting)) {
          result[i].near.insert(result[i].near.end(), corners.begin(), corners.end());
        }
      }
    }
    for (std::size_t i = 0; i < seams_.size(); ++i) {
      result[i].disc = ordered(std::move(discs[i]));
      result[i].is_disc = dupin::is_disc(result[i].disc);
    }
    return result;
  }

  /// Which shell a disc is of, and the first face of each that is left.
  void place_shells(std::vector<ShellReport>& shells, std::vector<SeamSide>& sides) const {
    std::map<std::uint32_t, std::uint32_t> shell_of;  // by connected part
    std::vector<std::uint8_t> is_alone(shells.size(), 1);
    for (std::uint32_t i = 0; i < shells.size(); ++i) {
      const auto [entry, is_new] = shell_of.try_emplace(part_of(shells[i].first_face), i);
      is_alone[entry->second] &= is_new ? 1 : 0;
      shells[i].first_face = support::kNone;
    }
    std::uint32_t left = 0;
    for (std::size_t face = 0; face < seam_of_.size(); ++face) {
      const auto entry = shell_of.find(part_of(face));
      const std::uint32_t shell = entry->second, seam = seam_of_[face];
      if (seam == support::kNone) {
        shells[shell].first_face = std::min(shells[shell].first_face, left++);
      } else {
        sides[seam].shell = shell;
        sides[seam].is_disc =
            sides[seam].is_disc && is_alone[shell] == 1 && shells[shell].depth == 0;
        --shells[shell].triangles;
      }
    }
  }

  /// Corners of discs alone go, too.
  void take_discs(const std::vector<std::uint32_t>& faces, Report& report) const {
    std::vector<unsigned> is_used(mesh_.points.size(), 0);
    for (std::size_t face = 0; face < seam_of_.size(); ++face) {
      for (const std::uint32_t corner : mesh_.triangles[face]) {
        is_used[corner] |= seam_of_[face] == support::kNone ? 1U : 2U;
      }
    }
    report.points -= static_cast<std::size_t>(std::ranges::count(is_used, 2U));
    report.triangles -= faces.size();
    for (const std::uint32_t face : faces) {
      const auto& [a, b, c] = corners_of(mesh_, face);
      report.area -= (b - a).cross(c - a).norm() / 2;
    }
  }

  const TriMesh& mesh_;
  const Vec3& origin_;
  std::span<const Seam> seams_;
  std::vector<std::uint32_t> seam_of_;  // by face
  std::vector<std::uint32_t> part_of_;  // by point
};

}  // namespace

OpenPiece opened(const TriMesh& mesh, const Vec3& origin, Report report,
                 std::span<const Seam> seams) {
  return Opener(mesh, origin, seams).run(std::move(report));
}

std::size_t border_size(const SeamSide& side) {
  Soup soup;
  soup.append(side.disc);
  return border_of(soup.mesh()).size();
}

// Each side is a solid with its disc. So its triangles do not meet the disc, and are on its outer
// or inner side near the border; if they do not meet those of the other side, either, both solids
// have nothing in common but the disc.
bool fit(const SeamSide& one, const SeamSide& other) {
  if (!one.is_disc || !other.is_disc || one.disc != turned(other.disc)) {
    return false;
  }
  const auto places_of = [](std::span<const Vec3> triangles) {
    std::vector<Vec3> places(triangles.begin(), triangles.end());
    std::ranges::sort(places, kLess);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  };
  const std::vector<Vec3> own = places_of(one.near), others = places_of(other.near),
                          of_disc = places_of(one.disc);
  std::vector<Vec3> common;
  std::ranges::set_intersection(own, others, std::back_inserter(common), kLess);
  if (!std::ranges::includes(of_disc, common, kLess)) {
    return false;
  }
  Soup both;
  both.append(one.near);
  both.append(other.near);
  const Report report = check(both.mesh(), {.limit = 0});
  return report.count(Defect::self_intersection) == 0 &&
         report.count(Defect::duplicate_face) == 0 && report.count(Defect::degenerate_face) == 0 &&
         report.count(Defect::non_manifold_edge) == 0 &&
         report.count(Defect::inconsistent_orientation) == 0;
}

void join_shells(std::span<const ShellPair> pairs, Report& report) {
  std::vector<ShellReport>& shells = report.shells;
  support::DisjointSets sets(shells.size());
  for (const ShellPair& pair : pairs) {
    sets.unite(static_cast<std::uint32_t>(pair.shells[0]),
               static_cast<std::uint32_t>(pair.shells[1]));
    // Each surface loses a disc, and the border has as many points as edges.
    shells[pair.shells[0]].euler_number -= 2;
    report.euler_number -= 2;
    report.points -= pair.points;
  }
  const std::vector<std::uint32_t> first = sets.representatives();
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (first[i] != i) {
      ShellReport& whole = shells[first[i]];
      whole.first_face = std::min(whole.first_face, shells[i].first_face);
      whole.triangles += shells[i].triangles;
      whole.volume += shells[i].volume;
      whole.euler_number += shells[i].euler_number;
    }
  }
  std::vector<ShellReport> left;
  report.components = 0;
  report.genus = 0;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (first[i] == i) {
      left.push_back(shells[i]);
      report.components += shells[i].depth % 2 == 0 ? 1 : 0;
      report.genus += (2 - shells[i].euler_number) / 2;
    }
  }
  shells = std::move(left);
}

}  // namespace dupin
