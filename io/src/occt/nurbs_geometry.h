#pragma once

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>

#include "exchange/exchange_model.h"

namespace dupin::occt {

/// U goes around, V along.
[[nodiscard]] Handle(Geom_BSplineSurface) bspline_surface(const NurbsSurface& surface);

/// The angle of a point near the ring, in (-pi, pi], as RingCurve has it.
[[nodiscard]] double angle_on(const exchange::RingCurve& ring, const Vec3& point);

/// The surface's boundary at `v` by the ring's angle, which it passes through once: from `seam` to
/// a whole turn more. Within rounding.
[[nodiscard]] Handle(Geom2d_BSplineCurve)
    boundary_by_angle(const Handle(Geom_BSplineSurface) & surface, double v,
                      const exchange::RingCurve& ring, double seam);

}  // namespace dupin::occt
