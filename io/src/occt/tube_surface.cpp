#include "occt/tube_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax3.hxx>

#include "occt/labelled_shape.h"
#include "occt/nurbs_geometry.h"

namespace dupin::occt {
namespace {

using exchange::RingCurve;

constexpr double kTurn = 2 * std::numbers::pi;

struct SurfaceMaker {
  const RingCurve &start, &end;
  double seam;

  TubeSurface operator()(const exchange::CylinderOrCone& /*unused*/) const {
    const Vec3 axis = end.center - start.center;
    const double length = axis.norm();
    const Vec3 across = start.normal.cross(start.axis);
    const Vec3 to_seam = std::cos(seam) * start.axis + std::sin(seam) * across;
    TubeSurface result;
    result.seam_again = kTurn;
    if (start.first == end.first) {
      result.surface = new Geom_CylindricalSurface(
          gp_Ax3(pnt(start.center), dir(axis), dir(to_seam)), start.first);
      result.end = length;
      return result;
    }
    // Its axis points to where it widens.
    const bool widens = end.first > start.first;
    const RingCurve& narrow = widens ? start : end;
    const double half = std::atan2(std::abs(end.first - start.first), length);
    const double slant = std::hypot(end.first - start.first, length);
    result.surface = new Geom_ConicalSurface(
        gp_Ax3(pnt(narrow.center), dir(widens ? axis : Vec3(-axis)), dir(to_seam)), half,
        narrow.first);
    result.start = widens ? 0 : slant;
    result.end = widens ? slant : 0;
    return result;
  }

  TubeSurface operator()(const exchange::TorusArc& arc) const {
    const Vec3 radial = start.center - arc.center;
    TubeSurface result;
    result.surface = new Geom_ToroidalSurface(gp_Ax3(pnt(arc.center), dir(arc.axis), dir(radial)),
                                              radial.norm(), start.first);
    result.seam_again = kTurn;
    result.end = arc.angle;
    result.is_along_first = true;
    return result;
  }

  TubeSurface operator()(const exchange::Rim& /*rim*/) const {
    return (*this)(exchange::CylinderOrCone{});
  }

  TubeSurface operator()(const NurbsSurface& nurbs) const { return {bspline_surface(nurbs)}; }
};

// A ring as a boundary of the tube's surface.
class Border {
 public:
  Border(const TubeSurface& tube, const RingEdges& ring, double along)
      : tube_(tube), ring_(ring), along_(along) {
    const double width = tube.seam_again - tube.seam;
    seam_ = angle_on(ring.ring(), vec(tube.at(tube.seam, along)));
    const double next = angle_on(ring.ring(), vec(tube.at(tube.seam + width / 64, along)));
    sense_ = std::remainder(next - seam_, kTurn) > 0 ? 1 : -1;
  }

  [[nodiscard]] const TopoDS_Vertex& vertex() const { return ring_.vertex_at(seam_); }

  // The edges, each with its curve on the surface, in the order in which the parameter around
  // rises; reversed where they run against it.
  [[nodiscard]] std::vector<TopoDS_Edge> edges() const {
    std::vector<TopoDS_Edge> result;
    const std::size_t count = ring_.arcs().size(), first = ring_.arc_at(seam_);
    double from = ring_.arcs()[first].from;
    for (std::size_t i = 0; i < count; ++i) {
      const RingArc& arc = ring_.arcs()[(first + i) % count];
      // `from` is where the seam is by this edge's angle.
      from = arc.from < from - 1e-9 ? from - kTurn : from;
      put_curve(arc, from);
      result.push_back(arc.edge);
    }
    if (sense_ < 0) {
      std::ranges::reverse(result);
      for (TopoDS_Edge& edge : result) {
        edge.Reverse();
      }
    }
    return result;
  }

 private:
  void put_curve(const RingArc& arc, double seam) const {
    double first = 0, last = 0;
    (void)BRep_Tool::Curve(arc.edge, first, last);
    const double parameter = first - arc.from + seam;
    const Handle(Geom2d_Curve) on = curve(parameter);
    double off = 0;
    const Handle(Geom_Curve) edge = BRep_Tool::Curve(arc.edge, first, last);
    constexpr int kSamples = 64;
    for (int i = 0; i <= kSamples; ++i) {
      const double t = first + (last - first) * i / kSamples;
      const gp_Pnt2d uv = on->Value(t);
      off = std::max(off, edge->Value(t).Distance(tube_.surface->Value(uv.X(), uv.Y())));
    }
    const double tolerance = std::max(Precision::Confusion(), 1.5 * off);
    const BRep_Builder builder;
    builder.UpdateEdge(arc.edge, on, tube_.surface, TopLoc_Location(), tolerance);
    for (const double angle : {arc.from, arc.to}) {
      builder.UpdateVertex(ring_.vertex_at(angle), tolerance);
    }
  }

  [[nodiscard]] Handle(Geom2d_Curve) curve(double seam) const {
    if (const auto spline = Handle(Geom_BSplineSurface)::DownCast(tube_.surface)) {
      return boundary_by_angle(spline, along_, ring_.ring(), seam);
    }
    const double around = sense_ > 0 ? tube_.seam - seam : tube_.seam_again + seam;
    return tube_.is_along_first ? new Geom2d_Line(gp_Pnt2d(along_, around), gp_Dir2d(0, sense_))
                                : new Geom2d_Line(gp_Pnt2d(around, along_), gp_Dir2d(sense_, 0));
  }

  const TubeSurface& tube_;
  const RingEdges& ring_;
  double along_;
  double seam_ = 0;
  int sense_ = 1;
};

TopoDS_Edge seam_edge(const TubeSurface& tube, const TopoDS_Vertex& low,
                      const TopoDS_Vertex& high) {
  const auto line = [&](double around) {
    return tube.is_along_first ? new Geom2d_Line(gp_Pnt2d(0, around), gp_Dir2d(1, 0))
                               : new Geom2d_Line(gp_Pnt2d(around, 0), gp_Dir2d(0, 1));
  };
  const Handle(Geom_Curve) curve =
      tube.is_along_first ? tube.surface->VIso(tube.seam) : tube.surface->UIso(tube.seam);
  const BRep_Builder builder;
  TopoDS_Edge edge;
  builder.MakeEdge(edge, curve, Precision::Confusion());
  const Handle(Geom2d_Curve) here = line(tube.seam), again = line(tube.seam_again);
  // The first is that of the edge in its own direction.
  builder.UpdateEdge(edge, tube.is_along_first ? here : again, tube.is_along_first ? again : here,
                     tube.surface, TopLoc_Location(), Precision::Confusion());
  builder.Add(edge, TopoDS::Vertex(low.Oriented(TopAbs_FORWARD)));
  builder.Add(edge, TopoDS::Vertex(high.Oriented(TopAbs_REVERSED)));
  const double from = std::min(tube.start, tube.end), to = std::max(tube.start, tube.end);
  builder.Range(edge, from, to);
  const auto widen = [&](const TopoDS_Vertex& vertex, double at) {
    const double off = BRep_Tool::Pnt(vertex).Distance(curve->Value(at));
    builder.UpdateVertex(vertex, std::max(Precision::Confusion(), 1.5 * off));
  };
  widen(low, from);
  widen(high, to);
  return edge;
}

// Away from the rings' centres.
bool points_out(const TubeSurface& tube, const RingCurve& start) {
  const double around = tube.seam + (tube.seam_again - tube.seam) / 3;
  const double u = tube.is_along_first ? tube.start : around;
  const double v = tube.is_along_first ? around : tube.start;
  gp_Pnt at;
  gp_Vec du, dv;
  tube.surface->D1(u, v, at, du, dv);
  const gp_Vec normal = du.Crossed(dv);
  return normal.Dot(gp_Vec(pnt(start.center), at)) > 0;
}

bool is_outward(const exchange::TubeFace& tube, const TubeSurface& surface,
                const RingCurve& start) {
  const bool out = points_out(surface, start);
  if (const auto* rim = std::get_if<exchange::Rim>(&tube.surface)) {
    // Of a cone between the rings, the side to which the end's plane looks: the normal away from
    // the axis points there where the cone narrows that way.
    gp_Pnt at;
    gp_Vec du, dv;
    surface.surface->D1(surface.seam, surface.start, at, du, dv);
    const gp_Vec normal = du.Crossed(dv);
    return normal.Dot(gp_Vec(rim->outward.x(), rim->outward.y(), rim->outward.z())) > 0;
  }
  return out != tube.is_inside_out;
}

}  // namespace

bool has_free_seam(const exchange::TubeFace& tube) {
  return std::holds_alternative<exchange::CylinderOrCone>(tube.surface) ||
         std::holds_alternative<exchange::Rim>(tube.surface);
}

TubeSurface tube_surface(const exchange::TubeFace& tube, const RingCurve& start,
                         const RingCurve& end, double seam) {
  return std::visit(SurfaceMaker{start, end, seam}, tube.surface);
}

TopoDS_Face tube_face(const exchange::TubeFace& tube, const TubeSurface& surface,
                      const RingEdges& start, const RingEdges& end) {
  const bool rises = surface.start < surface.end;
  const Border low(surface, rises ? start : end, std::min(surface.start, surface.end));
  const Border high(surface, rises ? end : start, std::max(surface.start, surface.end));
  const TopoDS_Edge seam = seam_edge(surface, low.vertex(), high.vertex());
  // Counter-clockwise by the parameters around and along.
  std::vector<TopoDS_Edge> loop = low.edges();
  loop.push_back(TopoDS::Edge(seam.Oriented(TopAbs_FORWARD)));
  std::vector<TopoDS_Edge> above = high.edges();
  std::ranges::reverse(above);
  for (const TopoDS_Edge& edge : above) {
    loop.push_back(TopoDS::Edge(edge.Reversed()));
  }
  loop.push_back(TopoDS::Edge(seam.Oriented(TopAbs_REVERSED)));
  if (surface.is_along_first) {
    std::ranges::reverse(loop);
    for (TopoDS_Edge& edge : loop) {
      edge.Reverse();
    }
  }
  const BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, surface.surface, Precision::Confusion());
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (const TopoDS_Edge& edge : loop) {
    builder.Add(wire, edge);
  }
  wire.Closed(true);
  builder.Add(face, wire);
  if (!is_outward(tube, surface, start.ring())) {
    face.Reverse();
  }
  return face;
}

}  // namespace dupin::occt
