#include "occt/exchange_document.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Precision.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_NextAssemblyUsageOccurrence.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_ChildIterator.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>

#include "occt/nurbs_geometry.h"
#include "text/step_text.h"

namespace dupin::occt {
namespace {

using exchange::Model;
using exchange::Written;

// Files do not say when they were written: the same model is the same bytes.
constexpr const char* kTimeStamp = "1970-01-01T00:00:00";

TCollection_ExtendedString wide(const std::string& text) { return {text.c_str(), Standard_True}; }

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
  [[nodiscard]] Handle(XCAFDoc_ColorTool) colours() const {
    return XCAFDoc_DocumentTool::ColorTool(document_->Main());
  }

 private:
  Handle(XCAFApp_Application) application_;
  Handle(TDocStd_Document) document_;
};

Quantity_Color colour(const exchange::Label& label) {
  const auto& [red, green, blue] = label.colour;
  return {red / 255., green / 255., blue / 255., Quantity_TOC_sRGB};
}

void add_solid(const Document& document, const TDF_Label& at, const TopoDS_Shape& solid,
               const Model& model, const FaceLabels& labels) {
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
    const std::uint32_t* label = labels.Seek(face.Current());
    if (label == nullptr) {
      continue;
    }
    const TDF_Label part = document.shapes()->AddSubShape(at, face.Current());
    if (!part.IsNull()) {
      TDataStd_Name::Set(part, wide(model.labels[*label].name));
      document.colours()->SetColor(part, colour(model.labels[*label]), XCAFDoc_ColorSurf);
    }
  }
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

std::string transferred(const Document& document, const std::string& name) {
  STEPCAFControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.unit", "MM");
  Interface_Static::SetCVal("write.step.product.name", "dupin");
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  writer.SetColorMode(Standard_True);
  writer.SetNameMode(Standard_True);
  if (!writer.Transfer(document.get(), STEPControl_AsIs)) {
    throw Refusal("OpenCASCADE does not make STEP of it", name);
  }
  const Handle(StepData_StepModel) model = writer.ChangeWriter().Model();
  number_occurrences(model);
  say_who_wrote(model);
  StepData_StepWriter text(model);
  text.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
  std::ostringstream out;
  if (!text.Print(out)) {
    throw Refusal("OpenCASCADE does not write it", name);
  }
  return text::step_escaped(out.str());
}

std::string iges_text(const Document& document, const std::string& name) {
  IGESCAFControl_Writer writer;
  Interface_Static::SetCVal("write.iges.unit", "MM");
  writer.SetNameMode(Standard_True);
  if (!writer.Transfer(document.get())) {
    throw Refusal("OpenCASCADE does not make IGES of it", name);
  }
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
  BRepGProp::VolumeProperties(solid, volume);
  BRepGProp::SurfaceProperties(solid, area);
  result.volume = volume.Mass();
  result.area = area.Mass();
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
    ++result.faces;
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
    BRepGProp::VolumeProperties(solid.Current(), volume);
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
  if (solids.size() == 1) {
    const TDF_Label only = shapes->AddShape(solids.front().solid, Standard_False);
    TDataStd_Name::Set(only, wide(solids.front().name));
    add_solid(document, only, solids.front().solid, model, labels);
    return transferred(document, model.name);
  }
  const TDF_Label root = shapes->NewShape();
  TDataStd_Name::Set(root, wide(model.name));
  for (const NamedSolid& solid : solids) {
    const TDF_Label here = shapes->AddShape(solid.solid, Standard_False);
    TDataStd_Name::Set(here, wide(solid.name));
    add_solid(document, here, solid.solid, model, labels);
    const TDF_Label component = shapes->AddComponent(root, here, TopLoc_Location());
    TDataStd_Name::Set(component, wide(solid.name));
  }
  shapes->UpdateAssemblies();
  return transferred(document, model.name);
}

Written read_back(std::string bytes) {
  const Document document;
  STEPCAFControl_Reader reader;
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
  std::istringstream in(bytes);
  Handle(TDocStd_Document) into = document.get();
  if (reader.ChangeReader().ReadStream("dupin", in) != IFSelect_RetDone ||
      !reader.Transfer(into)) {
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
    TDataStd_Name::Set(label, wide(surface.name));
  }
  return iges ? iges_text(document, name) : transferred(document, name);
}

}  // namespace dupin::occt
