#include "occt/labelled_booleans.h"

#include <algorithm>
#include <sstream>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <TopTools_ListOfShape.hxx>

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
                    std::span<const LabelledShape> arguments, std::span<const LabelledShape> tools,
                    const std::string& at, const std::string& what) {
  const auto shapes = [](std::span<const LabelledShape> all) {
    TopTools_ListOfShape list;
    for (const LabelledShape& one : all) {
      list.Append(one.shape);
    }
    return list;
  };
  operation.SetArguments(shapes(arguments));
  operation.SetTools(shapes(tools));
  operation.SetRunParallel(Standard_False);
  operation.SetNonDestructive(Standard_True);
  operation.Build();
  if (!operation.IsDone() || operation.HasErrors()) {
    throw Refusal("OpenCASCADE does not find where " + what + ": " + errors_of(operation), at);
  }
  LabelledShape result;
  result.shape = operation.Shape();
  for (const auto list : {arguments, tools}) {
    for (const LabelledShape& one : list) {
      inherit(operation, one.labels, result.labels);
    }
  }
  return result;
}

}  // namespace

LabelledShape fused(std::span<const LabelledShape> all, const std::string& at,
                    const std::string& what) {
  if (all.size() == 1) {
    return all.front();
  }
  BRepAlgoAPI_Fuse fuse;
  return built(fuse, all.first(1), all.subspan(1), at, what + " meet");
}

LabelledShape combined(const LabelledShape& a, const LabelledShape& b,
                       exchange::Operation operation) {
  constexpr const char* kBoth = "the solid and what is inside it meet";
  if (operation == exchange::Operation::subtract) {
    BRepAlgoAPI_Cut cut;
    return built(cut, {&a, 1}, {&b, 1}, "", kBoth);
  }
  BRepAlgoAPI_Common common;
  return built(common, {&a, 1}, {&b, 1}, "", kBoth);
}

}  // namespace dupin::occt
