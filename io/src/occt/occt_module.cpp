#include "occt/occt_module.h"

#include <Standard_Failure.hxx>

#include "occt/body_booleans.h"
#include "occt/body_shape.h"
#include "occt/exchange_document.h"
#include "occt/labelled_booleans.h"

namespace dupin::occt {
namespace {

using exchange::Model;
using exchange::Written;

// What goes wrong is said, not thrown: no exception crosses the module's border.
template <class Work>
Written guarded(const Work& work) {
  Written result;
  try {
    return work();
  } catch (const Refusal& refusal) {
    result.fault = refusal.what();
    result.at = refusal.at();
  } catch (const Standard_Failure& failure) {
    result.fault = std::string("OpenCASCADE fails: ") + failure.DynamicType()->Name() + " " +
                   failure.GetMessageString();
  } catch (const std::exception& error) {
    result.fault = error.what();
  }
  return result;
}

std::vector<NamedSolid> named(const LabelledShape& shape, const Model& model) {
  std::vector<NamedSolid> result;
  const auto solids = checked_solids(shape.shape, model.name);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    result.push_back(
        {solids.size() == 1 ? model.name : model.name + "-" + std::to_string(i + 1), solids[i]});
  }
  return result;
}

Written write_united(const Model& model) {
  LabelledShape shape = united(model.whole);
  if (model.operation != exchange::Operation::none && !model.tools.bodies.empty()) {
    LabelledShape tools = united(model.tools);
    if (!model.kept.bodies.empty()) {
      tools = combined(tools, united(model.kept), exchange::Operation::subtract);
    }
    shape = combined(shape, tools, model.operation);
  }
  return read_back(step_text(model, named(shape, model), shape.labels));
}

Written write_apart(const Model& model) {
  std::vector<NamedSolid> solids;
  FaceLabels labels;
  for (const exchange::Body& body : model.whole.bodies) {
    const LabelledShape shape = solid_of(body);
    for (const TopoDS_Shape& solid : checked_solids(shape.shape, body.name)) {
      solids.push_back({body.name, solid});
    }
    for (FaceLabels::Iterator face(shape.labels); face.More(); face.Next()) {
      labels.Bind(face.Key(), face.Value());
    }
  }
  return read_back(step_text(model, solids, labels));
}

Written write_solids(const Model& model) {
  return guarded([&] { return model.is_united ? write_united(model) : write_apart(model); });
}

Written write_surfaces(const std::string& name, const std::vector<exchange::NamedSurface>& surfaces,
                       bool iges) {
  return guarded([&] {
    Written result;
    result.bytes = surfaces_text(name, surfaces, iges);
    return result;
  });
}

Written read_solids(const std::string& step) {
  return guarded([&] { return read_back(step); });
}

}  // namespace
}  // namespace dupin::occt

const dupin::exchange::Module* dupin_occt_module_3() {
  static const dupin::exchange::Module kModule{
      dupin::occt::write_solids, dupin::occt::write_surfaces, dupin::occt::read_solids};
  return &kModule;
}
