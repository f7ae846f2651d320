#pragma once

#include <string>
#include <vector>

#include "exchange/exchange_model.h"
#include "occt/labelled_shape.h"

namespace dupin::occt {

/// A solid with its name.
struct NamedSolid {
  std::string name;
  TopoDS_Shape solid;
};

/// The solids of a shape, in its order, each a closed shell that BRepCheck accepts and with a
/// positive volume; `at` is what messages name. Throws Refusal.
[[nodiscard]] std::vector<TopoDS_Shape> checked_solids(const TopoDS_Shape& shape,
                                                       const std::string& at);

/// Solids of an assembly as a STEP file (AP214) in millimetres, with names and colours of its parts
/// on the faces; always the same bytes for the same model.
[[nodiscard]] std::string step_text(const exchange::Model& model,
                                    const std::vector<NamedSolid>& solids,
                                    const FaceLabels& labels);

/// What a STEP file holds. Throws Refusal if it is not what was written: so many solids, sound.
[[nodiscard]] exchange::Written read_back(std::string bytes);

/// Surfaces without solids.
[[nodiscard]] std::string surfaces_text(const std::string& name,
                                        const std::vector<exchange::NamedSurface>& surfaces,
                                        bool iges);

}  // namespace dupin::occt
