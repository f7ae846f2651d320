#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>

#include "exchange/exchange_model.h"
#include "occt/ring_edges.h"

namespace dupin::occt {

[[nodiscard]] inline gp_Pnt pnt(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
[[nodiscard]] inline gp_Dir dir(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
[[nodiscard]] inline Vec3 vec(const gp_Pnt& p) { return {p.X(), p.Y(), p.Z()}; }

/// The surface of a tube between two rings, with the parameters of its ends and of its seam.
struct TubeSurface {
  Handle(Geom_Surface) surface;
  double seam = 0, seam_again = 1;  ///< around: where it begins and ends
  double start = 0, end = 1;        ///< along
  bool is_along_first = false;      ///< U goes along, as a torus's does, else around

  [[nodiscard]] gp_Pnt at(double around, double along) const {
    return is_along_first ? surface->Value(along, around) : surface->Value(around, along);
  }
};

/// Whether the tube's seam can be anywhere.
[[nodiscard]] bool has_free_seam(const exchange::TubeFace& tube);

/// The surface; of one whose seam can be anywhere, with its seam at this angle of its start.
[[nodiscard]] TubeSurface tube_surface(const exchange::TubeFace& tube,
                                       const exchange::RingCurve& start,
                                       const exchange::RingCurve& end, double seam);

/// The face between the rings' edges, its normal pointing out. Refines the tolerances of the edges
/// where they are farther from the surface.
[[nodiscard]] TopoDS_Face tube_face(const exchange::TubeFace& tube, const TubeSurface& surface,
                                    const RingEdges& start, const RingEdges& end);

}  // namespace dupin::occt
