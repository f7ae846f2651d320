#include "kernel/nef_oracle.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include "dupin/interop/cgal.h"

namespace dupin::test {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Nef to_nef(const Solid& solid) {
  if (solid.empty()) {
    return Nef(Nef::EMPTY);
  }
  Surface surface = interop::to_surface_mesh<Kernel::Point_3>(solid);
  return Nef(surface);
}

Nef combined(NefOperation operation, const Nef& a, const Nef& b) {
  switch (operation) {
    case NefOperation::unite:
      return a + b;
    case NefOperation::intersect:
      return a * b;
    case NefOperation::subtract:
      return a - b;
  }
  return Nef(Nef::EMPTY);
}

Nef evaluated(std::span<const NefStep> steps, std::span<const Solid> operands) {
  std::vector<Nef> stack;
  for (const NefStep& step : steps) {
    if (const auto* operand = std::get_if<std::size_t>(&step)) {
      stack.push_back(to_nef(operands[*operand]));
      continue;
    }
    const Nef right = std::move(stack.back());
    stack.pop_back();
    stack.back() = combined(std::get<NefOperation>(step), stack.back(), right);
  }
  return stack.back().regularization();
}

mpq_class volume(const Surface& surface) {
  mpq_class six = 0;
  for (const auto face : surface.faces()) {
    std::array<std::array<mpq_class, 3>, 3> p;
    auto corner = p.begin();
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face))) {
      *corner++ = interop::rational_coordinates(surface.point(vertex));
    }
    six += p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) +
           p[0][1] * (p[1][2] * p[2][0] - p[1][0] * p[2][2]) +
           p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0]);
  }
  return six / 6;
}

}  // namespace

std::optional<NefResult> by_nef(NefOperation operation, const Solid& a, const Solid& b) {
  const Solid operands[] = {a, b};
  const NefStep steps[] = {std::size_t{0}, std::size_t{1}, operation};
  return by_nef(steps, operands);
}

std::optional<NefResult> by_nef(std::span<const NefStep> steps, std::span<const Solid> operands) {
  const Nef nef = evaluated(steps, operands);
  if (nef.is_empty()) {
    return NefResult{};
  }
  if (!nef.is_simple()) {  // converting would end in a segmentation fault
    return std::nullopt;
  }
  NefResult result;
  for (auto volume = nef.volumes_begin(); volume != nef.volumes_end(); ++volume) {
    result.components += volume->mark() ? 1 : 0;
  }
  Surface surface;
  constexpr bool kTriangulate = true;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(nef, surface, kTriangulate);
  result.volume = volume(surface);
  auto shell = surface.add_property_map<Surface::Face_index, std::size_t>("f:shell").first;
  const auto shells = static_cast<std::int64_t>(
      CGAL::Polygon_mesh_processing::connected_components(surface, shell));
  const auto euler_number = static_cast<std::int64_t>(surface.number_of_vertices()) -
                            static_cast<std::int64_t>(surface.number_of_edges()) +
                            static_cast<std::int64_t>(surface.number_of_faces());
  result.genus = shells - euler_number / 2;
  return result;
}

}  // namespace dupin::test
