#include "occt/ring_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <BRep_Builder.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <gp_Ax2.hxx>

namespace dupin::occt {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kSameAngle = 1e-7;

double in_turn(double angle) {
  const double turned = angle - kTurn * std::floor(angle / kTurn);
  return turned >= kTurn ? 0 : turned;
}

double apart(double a, double b) { return std::abs(std::remainder(a - b, kTurn)); }

gp_Dir dir(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
gp_Pnt pnt(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// Of ellipses OpenCASCADE's angle begins at the larger axis: this is what it is more than ours.
double shift(const exchange::RingCurve& ring) {
  return ring.second > ring.first ? std::numbers::pi / 2 : 0;
}

Handle(Geom_Curve) curve(const exchange::RingCurve& ring) {
  if (ring.first == ring.second) {
    return new Geom_Circle(gp_Ax2(pnt(ring.center), dir(ring.normal), dir(ring.axis)), ring.first);
  }
  const Vec3 across = ring.normal.cross(ring.axis);
  return ring.first > ring.second
             ? new Geom_Ellipse(gp_Ax2(pnt(ring.center), dir(ring.normal), dir(ring.axis)),
                                ring.first, ring.second)
             : new Geom_Ellipse(gp_Ax2(pnt(ring.center), dir(ring.normal), dir(across)),
                                ring.second, ring.first);
}

}  // namespace

void RingEdges::add_seam(double angle) {
  const double wrapped = in_turn(angle);
  if (std::ranges::none_of(angles_, [&](double a) { return apart(a, wrapped) < kSameAngle; })) {
    angles_.push_back(wrapped);
  }
}

void RingEdges::make() {
  if (angles_.empty()) {
    angles_.push_back(0);
  }
  std::ranges::sort(angles_);
  const Handle(Geom_Curve) on = curve(ring_);
  const BRep_Builder builder;
  for (const double angle : angles_) {
    TopoDS_Vertex vertex;
    builder.MakeVertex(vertex, on->Value(angle - shift(ring_)), Precision::Confusion());
    vertices_.push_back(vertex);
  }
  for (std::size_t i = 0; i < angles_.size(); ++i) {
    const bool is_last = i + 1 == angles_.size();
    RingArc arc;
    arc.from = angles_[i];
    arc.to = is_last ? angles_.front() + kTurn : angles_[i + 1];
    builder.MakeEdge(arc.edge, on, Precision::Confusion());
    builder.Add(arc.edge, TopoDS::Vertex(vertices_[i].Oriented(TopAbs_FORWARD)));
    builder.Add(arc.edge, TopoDS::Vertex(vertices_[is_last ? 0 : i + 1].Oriented(TopAbs_REVERSED)));
    builder.Range(arc.edge, arc.from - shift(ring_), arc.to - shift(ring_));
    arcs_.push_back(arc);
  }
}

std::size_t RingEdges::arc_at(double angle) const {
  const double wrapped = in_turn(angle);
  return std::size_t(
      std::ranges::min_element(angles_, {}, [&](double a) { return apart(a, wrapped); }) -
      angles_.begin());
}

const TopoDS_Vertex& RingEdges::vertex_at(double angle) const { return vertices_[arc_at(angle)]; }

}  // namespace dupin::occt
