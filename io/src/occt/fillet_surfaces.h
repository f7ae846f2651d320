#pragma once

#include <vector>

#include <TopoDS_Edge.hxx>

#include "exchange/exchange_model.h"
#include "occt/labelled_shape.h"

namespace dupin::occt {

/// The shape with the fillet's own surfaces in the place of what lies between these and the edges
/// in which both its parts meet. Throws Refusal where they do not join to a closed surface.
[[nodiscard]] LabelledShape with_fillet_surfaces(const LabelledShape& shape,
                                                 const exchange::RollingBall& fillet,
                                                 const std::vector<TopoDS_Edge>& sharp);

}  // namespace dupin::occt
