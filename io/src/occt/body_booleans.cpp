#include "occt/body_booleans.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include <BRepBndLib.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "occt/body_shape.h"
#include "occt/fillet_surfaces.h"
#include "occt/labelled_booleans.h"

namespace dupin::occt {
namespace {

// Sets of bodies whose boxes overlap, in the order of their first.
std::vector<std::vector<std::size_t>> groups(const std::vector<LabelledShape>& all) {
  std::vector<Bnd_Box> boxes(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    BRepBndLib::Add(all[i].shape, boxes[i]);
  }
  std::vector<std::size_t> leader(all.size());
  std::iota(leader.begin(), leader.end(), std::size_t{0});
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (leader[i] != leader[j] && !boxes[i].IsOut(boxes[j])) {
        const std::size_t from = std::max(leader[i], leader[j]);
        const std::size_t to = std::min(leader[i], leader[j]);
        std::ranges::replace(leader, from, to);
      }
    }
  }
  std::vector<std::vector<std::size_t>> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (leader[i] == i) {
      auto& group = result.emplace_back();
      for (std::size_t j = i; j < all.size(); ++j) {
        if (leader[j] == i) {
          group.push_back(j);
        }
      }
    }
  }
  return result;
}

void append(const LabelledShape& from, LabelledShape& to) {
  const BRep_Builder builder;
  if (to.shape.IsNull()) {
    TopoDS_Compound compound;
    builder.MakeCompound(compound);
    to.shape = compound;
  }
  builder.Add(to.shape, from.shape);
  for (FaceLabels::Iterator face(from.labels); face.More(); face.Next()) {
    to.labels.Bind(face.Key(), face.Value());
  }
}

// By OpenCASCADE's own ball of constant radius; none where it fails.
std::optional<LabelledShape> rolled(const LabelledShape& shape, const exchange::RollingBall& ball,
                                    const std::vector<TopoDS_Edge>& edges) {
  try {
    BRepFilletAPI_MakeFillet fillet(shape.shape);
    for (const TopoDS_Edge& edge : edges) {
      if (fillet.Contour(edge) == 0) {
        fillet.Add(*ball.radius, edge);
      }
    }
    fillet.Build();
    if (!fillet.IsDone()) {
      return std::nullopt;
    }
    LabelledShape result;
    result.shape = fillet.Shape();
    inherit(fillet, shape.labels, result.labels);
    for (TopExp_Explorer face(result.shape, TopAbs_FACE); face.More(); face.Next()) {
      if (!result.labels.IsBound(face.Current())) {
        result.labels.Bind(face.Current(), ball.label);
      }
    }
    return result;
  } catch (const Standard_Failure&) {
    return std::nullopt;
  }
}

LabelledShape filleted(const LabelledShape& shape, const exchange::RollingBall& ball) {
  EdgeFaces faces;
  TopExp::MapShapesAndAncestors(shape.shape, TopAbs_EDGE, TopAbs_FACE, faces);
  const auto edges = edges_between(faces, shape.labels, ball.between);
  if (edges.empty()) {
    throw Refusal("OpenCASCADE finds no edge between the two", ball.name);
  }
  try {
    return with_fillet_surfaces(shape, {&ball});
  } catch (const Refusal&) {
    if (ball.radius) {
      if (auto result = rolled(shape, ball, edges)) {
        return *result;
      }
    }
    throw;
  }
}

// All at once, or one after the other.
LabelledShape filleted(LabelledShape shape, const std::vector<exchange::RollingBall>& balls) {
  if (balls.size() > 1) {
    Fillets all;
    for (const exchange::RollingBall& ball : balls) {
      all.push_back(&ball);
    }
    try {
      return with_fillet_surfaces(shape, all);
    } catch (const Refusal&) {
      // Some of them may do, and else the message is about one.
    }
  }
  for (const exchange::RollingBall& ball : balls) {
    shape = filleted(shape, ball);
  }
  return shape;
}

}  // namespace

LabelledShape united(const exchange::BodyUnion& bodies) {
  std::vector<LabelledShape> all;
  all.reserve(bodies.bodies.size());
  for (const exchange::Body& body : bodies.bodies) {
    all.push_back(solid_of(body));
  }
  LabelledShape result;
  for (const auto& group : groups(all)) {
    std::vector<LabelledShape> members;
    members.reserve(group.size());
    for (const std::size_t body : group) {
      members.push_back(std::move(all[body]));
    }
    append(fused(members, bodies.bodies[group.front()].name, "it and others"), result);
  }
  return filleted(std::move(result), bodies.fillets);
}

}  // namespace dupin::occt
