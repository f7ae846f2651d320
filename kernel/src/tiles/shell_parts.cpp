#include "tiles/shell_parts.h"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/shell_nesting.h"
#include "tiles/tile_mesh.h"

namespace dupin::tiles {
namespace {

/// A facet as a mesh of its own.
struct FacetMesh {
  explicit FacetMesh(const Facet& facet)
      : corners{to_vec3(corner_of(facet, 0)), to_vec3(corner_of(facet, 1)),
                to_vec3(corner_of(facet, 2))} {}
  [[nodiscard]] mesh::MeshView view() const { return {corners, triangles}; }

  std::array<Vec3, 3> corners;
  std::array<Triangle, 1> triangles{{{0, 1, 2}}};
};

}  // namespace

void add(const ShellPart& part, ShellPart& shell) {
  shell.first_face = std::min(shell.first_face, part.first_face);
  shell.triangles += part.triangles;
  shell.euler_number += part.euler_number;
  shell.volume += part.volume;
  shell.box.extend(part.box);
  if (std::pair(part.test_cost, part.test_face) < std::pair(shell.test_cost, shell.test_face)) {
    shell.test_cost = part.test_cost;
    shell.test_face = part.test_face;
    shell.test_facet = part.test_facet;
  }
}

std::uint32_t ShellParts::add(ShellPart part) {
  parts_.push_back(std::move(part));
  sets_.add(1);
  return static_cast<std::uint32_t>(parts_.size() - 1);
}

JoinedShells ShellParts::joined() && {
  JoinedShells result{{}, sets_.representatives()};
  std::vector<std::uint32_t> roots;
  for (std::uint32_t part = 0; part < parts_.size(); ++part) {
    if (const std::uint32_t root = result.of_part[part]; root == part) {
      roots.push_back(part);
    } else {
      tiles::add(parts_[part], parts_[root]);
      parts_[part].volume = 0;
    }
  }
  std::ranges::sort(roots, {}, [&](std::uint32_t root) { return parts_[root].first_face; });
  std::vector<std::uint32_t> number(parts_.size());
  result.shells.reserve(roots.size());
  for (const std::uint32_t root : roots) {
    number[root] = static_cast<std::uint32_t>(result.shells.size());
    result.shells.push_back(std::move(parts_[root]));
  }
  for (std::uint32_t& shell : result.of_part) {
    shell = number[shell];
  }
  return result;
}

ShellDepths::ShellDepths(std::span<const ShellPart> shells) : questions_(shells.size()) {
  for (std::uint32_t inner = 0; inner < shells.size(); ++inner) {
    bool is_asked = false;
    for (std::uint32_t outer = 0; outer < shells.size(); ++outer) {
      if (outer != inner && shells[outer].box.contains(shells[inner].box)) {
        if (!std::exchange(is_asked, true)) {
          points_.push_back(mesh::point_within(FacetMesh(shells[inner].test_facet).view(), 0));
        }
        questions_[outer].push_back({inner, static_cast<std::uint32_t>(points_.size() - 1), 0});
      }
    }
  }
}

void ShellDepths::add(std::uint32_t shell, const Facet& facet) {
  if (questions_[shell].empty()) {
    return;
  }
  constexpr std::array<std::uint32_t, 1> kOnly{0};
  const FacetMesh mesh(facet);
  for (Question& question : questions_[shell]) {
    question.winding += mesh::winding_number(mesh.view(), kOnly, points_[question.point]);
  }
}

std::vector<int> ShellDepths::depths() const {
  std::vector<int> depths(questions_.size());
  for (const std::vector<Question>& around : questions_) {
    for (const Question& question : around) {
      depths[question.inner] += question.winding != 0 ? 1 : 0;
    }
  }
  return depths;
}

}  // namespace dupin::tiles
