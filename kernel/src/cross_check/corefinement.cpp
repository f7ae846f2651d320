#include "cross_check/corefinement.h"

#include <string>

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include "cross_check/guarded.h"
#include "cross_check/surface_mesh.h"

namespace dupin::cross_check {
namespace {

bool compute(SetOperation operation, Surface& a, Surface& b, Surface& result) {
  namespace processing = CGAL::Polygon_mesh_processing;
  switch (operation) {
    case SetOperation::unite:
      return processing::corefine_and_compute_union(a, b, result);
    case SetOperation::intersect:
      return processing::corefine_and_compute_intersection(a, b, result);
    case SetOperation::subtract:
      return processing::corefine_and_compute_difference(a, b, result);
  }
  return false;
}

}  // namespace

mesh::ExactMesh corefine(SetOperation operation, const mesh::ExactMesh& a,
                         const mesh::ExactMesh& b) {
  const std::string what = "'" + std::string(name(operation)) + "' by corefinement";
  for (const mesh::ExactMesh* operand : {&a, &b}) {
    if (!operand->contacts.empty()) {
      throw Error(Errc::boolean_failed, what + " takes no operand whose surface touches itself");
    }
  }
  return guarded(what, [&] {
    Surface left = surface_mesh(a), right = surface_mesh(b), result;
    if (!compute(operation, left, right, result)) {
      throw Error(Errc::boolean_failed,
                  what + " refuses a result that touches itself along an edge");
    }
    return exact_mesh(result, what);
  });
}

}  // namespace dupin::cross_check
