#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS_Edge.hxx>

#include "exchange/exchange_model.h"
#include "occt/labelled_shape.h"

namespace dupin::occt {

/// Edges with the faces that meet in them.
using EdgeFaces = TopTools_IndexedDataMapOfShapeListOfShape;

/// Those of `faces` in which faces of both labels meet.
[[nodiscard]] std::vector<TopoDS_Edge> edges_between(const EdgeFaces& faces,
                                                     const FaceLabels& face_labels,
                                                     const std::array<std::uint32_t, 2>& labels);

using Fillets = std::vector<const exchange::RollingBall*>;

/// The shape with the fillets' own surfaces in the place of what lies between these and the edges
/// in which their parts meet. Throws Refusal, naming one of them, where they do not join to a
/// closed surface.
[[nodiscard]] LabelledShape with_fillet_surfaces(const LabelledShape& shape,
                                                 const Fillets& fillets);

}  // namespace dupin::occt
