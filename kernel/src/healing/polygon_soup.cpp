#include "healing/polygon_soup.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "arrangement/arrange.h"
#include "healing/closed_shells.h"
#include "healing/crossed_voids.h"
#include "healing/shell_enclosure.h"
#include "healing/shell_lobes.h"
#include "healing/sorted_copies.h"
#include "mesh/coincident_points.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "support/sequences.h"

namespace dupin::healing {
namespace {

void turn(Triangle& t) { std::swap(t[1], t[2]); }

using Faces = std::vector<std::uint32_t>;

void turn_faces(PolygonSoup& soup, std::span<const std::uint32_t> faces,
                std::vector<std::uint8_t>& is_turned) {
  for (const std::uint32_t face : faces) {
    turn(soup.triangles[face]);
    is_turned[face] ^= 1;
  }
}

std::vector<int> volume_signs(const PolygonSoup& soup, const mesh::Shells& shells) {
  std::vector<int> signs;
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    const auto faces =
        support::selected(std::span(std::as_const(soup.triangles)), shells.faces_of(shell));
    signs.push_back(mesh::volume_sign({soup.points, faces}));
  }
  return signs;
}

// Per face 1 if it is there the other way round, too.
std::vector<std::uint8_t> find_turned_copies(std::span<const Triangle> triangles) {
  std::vector<std::uint8_t> found(triangles.size(), 0);
  const std::vector<Copy> sorted = sorted_copies(triangles);
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    const auto end = std::find_if(begin, sorted.end(),
                                  [&](const Copy& copy) { return copy.corners != begin->corners; });
    const auto odd = std::count_if(begin, end, [](const Copy& copy) { return copy.is_odd; });
    const bool is_both = odd != 0 && odd != end - begin;
    for (; begin != end; ++begin) {
      found[begin->face] = is_both ? 1 : 0;
    }
  }
  return found;
}

struct InsideOut {
  Faces faces;
  Cavities cavities;       // once these are turned
  bool may_cross = false;  // at edges they have in common
};

/// Which shells bound material and which voids, from outside to inside.
class ShellFacing {
 public:
  ShellFacing(const ClosedShells& closed, std::span<const int> signs,
              const ShellEnclosure& enclosure, std::span<const std::uint8_t> is_paired,
              std::span<const std::uint8_t> is_there_turned)
      : closed_(closed),
        signs_(signs),
        enclosure_(enclosure),
        is_paired_(is_paired),
        is_there_turned_(is_there_turned) {}

  /// Per shell the sign of its volume as it has to be.
  std::vector<int> find() {
    facing_.assign(signs_.size(), 0);
    std::vector<std::uint32_t> order = support::numbers_below(signs_.size());
    std::ranges::stable_sort(
        order, {}, [this](std::uint32_t shell) { return enclosure_.around(shell).size(); });
    for (const std::uint32_t shell : order) {
      if (signs_[shell] != 0) {
        facing_[shell] = is_cavity(shell) ? -1 : 1;
      }
    }
    return std::move(facing_);
  }

 private:
  // What is there the other way round, too, is a body that is there several times, no cavity. Else
  // if in material it is part of no shell right around it; in a void, if it is part of all of them.
  [[nodiscard]] bool is_cavity(std::uint32_t shell) const {
    const auto faces = closed_.shells.faces_of(shell);
    const auto is_paired = [this](std::uint32_t face) { return is_paired_[face] != 0; };
    const auto is_there_turned = [this](std::uint32_t face) { return is_there_turned_[face] != 0; };
    if (std::ranges::any_of(faces, is_paired) || std::ranges::all_of(faces, is_there_turned)) {
      return false;
    }
    int winding = 0;
    for (const std::uint32_t outer : enclosure_.around(shell)) {
      winding += facing_[outer];
    }
    const std::vector<std::uint32_t> parents = parents_of(shell);
    if (winding > 0) {
      return std::ranges::none_of(
          parents, [&](std::uint32_t outer) { return is_of_material(shell, outer); });
    }
    return !parents.empty() && std::ranges::all_of(parents, [&](std::uint32_t outer) {
      return facing_[outer] < 0 && may_cross(shell, outer);
    });
  }

  // By the way it faces. If both are inside out it is a void's, unless they may cross.
  [[nodiscard]] bool is_of_material(std::uint32_t shell, std::uint32_t outer) const {
    const bool agrees = signs_[outer] == signs_[shell];
    return facing_[outer] < 0 ? !agrees : agrees && (signs_[shell] > 0 || may_cross(shell, outer));
  }

  // If they face the same way and have an edge in common, both might as well be others that cross.
  [[nodiscard]] bool may_cross(std::uint32_t shell, std::uint32_t outer) const {
    return signs_[outer] == signs_[shell] &&
           std::ranges::binary_search(closed_.at_one_edge, ShellPair(std::minmax(outer, shell)));
  }

  // The inmost of those around it.
  [[nodiscard]] std::vector<std::uint32_t> parents_of(std::uint32_t shell) const {
    const auto around = enclosure_.around(shell);
    std::vector<std::uint32_t> parents;
    std::ranges::copy_if(around, std::back_inserter(parents), [&](std::uint32_t outer) {
      return std::ranges::none_of(around, [&](std::uint32_t other) {
        return std::ranges::binary_search(enclosure_.around(other), outer);
      });
    });
    return parents;
  }

  const ClosedShells& closed_;
  std::span<const int> signs_;
  const ShellEnclosure& enclosure_;
  std::span<const std::uint8_t> is_paired_, is_there_turned_;
  std::vector<int> facing_;
};

// Turns what shells that touch themselves wind around the other way than most.
void turn_lobes(PolygonSoup& soup, const ClosedShells& closed, std::vector<int>& signs,
                std::vector<std::uint8_t>& is_turned) {
  for (std::size_t shell = 0; shell < closed.shells.count; ++shell) {
    if (closed.touches_itself[shell] == 0) {
      continue;
    }
    const auto of_shell = closed.shells.faces_of(shell);
    const Faces to_turn = lobe_faces(soup, of_shell, signs[shell]);
    turn_faces(soup, to_turn, is_turned);
    if (!to_turn.empty() && signs[shell] == 0) {
      signs[shell] = 1;
    }
  }
}

InsideOut inside_out(PolygonSoup& soup, std::span<const std::uint8_t> is_paired,
                     std::vector<std::uint8_t>& is_turned) {
  const ClosedShells closed = closed_shells(soup.points, soup.triangles);
  const mesh::Shells& shells = closed.shells;
  std::vector<int> signs = volume_signs(soup, shells);
  turn_lobes(soup, closed, signs, is_turned);
  InsideOut result;
  result.cavities.touching = std::ranges::count(closed.touches_itself, 1) > 0;
  result.may_cross = result.cavities.touching || !closed.at_one_edge.empty();
  if (std::ranges::find(signs, -1) == signs.end()) {
    return result;
  }
  const ShellEnclosure enclosure(soup, shells, signs);
  const std::vector<std::uint8_t> there_turned = find_turned_copies(soup.triangles);
  const std::vector<int> facing =
      ShellFacing(closed, signs, enclosure, is_paired, there_turned).find();
  for (std::size_t shell = 0; shell < shells.count; ++shell) {
    const auto of_shell = shells.faces_of(shell);
    if (facing[shell] < 0) {
      ++result.cavities.count;
      result.cavities.faces.insert(result.cavities.faces.end(), of_shell.begin(), of_shell.end());
    }
    if (facing[shell] != signs[shell]) {
      result.faces.insert(result.faces.end(), of_shell.begin(), of_shell.end());
    }
  }
  return result;
}

}  // namespace

MergedPoints merge_duplicate_points(const TriMesh& mesh) {
  const std::vector<std::uint32_t> first = mesh::coincident_representatives(mesh.points);
  PolygonSoup soup{mesh.points, mesh.triangles, {}};
  std::vector<bool> is_copy(mesh.points.size());
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    soup.sources.push_back(i);
    for (std::uint32_t& corner : soup.triangles[i]) {
      is_copy[corner] = first[corner] != corner;
      corner = first[corner];
    }
  }
  const auto copies = std::ranges::count(is_copy, true);
  return {std::move(soup), static_cast<std::size_t>(copies)};
}

namespace {

// With labels, and the soup's own numbers for sources.
mesh::ExactMesh surface_of(const PolygonSoup& soup, const TriMesh& mesh) {
  mesh::ExactMesh surface;
  surface.points = soup.points;
  surface.triangles = soup.triangles;
  surface.names = mesh.names;
  for (const std::uint32_t face : soup.sources) {
    surface.sources.push_back({0, face});
    if (!mesh.labels.empty()) {
      surface.labels.push_back(mesh.labels[face]);
    }
  }
  return surface;
}

// Of triangles of the soup, those of the mesh that it is from.
void name_faces(const PolygonSoup& soup, std::vector<Source>& sources) {
  for (Source& source : sources) {
    source.triangle = soup.sources[source.triangle];
  }
}

}  // namespace

mesh::ExactMesh wound_around(const PolygonSoup& soup, const TriMesh& mesh,
                             const Progress& progress) {
  mesh::ExactMesh solid = arrangement::positive_winding_boundary(surface_of(soup, mesh), progress);
  name_faces(soup, solid.sources);
  return solid;
}

arrangement::WoundSurface wound_surface(const PolygonSoup& soup, const TriMesh& mesh,
                                        std::span<const std::uint8_t> crossing) {
  const std::vector<std::uint8_t> is_crossing = support::selected(crossing, soup.sources);
  arrangement::WoundSurface wound = arrangement::wound_surface(surface_of(soup, mesh), is_crossing);
  name_faces(soup, wound.boundary.sources);
  for (std::uint32_t& source : wound.outside.sources) {
    source = soup.sources[source];
  }
  return wound;
}

Cavities turn_shells_outward(PolygonSoup& soup, std::span<const std::uint8_t> is_paired,
                             std::vector<std::uint8_t>& is_turned) {
  const std::vector<std::uint8_t> before = is_turned;
  InsideOut found = inside_out(soup, is_paired, is_turned);
  turn_faces(soup, found.faces, is_turned);
  Cavities cavities = std::move(found.cavities);
  if (found.may_cross && is_turned != before) {
    std::vector<std::uint8_t> turned_now(before.size()), is_of_cavity(before.size(), 0);
    std::ranges::transform(before, is_turned, turned_now.begin(), std::not_equal_to<>());
    for (const std::uint32_t face : cavities.faces) {
      is_of_cavity[face] = 1;
    }
    turn_faces(soup, faces_of_crossed_voids(soup.points, soup.triangles, turned_now, is_of_cavity),
               is_turned);
  }
  for (std::uint32_t& face : cavities.faces) {
    face = soup.sources[face];
  }
  return cavities;
}

}  // namespace dupin::healing
