#pragma once

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "assembly/part_context.h"

namespace dupin::test {

/// A part "p" of a document "d.json", at its place /parts/0, among neighbours of given shapes.
class LonePart {
 public:
  explicit LonePart(PartShape shape, std::map<std::string, PartSurface> neighbours = {},
                    double tolerance = 0.05)
      : document_{"d.json", Unit::millimetre, tolerance, {}, {{"p", std::move(shape)}}},
        neighbours_(std::move(neighbours)) {}

  [[nodiscard]] assembly::PartContext context() const {
    return {
        document_, 0,
        [this](const PortReference& port) -> const Ring& {
          return *port_ring(neighbours_.at(port.part), port.end);
        },
        [this](const PortReference& port) { return leaving(neighbours_.at(port.part), port.end); },
        [this](const std::string& name) -> const PartSurface& { return neighbours_.at(name); }};
  }

 private:
  Assembly document_;
  std::map<std::string, PartSurface> neighbours_;
};

/// "pipe/radius: the message" of the fault that `work` finds in the part, or nothing.
template <class Work>
std::string fault_of(const Work& work, Errc code = Errc::invalid_argument) {
  try {
    (void)work();
  } catch (const Error& error) {
    EXPECT_EQ(name(error.code()), name(code)) << error.what();
    EXPECT_EQ(error.part(), "p") << error.what();
    const std::string begin = "d.json#/parts/0/";
    EXPECT_EQ(error.where().substr(0, begin.size()), begin) << error.what();
    return error.where().substr(begin.size()) + ": " + error.message();
  }
  return "";
}

}  // namespace dupin::test
