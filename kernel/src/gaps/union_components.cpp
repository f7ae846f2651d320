#include "gaps/union_components.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "mesh/edge_table.h"
#include "mesh/shell_nesting.h"
#include "predicates/triangle_overlap.h"
#include "support/disjoint_sets.h"

namespace dupin::gaps {
namespace {

// The shells of both meshes, those of a first. Faces of different meshes never share a shell,
// though they may share edges.
struct AllShells {
  mesh::Shells shells;
  std::size_t of_a = 0;
};

AllShells all_shells(const MeshPair& pair) {
  AllShells all;
  all.shells = mesh::shells(pair.of_a().size(), mesh::EdgeTable(pair.of_a(), pair.points.size()));
  all.of_a = all.shells.count;
  const mesh::Shells others =
      mesh::shells(pair.of_b().size(), mesh::EdgeTable(pair.of_b(), pair.points.size()));
  const auto append = [](std::vector<std::uint32_t>& to, std::span<const std::uint32_t> from,
                         std::size_t shift) {
    for (const std::uint32_t x : from) {
      to.push_back(x + static_cast<std::uint32_t>(shift));
    }
  };
  append(all.shells.of_face, others.of_face, all.of_a);
  append(all.shells.starts, std::span(others.starts).subspan(1), all.shells.faces.size());
  append(all.shells.faces, others.faces, all.shells.faces.size());
  all.shells.count += others.count;
  return all;
}

using ShellPairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

bool share_corner(const Triangle& s, const Triangle& t) {
  return std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end();
}

// Pairs of a shell of a and one of b that have a point in common.
ShellPairs meeting_shells(const MeshPair& pair, const FaceBoxIndex& boxes,
                          const mesh::Shells& shells) {
  ShellPairs meeting;
  for (std::uint32_t a = 0; a < pair.faces_of_a; ++a) {
    boxes.visit_near(a, 0, [&](std::uint32_t b) {
      const std::pair shell_pair(shells.of_face[a], shells.of_face[b]);
      if (!meeting.contains(shell_pair) &&
          (share_corner(pair.triangles[a], pair.triangles[b]) ||
           predicates::TriangleOverlapTest(pair.points, pair.triangles[a])
                   .meeting(pair.triangles[b]) != predicates::TriangleOverlap::none)) {
        meeting.insert(shell_pair);
      }
    });
  }
  return meeting;
}

// Joins shells that bound, or lie in, the same piece of material: one within an odd number of
// shells of a mesh with the innermost of them, be it as the wall of a void in the same mesh or as a
// piece inside the other. Shells that meet are joined anyway and are not asked about.
void join_nested(const MeshPair& pair, const AllShells& all, const ShellPairs& meeting,
                 support::DisjointSets& pieces) {
  const auto count = static_cast<std::uint32_t>(all.shells.count);
  const auto in_a = [&](std::uint32_t shell) { return shell < all.of_a; };
  const mesh::ShellNest nest(mesh::MeshView(pair.points, pair.triangles), all.shells);
  std::vector<std::vector<std::uint32_t>> around(count);
  for (std::uint32_t inner = 0; inner < count; ++inner) {
    std::optional<mesh::WindingPoint> point;
    nest.visit_boxes_around(inner, 0, [&](std::size_t other) {
      const auto outer = static_cast<std::uint32_t>(other);
      if (meeting.contains(std::minmax(outer, inner))) {
        return;
      }
      if (!point) {
        point = nest.test_point(inner);
      }
      if (nest.encloses(outer, *point)) {
        around[inner].push_back(outer);
      }
    });
    std::ranges::sort(around[inner]);
  }
  const auto depth = [&](std::uint32_t shell) {  // within its own mesh
    return std::count_if(around[shell].begin(), around[shell].end(),
                         [&](std::uint32_t other) { return in_a(other) == in_a(shell); });
  };
  for (std::uint32_t shell = 0; shell < count; ++shell) {
    const auto middle = std::partition(around[shell].begin(), around[shell].end(), in_a);
    for (const auto& [from, to] :
         {std::pair(around[shell].begin(), middle), std::pair(middle, around[shell].end())}) {
      if ((to - from) % 2 == 1) {
        pieces.unite(shell, *std::max_element(from, to, [&](std::uint32_t a, std::uint32_t b) {
                       return depth(a) < depth(b);
                     }));
      }
    }
  }
}

}  // namespace

UnionTopology union_topology(const MeshPair& pair, const FaceBoxIndex& boxes, bool closed) {
  const AllShells all = all_shells(pair);
  const ShellPairs meeting = meeting_shells(pair, boxes, all.shells);
  support::DisjointSets pieces(all.shells.count);
  for (const auto& [a, b] : meeting) {
    pieces.unite(a, b);
  }
  if (closed) {
    join_nested(pair, all, meeting, pieces);
  }
  return {!meeting.empty(), pieces.count()};
}

}  // namespace dupin::gaps
