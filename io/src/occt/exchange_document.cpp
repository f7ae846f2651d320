#include "occt/exchange_document.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESEntity.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Precision.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPConstruct.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_MechanicalDesignGeometricPresentationRepresentation.hxx>
#include <StepVisual_PresentationStyleAssignment.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_ChildIterator.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <TransferBRep_ShapeMapper.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include "occt/nurbs_geometry.h"
#include "text/step_text.h"

namespace dupin::occt {
namespace {

using exchange::Model;
using exchange::Written;

// Relative, of volumes and areas. Without it, quadrature takes no notice of knots.
constexpr double kIntegral = 1e-7;

// Files do not say when they were written: the same model is the same bytes.
constexpr const char* kTimeStamp = "1970-01-01T00:00:00";

TCollection_ExtendedString token(const std::string& name) {
  return {text::step_token(name).c_str(), Standard_True};
}

std::string narrow(const TCollection_ExtendedString& text) {
  std::string bytes(std::size_t(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter at = bytes.data();
  (void)text.ToUTF8CString(at);
  bytes.resize(bytes.find('\0'));
  return bytes;
}

std::string name_of(const TDF_Label& label) {
  Handle(TDataStd_Name) name;
  return label.FindAttribute(TDataStd_Name::GetID(), name) ? narrow(name->Get()) : "";
}

// A document that is closed when nobody needs it any more.
class Document {
 public:
  Document() {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    application_ = XCAFApp_Application::GetApplication();
    application_->NewDocument("MDTV-XCAF", document_);
  }
  ~Document() { application_->Close(document_); }
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  [[nodiscard]] Handle(TDocStd_Document) get() const { return document_; }
  [[nodiscard]] Handle(XCAFDoc_ShapeTool) shapes() const {
    return XCAFDoc_DocumentTool::ShapeTool(document_->Main());
  }

 private:
  Handle(XCAFApp_Application) application_;
  Handle(TDocStd_Document) document_;
};

Quantity_Color colour(const exchange::Label& label) {
  const auto& [red, green, blue] = label.colour;
  return {red / 255., green / 255., blue / 255., Quantity_TOC_sRGB};
}

// The names and colours of a solid's faces. The library's own writer puts styles in the order of
// addresses.
void style_faces(const Handle(XSControl_WorkSession) & session, const TopoDS_Shape& solid,
                 const Model& model, const FaceLabels& labels) {
  const Handle(Transfer_FinderProcess) finder = session->TransferWriter()->FinderProcess();
  STEPConstruct_Styles styles(session);
  std::map<std::uint32_t, Handle(StepVisual_PresentationStyleAssignment)> assignments;
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
    const std::uint32_t* label = labels.Seek(face.Current());
    const auto item = STEPConstruct::FindEntity(finder, face.Current());
    if (label == nullptr || item.IsNull()) {
      continue;
    }
    item->SetName(
        new TCollection_HAsciiString(text::step_token(model.labels[*label].name).c_str()));
    auto& assignment = assignments[*label];
    if (assignment.IsNull()) {
      assignment =
          styles.MakeColorPSA(item, STEPConstruct_Styles::EncodeColor(colour(model.labels[*label])),
                              nullptr, nullptr, 0);
    }
    styles.AddStyle(item, assignment, nullptr);
  }
  if (styles.NbStyles() == 0) {
    return;
  }
  Handle(StepVisual_MechanicalDesignGeometricPresentationRepresentation) representation;
  (void)styles.CreateMDGPR(styles.FindContext(solid), representation);
  if (representation.IsNull()) {
    throw Refusal("OpenCASCADE does not colour it", model.name);
  }
  session->Model()->AddWithRefs(representation);
}

// The library counts occurrences over all files of a process.
void number_occurrences(const Handle(StepData_StepModel) & model) {
  int count = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto occurrence =
        Handle(StepRepr_NextAssemblyUsageOccurrence)::DownCast(model->Entity(i));
    if (!occurrence.IsNull()) {
      occurrence->SetId(new TCollection_HAsciiString(++count));
    }
  }
}

void say_who_wrote(const Handle(StepData_StepModel) & model) {
  const auto text = [](const char* value) { return new TCollection_HAsciiString(value); };
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text("dupin"));
  header.SetTimeStamp(text(kTimeStamp));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetOriginatingSystem(text("dupin"));
  header.SetAuthorisation(text(""));
}

template <class Styling>
std::string transferred(const Document& document, const std::string& name,
                        const Styling& put_styles) {
  STEPCAFControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetCVal("write.step.product.name", "dupin");
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  writer.SetColorMode(Standard_False);
  writer.SetNameMode(Standard_True);
  if (!writer.Transfer(document.get(), STEPControl_AsIs)) {
    throw Refusal("OpenCASCADE does not make STEP of it", name);
  }
  put_styles(writer.ChangeWriter().WS());
  const Handle(StepData_StepModel) model = writer.ChangeWriter().Model();
  number_occurrences(model);
  say_who_wrote(model);
  StepData_StepWriter text(model);
  text.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
  std::ostringstream out;
  if (!text.Print(out)) {
    throw Refusal("OpenCASCADE does not write it", name);
  }
  return text::with_step_strings(out.str());
}

// A name property, and as much of it as fits into the directory. The library's own writer puts
// names in the order of addresses.
void name_entities(IGESCAFControl_Writer& writer, const Document& document) {
  constexpr std::size_t kInDirectory = 8;
  TDF_LabelSequence labels;
  document.shapes()->GetFreeShapes(labels);
  for (const TDF_Label& label : labels) {
    const auto mapper =
        TransferBRep::ShapeMapper(writer.TransferProcess(), XCAFDoc_ShapeTool::GetShape(label));
    Handle(IGESData_IGESEntity) entity;
    if (!writer.TransferProcess()->FindTypedTransient(mapper, STANDARD_TYPE(IGESData_IGESEntity),
                                                      entity)) {
      continue;
    }
    const std::string name = name_of(label);
    const Handle(IGESBasic_Name) property = new IGESBasic_Name;
    property->Init(1, new TCollection_HAsciiString(name.c_str()));
    entity->AddProperty(property);
    writer.Model()->AddEntity(property);
    std::string label_text = name.substr(0, kInDirectory);
    label_text.insert(0, kInDirectory - label_text.size(), ' ');
    entity->SetLabel(new TCollection_HAsciiString(label_text.c_str()));
  }
}

std::string iges_text(const Document& document, const std::string& name) {
  IGESCAFControl_Writer writer;
  Interface_Static::SetCVal("write.iges.unit", "MM");
  writer.SetNameMode(Standard_False);
  if (!writer.Transfer(document.get())) {
    throw Refusal("OpenCASCADE does not make IGES of it", name);
  }
  name_entities(writer, document);
  const auto text = [](const char* value) { return new TCollection_HAsciiString(value); };
  IGESData_GlobalSection header = writer.Model()->GlobalSection();
  header.SetSendName(text("dupin"));
  header.SetFileName(text("dupin"));
  header.SetSystemId(text("dupin"));
  header.SetReceiveName(text("dupin"));
  header.SetAuthorName(text(""));
  header.SetCompanyName(text(""));
  header.SetDate(text("19700101.000000"));
  header.SetLastChangeDate(text("19700101.000000"));
  writer.Model()->SetGlobalSection(header);
  std::ostringstream out;
  if (!writer.Write(out)) {
    throw Refusal("OpenCASCADE does not write it", name);
  }
  return out.str();
}

exchange::WrittenSolid measured(const TopoDS_Shape& solid) {
  exchange::WrittenSolid result;
  GProp_GProps volume, area;
  (void)BRepGProp::VolumeProperties(solid, volume, kIntegral);
  (void)BRepGProp::SurfaceProperties(solid, area, kIntegral);
  result.volume = volume.Mass();
  result.area = area.Mass();
  TopTools_IndexedMapOfShape vertices, edges, faces, shells;
  TopExp::MapShapes(solid, TopAbs_VERTEX, vertices);
  TopExp::MapShapes(solid, TopAbs_EDGE, edges);
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  TopExp::MapShapes(solid, TopAbs_SHELL, shells);
  result.faces = std::size_t(faces.Extent());
  result.shells = std::size_t(shells.Extent());
  // A face with some loops is a disc with holes; what stands for a pole is no edge.
  result.euler_number = vertices.Extent();
  for (int i = 1; i <= edges.Extent(); ++i) {
    result.euler_number -= BRep_Tool::Degenerated(TopoDS::Edge(edges(i))) ? 0 : 1;
  }
  for (int i = 1; i <= faces.Extent(); ++i) {
    result.euler_number += 2 - faces(i).NbChildren();
  }
  return result;
}

double largest_tolerance(const TopoDS_Shape& shape) {
  double largest = 0;
  for (TopExp_Explorer edge(shape, TopAbs_EDGE); edge.More(); edge.Next()) {
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Edge(edge.Current())));
  }
  for (TopExp_Explorer vertex(shape, TopAbs_VERTEX); vertex.More(); vertex.Next()) {
    largest = std::max(largest, BRep_Tool::Tolerance(TopoDS::Vertex(vertex.Current())));
  }
  return largest;
}

// A part of the document, with what it consists of.
void read_label(const Document& document, const TDF_Label& label, Written& result) {
  const Handle(XCAFDoc_ShapeTool) shapes = document.shapes();
  TDF_LabelSequence components;
  if (XCAFDoc_ShapeTool::GetComponents(label, components)) {
    for (const TDF_Label& component : components) {
      TDF_Label referred;
      if (XCAFDoc_ShapeTool::GetReferredShape(component, referred)) {
        read_label(document, referred, result);
      }
    }
    return;
  }
  const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
  for (const TopoDS_Shape& solid : checked_solids(shape, name_of(label))) {
    result.solids.push_back(measured(solid));
    result.solids.back().name = name_of(label);
  }
  TDF_LabelSequence parts;
  (void)XCAFDoc_ShapeTool::GetSubShapes(label, parts);
  for (const TDF_Label& part : parts) {
    if (XCAFDoc_ShapeTool::GetShape(part).ShapeType() == TopAbs_FACE) {
      ++result.faces[name_of(part)];
    }
  }
  result.tolerance = std::max(result.tolerance, largest_tolerance(shape));
}

}  // namespace

std::vector<TopoDS_Shape> checked_solids(const TopoDS_Shape& shape, const std::string& at) {
  if (shape.IsNull() || !BRepCheck_Analyzer(shape).IsValid()) {
    throw Refusal("what OpenCASCADE makes of it is no valid boundary, says BRepCheck", at);
  }
  std::vector<TopoDS_Shape> result;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    for (TopExp_Explorer shell(solid.Current(), TopAbs_SHELL); shell.More(); shell.Next()) {
      if (!BRep_Tool::IsClosed(shell.Current())) {
        throw Refusal("what OpenCASCADE makes of it is not closed", at);
      }
    }
    GProp_GProps volume;
    (void)BRepGProp::VolumeProperties(solid.Current(), volume, kIntegral);
    if (!(volume.Mass() > 0) || !std::isfinite(volume.Mass())) {
      throw Refusal("what OpenCASCADE makes of it is inside out", at);
    }
    result.push_back(solid.Current());
  }
  if (result.empty()) {
    throw Refusal("what OpenCASCADE makes of it is no solid", at);
  }
  return result;
}

std::string step_text(const Model& model, const std::vector<NamedSolid>& solids,
                      const FaceLabels& labels) {
  const Document document;
  const Handle(XCAFDoc_ShapeTool) shapes = document.shapes();
  const TDF_Label root = solids.size() == 1 ? TDF_Label() : shapes->NewShape();
  if (!root.IsNull()) {
    TDataStd_Name::Set(root, token(model.name));
  }
  for (const NamedSolid& solid : solids) {
    const TDF_Label here = shapes->AddShape(solid.solid, Standard_False);
    TDataStd_Name::Set(here, token(solid.name));
    if (!root.IsNull()) {
      const TDF_Label component = shapes->AddComponent(root, here, TopLoc_Location());
      TDataStd_Name::Set(component, token(solid.name));
    }
  }
  shapes->UpdateAssemblies();
  return transferred(document, model.name, [&](const Handle(XSControl_WorkSession) & session) {
    for (const NamedSolid& solid : solids) {
      style_faces(session, solid.solid, model, labels);
    }
  });
}

Written read_back(std::string bytes) {
  const Document document;
  STEPCAFControl_Reader reader;
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
  std::istringstream in(bytes);
  Handle(TDocStd_Document) into = document.get();
  if (reader.ChangeReader().ReadStream("dupin", in) != IFSelect_RetDone || !reader.Transfer(into)) {
    throw Refusal("OpenCASCADE does not read back what it wrote", "");
  }
  Written result;
  result.bytes = std::move(bytes);
  TDF_LabelSequence roots;
  document.shapes()->GetFreeShapes(roots);
  for (const TDF_Label& root : roots) {
    read_label(document, root, result);
  }
  return result;
}

std::string surfaces_text(const std::string& name,
                          const std::vector<exchange::NamedSurface>& surfaces, bool iges) {
  const Document document;
  const Handle(XCAFDoc_ShapeTool) shapes = document.shapes();
  for (const exchange::NamedSurface& surface : surfaces) {
    BRepBuilderAPI_MakeFace face(bspline_surface(surface.surface), Precision::Confusion());
    if (!face.IsDone()) {
      throw Refusal("OpenCASCADE makes no face of its surface", surface.name);
    }
    const TDF_Label label = shapes->AddShape(face.Shape(), Standard_False);
    TDataStd_Name::Set(label,
                       iges ? TCollection_ExtendedString(text::ascii_only(surface.name).c_str())
                            : token(surface.name));
  }
  return iges ? iges_text(document, name) : transferred(document, name, [](const auto&) {});
}

}  // namespace dupin::occt
