#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>

#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/blends/piping_line.h"

namespace dupin::test {

/// Components with a name and lines of their own.
class Line {
 public:
  Line& add(PipingShape shape, std::initializer_list<Vec3> ports, double radius = 50) {
    PipingComponent component;
    component.line = 10 * (line_.components.size() + 1);
    component.name = "c" + std::to_string(line_.components.size());
    component.shape = shape;
    for (const Vec3& port : ports) {
      component.ports.push_back({port, radius, component.line + component.ports.size() + 1});
    }
    line_.components.push_back(component);
    return *this;
  }
  Line& pipe(const Vec3& from, const Vec3& to, double radius = 50) {
    return add(PipingShape::straight, {from, to}, radius);
  }
  Line& bend(const Vec3& from, const Vec3& corner, const Vec3& to, double radius = 50) {
    add(PipingShape::bend, {from, to}, radius);
    last().center = corner;
    return *this;
  }
  Line& tee(const Vec3& from, const Vec3& center, const Vec3& to, const Vec3& branch,
            double radius = 50, double branch_radius = 30) {
    add(PipingShape::fitting, {from, to, branch}, radius);
    last().center = center;
    last().ports[2].radius = branch_radius;
    return *this;
  }
  PipingComponent& last() { return line_.components.back(); }
  [[nodiscard]] PipingNetwork made(const PipingOptions& options = {}) const {
    return assembly_of(line_, options);
  }
  [[nodiscard]] const PipingLine& line() const { return line_; }

 private:
  PipingLine line_{"a.pcf", {}};
};

/// Of all parts of the region, which fit without gaps; as many components as said.
inline Solid solid(const PipingNetwork& network, std::size_t components = 1) {
  Built built = build(network.assembly, {.tolerance = .5});
  EXPECT_EQ(built.solid.components(), components);
  EXPECT_EQ(built.solid.euler_number(), std::ptrdiff_t(2 * components));
  for (const GapPair& gap : built.gaps) {
    EXPECT_TRUE(gap.report.verdict == GapVerdict::welded || gap.report.verdict == GapVerdict::open)
        << built.ports[gap.first].name;
  }
  return built.solid;
}

inline const Part& part(const PipingNetwork& network, const std::string& name) {
  for (const Part& part : network.assembly.parts) {
    if (part.name == name) {
      return part;
    }
  }
  ADD_FAILURE() << "no part " << name;
  return network.assembly.parts.front();
}

inline std::string notes(const PipingNetwork& network) {
  std::string text;
  for (const SourceNote& note : network.notes) {
    text += std::to_string(note.line) + ": " + note.text + "\n";
  }
  return text;
}

}  // namespace dupin::test
