#include "cross_check/nef.h"

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include "cross_check/guarded.h"
#include "cross_check/surface_mesh.h"
#include "dupin/interop/cgal.h"
#include "mesh/coincident_points.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"

namespace dupin::cross_check {
namespace {

using Nef = CGAL::Nef_polyhedron_3<Kernel>;

constexpr const char* kWhat = "the operation by Nef polyhedra";

[[noreturn]] void fail(const std::string& why) {
  throw Error(Errc::boolean_failed, std::string(kWhat) + " " + why);
}

// What a shell encloses, whether material or a void.
Nef filled(const mesh::ExactMesh& whole, std::span<const std::uint32_t> faces) {
  mesh::ExactMesh shell;
  std::map<std::uint32_t, std::uint32_t> indices;  // ascending: points of doubles stay first
  for (const std::uint32_t face : faces) {
    for (const std::uint32_t corner : whole.triangles[face]) {
      indices.emplace(corner, 0);
    }
  }
  for (auto& [corner, index] : indices) {
    index = static_cast<std::uint32_t>(shell.points.size());
    shell.points.push_back(whole.points[corner]);
    if (corner >= whole.double_count()) {
      shell.implicit.push_back(whole.implicit, corner - whole.double_count());
    }
  }
  for (const std::uint32_t face : faces) {
    const Triangle& t = whole.triangles[face];
    shell.triangles.push_back({indices[t[0]], indices[t[1]], indices[t[2]]});
  }
  const auto firsts = mesh::coincident_representatives(shell);
  for (std::uint32_t i = 0; i < firsts.size(); ++i) {
    if (firsts[i] != i) {
      fail("takes no operand of which a shell touches itself");
    }
  }
  if (mesh::volume_sign(mesh::MeshView(shell)) < 0) {
    for (Triangle& t : shell.triangles) {
      std::swap(t[1], t[2]);
    }
  }
  Surface surface = surface_mesh(shell);
  return Nef(surface);
}

// The sets are merged in a balanced tree, so that most of them are small.
template <class Merge>
Nef balanced(std::span<const Nef> sets, const Merge& merge) {
  if (sets.size() == 1) {
    return sets.front();
  }
  const Nef left = balanced(sets.first(sets.size() / 2), merge);
  return merge(left, balanced(sets.subspan(sets.size() / 2), merge));
}

// Nef polyhedra fill all that a surface encloses. Shells do not cross: a place is in the solid if
// it is in an odd number of them.
Nef nef_of(const mesh::ExactMesh& mesh) {
  const mesh::EdgeTable edges(mesh.triangles, mesh.points.size());
  const mesh::Shells shells = mesh::shells(mesh.triangles.size(), edges);
  std::vector<Nef> sets;
  for (std::size_t i = 0; i < shells.count; ++i) {
    sets.push_back(filled(mesh, shells.faces_of(i)));
  }
  return sets.empty() ? Nef()
                      : balanced(sets, [](const Nef& a, const Nef& b) -> Nef { return a ^ b; });
}

Nef combined(SetOperation operation, const std::vector<Nef>& sets, Steps& steps) {
  if (operation == SetOperation::unite) {
    return balanced(sets, [&](const Nef& a, const Nef& b) -> Nef {
      steps.next();
      return a + b;
    });
  }
  Nef result = sets.front();
  for (const Nef& set : std::span(sets).subspan(1)) {
    steps.next();
    result = operation == SetOperation::intersect ? result * set : result - set;
  }
  return result;
}

Nef nef_by_nef(const Request& request, const Progress& progress) {
  Steps steps(request.steps, progress);
  const Nef set = evaluated<Nef>(
      request.steps,
      [&](std::uint32_t operand) { return nef_of(request.operands[operand].exact()); },
      [&](SetOperation operation, const std::vector<Nef>& sets) {
        return combined(operation, sets, steps);
      });
  return set.regularization();
}

// Facets seen from outside the set. Vertices are known by their address.
class FacetReader {
 public:
  explicit FacetReader(const Nef& nef) {
    for (auto facet = nef.halffacets_begin(); facet != nef.halffacets_end(); ++facet) {
      if (!facet->incident_volume()->mark() && facet->twin()->incident_volume()->mark()) {
        read(facet);
      }
    }
  }

  Boundary take() { return std::move(boundary_); }

 private:
  void read(const Nef::Halffacet_const_handle& facet) {
    auto& edges = boundary_.facets.emplace_back();
    for (auto cycle = facet->facet_cycles_begin(); cycle != facet->facet_cycles_end(); ++cycle) {
      if (!cycle.is_shalfedge()) {
        fail("left a point alone in a facet");
      }
      const Nef::SHalfedge_const_handle first(cycle);
      Nef::SHalfedge_const_handle edge = first;
      do {
        edges.push_back({number(edge), number(edge->next())});
        edge = edge->next();
      } while (edge != first);
    }
  }

  std::uint32_t number(const Nef::SHalfedge_const_handle& edge) {
    const Nef::Vertex_const_handle vertex = edge->source()->center_vertex();
    const auto [entry, is_new] =
        numbers_.try_emplace(&*vertex, static_cast<std::uint32_t>(boundary_.points.size()));
    if (is_new) {
      boundary_.points.push_back(interop::rational_coordinates(vertex->point()));
    }
    return entry->second;
  }

  Boundary boundary_;
  std::map<const void*, std::uint32_t> numbers_;
};

}  // namespace

Boundary boundary_by_nef(const Request& request, const Progress& progress) {
  return guarded(kWhat, [&] { return FacetReader(nef_by_nef(request, progress)).take(); });
}

mesh::ExactMesh mesh_by_nef(const Request& request, const Progress& progress) {
  return guarded(kWhat, [&] {
    const Nef nef = nef_by_nef(request, progress);
    if (nef.is_empty()) {
      return mesh::ExactMesh();
    }
    if (!nef.is_simple()) {  // converting would end in a segmentation fault
      fail("has a result whose boundary is no 2-manifold");
    }
    Surface surface;
    constexpr bool kTriangulate = true;
    CGAL::convert_nef_polyhedron_to_polygon_mesh(nef, surface, kTriangulate);
    return exact_mesh(surface, kWhat);
  });
}

}  // namespace dupin::cross_check
