#include "occt/fillet_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <BOPAlgo_Splitter.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineSurface.hxx>
#include <ShapeFix_Shell.hxx>
#include <ShapeFix_Solid.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include "occt/nurbs_geometry.h"

namespace dupin::occt {
namespace {

using Surface = Handle(Geom_BSplineSurface);

constexpr double kRounding = 1e-6;  // millimetres

Refusal refusal(const exchange::RollingBall& fillet, const std::string& why) {
  return {"its surface does not join those of its pipes in OpenCASCADE: " + why, fillet.name};
}

// The faces of a label.
std::vector<TopoDS_Face> faces_of(const LabelledShape& shape, std::uint32_t label) {
  std::vector<TopoDS_Face> result;
  for (TopExp_Explorer face(shape.shape, TopAbs_FACE); face.More(); face.Next()) {
    const std::uint32_t* its = shape.labels.Seek(face.Current());
    if (its != nullptr && *its == label) {
      result.push_back(TopoDS::Face(face.Current()));
    }
  }
  return result;
}

// How far a curve on one of the faces' surfaces is from it, at many places.
double distance(const Handle(Geom_Curve) & curve, const std::vector<TopoDS_Face>& faces) {
  constexpr int kPlaces = 256;
  double furthest = 0;
  for (int i = 0; i <= kPlaces; ++i) {
    const double from = curve->FirstParameter(), to = curve->LastParameter();
    const gp_Pnt point = curve->Value(from + (to - from) * i / kPlaces);
    double nearest = INFINITY;
    for (const TopoDS_Face& face : faces) {
      const GeomAPI_ProjectPointOnSurf foot(point, BRep_Tool::Surface(face));
      nearest = foot.NbPoints() > 0 ? std::min(nearest, foot.LowerDistance()) : nearest;
    }
    furthest = std::max(furthest, nearest);
  }
  return furthest;
}

// Where the fillet meets its parts, as wide as to lie in their faces.
class Contacts {
 public:
  Contacts(const LabelledShape& shape, const exchange::RollingBall& fillet) {
    for (const NurbsSurface& surface : fillet.surfaces) {
      surfaces_.push_back(bspline_surface(surface));
      for (std::size_t side = 0; side < 2; ++side) {
        const Handle(Geom_Curve) curve = surfaces_.back()->UIso(double(side));
        const double off = distance(curve, faces_of(shape, fillet.between.at(side)));
        if (!(off <= fillet.error + kRounding)) {
          throw refusal(fillet, "it does not touch them");
        }
        const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(curve);
        const double wide = std::max(Precision::Confusion(), 2 * off);
        BRep_Builder().UpdateEdge(edge, wide);
        for (TopExp_Explorer vertex(edge, TopAbs_VERTEX); vertex.More(); vertex.Next()) {
          BRep_Builder().UpdateVertex(TopoDS::Vertex(vertex.Current()), wide);
        }
        edges_.Append(edge);
        width_ = std::max(width_, wide);
      }
    }
  }

  [[nodiscard]] const std::vector<Surface>& surfaces() const { return surfaces_; }
  [[nodiscard]] const TopTools_ListOfShape& edges() const { return edges_; }
  [[nodiscard]] double width() const { return width_; }

 private:
  std::vector<Surface> surfaces_;
  TopTools_ListOfShape edges_;
  double width_ = Precision::Confusion();
};

// What a list of shapes became.
template <class Algorithm, class Shapes>
TopTools_MapOfShape images(Algorithm& made, const Shapes& shapes) {
  TopTools_MapOfShape result;
  for (const TopoDS_Shape& shape : shapes) {
    const TopTools_ListOfShape& now = made.Modified(shape);
    if (now.IsEmpty()) {
      result.Add(shape);
    }
    for (const TopoDS_Shape& image : now) {
      result.Add(image);
    }
  }
  return result;
}

// Faces that can be reached from the sharp edges without a step over a contact.
TopTools_MapOfShape strips(const LabelledShape& cut, const exchange::RollingBall& fillet,
                           const TopTools_MapOfShape& sharp, const TopTools_MapOfShape& contacts) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(cut.shape, TopAbs_EDGE, TopAbs_FACE, faces);
  TopTools_MapOfShape found;
  std::vector<TopoDS_Shape> open;
  const auto reach = [&](const TopoDS_Shape& edge) {
    if (contacts.Contains(edge) || !faces.Contains(edge)) {
      return;
    }
    for (const TopoDS_Shape& face : faces.FindFromKey(edge)) {
      const std::uint32_t* label = cut.labels.Seek(face);
      if (label != nullptr && std::ranges::find(fillet.between, *label) != fillet.between.end() &&
          found.Add(face)) {
        open.push_back(face);
      }
    }
  };
  for (TopTools_MapOfShape::Iterator edge(sharp); edge.More(); edge.Next()) {
    reach(edge.Key());
  }
  while (!open.empty()) {
    const TopoDS_Shape face = open.back();
    open.pop_back();
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
      reach(edge.Current());
    }
  }
  return found;
}

TopoDS_Shape solid_of_shell(const TopoDS_Shape& sewn, const exchange::RollingBall& fillet) {
  TopoDS_Compound result;
  const BRep_Builder builder;
  builder.MakeCompound(result);
  for (TopExp_Explorer shell(sewn, TopAbs_SHELL); shell.More(); shell.Next()) {
    ShapeFix_Shell fixed;
    fixed.FixFaceOrientation(TopoDS::Shell(shell.Current()));
    if (!BRep_Tool::IsClosed(fixed.Shell())) {
      throw refusal(fillet, "what they make is not closed");
    }
    ShapeFix_Solid maker;
    builder.Add(result, maker.SolidFromShell(fixed.Shell()));
  }
  if (!BRepCheck_Analyzer(result).IsValid()) {
    throw refusal(fillet, "what they make is no valid boundary");
  }
  return result;
}

LabelledShape joined(const LabelledShape& cut, const TopTools_MapOfShape& strips,
                     const Contacts& contacts, const exchange::RollingBall& fillet) {
  BRepBuilderAPI_Sewing sewing(2 * contacts.width());
  FaceLabels labels;
  for (TopExp_Explorer face(cut.shape, TopAbs_FACE); face.More(); face.Next()) {
    if (!strips.Contains(face.Current())) {
      sewing.Add(face.Current());
      labels.Bind(face.Current(), *cut.labels.Seek(face.Current()));
    }
  }
  for (const Surface& surface : contacts.surfaces()) {
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, Precision::Confusion());
    sewing.Add(face);
    labels.Bind(face, fillet.label);
  }
  sewing.Perform();
  LabelledShape result;
  result.shape = solid_of_shell(sewing.SewedShape(), fillet);
  for (FaceLabels::Iterator face(labels); face.More(); face.Next()) {
    result.labels.Bind(sewing.Modified(face.Key()), face.Value());
  }
  return result;
}

}  // namespace

LabelledShape with_fillet_surfaces(const LabelledShape& shape, const exchange::RollingBall& fillet,
                                   const std::vector<TopoDS_Edge>& sharp) {
  try {
    const Contacts contacts(shape, fillet);
    BOPAlgo_Splitter splitter;
    splitter.AddArgument(shape.shape);
    splitter.SetTools(contacts.edges());
    splitter.SetNonDestructive(Standard_True);
    splitter.SetRunParallel(Standard_False);
    splitter.Perform();
    if (splitter.HasErrors()) {
      throw refusal(fillet, "the curves where they touch do not cut the faces");
    }
    LabelledShape cut;
    cut.shape = splitter.Shape();
    inherit(splitter, shape.labels, cut.labels);
    const auto gone =
        strips(cut, fillet, images(splitter, sharp), images(splitter, contacts.edges()));
    return joined(cut, gone, contacts, fillet);
  } catch (const Standard_Failure& failure) {
    throw refusal(fillet, failure.GetMessageString());
  }
}

}  // namespace dupin::occt
