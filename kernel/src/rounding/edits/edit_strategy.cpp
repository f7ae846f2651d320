#include "rounding/edits/edit_strategy.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>
#include <tbb/parallel_invoke.h>

#include "dupin/kernel/coordinates.h"
#include "rounding/edits/thicken_in_slabs.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/sequences.h"
#include "support/task_context.h"

namespace dupin::rounding {
namespace {

using Edge = std::tuple<std::uint32_t, double, std::uint32_t, std::uint32_t>;  // row, length, ends
using Faces = std::vector<std::uint32_t>;

/// So many faces in a row, near each other in most meshes, are thickened before the next ones: what
/// is looked at for one edge is at hand for others. A fifth less time than in order of length.
constexpr std::uint32_t kRow = 512;

/// The edges of the faces up to a length, by rows of so many faces, and shortest first.
std::vector<Edge> short_edges(const EditedMesh& mesh, const Faces& faces, double length,
                              std::uint32_t row) {
  std::vector<Edge> edges;
  for (const std::uint32_t f : faces) {
    if (!mesh.alive(f)) {
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangle(f)[i], b = mesh.triangle(f)[(i + 1) % 3];
      const double distance = (mesh.point(a) - mesh.point(b)).norm();
      if (distance <= length) {
        edges.emplace_back(f / row, distance, std::min(a, b), std::max(a, b));
      }
    }
  }
  support::sort_unique(edges);
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
                 const EditRule& rule, bool is_near) {
  static const std::vector<std::array<int, 3>> steps = lattice_steps();
  const Vec3 here = mesh.point(vertex);
  for (const auto& step :
       is_near ? std::span(steps).first(kDirections) : std::span(steps).subspan(kDirections)) {
    if (mesh.move(vertex,
                  {lattice.shifted(here.x(), step[0]), lattice.shifted(here.y(), step[1]),
                   lattice.shifted(here.z(), step[2])},
                  rule)) {
      return true;
    }
  }
  if (is_near) {
    return false;
  }
  double far = lattice.step(here.cwiseAbs().maxCoeff());
  while (far <= rule.reach) {
    for (std::size_t i = 0; i < kDirections; ++i) {
      const Vec3 direction(steps[i][0], steps[i][1], steps[i][2]);
      if (mesh.move(vertex, lattice.nearest(Vec3(here + far * direction)), rule)) {
        return true;
      }
    }
    far *= 2;
  }
  return false;
}

bool collapse_or_flip(EditedMesh& mesh, const Faces& faces, const EditRule& rule) {
  for (const auto& [row, length, a, b] : short_edges(mesh, faces, rule.reach, mesh.face_count())) {
    if (mesh.collapse(a, b, rule) || mesh.collapse(b, a, rule)) {
      return true;
    }
  }
  return std::ranges::any_of(faces, [&](std::uint32_t face) {
    return mesh.flip(face, 0, rule) || mesh.flip(face, 1, rule) || mesh.flip(face, 2, rule);
  });
}

/// Points with few faces first, which change least and are tried soonest.
bool shift_any_point(EditedMesh& mesh, const exact::FloatLattice& lattice, const Faces& faces,
                     const EditRule& rule, bool is_near) {
  Faces vertices;
  for (const std::uint32_t f : faces) {
    vertices.insert(vertices.end(), mesh.triangle(f).begin(), mesh.triangle(f).end());
  }
  support::sort_unique(vertices);
  std::ranges::stable_sort(vertices, {},
                           [&](std::uint32_t vertex) { return mesh.faces(vertex).size(); });
  return std::ranges::any_of(vertices, [&](std::uint32_t vertex) {
    return shift_point(mesh, lattice, vertex, rule, is_near);
  });
}

/// Ways to lower the number of faults, by what it takes to try them.
enum class Effort { edges, points, edges_around, far_points };
constexpr std::size_t kEfforts = 4;

bool moves_points(Effort effort) {
  return effort == Effort::points || effort == Effort::far_points;
}

/// Steps that lower the number of faults, fault by fault.
class Mending {
 public:
  Mending(EditedMesh& mesh, const exact::FloatLattice& lattice, double reach)
      : mesh_(mesh), lattice_(lattice), rule_{FaultRule::fewer, reach} {}

  /// One step, at the fault's own faces or next to them too. What was in vain is not tried again
  /// before something has changed there.
  bool improves(const Fault& fault, Effort effort) {
    Faces faces = {fault.first, fault.second};
    support::sort_unique(faces);
    auto& in_vain = in_vain_[static_cast<std::size_t>(effort)];
    const auto last = in_vain.find(fault);
    if (last != in_vain.end() && !has_changed_around(faces, effort, last->second)) {
      return false;
    }
    if (tried(faces, effort)) {
      return true;
    }
    in_vain[fault] = mesh_.edits();
    return false;
  }

 private:
  bool tried(const Faces& faces, Effort effort) {
    switch (effort) {
      case Effort::edges:
        return collapse_or_flip(mesh_, faces, rule_);
      case Effort::edges_around:
        return collapse_or_flip(mesh_, with_neighbours(mesh_, faces), rule_);
      case Effort::points:
      case Effort::far_points:
        return shift_any_point(mesh_, lattice_, faces, rule_, effort == Effort::points);
    }
    return false;
  }

  [[nodiscard]] bool has_changed_around(const Faces& faces, Effort effort,
                                        std::uint64_t since) const {
    if (mesh_.edits() == since) {
      return false;
    }
    const auto is_edited = [&](std::uint32_t face) { return mesh_.last_edit(face) > since; };
    const auto is_edited_at = [&](std::uint32_t face) {
      return mesh_.alive(face) && std::ranges::any_of(mesh_.triangle(face), [&](std::uint32_t v) {
               return std::ranges::any_of(mesh_.faces(v), is_edited);
             });
    };
    return effort == Effort::edges_around
               ? std::ranges::any_of(with_neighbours(mesh_, faces), is_edited_at)
               : std::ranges::any_of(faces, is_edited_at);
  }

  EditedMesh& mesh_;
  const exact::FloatLattice& lattice_;
  EditRule rule_;
  std::array<std::map<Fault, std::uint64_t>, kEfforts> in_vain_;  // the number of edits by then
};

/// Edits to be tried, per fault and besides: ten times as many as the 600 unions of
/// io_written_unions_test need. What takes more gets nowhere.
constexpr std::uint64_t kTrialsPerFault = 16, kTrials = 1 << 15;

/// Of them, to move points, in vain, where the surface can be cut instead; and for each time it was
/// not in vain. What does not help a handful of faults is seldom of use to others, and costs more
/// than all the rest. Where there are many faults, more of them are left, and cut.
constexpr std::uint64_t kMoves = 1 << 10, kMovesPerFault = 64, kManyFaults = 1 << 10;

/// mend_faults(), which may give up.
bool mend(EditedMesh& mesh, const exact::FloatLattice& lattice, double reach, bool is_thorough) {
  const std::uint64_t faults = mesh.faults().size(), trials = kTrials + kTrialsPerFault * faults;
  const std::uint64_t moves = is_thorough ? trials : kMoves / (1 + faults / kManyFaults);
  return mend_faults(mesh, lattice, reach, {trials, moves});
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
bool flip_low(EditedMesh& mesh, std::uint32_t face, const EditRule& rule) {
  const Triangle t = mesh.triangle(face);
  const int edge = longest_edge(mesh, t);
  const std::uint32_t a = t[edge], b = t[(edge + 1) % 3], c = t[(edge + 2) % 3];
  const auto across = mesh.face_with_edge(b, a);
  if (!across) {
    return false;
  }
  const std::uint32_t d = third_corner(mesh.triangle(*across), a, b);
  const double before = std::min(height(mesh, t), height(mesh, mesh.triangle(*across)));
  const double after = std::min(height(mesh, {a, d, c}), height(mesh, {d, b, c}));
  return after > before && mesh.flip(face, edge, rule);
}

/// Collapses short edges of the faces, and flips those that are low still.
void thicken_once(EditedMesh& mesh, double reach, const Faces& faces) {
  const EditRule rule{FaultRule::none, reach};
  for (const auto& [row, length, a, b] : short_edges(mesh, faces, reach, kRow)) {
    if (!mesh.faces(a).empty() && !mesh.faces(b).empty() && !mesh.collapse(a, b, rule)) {
      mesh.collapse(b, a, rule);
    }
  }
  for (const std::uint32_t f : faces) {
    if (mesh.alive(f) && height(mesh, mesh.triangle(f)) <= reach) {
      flip_low(mesh, f, rule);
    }
  }
}

/// The faces that are not as in the mesh that is rounded only.
support::BulkVector<std::uint8_t> differing_faces(const EditedMesh& mesh,
                                                  const BrokenMesh& original) {
  support::BulkVector<std::uint8_t> differing(mesh.face_count());
  support::for_each_block(differing.size(), [&](const support::Block& block) {
    for (auto f = static_cast<std::uint32_t>(block.begin); f < block.end; ++f) {
      const Triangle& t = mesh.triangle(f);
      const bool has_moved = std::ranges::any_of(
          t, [&](std::uint32_t v) { return mesh.point(v) != original.on_lattice[v]; });
      differing[f] = mesh.alive(f) && (has_moved || t != original.triangles[f]) ? 1 : 0;
    }
  });
  return differing;
}

/// Rounds the mesh: points that are where they were as the original has them.
void place_on_lattice(EditedMesh& mesh, const BrokenMesh& original,
                      const exact::FloatLattice& lattice) {
  support::BulkVector<Vec3> points(mesh.points().size());
  support::for_each_block(points.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const Vec3& here = mesh.points()[i];
      points[i] = here == original.doubles[i] ? original.on_lattice[i] : lattice.nearest(here);
    }
  });
  mesh.place(points);
}

}  // namespace

std::vector<std::uint32_t> with_neighbours(const EditedMesh& mesh, const Faces& faces) {
  Faces vertices, ring;
  for (const std::uint32_t f : faces) {
    if (mesh.alive(f)) {
      vertices.insert(vertices.end(), mesh.triangle(f).begin(), mesh.triangle(f).end());
    }
  }
  support::sort_unique(vertices);
  for (const std::uint32_t vertex : vertices) {
    const auto around = mesh.faces(vertex);
    ring.insert(ring.end(), around.begin(), around.end());
  }
  support::sort_unique(ring);
  return ring;
}

bool mend_faults(EditedMesh& mesh, const exact::FloatLattice& lattice, double reach,
                 const MostTrials& most) {
  Mending mending(mesh, lattice, reach);
  const std::uint64_t first = mesh.trials();
  std::uint64_t moves = 0, moved = 0;
  for (Effort effort = Effort::edges;;) {
    bool progress = false;
    for (const Fault& fault : mesh.faults()) {
      const std::uint64_t before = mesh.trials();
      if (before - first >= most.all ||
          (moves_points(effort) && moves >= most.moves + kMovesPerFault * moved)) {
        return false;
      }
      const bool improved = mesh.is_fault(fault) && mending.improves(fault, effort);
      progress = progress || improved;
      if (moves_points(effort)) {
        moves += mesh.trials() - before;
        moved += improved ? 1 : 0;
      }
    }
    if (progress) {
      effort = Effort::edges;
    } else if (effort == Effort::far_points) {
      return true;
    } else {
      effort = static_cast<Effort>(static_cast<int>(effort) + 1);
    }
  }
}

void thicken(EditedMesh& mesh, double reach, Faces faces) {
  while (!faces.empty()) {
    static_cast<void>(mesh.take_edited());
    thicken_once(mesh, reach, faces);
    faces = mesh.take_edited();
  }
}

bool thicken_doubles(EditedMesh& mesh, const BrokenMesh& original,
                     std::span<const std::uint8_t> inexact, double reach, double mending) {
  Faces left = thicken_in_slabs(mesh, original, reach);
  // Lemma: both faces of a fault are as given. Who was edited last of two was compared with the
  // other one. So they are sought while other faces are edited still.
  const auto alive = mesh.alive_faces();
  const auto triangles = mesh.triangles_of(alive);
  support::BulkVector<std::uint8_t> marked = marked_faces(triangles, inexact);
  for (std::size_t i = 0; i < alive.size(); ++i) {
    marked[i] = marked[i] != 0 && mesh.last_edit(alive[i]) == 0 ? 1 : 0;
  }
  std::vector<Fault> faults;
  tbb::task_group_context context = support::task_context();
  tbb::parallel_invoke(
      [&] { thicken(mesh, reach, std::move(left)); },
      [&] {
        faults = find_faults({mesh.points(), triangles, original.representatives}, marked);
      },
      context);
  faults = renumbered(std::move(faults), alive);
  std::erase_if(faults, [&](const Fault& fault) {
    return mesh.last_edit(fault.first) != 0 || mesh.last_edit(fault.second) != 0;
  });
  mesh.add_faults(faults);
  mend(mesh, exact::FloatLattice(Coordinates::binary64), reach + mending, false);
  thicken(mesh, reach, with_neighbours(mesh, mesh.take_edited()));
  return mesh.faults().empty();
}

bool repair_around(EditedMesh& mesh, const BrokenMesh& original,
                   const std::vector<std::uint32_t>& broken, const std::vector<Fault>& broken_pairs,
                   const RepairLimits& limits) {
  const auto& [lattice, step, reach, is_thorough] = limits;
  if (!lattice.holds_doubles()) {
    // Faults of nearest doubles are not looked for: those of the lattice are, and few are.
    thicken(mesh, std::min(step, reach), with_neighbours(mesh, broken));
    place_on_lattice(mesh, original, lattice);
  } else if (!std::ranges::all_of(mesh.points(), [](const Vec3& p) { return is_in_range(p); })) {
    place_on_lattice(mesh, original, lattice);
  }
  mesh.find_faults(differing_faces(mesh, original), broken_pairs);
  return mend(mesh, lattice, reach, is_thorough);
}

bool repair_further(EditedMesh& mesh, const Faces& broken, const RepairLimits& limits) {
  // Not what that edits, too: with a reach of pipes' own edges it would go on all over them.
  thicken_once(mesh, limits.reach, with_neighbours(mesh, broken));
  return mend(mesh, limits.lattice, limits.reach, limits.is_thorough);
}

}  // namespace dupin::rounding
