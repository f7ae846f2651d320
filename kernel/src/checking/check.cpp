#include "dupin/kernel/check.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

#include "checking/inspection.h"
#include "dupin/kernel/coordinates.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

std::string face(std::uint32_t index, const TriMesh& mesh) {
  const std::string text = std::to_string(index);
  const bool labelled = index < mesh.labels.size() && mesh.labels[index] < mesh.names.size();
  return labelled ? text + " ('" + mesh.names[mesh.labels[index]] + "')" : text;
}

// "face 3", "faces 3 and 5", "faces 3, 5 and 7"; of many only the first.
std::string faces(std::span<const std::uint32_t> indices, const TriMesh& mesh) {
  constexpr std::size_t kMost = 6;
  std::string text = indices.size() == 1 ? "face " : "faces ";
  const std::size_t shown = std::min(indices.size(), kMost);
  for (std::size_t i = 0; i < shown; ++i) {
    const bool last = i + 1 == indices.size();
    text += i == 0 ? "" : last ? " and " : ", ";
    text += face(indices[i], mesh);
  }
  if (shown < indices.size()) {
    text += " and " + std::to_string(indices.size() - shown) + " more";
  }
  return text;
}

std::uint32_t point_of(const Finding& finding, std::size_t i) {
  if (i >= finding.points.size()) {
    throw Error(Errc::invalid_argument, "the finding names too few points");
  }
  return finding.points[i];
}

std::string edge(const Finding& finding, const TriMesh& mesh) {
  const auto end = [&](std::size_t i) {
    const std::uint32_t point = point_of(finding, i);
    if (point >= mesh.points.size()) {
      throw Error(Errc::invalid_argument, "the finding is one of another mesh: it names point " +
                                              std::to_string(point) + " of " +
                                              std::to_string(mesh.points.size()));
    }
    return decimal(mesh.points[point]);
  };
  return "the edge from " + end(0) + " to " + end(1);
}

}  // namespace

Report check(const TriMesh& mesh, const CheckOptions& options) {
  const UsualArithmetic usual;
  return checking::inspect(mesh, options).report;
}

bool Report::closed() const {
  return count(Defect::boundary_edge) == 0 && count(Defect::non_manifold_edge) == 0 &&
         count(Defect::non_manifold_vertex) == 0 && count(Defect::inconsistent_orientation) == 0;
}

bool Report::is_solid() const {
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0 && is_fatal(static_cast<Defect>(i))) {
      return false;
    }
  }
  return true;
}

bool is_fatal(Defect defect) {
  return defect != Defect::contact && defect != Defect::isolated_point;
}

std::string_view name(Defect defect) {
  switch (defect) {
    case Defect::non_finite_point:
      return "non_finite_point";
    case Defect::point_out_of_range:
      return "point_out_of_range";
    case Defect::bad_index:
      return "bad_index";
    case Defect::degenerate_face:
      return "degenerate_face";
    case Defect::duplicate_face:
      return "duplicate_face";
    case Defect::boundary_edge:
      return "boundary_edge";
    case Defect::non_manifold_edge:
      return "non_manifold_edge";
    case Defect::non_manifold_vertex:
      return "non_manifold_vertex";
    case Defect::inconsistent_orientation:
      return "inconsistent_orientation";
    case Defect::self_intersection:
      return "self_intersection";
    case Defect::contact:
      return "contact";
    case Defect::inside_out_component:
      return "inside_out_component";
    case Defect::isolated_point:
      return "isolated_point";
  }
  return "unknown";
}

std::string describe(const Finding& finding, const TriMesh& mesh) {
  const auto at_faces = [&] { return faces(finding.faces, mesh); };
  const auto point = [&](std::size_t i) { return "point " + std::to_string(point_of(finding, i)); };
  switch (finding.defect) {
    case Defect::non_finite_point:
      return point(0) + " has coordinates that are not finite numbers: " + decimal(finding.place);
    case Defect::point_out_of_range:
      return point(0) + " has " + range_fault(finding.place);
    case Defect::bad_index:
      return at_faces() + " refers to " + point(0) + ", but there are only " +
             std::to_string(mesh.points.size()) + " points";
    case Defect::degenerate_face:
      return at_faces() + " at " + decimal(finding.place) +
             " has no area: its corners lie on one line";
    case Defect::duplicate_face:
      return at_faces() + " at " + decimal(finding.place) + " have the same three corners";
    case Defect::boundary_edge:
      return edge(finding, mesh) + " belongs to " + at_faces() + " only";
    case Defect::non_manifold_edge:
      return edge(finding, mesh) + " is shared by " + at_faces();
    case Defect::non_manifold_vertex:
      return at_faces() + " meet in " + point(0) + " at " + decimal(finding.place) +
             " but do not hang together by edges there";
    case Defect::inconsistent_orientation:
      return at_faces() + " run along " + edge(finding, mesh) + " in the same direction";
    case Defect::self_intersection:
      return at_faces() + " intersect near " + decimal(finding.place);
    case Defect::contact:
      return at_faces() + " touch in " +
             (finding.points.size() == 2 ? edge(finding, mesh) : decimal(finding.place)) +
             " without sharing it";
    case Defect::inside_out_component:
      return "the shell of " + at_faces() + " at " + decimal(finding.place) + " is inside out";
    case Defect::isolated_point:
      return point(0) + " at " + decimal(finding.place) + " belongs to no face";
  }
  return "unknown";
}

}  // namespace dupin
