#include "occt/body_booleans.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "occt/body_shape.h"
#include "occt/fillet_surfaces.h"

namespace dupin::occt {
namespace {

std::string errors_of(const BRepAlgoAPI_BooleanOperation& algorithm) {
  std::ostringstream text;
  algorithm.DumpErrors(text);
  std::string all = text.str();
  std::ranges::replace(all, '\n', ' ');
  return all;
}

LabelledShape built(BRepAlgoAPI_BooleanOperation& operation,
                    const std::vector<const LabelledShape*>& arguments,
                    const std::vector<const LabelledShape*>& tools, const std::string& at) {
  const auto shapes = [](const std::vector<const LabelledShape*>& all) {
    TopTools_ListOfShape list;
    for (const LabelledShape* one : all) {
      list.Append(one->shape);
    }
    return list;
  };
  operation.SetArguments(shapes(arguments));
  operation.SetTools(shapes(tools));
  operation.SetRunParallel(Standard_False);
  operation.SetNonDestructive(Standard_True);
  operation.Build();
  if (!operation.IsDone() || operation.HasErrors()) {
    throw Refusal("OpenCASCADE does not find where it crosses others: " + errors_of(operation), at);
  }
  LabelledShape result;
  result.shape = operation.Shape();
  for (const auto* list : {&arguments, &tools}) {
    for (const LabelledShape* one : *list) {
      inherit(operation, one->labels, result.labels);
    }
  }
  return result;
}

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

LabelledShape fused(const std::vector<const LabelledShape*>& all, const std::string& at) {
  if (all.size() == 1) {
    return *all.front();
  }
  BRepAlgoAPI_Fuse fuse;
  return built(fuse, {all.front()}, {all.begin() + 1, all.end()}, at);
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
    std::vector<const LabelledShape*> members;
    members.reserve(group.size());
    for (const std::size_t body : group) {
      members.push_back(&all[body]);
    }
    append(fused(members, bodies.bodies[group.front()].name), result);
  }
  return filleted(std::move(result), bodies.fillets);
}

LabelledShape combined(const LabelledShape& a, const LabelledShape& b,
                       exchange::Operation operation) {
  if (operation == exchange::Operation::subtract) {
    BRepAlgoAPI_Cut cut;
    return built(cut, {&a}, {&b}, "");
  }
  BRepAlgoAPI_Common common;
  return built(common, {&a}, {&b}, "");
}

}  // namespace dupin::occt
