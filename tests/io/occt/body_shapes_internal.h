#pragma once

#include <numbers>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>

#include "exchange/exchange_model.h"
#include "occt/labelled_shape.h"

namespace dupin::occt {

/// A pipe of radius 1 upwards, an elbow to the right, and a cone.
inline exchange::Body bent_pipe() {
  exchange::Body body;
  body.name = "bent";
  body.rings = {{{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, 1, 1},
                {{0, 0, 5}, {0, 0, 1}, {0, 1, 0}, 1, 1},
                {{3, 0, 8}, {1, 0, 0}, {0, 0, 1}, 1, 1},
                {{9, 0, 8}, {1, 0, 0}, {0, 1, 0}, 2, 2}};
  body.tubes = {{0, 0, 1, exchange::CylinderOrCone{}},
                {1, 1, 2, exchange::TorusArc{{3, 0, 5}, {0, 1, 0}, std::numbers::pi / 2}},
                {2, 2, 3, exchange::CylinderOrCone{}}};
  body.discs = {{3, 0, {0, 0, -1}}, {4, 3, {1, 0, 0}}};
  return body;
}

constexpr double kBentVolume = std::numbers::pi * (5 + 3 * std::numbers::pi / 2 + 14);

/// A cylinder of radius 1/2 across its cone.
inline exchange::Body branch() {
  exchange::Body body;
  body.name = "branch";
  body.rings = {{{5, 0.2, -3}, {0, 0, -1}, {1, 0, 0}, .5, .5},
                {{5, 0.2, 20}, {0, 0, 1}, {1, 0, 0}, .5, .5}};
  body.tubes = {{5, 0, 1, exchange::CylinderOrCone{}}};
  body.discs = {{6, 0, {0, 0, -1}}, {7, 1, {0, 0, 1}}};
  return body;
}

inline double volume(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  (void)BRepGProp::VolumeProperties(shape, properties, 1e-9);
  return properties.Mass();
}

inline bool is_valid(const TopoDS_Shape& shape) { return BRepCheck_Analyzer(shape).IsValid(); }

}  // namespace dupin::occt
