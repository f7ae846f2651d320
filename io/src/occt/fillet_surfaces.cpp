#include "occt/fillet_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

// Where fillets meet their parts, as wide as to lie in their faces.
class Contacts {
 public:
  Contacts(const LabelledShape& shape, const Fillets& fillets) {
    for (const exchange::RollingBall* fillet : fillets) {
      append(shape, *fillet);
    }
  }

  /// With the label of the fillet.
  [[nodiscard]] const std::vector<std::pair<Surface, std::uint32_t>>& surfaces() const {
    return surfaces_;
  }
  [[nodiscard]] const TopTools_ListOfShape& edges() const { return edges_; }
  [[nodiscard]] double width() const { return width_; }

 private:
  void append(const LabelledShape& shape, const exchange::RollingBall& fillet) {
    const std::array faces{faces_of(shape, fillet.between[0]), faces_of(shape, fillet.between[1])};
    for (const NurbsSurface& surface : fillet.surfaces) {
      surfaces_.emplace_back(bspline_surface(surface), fillet.label);
      for (std::size_t side = 0; side < 2; ++side) {
        const Handle(Geom_Curve) curve = surfaces_.back().first->UIso(double(side));
        const double off = distance(curve, faces.at(side));
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

  std::vector<std::pair<Surface, std::uint32_t>> surfaces_;
  TopTools_ListOfShape edges_;
  double width_ = Precision::Confusion();
};

// What a list of shapes became.
TopTools_MapOfShape images(BOPAlgo_Splitter& made, const TopTools_ListOfShape& shapes) {
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

// Faces of the fillets' parts that can be reached from the edges between these without a step over
// a contact.
class Strips {
 public:
  Strips(const LabelledShape& cut, const TopTools_MapOfShape& contacts)
      : cut_(cut), contacts_(contacts) {
    TopExp::MapShapesAndAncestors(cut.shape, TopAbs_EDGE, TopAbs_FACE, faces_);
  }

  void add(const exchange::RollingBall& fillet) {
    std::vector<TopoDS_Shape> open;
    for (const TopoDS_Edge& edge : edges_between(faces_, cut_.labels, fillet.between)) {
      reach(edge, fillet, open);
    }
    while (!open.empty()) {
      const TopoDS_Shape face = open.back();
      open.pop_back();
      for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
        reach(edge.Current(), fillet, open);
      }
    }
  }

  [[nodiscard]] const TopTools_MapOfShape& found() const { return found_; }

 private:
  void reach(const TopoDS_Shape& edge, const exchange::RollingBall& fillet,
             std::vector<TopoDS_Shape>& open) {
    if (contacts_.Contains(edge) || !faces_.Contains(edge)) {
      return;
    }
    for (const TopoDS_Shape& face : faces_.FindFromKey(edge)) {
      const std::uint32_t* label = cut_.labels.Seek(face);
      if (label != nullptr && std::ranges::find(fillet.between, *label) != fillet.between.end() &&
          found_.Add(face)) {
        open.push_back(face);
      }
    }
  }

  const LabelledShape& cut_;
  const TopTools_MapOfShape& contacts_;
  EdgeFaces faces_;
  TopTools_MapOfShape found_;
};

// Of a solid's faces but the strips, and the fillets' own.
TopoDS_Shape sewn(BRepBuilderAPI_Sewing& sewing, const Fillets& fillets) {
  sewing.Perform();
  TopExp_Explorer shell(sewing.SewedShape(), TopAbs_SHELL);
  const auto refuse = [&](const std::string& why) { return refusal(*fillets.front(), why); };
  if (!shell.More()) {
    throw refuse("it makes no surface of them");
  }
  ShapeFix_Shell fixed;
  fixed.FixFaceOrientation(TopoDS::Shell(shell.Current()));
  shell.Next();
  if (!BRep_Tool::IsClosed(fixed.Shell()) || shell.More()) {
    throw refuse("what they make is not closed");
  }
  ShapeFix_Solid maker;
  TopoDS_Shape solid = maker.SolidFromShell(fixed.Shell());
  if (!BRepCheck_Analyzer(solid).IsValid()) {
    throw refuse("what they make is no valid boundary");
  }
  return solid;
}

// Solids without strips are what they were.
LabelledShape joined(const LabelledShape& cut, const TopTools_MapOfShape& strips,
                     const Contacts& contacts, const Fillets& fillets) {
  BRepBuilderAPI_Sewing sewing(2 * contacts.width());
  FaceLabels sewn_labels;
  const auto add = [&](const TopoDS_Shape& face, std::uint32_t label) {
    sewing.Add(face);
    sewn_labels.Bind(face, label);
  };
  TopoDS_Compound all;
  const BRep_Builder builder;
  builder.MakeCompound(all);
  LabelledShape result;
  for (TopExp_Explorer solid(cut.shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    std::vector<TopoDS_Shape> faces;
    for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next()) {
      faces.push_back(face.Current());
    }
    const bool is_cut =
        std::ranges::any_of(faces, [&](const TopoDS_Shape& face) { return strips.Contains(face); });
    if (!is_cut) {
      builder.Add(all, solid.Current());
    }
    for (const TopoDS_Shape& face : faces) {
      if (!is_cut) {
        result.labels.Bind(face, *cut.labels.Seek(face));
      } else if (!strips.Contains(face)) {
        add(face, *cut.labels.Seek(face));
      }
    }
  }
  for (const auto& [surface, label] : contacts.surfaces()) {
    add(BRepBuilderAPI_MakeFace(surface, Precision::Confusion()), label);
  }
  builder.Add(all, sewn(sewing, fillets));
  result.shape = all;
  for (FaceLabels::Iterator face(sewn_labels); face.More(); face.Next()) {
    result.labels.Bind(sewing.Modified(face.Key()), face.Value());
  }
  return result;
}

}  // namespace

std::vector<TopoDS_Edge> edges_between(const EdgeFaces& faces, const FaceLabels& face_labels,
                                       const std::array<std::uint32_t, 2>& labels) {
  std::vector<TopoDS_Edge> result;
  for (int i = 1; i <= faces.Extent(); ++i) {
    std::array<bool, 2> seen{};
    for (const TopoDS_Shape& face : faces(i)) {
      const std::uint32_t* label = face_labels.Seek(face);
      for (std::size_t k = 0; k < 2; ++k) {
        seen.at(k) = seen.at(k) || (label != nullptr && *label == labels.at(k));
      }
    }
    if (seen[0] && seen[1]) {
      result.push_back(TopoDS::Edge(faces.FindKey(i)));
    }
  }
  return result;
}

LabelledShape with_fillet_surfaces(const LabelledShape& shape, const Fillets& fillets) {
  try {
    const Contacts contacts(shape, fillets);
    BOPAlgo_Splitter splitter;
    splitter.AddArgument(shape.shape);
    splitter.SetTools(contacts.edges());
    splitter.SetNonDestructive(Standard_True);
    splitter.SetRunParallel(Standard_False);
    splitter.Perform();
    if (splitter.HasErrors()) {
      throw refusal(*fillets.front(), "the curves where they touch do not cut the faces");
    }
    LabelledShape cut;
    cut.shape = splitter.Shape();
    inherit(splitter, shape.labels, cut.labels);
    const TopTools_MapOfShape borders = images(splitter, contacts.edges());
    Strips strips(cut, borders);
    for (const exchange::RollingBall* fillet : fillets) {
      strips.add(*fillet);
    }
    return joined(cut, strips.found(), contacts, fillets);
  } catch (const Standard_Failure& failure) {
    throw refusal(*fillets.front(), failure.GetMessageString());
  }
}

}  // namespace dupin::occt
