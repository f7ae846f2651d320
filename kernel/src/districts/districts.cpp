#include "dupin/kernel/districts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "districts/box_cover.h"
#include "districts/boxes_in_tree.h"
#include "districts/touching_pairs.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "exact/exact_numbers.h"
#include "mesh/exact_mesh.h"
#include "mesh/point_winding.h"
#include "support/disjoint_sets.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin {
namespace {

using districts::BoxesInTree;
using districts::Tree;
using districts::tree_box;
using districts::tree_of;
using districts::TreeEntry;

/// A box that contains one triangle contains the next, most likely.
class Containment {
 public:
  explicit Containment(std::span<const Eigen::AlignedBox3d> boxes) : boxes_(boxes) {}

  /// Whether one box has all three corners in its interior.
  [[nodiscard]] bool contains(const std::array<Eigen::AlignedBox3d, 3>& corners) {
    if (last_ < boxes_.size() && is_inside(corners, boxes_[last_])) {
      return true;
    }
    const std::vector<std::uint32_t> around = boxes_.touching(corners[0]);
    const auto found = std::ranges::find_if(
        around, [&](std::uint32_t i) { return is_inside(corners, boxes_[i]); });
    last_ = found != around.end() ? *found : last_;
    return found != around.end();
  }

  /// Whether the interiors of all together contain the triangle between places in these corners.
  [[nodiscard]] bool covers(const std::array<Eigen::AlignedBox3d, 3>& corners,
                            districts::Polygon triangle) const {
    Eigen::AlignedBox3d all = corners[0];
    all.extend(corners[1]).extend(corners[2]);
    Boxes boxes;
    for (const std::uint32_t i : boxes_.touching(all)) {
      boxes.push_back(boxes_[i]);
    }
    return districts::is_covered(std::move(triangle), boxes);
  }

 private:
  static bool is_inside(const std::array<Eigen::AlignedBox3d, 3>& corners,
                        const Eigen::AlignedBox3d& box) {
    return std::ranges::all_of(corners, [&](const Eigen::AlignedBox3d& corner) {
      return (box.min().array() < corner.min().array()).all() &&
             (corner.max().array() < box.max().array()).all();
    });
  }

  BoxesInTree boxes_;
  std::size_t last_ = support::kNone;
};

/// Where a point of a mesh is, exactly or within what doubles tell; and exactly. Rounding may make
/// one of triangles that lie in several boxes.
template <class BoxOfPoint, class PlaceOfPoint>
bool lie_in(const std::vector<Triangle>& triangles, const Boxes& boxes,
            const BoxOfPoint& box_of_point, const PlaceOfPoint& place_of_point) {
  require_numbers(boxes);
  Containment containment(boxes);
  return std::ranges::all_of(triangles, [&](const Triangle& t) {
    const std::array corners{box_of_point(t[0]), box_of_point(t[1]), box_of_point(t[2])};
    return containment.contains(corners) ||
           containment.covers(corners,
                              {place_of_point(t[0]), place_of_point(t[1]), place_of_point(t[2])});
  });
}

/// The first that is not empty; else an empty one.
Eigen::AlignedBox3d first_full(const Boxes& boxes) {
  const auto found = std::ranges::find_if(boxes, [](const auto& box) { return !box.isEmpty(); });
  return found == boxes.end() ? Eigen::AlignedBox3d() : *found;
}

/// Whether boxes that touch none of the tree's may lie where these enclose a space: no way out
/// along an axis.
bool may_be_enclosed(const Tree& tree, const Vec3& place) {
  for (int k = 0; k < 3; ++k) {
    for (const double end :
         {-std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}) {
      Eigen::AlignedBox3d way(place, place);
      (end < 0 ? way.min() : way.max())[k] = end;
      if (tree.qbegin(boost::geometry::index::intersects(tree_box(way))) == tree.qend()) {
        return false;
      }
    }
  }
  return true;
}

/// Surfaces lie in boxes, but does what they bound? Else a solid lies inside of another one, in a
/// space that the boxes of this enclose. Within its boxes a surface may move without winding
/// differently about a place outside of them: doubles will do.
/// `firsts` has a box of each solid, empty if it has none.
void require_outside(const mesh::MeshView& doubles, std::size_t number, const Vec3& origin,
                     const Boxes& own, const BoxesInTree& firsts) {
  Eigen::AlignedBox3d all;
  for (const Eigen::AlignedBox3d& box : own) {
    all.extend(box);
  }
  std::optional<Tree> tree;
  for (const std::uint32_t other : firsts.touching(all)) {
    const Eigen::AlignedBox3d& first = firsts[other];
    if (other == number || !all.contains(first)) {
      continue;
    }
    tree = tree ? std::move(tree) : tree_of(own);
    if (!may_be_enclosed(*tree, first.center())) {
      continue;
    }
    const Vec3 place = first.center() - origin;
    if (mesh::winding_number(doubles, support::numbers_below(doubles.triangles.size()),
                             {exact::exact_vector(place), 1, Eigen::AlignedBox3d(place, place)}) !=
        0) {
      throw Error(Errc::invalid_argument, "boxes of the solid " + std::to_string(other) +
                                              " lie inside of the solid " + std::to_string(number));
    }
  }
}

mesh::MeshView doubles_of(const Solid& solid) {
  return {solid.nearest_points(), solid.triangles()};
}
mesh::MeshView doubles_of(const Rounded& rounded) {
  return {rounded.mesh().points, rounded.mesh().triangles};
}
Vec3 origin_of(const Solid& /*solid*/) { return Vec3::Zero(); }
Vec3 origin_of(const Rounded& rounded) { return rounded.report().origin; }

void require_apart(std::span<const Boxes> boxes) {
  Boxes all;
  std::vector<std::size_t> owner;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    all.insert(all.end(), boxes[i].begin(), boxes[i].end());
    owner.resize(all.size(), i);
  }
  std::vector<std::size_t> owner_of(all.size(), boxes.size());  // by district
  const std::vector<std::uint32_t> districts = districts_of(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::size_t& known = owner_of[districts[i]];
    known = known == boxes.size() ? owner[i] : known;
    if (known != owner[i]) {
      throw Error(Errc::invalid_argument, "boxes of the solids " + std::to_string(known) + " and " +
                                              std::to_string(owner[i]) + " touch");
    }
  }
}

template <class Item>
void require_in_boxes(std::span<const Item> items, std::span<const Boxes> boxes) {
  if (items.size() != boxes.size()) {
    throw Error(
        Errc::invalid_argument,
        std::to_string(items.size()) + " solids have the boxes of " + std::to_string(boxes.size()));
  }
  require_apart(boxes);
  Boxes firsts(boxes.size());
  std::ranges::transform(boxes, firsts.begin(), first_full);
  const BoxesInTree all_firsts(firsts);
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!lies_in(items[i], boxes[i])) {
      throw Error(Errc::invalid_argument,
                  "the solid " + std::to_string(i) + " does not lie in its boxes");
    }
    require_outside(doubles_of(items[i]), i, origin_of(items[i]), boxes[i], all_firsts);
  }
}

/// Names that several meshes have, once.
class Names {
 public:
  [[nodiscard]] std::uint32_t number(const std::string& name) {
    const auto [entry, is_new] =
        known_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (is_new) {
      names_.push_back(name);
    }
    return entry->second;
  }
  /// Those of a mesh without labels are "".
  void append_labels(const std::vector<std::uint32_t>& labels,
                     const std::vector<std::string>& names, std::size_t triangles,
                     std::vector<std::uint32_t>& all) {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(names.size());
    for (const std::string& name : names) {
      numbers.push_back(number(name));
    }
    if (labels.empty() && triangles > 0) {
      all.insert(all.end(), triangles, number(""));
    }
    std::ranges::transform(labels, std::back_inserter(all),
                           [&](std::uint32_t label) { return numbers[label]; });
  }
  [[nodiscard]] std::vector<std::string> take() { return std::move(names_); }

 private:
  std::map<std::string, std::uint32_t> known_;
  std::vector<std::string> names_;
};

template <class Item>
void append(const std::vector<Item>& from, std::vector<Item>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

/// What of a mesh comes behind what others have brought.
class Joiner {
 public:
  explicit Joiner(std::span<const Solid> solids) {
    std::size_t points = 0, triangles = 0;
    for (const Solid& solid : solids) {
      doubles_ += solid.exact().double_count();
      points += solid.point_count();
      triangles += solid.triangle_count();
      has_labels_ = has_labels_ || !solid.labels().empty();
      has_planes_ = has_planes_ || !solid.exact().plane_of.empty();
      has_classes_ = has_classes_ || !solid.exact().stable.of_triangle.empty();
    }
    if (points > support::kNone || triangles > support::kNone) {
      throw Error(Errc::limit_exceeded, "a solid has less than 2^32 points and triangles");
    }
    mesh_.points.resize(points);
    mesh_.triangles.reserve(triangles);
    mesh_.sources.reserve(triangles);
  }

  void add(const mesh::ExactMesh& from) {
    const std::uint32_t count = from.double_count();
    const auto second = static_cast<std::uint32_t>(doubles_ + mesh_.implicit.size());
    std::copy_n(from.points.begin(), count, mesh_.points.begin() + first_);
    std::copy(from.points.begin() + count, from.points.end(), mesh_.points.begin() + second);
    mesh_.implicit.append(from.implicit);
    const auto renumbered = [&](std::uint32_t point) {
      return point < count ? first_ + point : second + (point - count);
    };
    for (const auto& [a, b, c] : from.triangles) {
      mesh_.triangles.push_back({renumbered(a), renumbered(b), renumbered(c)});
      mesh_.sources.push_back(
          {operand_, static_cast<std::uint32_t>(mesh_.sources.size() - first_triangle_)});
    }
    if (has_labels_) {
      names_.append_labels(from.labels, from.names, from.triangles.size(), mesh_.labels);
    }
    append(from.contacts, mesh_.contacts);
    add_planes(from);
    add_classes(from);
    first_ += count;
    first_triangle_ += from.triangles.size();
    ++operand_;
  }

  [[nodiscard]] mesh::ExactMesh take() {
    mesh_.names = names_.take();
    return std::move(mesh_);
  }

 private:
  void add_planes(const mesh::ExactMesh& from) {
    if (!has_planes_) {
      return;
    }
    const auto shift = static_cast<std::uint32_t>(mesh_.planes.size());
    append(from.planes, mesh_.planes);
    mesh_.plane_of.resize(first_triangle_, mesh::ExactMesh::kOwnPlane);
    for (const std::uint32_t plane : from.plane_of) {
      mesh_.plane_of.push_back(plane == mesh::ExactMesh::kOwnPlane ? plane : plane + shift);
    }
    mesh_.plane_of.resize(mesh_.triangles.size(), mesh::ExactMesh::kOwnPlane);
  }

  void add_classes(const mesh::ExactMesh& from) {
    if (!has_classes_) {
      return;
    }
    constexpr std::uint32_t kNone = mesh::StableFaceGroups::kNone;
    const auto shift = static_cast<std::uint32_t>(mesh_.stable.classes.size());
    append(from.stable.classes, mesh_.stable.classes);
    mesh_.stable.of_triangle.resize(first_triangle_, kNone);
    for (const std::uint32_t own : from.stable.of_triangle) {
      mesh_.stable.of_triangle.push_back(own == kNone ? own : own + shift);
    }
    mesh_.stable.of_triangle.resize(mesh_.triangles.size(), kNone);
  }

  std::size_t doubles_ = 0, first_triangle_ = 0;
  bool has_labels_ = false, has_planes_ = false, has_classes_ = false;
  std::uint32_t operand_ = 0, first_ = 0;
  Names names_;
  mesh::ExactMesh mesh_;
};

}  // namespace

void require_numbers(std::span<const Eigen::AlignedBox3d> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].min().hasNaN() || boxes[i].max().hasNaN()) {
      throw Error(Errc::invalid_argument,
                  "box " + std::to_string(i) + " has a bound that is not a number");
    }
  }
}

void for_each_touching(std::span<const Eigen::AlignedBox3d> boxes,
                       const std::function<void(std::uint32_t, std::uint32_t)>& visit) {
  require_numbers(boxes);
  if (auto pairs = districts::touching_pairs(boxes)) {
    std::ranges::sort(*pairs);
    for (const auto& [i, j] : *pairs) {
      visit(i, j);
    }
    return;
  }
  const BoxesInTree all(boxes);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const auto near = all.touching(boxes[i]);
    for (auto other = std::ranges::upper_bound(near, i); other != near.end(); ++other) {
      visit(i, *other);
    }
  }
}

std::vector<std::uint32_t> districts_of(std::span<const Eigen::AlignedBox3d> boxes) {
  return districts_of(boxes, {});
}

namespace {

/// Of few pairs that touch.
std::vector<std::uint32_t> districts_of(std::size_t count, const districts::TouchingPairs& touching,
                                        std::span<const std::array<std::uint32_t, 2>> apart) {
  support::DisjointSets sets(count);
  for (const auto& pair : touching) {
    if (!std::ranges::binary_search(apart, pair)) {
      sets.unite(pair[0], pair[1]);
    }
  }
  std::vector<std::uint32_t> district = sets.representatives();
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    district[i] = district[i] == i ? next++ : district[district[i]];
  }
  return district;
}

/// Goes from box to box, and leaves out those that it has seen: however many touch.
std::vector<std::uint32_t> districts_of_crowd(std::span<const Eigen::AlignedBox3d> boxes,
                                              std::span<const std::array<std::uint32_t, 2>> apart) {
  std::vector<std::uint32_t> district(boxes.size(), support::kNone), open;
  const auto tree_of_new = [&] {
    return tree_of(boxes, [&](std::uint32_t i) { return district[i] == support::kNone; });
  };
  Tree tree = tree_of_new();
  std::size_t known = 0;  // met again in the tree
  std::uint32_t count = 0;
  for (std::uint32_t first = 0; first < boxes.size(); ++first) {
    if (district[first] != support::kNone) {
      continue;
    }
    district[first] = count;
    open.push_back(first);
    while (!open.empty()) {
      const std::uint32_t own = open.back();
      const Eigen::AlignedBox3d& box = boxes[own];
      open.pop_back();
      if (box.isEmpty()) {
        continue;
      }
      std::vector<TreeEntry> near;
      const auto is_new = [&](const TreeEntry& e) {
        if (district[e.second] != support::kNone) {
          ++known;
          return false;
        }
        return !std::ranges::binary_search(
            apart, std::array{std::min(own, e.second), std::max(own, e.second)});
      };
      tree.query(boost::geometry::index::intersects(tree_box(box)) &&
                     boost::geometry::index::satisfies(is_new),
                 std::back_inserter(near));
      for (const auto& [other, number] : near) {
        district[number] = count;
        open.push_back(number);
      }
      if (known > boxes.size()) {  // as where all touch each other
        tree = tree_of_new();
        known = 0;
      }
    }
    ++count;
  }
  return district;
}

}  // namespace

std::vector<std::uint32_t> districts_of(std::span<const Eigen::AlignedBox3d> boxes,
                                        std::span<const std::array<std::uint32_t, 2>> apart) {
  require_numbers(boxes);
  const auto touching = districts::touching_pairs(boxes);
  return touching ? districts_of(boxes.size(), *touching, apart) : districts_of_crowd(boxes, apart);
}

void add(const RoundingReport& district, RoundingReport& all) {
  all.coordinates = district.coordinates;
  all.origin = district.origin;
  all.moved += district.moved;
  all.largest_move = std::max(all.largest_move, district.largest_move);
  all.repair_reach = std::max(all.repair_reach, district.repair_reach);
  all.removed_triangles += district.removed_triangles;
  all.removed_shells += district.removed_shells;
  append(district.filled_places, all.filled_places);
  all.slit_width = std::max(all.slit_width, district.slit_width);
  append(district.snapped_places, all.snapped_places);
  append(district.parted, all.parted);
  all.parted_by = std::max(all.parted_by, district.parted_by);
  append(district.thin_shells, all.thin_shells);
}

namespace {

// As many of each defect as check() keeps, in its order.
void add_findings(const Report& district, Report& all) {
  const auto faces = static_cast<std::uint32_t>(all.triangles);
  const auto points = static_cast<std::uint32_t>(all.points);
  for (Finding finding : district.findings) {
    const auto kept = std::ranges::count(all.findings, finding.defect, &Finding::defect);
    if (std::size_t(kept) < CheckOptions().limit) {
      std::ranges::for_each(finding.faces, [=](std::uint32_t& face) { face += faces; });
      std::ranges::for_each(finding.points, [=](std::uint32_t& point) { point += points; });
      all.findings.push_back(std::move(finding));
    }
  }
  std::ranges::stable_sort(all.findings, {}, &Finding::defect);
}

}  // namespace

void add(const Report& district, Report& all) {
  if (!district.findings.empty()) {
    add_findings(district, all);
  }
  const auto faces = static_cast<std::uint32_t>(all.triangles);
  all.points += district.points;
  all.triangles += district.triangles;
  all.counts.resize(district.counts.size(), 0);
  std::ranges::transform(district.counts, all.counts, all.counts.begin(), std::plus<>());
  for (ShellReport shell : district.shells) {
    shell.first_face += faces;
    all.shells.push_back(shell);
  }
  all.components += district.components;
  all.euler_number += district.euler_number;
  all.genus += district.genus;
  all.volume += district.volume;
  all.area += district.area;
}

Eigen::AlignedBox3d bounds_of(std::span<const Boxes> boxes) {
  Eigen::AlignedBox3d bounds;
  for (const Boxes& some : boxes) {
    for (const Eigen::AlignedBox3d& box : some) {
      bounds.extend(box);
    }
  }
  return bounds;
}

bool lies_in(const Solid& solid, const Boxes& boxes) {
  // A double between a place that is none and the next box side, which is one: comparing the
  // nearest double strictly is comparing the place.
  const auto box_of_point = [&](std::uint32_t point) {
    const Vec3& place = solid.nearest_points()[point];
    return Eigen::AlignedBox3d(place, place);
  };
  return lie_in(solid.triangles(), boxes, box_of_point,
                [&](std::uint32_t point) { return solid.exact_point(point); });
}

bool lies_in(const Rounded& rounded, const Boxes& boxes) {
  const Vec3& origin = rounded.report().origin;
  const auto box_of_point = [&](std::uint32_t point) {
    const Vec3 place = rounded.mesh().points[point] + origin;
    Eigen::AlignedBox3d around(place, place);
    for (int k = 0; k < 3; ++k) {
      if (origin[k] != 0) {
        around.min()[k] = std::nextafter(place[k], -std::numeric_limits<double>::infinity());
        around.max()[k] = std::nextafter(place[k], std::numeric_limits<double>::infinity());
      }
    }
    return around;
  };
  return lie_in(rounded.mesh().triangles, boxes, box_of_point, [&](std::uint32_t point) {
    std::array<mpq_class, 3> place;
    for (int k = 0; k < 3; ++k) {
      place.at(static_cast<std::size_t>(k)) =
          mpq_class(rounded.mesh().points[point][k]) + mpq_class(origin[k]);
    }
    return place;
  });
}

Solid joined(std::span<const Solid> solids, std::span<const Boxes> boxes) {
  const UsualArithmetic usual;
  require_in_boxes(solids, boxes);
  Joiner joiner(solids);
  for (const Solid& solid : solids) {
    joiner.add(solid.exact());
  }
  return Solid(std::make_shared<const mesh::ExactMesh>(joiner.take()));
}

Rounded joined(std::span<const Rounded> all, std::span<const Boxes> boxes) {
  const UsualArithmetic usual;
  require_in_boxes(all, boxes);
  Rounded result;
  bool has_labels = false;
  std::size_t points = 0, triangles = 0;
  for (const Rounded& part : all) {
    has_labels = has_labels || !part.mesh_.labels.empty();
    points += part.mesh_.points.size();
    triangles += part.mesh_.triangles.size();
    if (part.report_.origin != all[0].report_.origin ||
        part.report_.coordinates != all[0].report_.coordinates) {
      throw Error(Errc::invalid_argument, "rounded solids have several origins or coordinates");
    }
  }
  if (points > support::kNone || triangles > support::kNone) {
    throw Error(Errc::limit_exceeded, "a mesh has less than 2^32 points and triangles");
  }
  result.mesh_.points.reserve(points);
  result.mesh_.triangles.reserve(triangles);
  result.sources_.reserve(triangles);
  Names names;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const TriMesh& mesh = all[i].mesh_;
    const auto shift = static_cast<std::uint32_t>(result.mesh_.points.size());
    append(mesh.points, result.mesh_.points);
    for (const auto& [a, b, c] : mesh.triangles) {
      result.mesh_.triangles.push_back({a + shift, b + shift, c + shift});
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      result.sources_.push_back({i, t});
    }
    if (has_labels) {
      names.append_labels(mesh.labels, mesh.names, mesh.triangles.size(), result.mesh_.labels);
    }
    append(all[i].contacts_, result.contacts_);
    add(all[i].report_, result.report_);
  }
  result.mesh_.names = names.take();
  return result;
}

}  // namespace dupin
