#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/kernel/error.h"
#include "support/message_of.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

std::string head_and_parts(const std::string& parts) {
  return R"({"units": "in", "tolerance": 0.1, "segments": 24, "wall": 0.5, "parts": [)" + parts +
         "]}";
}

void expect_same_again(const std::string& text) {
  const std::string written = document_text(parse_assembly(text));
  EXPECT_EQ(document_text(parse_assembly(written)), written);
}

// What a document says is what its parts are resolved to.
TEST(DocumentText, gives_all_examples_back_bit_by_bit) {
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::source_folder() / "examples")) {
    if (entry.path().extension() != ".json" || entry.path().stem() == "tight") {  // which folds
      continue;
    }
    ++count;
    const Assembly read = read_assembly(entry.path()), again = parse_assembly(document_text(read));
    EXPECT_EQ(again.tolerance, read.tolerance);
    EXPECT_EQ(again.unit, read.unit);
    EXPECT_EQ(again.wall, read.wall);
    EXPECT_EQ(again.segments, read.segments);
    const ResolvedAssembly a = resolve(read), b = resolve(again);
    ASSERT_EQ(a.parts.size(), b.parts.size()) << entry.path();
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
      EXPECT_EQ(a.parts[i].name, b.parts[i].name);
      for (const End end : {End::start, End::end}) {
        const Ring *one = port_ring(a.parts[i].shape, end),
                   *other = port_ring(b.parts[i].shape, end);
        ASSERT_EQ(one == nullptr, other == nullptr) << entry.path() << a.parts[i].name;
        if (one != nullptr) {
          EXPECT_EQ(*one, *other) << entry.path() << a.parts[i].name;
        }
      }
    }
    for (std::size_t i = 0; i < read.parts.size(); ++i) {
      EXPECT_EQ(again.parts[i].wall, read.parts[i].wall);
      EXPECT_EQ(again.parts[i].solid, read.parts[i].solid);
    }
    EXPECT_EQ(document_text(again), document_text(read)) << entry.path();
  }
  EXPECT_GT(count, 20);
}

TEST(DocumentText, keeps_the_head_and_a_part_on_each_line) {
  const std::string text = document_text(parse_assembly(head_and_parts(
      R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [0.1, 0, 1e300], "radius": 2}, "wall": 0},
         {"name": "b", "pipe": {"from": "a.end", "length": 3}, "solid": true})")));
  EXPECT_EQ(text, R"({
 "units": "in",
 "tolerance": 0.1,
 "segments": 24,
 "wall": 0.5,
 "parts": [
  {"name":"a","pipe":{"from":[0.0,0.0,0.0],"to":[0.1,0.0,1e+300],"radius":2.0},"wall":0.0},
  {"name":"b","pipe":{"from":"a.end","length":3.0},"solid":true}
 ]
}
)");
}

TEST(DocumentText, what_JSON_cannot_say_is_refused) {
  const Assembly good = parse_assembly(
      head_and_parts(
          R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [0, 0, 1], "radius": 2}},
             {"name": "b", "pipe": {"from": [0, 0, 5], "to": [0, 0, 9], "radius": 2}})"),
      "d.json");
  const auto said = [&](const auto& change) {
    Assembly bad = good;
    change(bad, std::get<PipeBetween>(bad.parts[1].shape));
    return test::message_of([&] { (void)document_text(bad); }, Errc::invalid_argument);
  };
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(said([](Assembly&, PipeBetween& pipe) { pipe.radius = kInfinite; }),
            "d.json#/parts/1/pipe/radius: 'b': numbers must be finite, not inf");
  EXPECT_EQ(said([](Assembly&, PipeBetween& pipe) { pipe.to.y() = std::nan(""); }),
            "d.json#/parts/1/pipe/to/1: 'b': numbers must be finite, not nan");
  EXPECT_EQ(said([](Assembly& bad, PipeBetween&) { bad.tolerance = -kInfinite; }),
            "d.json#/tolerance: numbers must be finite, not -inf");
  EXPECT_EQ(said([](Assembly& bad, PipeBetween&) { bad.parts[1].name = "b\xff"; }),
            "d.json#/parts/1/name: 'b\\xff': 'b\\xff' is no UTF-8, as texts of JSON are");
  EXPECT_EQ(said([](Assembly& bad, PipeBetween&) { bad.patches["\xff"] = "x"; }),
            "d.json#/patches/\\xff: '\\xff' is no UTF-8, as texts of JSON are");
}

// Every key in each of its forms, whether it makes sense or not.
TEST(DocumentText, gives_every_form_of_every_key_back) {
  for (
      const char* part : {
          R"("pipe": {"from": [0,0,0], "to": [1,0,0], "semi_axes": [2,1], "axis": [0,0,1]})",
          R"("pipe": {"from": [0,0,0], "direction": [1,0,0], "length": 3, "radius": 2})",
          R"("pipe": {"from": "x.end", "to": [1,2,3]})",
          R"("cone": {"from": [0,0,0], "to": [1,0,0], "radii": [2,1]})",
          R"("cone": {"from": [0,0,0], "to": [1,0,0], "semi_axes": [[2,1],[3,2]], "axis": [0,0,1]})",
          R"("cone": {"from": [0,0,0], "direction": [1,0,0], "length": 3, "radii": [2,1]})",
          R"("cone": {"from": "x.end", "length": 3, "end_radius": 2})",
          R"("cone": {"from": "x.end", "length": 3, "end_semi_axes": [2,1], "axis": [0,1,0]})",
          R"("oblique": {"from": "x.end", "to": [1,2,3], "end_radius": 2})",
          R"("oblique": {"from": [0,0,0], "to": [1,2,3], "normal": [0,0,1], "radii": [2,1]})",
          R"("elbow": {"from": "x.end", "bend_radius": 3, "angle": 33.3, "toward": [0,1,0]})",
          R"("elbow": {"from": [0,0,0], "direction": [1,0,0], "radius": 1, "bend_radius": 3, "angle": 90, "toward": [0,1,0]})",
          R"("elbow": {"from": [0,0,0], "direction": [1,0,0], "radius": 1, "to": [0,1,0]})",
          R"("elbow": {"from": [0,0,0], "corner": [1,0,0], "radius": 1, "to": [0,1,0]})",
          R"("elbow": {"from": "x.end", "corner": [1,0,0], "to": [0,1,0]})",
          R"("sphere": {"center": [1,2,3], "radius": 4})",
          R"("spline": {"through": [{"point": [1,2,3], "radius": 4}], "closed": true})",
          R"("spline": {"from": "x.end", "to": "y.start", "through": []})",
          R"("cyclic_blend": {"from": "x.end", "to": "y.start", "radius_law": "R2", "k": 3, "l": "auto", "continuity": "G2"})",
          R"("two_cone_blend": {"from": "x.end", "to": "y.start", "reach": [1,2], "m": [1,2,3], "w": [3,2,1]})",
          R"("ringed_blend": {"from": "x.end", "to": {"center": [1,2,3], "direction": [0,0,1], "radius": 2, "plate": "widening"}, "bidegree": [5,2]})",
          R"("ringed_blend": {"from": {"center": [1,2,3], "direction": [0,0,1], "radius": 2, "apex": [0,0,9]}, "to": {"center": [1,2,3], "direction": [0,0,1], "radius": 2, "slope": 0.5}, "k": 1, "l": 2})",
          R"("ringed_blend": {"from": {"center": [1,2,3], "direction": [0,0,1], "radius": 2, "sphere": [0,0,9]}, "to": {"center": [1,2,3], "direction": [0,0,1], "radius": 2, "ruling": [0,0,1]}})",
          R"("cyclide_blend": {"from": "x.end", "to": "y.start"})",
          R"("cyclide_chain": {"direction": [0,0,1], "slope": 0.1, "spheres": [[0,0,0,1],[0,0,1,1],[0,0,2,1]], "tangents": [{"sphere": 2, "tangent": [0,0,1,0]}], "wall": 0.1, "joints": "kneecaps"})",
          R"("cyclide_chain": {"from": "x.end", "spheres": [[0,0,0,1]]})",
          R"("fillet": {"between": ["a", "b"], "radius": 2})",
          R"("cope": {"end": "x.end", "to": "b"})",
          R"("junction": {"ends": ["x.end", "y.end"], "center": [1,2,3], "radius": 4, "cap_angles": [30, 33.3], "smoothness": 0.5})",
          R"("cap": {"at": "x.end"})",
      }) {
    const std::string text = head_and_parts(R"({"name": "p", )" + std::string(part) + "}");
    expect_same_again(text);
    const std::string key = std::string(part).substr(0, std::string(part).find(':'));
    EXPECT_THAT(document_text(parse_assembly(text)), testing::HasSubstr(key + ":")) << part;
  }
}

TEST(DocumentText, gives_angles_back_bit_by_bit) {
  for (int i = 1; i < 360; ++i) {
    const std::string text = head_and_parts(
        R"({"name": "p", "elbow": {"from": "x.end", "bend_radius": 3, "toward": [0,1,0], "angle": )" +
        std::to_string(i * .9973) + "}}");
    const auto angle = [](const Assembly& assembly) {
      return std::get<ElbowTurning>(assembly.parts[0].shape).angle;
    };
    const Assembly read = parse_assembly(text);
    EXPECT_EQ(angle(parse_assembly(document_text(read))), angle(read));
  }
}

}  // namespace
}  // namespace dupin
