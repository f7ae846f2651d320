#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/parts/part_kind.h"

namespace dupin::assembly {
namespace {

const PortReference kFrom{"a", End::end}, kTo{"b", End::start};

// "from a.end" and "to b.start", with the own end where that is the end.
std::string text_of(const References& references) {
  std::string result;
  for (const auto& [port, key, own_end] : references) {
    result += (result.empty() ? "" : ", ") + std::string(key) + " " + to_string(port) +
              (own_end == End::end ? " at end" : "");
  }
  return result;
}

struct Row {
  PartShape shape;
  std::string references, portless;
};

std::vector<Row> rows() {
  const Vec3 o = Vec3::Zero();
  const std::string both = "from a.end, to b.start at end";
  CyclideChainThrough hollow;
  hollow.wall = 1;
  CyclideChainThrough going_on;
  going_on.from = kFrom;
  RingedBlendBetween leading;
  leading.from = FreeEnd{o, o, 1, {}};
  leading.to = kTo;
  return {{PipeBetween{o, o}, "", ""},
          {PipeAlong{kFrom, 1}, "from a.end", ""},
          {PipeAlong{Place(), 1}, "", ""},
          {PipeTo{kFrom, o}, "from a.end", ""},
          {ConeBetween{o, o}, "", ""},
          {ConeAlong{kFrom, 1, 1, {}, {}}, "from a.end", ""},
          {ObliqueBetween{o, o, o}, "", ""},
          {ElbowTurning{kFrom}, "from a.end", ""},
          {ElbowTo{kFrom, o}, "from a.end", ""},
          {ElbowCorner{kFrom, o, o}, "from a.end", ""},
          {SphereAt(), "", "a sphere"},
          {SplineBetween{kFrom, kTo, {}}, both, ""},
          {SplineRound(), "", "a closed spline"},
          {CyclicBlendBetween{kFrom, kTo, {}}, both, ""},
          {TwoConeBlendBetween{kFrom, kTo}, both, ""},
          {RingedBlendBetween{kFrom, kTo}, both, ""},
          {leading, "to b.start at end", ""},
          {CyclideBlendBetween{kFrom, kTo}, both, ""},
          {going_on, "from a.end", ""},
          {hollow, "", "hollow"},
          {CapAt{kFrom}, "at a.end", "a cap"}};
}

TEST(PartKind, knows_what_a_shape_refers_to_and_whether_it_has_ports) {
  for (const auto& [shape, references, portless] : rows()) {
    const PartKind& its_kind = part_kind(shape);
    EXPECT_EQ(its_kind.key, kind(shape));
    EXPECT_EQ(text_of(its_kind.references(shape)), references) << its_kind.key;
    EXPECT_EQ(its_kind.portless(shape), portless) << its_kind.key;
  }
}

TEST(PartKind, knows_blends_and_caps) {
  for (const auto& row : rows()) {
    const PartKind& its_kind = part_kind(row.shape);
    EXPECT_EQ(its_kind.is_tangent, its_kind.key.ends_with("_blend") || its_kind.key == "spline")
        << its_kind.key;
    EXPECT_EQ(its_kind.names_end, its_kind.key == "cap") << its_kind.key;
  }
}

}  // namespace
}  // namespace dupin::assembly
