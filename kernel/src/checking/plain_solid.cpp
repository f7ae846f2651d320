#include "checking/plain_solid.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <span>

#include "checking/self_intersection.h"
#include "dupin/kernel/connected_components.h"
#include "dupin/kernel/coordinates.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "mesh/shell_nesting.h"
#include "support/blocks.h"
#include "support/bulk_vector.h"
#include "support/none.h"
#include "support/sequences.h"

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

/// The links around each point, in no certain order.
class Links {
 public:
  Links(std::span<const Triangle> triangles, std::size_t points)
      : start_(points + 2, 0), links_(3 * triangles.size()) {
    for_each_link(triangles, [&](std::uint32_t point, const Link&) { count(start_[point + 2]); });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    for_each_link(triangles, [&](std::uint32_t point, const Link& link) {
      links_[count(start_[point + 1])] = link;
    });
  }
  [[nodiscard]] std::span<Link> of(std::size_t point) {
    return std::span(links_).subspan(start_[point], start_[point + 1] - start_[point]);
  }

 private:
  static std::uint32_t count(std::uint32_t& number) {
    return std::atomic_ref(number).fetch_add(1, std::memory_order_relaxed);
  }
  template <class Visit>
  static void for_each_link(std::span<const Triangle> triangles, const Visit& visit) {
    support::for_each_block(triangles.size(), [&](const support::Block& block) {
      for (std::size_t i = block.begin; i < block.end; ++i) {
        const auto& [a, b, c] = triangles[i];
        visit(a, {b, c});
        visit(b, {c, a});
        visit(c, {a, b});
      }
    });
  }

  support::BulkVector<std::uint32_t> start_;
  support::BulkVector<Link> links_;
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
    const std::span<Link> around = links.of(point);
    if (around.empty()) {
      all_used.store(false, std::memory_order_relaxed);
    }
    return around.empty() || is_one_cycle(around);
  });
  uses_all_points = all_used;
  return is_closed;
}

/// Of a closed manifold: triangles hang together by edges if they do by points.
mesh::Shells shells_of(std::span<const Triangle> triangles, std::size_t points) {
  const std::vector<std::uint32_t> component = connected_components(triangles, points);
  std::vector<std::uint32_t> first(points, support::kNone), lowest(triangles.size());
  for (std::uint32_t f = 0; f < triangles.size(); ++f) {
    std::uint32_t& face = first[component[triangles[f][0]]];
    face = std::min(face, f);
    lowest[f] = face;
  }
  return mesh::grouped(std::move(lowest));
}

/// Whether shells around material enclose a positive volume, those around voids a negative one.
bool are_turned_right(const mesh::MeshView& mesh, const mesh::Shells& shells) {
  const std::vector<int> depths = mesh::nesting_depths(mesh, shells);
  for (std::size_t i = 0; i < shells.count; ++i) {
    mesh::MeshView shell = mesh;
    std::vector<Triangle> faces;
    if (shells.count > 1) {
      faces = support::selected(mesh.triangles, shells.faces_of(i));
      shell.triangles = faces;
    }
    if (mesh::volume_sign(shell) != (depths[i] % 2 == 0 ? 1 : -1)) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::optional<PlainSolid> plain_solid(const TriMesh& mesh, double margin) {
  const std::size_t points = mesh.points.size();
  const auto is_triangle = [&](std::size_t i) {
    const auto& [a, b, c] = mesh.triangles[i];
    return a < points && b < points && c < points && a != b && b != c && c != a;
  };
  PlainSolid plain;
  if (!all_of(points, [&](std::size_t i) { return is_in_range(mesh.points[i]); }) ||
      !all_of(mesh.triangles.size(), is_triangle) ||
      !is_closed_manifold(mesh.triangles, points, plain.uses_all_points)) {
    return std::nullopt;
  }
  // Points that coincide, if there are any, make their triangles cross.
  std::vector<std::uint32_t> own(points);
  std::iota(own.begin(), own.end(), 0U);
  SelfIntersections found = find_self_intersections(
      mesh.points, mesh.triangles,
      {.limit = 1, .representatives = own, .closed = true, .margin = margin});
  if (!found.none() || found.contacts > 0 ||
      !are_turned_right({mesh.points, mesh.triangles}, shells_of(mesh.triangles, points))) {
    return std::nullopt;
  }
  plain.stable = std::move(found.stable);
  return plain;
}

}  // namespace dupin::checking
