#include "checking/plain_solid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <utility>

#include "checking/self_intersection.h"
#include "dupin/kernel/connected_components.h"
#include "dupin/kernel/coordinates.h"
#include "exact/exact_numbers.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "mesh/shell_nesting.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/sequences.h"
#include "support/sort_by_key.h"

namespace dupin::checking {
namespace {

/// Whether holds(index) for all indices below `count`.
template <class Holds>
bool all_of(std::size_t count, const Holds& holds) {
  std::atomic<bool> all = true;
  support::for_each_block(count, [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      if (!holds(i)) {
        all.store(false, std::memory_order_relaxed);
        return;
      }
    }
  });
  return all;
}

/// The edge of a triangle opposite to a point, run along as the triangle does.
struct Link {
  std::uint32_t from, to;
};

/// Whether the links make one cycle through all of them.
bool is_one_cycle(std::span<Link> links) {
  constexpr std::size_t kFew = 16;  // in any order
  const bool is_sorted = links.size() > kFew;
  if (is_sorted) {
    std::ranges::sort(links, {}, &Link::from);
  }
  const auto next = [&](std::uint32_t from) {
    const auto found = is_sorted ? std::ranges::lower_bound(links, from, {}, &Link::from)
                                 : std::ranges::find(links, from, &Link::from);
    const bool is_there = found != links.end() && found->from == from;
    return is_there ? static_cast<std::size_t>(found - links.begin()) : links.size();
  };
  std::size_t at = 0, steps = 0;
  do {
    at = next(links[at].to);
    if (at == links.size() || ++steps > links.size()) {
      return false;
    }
  } while (at != 0);
  return steps == links.size();
}

/// The links around each point, in no certain order: those of most points, which have few, within
/// one line of memory, where the threads put them and find them.
class Links {
 public:
  Links(std::span<const Triangle> triangles, std::size_t points) : around_(points) {
    support::for_each_block(points, [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        around_[i].count = 0;
      }
    });
    more_ = support::collect_in_order<LinkOf>(triangles.size(),
                                              [&](std::size_t i, std::vector<LinkOf>& more) {
                                                const auto& [a, b, c] = triangles[i];
                                                add(a, {b, c}, more);
                                                add(b, {c, a}, more);
                                                add(c, {a, b}, more);
                                              });
    support::sort_by_key(
        more_, static_cast<std::uint32_t>(points), [](const LinkOf& m) { return m.point; },
        [](const LinkOf& m, const LinkOf& n) { return m.point < n.point; });
  }
  /// `room` is for those of a point that has many.
  [[nodiscard]] std::span<Link> of(std::size_t point, std::vector<Link>& room) {
    Around& around = around_[point];
    if (around.count <= kFew) {
      return std::span(around.links).first(around.count);
    }
    room.assign(around.links.begin(), around.links.end());
    for (const LinkOf& more : std::ranges::equal_range(more_, point, {}, &LinkOf::point)) {
      room.push_back(more.link);
    }
    return room;
  }

 private:
  static constexpr std::size_t kFew = 7;
  struct alignas(64) Around {
    std::array<Link, kFew> links;
    std::uint32_t count;
  };
  struct LinkOf {
    std::uint32_t point;
    Link link;
  };

  void add(std::uint32_t point, const Link& link, std::vector<LinkOf>& more) {
    Around& around = around_[point];
    const std::uint32_t before =
        std::atomic_ref(around.count).fetch_add(1, std::memory_order_relaxed);
    if (before < kFew) {
      around.links[before] = link;
    } else {
      more.push_back({point, link});
    }
  }

  support::BulkVector<Around> around_;
  std::vector<LinkOf> more_;
};

/// Whether the triangles at each point, if any, make one closed fan. Lemma: then each edge has two
/// triangles, which run along it in opposite directions. For a triangle that runs from v to w is a
/// link of v that starts at w or ends there; in a cycle each point is the start of one link and the
/// end of one. Two triangles of the same three corners make cycles of two links, which close too:
/// they are faults of the search for intersections.
bool is_closed_manifold(std::span<const Triangle> triangles, std::size_t points,
                        bool& uses_all_points) {
  Links links(triangles, points);
  std::atomic<bool> all_used = true;
  const bool is_closed = all_of(points, [&](std::size_t point) {
    std::vector<Link> room;
    const std::span<Link> around = links.of(point, room);
    if (around.empty()) {
      all_used.store(false, std::memory_order_relaxed);
    }
    return around.empty() || is_one_cycle(around);
  });
  uses_all_points = all_used;
  return is_closed;
}

/// Whether points are in range, and triangles have three of them.
bool is_mesh(const TriMesh& mesh) {
  const std::size_t points = mesh.points.size();
  const auto is_triangle = [&](std::size_t i) {
    const auto& [a, b, c] = mesh.triangles[i];
    return a < points && b < points && c < points && a != b && b != c && c != a;
  };
  return all_of(points, [&](std::size_t i) { return is_in_range(mesh.points[i]); }) &&
         all_of(mesh.triangles.size(), is_triangle);
}

/// Of a closed manifold.
mesh::Shells shells_of(std::span<const Triangle> triangles, std::size_t points) {
  return mesh::shells_by_points(triangles, connected_components(triangles, points));
}

/// Calls visit(shell, its triangles) for each shell, one after the other, until one returns false;
/// whether none did.
template <class Visit>
bool visit_shells(const mesh::MeshView& mesh, const mesh::Shells& shells, const Visit& visit) {
  for (std::size_t i = 0; i < shells.count; ++i) {
    mesh::MeshView shell = mesh;
    std::vector<Triangle> faces;
    if (shells.count > 1) {
      faces = support::selected(mesh.triangles, shells.faces_of(i));
      shell.triangles = faces;
    }
    if (!visit(i, shell)) {
      return false;
    }
  }
  return true;
}

bool are_turned_right(const mesh::MeshView& mesh, const mesh::Shells& shells) {
  const std::vector<int> depths = mesh::nesting_depths(mesh, shells);
  return visit_shells(mesh, shells, [&](std::size_t i, const mesh::MeshView& shell) {
    return mesh::volume_sign(shell) == mesh::sign_at(depths[i]);
  });
}

}  // namespace

std::optional<PlainSolid> plain_solid(const TriMesh& mesh, double margin) {
  const std::size_t points = mesh.points.size();
  PlainSolid plain;
  if (!is_mesh(mesh) || !is_closed_manifold(mesh.triangles, points, plain.uses_all_points)) {
    return std::nullopt;
  }
  // Points that coincide, if there are any, make their triangles cross.
  const std::vector<std::uint32_t> own = support::numbers_below(points);
  SelfIntersections found = find_self_intersections(
      mesh.points, mesh.triangles,
      {.limit = 1, .representatives = own, .closed = true, .margin = margin, .enough = 1});
  if (!found.none() || found.contacts > 0 ||
      !are_turned_right({mesh.points, mesh.triangles}, shells_of(mesh.triangles, points))) {
    return std::nullopt;
  }
  plain.stable = std::move(found.stable);
  return plain;
}

std::optional<Report> plain_report(const TriMesh& mesh) {
  const std::size_t points = mesh.points.size();
  bool uses_all_points = false;
  if (!is_mesh(mesh) || !is_closed_manifold(mesh.triangles, points, uses_all_points) ||
      !uses_all_points) {
    return std::nullopt;
  }
  const mesh::Shells shells = shells_of(mesh.triangles, points);
  const mesh::MeshView view(mesh.points, mesh.triangles);
  const std::vector<int> depths = mesh::nesting_depths(view, shells);
  Report report;
  report.points = points;
  report.triangles = mesh.triangles.size();
  report.counts.assign(static_cast<std::size_t>(Defect::isolated_point) + 1, 0);
  report.area = mesh::area(view);
  std::vector<std::int64_t> corners(shells.count, 0);
  std::vector<std::uint8_t> is_counted(points, 0);
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (const std::uint32_t corner : mesh.triangles[f]) {
      corners[shells.of_face[f]] += 1 - std::exchange(is_counted[corner], 1);
    }
  }
  mpq_class sum;
  const auto add_shell = [&](std::size_t i, const mesh::MeshView& shell) {
    const mpq_class volume = mesh::exact_volume(shell);
    sum += volume;
    const std::size_t faces = shell.triangles.size();
    const std::int64_t euler = corners[i] - static_cast<std::int64_t>(faces) / 2;
    report.shells.push_back(
        {shells.faces_of(i)[0], faces, exact::nearest_double(volume), depths[i], euler});
    report.euler_number += euler;
    report.genus += (2 - euler) / 2;
    report.components += depths[i] % 2 == 0 ? 1 : 0;
    return sgn(volume) == mesh::sign_at(depths[i]);
  };
  if (!visit_shells(view, shells, add_shell)) {
    return std::nullopt;
  }
  report.volume = exact::nearest_double(sum);
  return report;
}

}  // namespace dupin::checking
