#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <NCollection_DataMap.hxx>
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

/// What cannot be written, and what is at fault.
class Refusal : public std::runtime_error {
 public:
  Refusal(const std::string& why, std::string at) : std::runtime_error(why), at_(std::move(at)) {}
  [[nodiscard]] const std::string& at() const { return at_; }

 private:
  std::string at_;
};

}  // namespace dupin::occt
