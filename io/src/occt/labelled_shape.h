#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <NCollection_DataMap.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>

namespace dupin::occt {

/// Faces by what they belong to.
using FaceLabels = NCollection_DataMap<TopoDS_Shape, std::uint32_t, TopTools_ShapeMapHasher>;

/// A shape whose faces are labelled.
struct LabelledShape {
  TopoDS_Shape shape;
  FaceLabels labels;
};

/// The labels of what an algorithm made of faces. What has one already keeps it.
template <class Algorithm>
void inherit(Algorithm& made, const FaceLabels& before, FaceLabels& after) {
  for (FaceLabels::Iterator face(before); face.More(); face.Next()) {
    const TopTools_ListOfShape& now = made.Modified(face.Key());
    const auto bind = [&](const TopoDS_Shape& shape) {
      if (!after.IsBound(shape)) {
        after.Bind(shape, face.Value());
      }
    };
    if (now.IsEmpty() && !made.IsDeleted(face.Key())) {
      bind(face.Key());
    }
    for (const TopoDS_Shape& shape : now) {
      bind(shape);
    }
  }
}

/// What cannot be written, and what is at fault.
class Refusal : public std::runtime_error {
 public:
  Refusal(const std::string& why, std::string at) : std::runtime_error(why), at_(std::move(at)) {}
  [[nodiscard]] const std::string& at() const { return at_; }

 private:
  std::string at_;
};

}  // namespace dupin::occt
