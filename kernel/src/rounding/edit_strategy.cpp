#include "rounding/edit_strategy.h"

#include <algorithm>
#include <array>
#include <tuple>

#include <Eigen/Geometry>

namespace dupin::rounding {
namespace {

using Edge = std::tuple<double, std::uint32_t, std::uint32_t>;  // length, ends
using Faces = std::vector<std::uint32_t>;

void sort_unique(Faces& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// The edges of the faces up to a length, shortest first.
std::vector<Edge> short_edges(const EditedMesh& mesh, const Faces& faces, double length) {
  std::vector<Edge> edges;
  for (const std::uint32_t f : faces) {
    if (!mesh.alive(f)) {
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangle(f)[i], b = mesh.triangle(f)[(i + 1) % 3];
      const double distance = (mesh.point(a) - mesh.point(b)).norm();
      if (distance <= length) {
        edges.emplace_back(distance, std::min(a, b), std::max(a, b));
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

constexpr std::size_t kDirections = 26;  // the first of lattice_steps: those of one step

/// Offsets to the neighbours on a lattice: one step per coordinate, then two, nearest first.
std::vector<std::array<int, 3>> lattice_steps() {
  std::vector<std::array<int, 3>> steps;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -2; y <= 2; ++y) {
      for (int z = -2; z <= 2; ++z) {
        if (x != 0 || y != 0 || z != 0) {
          steps.push_back({x, y, z});
        }
      }
    }
  }
  std::ranges::stable_sort(steps, {}, [](const auto& s) {
    return std::pair(std::max({std::abs(s[0]), std::abs(s[1]), std::abs(s[2])}),
                     s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
  });
  return steps;
}

/// Moves a point to a near number of the lattice, or, further off, by a power of two of the
/// lattice's largest step.
bool shift_point(EditedMesh& mesh, const exact::FloatLattice& lattice, std::uint32_t vertex,
                 const EditRule& terms) {
  static const std::vector<std::array<int, 3>> steps = lattice_steps();
  const Vec3 here = mesh.point(vertex);
  for (const auto& step : steps) {
    if (mesh.move(vertex,
                  {lattice.shifted(here.x(), step[0]), lattice.shifted(here.y(), step[1]),
                   lattice.shifted(here.z(), step[2])},
                  terms)) {
      return true;
    }
  }
  double far = lattice.step(here.cwiseAbs().maxCoeff());
  while (far <= terms.reach) {
    for (std::size_t i = 0; i < kDirections; ++i) {
      const Vec3 direction(steps[i][0], steps[i][1], steps[i][2]);
      if (mesh.move(vertex, lattice.nearest(Vec3(here + far * direction)), terms)) {
        return true;
      }
    }
    far *= 2;
  }
  return false;
}

bool collapse_or_flip(EditedMesh& mesh, const Faces& faces, const EditRule& terms) {
  for (const auto& [length, a, b] : short_edges(mesh, faces, terms.reach)) {
    if (mesh.collapse(a, b, terms) || mesh.collapse(b, a, terms)) {
      return true;
    }
  }
  return std::ranges::any_of(faces, [&](std::uint32_t face) {
    return mesh.flip(face, 0, terms) || mesh.flip(face, 1, terms) || mesh.flip(face, 2, terms);
  });
}

bool shift_any_point(EditedMesh& mesh, const exact::FloatLattice& lattice, const Faces& faces,
                     const EditRule& terms) {
  Faces vertices;
  for (const std::uint32_t f : faces) {
    vertices.insert(vertices.end(), mesh.triangle(f).begin(), mesh.triangle(f).end());
  }
  sort_unique(vertices);
  return std::ranges::any_of(
      vertices, [&](std::uint32_t vertex) { return shift_point(mesh, lattice, vertex, terms); });
}

/// One step that lowers the number of bad items: at the item's own faces, else next to them; new
/// edges first, because they are cheaper to try than new places.
bool improve(EditedMesh& mesh, const exact::FloatLattice& lattice, const Fault& item,
             const EditRule& terms) {
  Faces faces = {item.first, item.second};
  sort_unique(faces);
  const Faces ring = with_neighbours(mesh, faces);
  return collapse_or_flip(mesh, faces, terms) || collapse_or_flip(mesh, ring, terms) ||
         shift_any_point(mesh, lattice, faces, terms) ||
         shift_any_point(mesh, lattice, ring, terms);
}

double height(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

double height(const EditedMesh& mesh, const Triangle& t) {
  return height(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
}

int longest_edge(const EditedMesh& mesh, const Triangle& t) {
  int longest = 0;
  double length = -1;
  for (int i = 0; i < 3; ++i) {
    const double here = (mesh.point(t[i]) - mesh.point(t[(i + 1) % 3])).norm();
    if (here > length) {
      longest = i;
      length = here;
    }
  }
  return longest;
}

/// Flips the longest edge of a low triangle if the lower of the two new ones is higher.
bool flip_low(EditedMesh& mesh, std::uint32_t face, const EditRule& terms) {
  const Triangle t = mesh.triangle(face);
  const int edge = longest_edge(mesh, t);
  const std::uint32_t a = t[edge], b = t[(edge + 1) % 3], c = t[(edge + 2) % 3];
  const auto across = mesh.face_with_edge(b, a);
  if (!across) {
    return false;
  }
  std::uint32_t d = 0;
  for (const std::uint32_t corner : mesh.triangle(*across)) {
    d = corner != a && corner != b ? corner : d;
  }
  const double before = std::min(height(mesh, t), height(mesh, mesh.triangle(*across)));
  const double after = std::min(height(mesh, {a, d, c}), height(mesh, {d, b, c}));
  return after > before && mesh.flip(face, edge, terms);
}

}  // namespace

std::vector<std::uint32_t> with_neighbours(const EditedMesh& mesh, const Faces& faces) {
  Faces vertices, ring;
  for (const std::uint32_t f : faces) {
    if (mesh.alive(f)) {
      vertices.insert(vertices.end(), mesh.triangle(f).begin(), mesh.triangle(f).end());
    }
  }
  sort_unique(vertices);
  for (const std::uint32_t vertex : vertices) {
    const auto around = mesh.faces(vertex);
    ring.insert(ring.end(), around.begin(), around.end());
  }
  sort_unique(ring);
  return ring;
}

std::uint64_t repair(EditedMesh& mesh, const exact::FloatLattice& lattice, double reach,
                     std::uint64_t trials) {
  const EditRule terms{EditRule::Rule::fewer_bad, reach};
  const std::uint64_t first = mesh.trials();
  std::vector<Fault> items = mesh.bad_items();
  for (bool progress = true; progress && !items.empty(); items = mesh.bad_items()) {
    progress = false;
    for (const Fault& item : items) {
      if (mesh.trials() - first >= trials) {
        return 0;
      }
      progress = (mesh.is_bad(item) && improve(mesh, lattice, item, terms)) || progress;
    }
  }
  return trials - std::min(trials, mesh.trials() - first);
}

void clean_up(EditedMesh& mesh, double reach, Faces faces) {
  const EditRule terms{EditRule::Rule::none_bad, reach};
  while (!faces.empty()) {
    static_cast<void>(mesh.take_edited());
    for (const auto& [length, a, b] : short_edges(mesh, faces, reach)) {
      if (!mesh.faces(a).empty() && !mesh.faces(b).empty() && !mesh.collapse(a, b, terms)) {
        mesh.collapse(b, a, terms);
      }
    }
    for (const std::uint32_t f : faces) {
      if (mesh.alive(f) && height(mesh, mesh.triangle(f)) <= reach) {
        flip_low(mesh, f, terms);
      }
    }
    faces = mesh.take_edited();
  }
}

}  // namespace dupin::rounding
