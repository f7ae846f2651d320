#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/cost_limit.h"
#include "assembly/part_box.h"
#include "dupin/blends/build.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"

namespace dupin::assembly {
namespace {

const std::string kPipe =
    R"({"name": "p", "pipe": {"from": [0,0,0], "to": [10,0,0], "radius": 1}})";
const std::string kFarPipe =
    R"(, {"name": "q", "pipe": {"from": [1e5,3e4,0], "to": [1.2e5,3e4,100], "radius": 1e4}})";

std::string elbow(const std::string& bend_radius) {
  return kPipe + R"(, {"name": "e", "elbow": {"from": "p.end", "bend_radius": )" + bend_radius +
         R"(, "toward": [0,1,0], "angle": 90}})";
}

std::string blend(const std::string& kind, const std::string& more = "") {
  return kPipe + kFarPipe + R"(, {"name": "b", ")" + kind +
         R"(": {"from": "p.end", "to": "q.start")" + more + "}}";
}

std::string sphere(const std::string& radius) {
  return R"({"name": "s", "sphere": {"center": [0,0,0], "radius": )" + radius + "}}";
}

std::string cone(const std::string& to, const std::string& radii) {
  return R"({"name": "c", "cone": {"from": [0,0,0], "to": )" + to + R"(, "radii": )" + radii + "}}";
}

std::string spheres(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += std::string(i == 0 ? "" : ", ") + R"({"name": "s)" + std::to_string(i) +
            R"(", "sphere": {"center": [)" + std::to_string(3 * i) + R"(,0,0], "radius": 1}})";
  }
  return text;
}

struct Row {
  const char* tolerance;
  std::string parts;
  bool is_refused;
};

const std::vector<Row>& rows() {
  static const std::vector<Row> kRows{
      {"1e-3", elbow("3"), false},
      {"1e-5", elbow("3"), false},
      {"1e-6", elbow("3"), true},
      {"1e-7", elbow("3"), true},
      {"1e-9", elbow("3"), true},
      {"0.05", elbow("1e4"), false},
      {"0.05", elbow("1e6"), false},
      {"0.001", elbow("1e6"), true},
      {"0.05", elbow("1e9"), false},
      {"0.001", elbow("1e9"), true},
      {"0.05", blend("ringed_blend"), false},
      {"0.001", blend("ringed_blend"), true},
      {"0.05", blend("cyclide_blend"), false},
      {"0.01", blend("cyclide_blend"), true},
      {"0.05", blend("cyclic_blend", R"(, "radius_law": "R2", "k": 1e5, "l": 1e5)"), false},
      {"0.0001", blend("cyclic_blend", R"(, "radius_law": "R2", "k": 1e5, "l": 1e5)"), true},
      {"1e-4", kPipe, false},
      {"1e-7", kPipe, false},
      {"1e-9", kPipe, true},
      {"1e-5", sphere("1"), false},
      {"1e-6", sphere("1"), true},
      {"1e-8", sphere("1"), true},
      {"0.01", sphere("1e4"), true},
      {"1", sphere("1e6"), true},
      {"1", cone("[1e6,0,0]", "[1,1e6]"), false},
      {"0.001", cone("[1e6,0,0]", "[1,1e6]"), true},
      {"0.001", cone("[1e6,1e6,1e6]", "[1e5,1e6]"), true},
      {"5e-6", spheres(1), false},
      {"5e-6", spheres(20), true},
  };
  return kRows;
}

Assembly document(const Row& row, const std::string& keys = "") {
  return parse_assembly(R"({"units": "mm", )" + keys + R"("tolerance": )" + row.tolerance +
                            R"(, "parts": [)" + row.parts + "]}",
                        "d.json");
}

// Why a document is refused, or "".
std::string refusal(const Assembly& assembly, std::size_t most = kUsualTriangles) {
  const ResolvedAssembly resolved = resolve(assembly);
  try {
    refuse_too_costly(assembly, resolved, welded_runs(resolved),
                      lattice_spacing(assembly, resolved), most);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    EXPECT_THAT(error.what(), testing::HasSubstr("d.json#/parts/"));
    return error.message();
  }
  return "";
}

// What all meshes together have.
std::size_t triangles_of(const Assembly& assembly) {
  const ResolvedAssembly resolved = resolve(assembly);
  const double grid = lattice_spacing(assembly, resolved);
  std::size_t count = 0;
  for (const WeldedRun& run : welded_runs(resolved)) {
    const RingSampling sampling = run_sampling(assembly, resolved, run, 0, grid);
    EXPECT_LE(sampling.segments, 9000U);
    for (const auto part : run.parts) {
      count += tessellated(assembly, resolved.parts[part], sampling).mesh.triangles.size();
    }
  }
  return count;
}

TEST(CostLimit, makes_or_refuses_extreme_documents_by_what_they_would_cost) {
  for (const Row& row : rows()) {
    const Assembly assembly = document(row);
    EXPECT_EQ(refusal(assembly) != "", row.is_refused) << row.tolerance << ": " << row.parts;
    if (!row.is_refused) {
      EXPECT_LE(triangles_of(assembly), 1.1 * kUsualTriangles) << row.parts;
    }
  }
}

std::string wide_blend(const std::string& kind, double ratio, const std::string& more = "") {
  const auto times = [&](double factor) { return decimal(factor * ratio, 17); };
  return kPipe + R"(, {"name": "q", "pipe": {"from": [)" + times(10) + "," + times(3) +
         R"(,0], "to": [)" + times(12) + "," + times(3) + "," + times(0.01) + R"(], "radius": )" +
         times(1) + R"(}}, {"name": "b", ")" + kind + R"(": {"from": "p.end", "to": "q.start")" +
         more + "}}";
}

// The small end has as many corners as the large one needs.
TEST(CostLimit, blends_of_extreme_ratios_are_solids_wherever_the_cost_allows_them) {
  const struct {
    double ratio;
    const char* tolerance;
  } table[]{{1e2, "0.05"}, {1e3, "0.05"}, {1e4, "0.05"}, {1e6, "100"}};
  for (const auto& [ratio, tolerance] : table) {
    const std::string reach = decimal(10 * ratio, 17);
    for (const std::string& parts :
         {wide_blend("ringed_blend", ratio), wide_blend("cyclide_blend", ratio),
          wide_blend("cyclic_blend", ratio,
                     R"(, "radius_law": "R2", "k": )" + reach + R"(, "l": )" + reach)}) {
      EXPECT_GT(build(document({tolerance, parts, false})).solid.volume(), 0) << parts;
    }
  }
}

TEST(CostLimit, names_a_tolerance_that_would_do_and_is_not_much_larger_than_needed) {
  const std::string before = "a tolerance of ";
  for (const Row& row : rows()) {
    Assembly assembly = document(row);
    if (const std::string message = refusal(assembly); !message.empty()) {
      assembly.tolerance = std::stod(message.substr(message.rfind(before) + before.size()));
      EXPECT_EQ(refusal(assembly), "") << message;
      assembly.tolerance /= 1.3;
      EXPECT_NE(refusal(assembly), "") << message;
    }
  }
}

TEST(CostLimit, says_what_is_asked_for) {
  const struct {
    Row row;
    std::string keys, message;
  } table[]{
      {{"1e-6", elbow("3"), true},
       "",
       "a tolerance of 1e-06 asks for about 15.2 million triangles; the limit is 4 million; a "
       "tolerance of 4e-06 would do, or a higher limit"},
      {{"5e-6", spheres(20), true},
       "",
       "a tolerance of 5e-06 asks for about 39.5 million triangles, 1.98 million of them for this "
       "part alone; the limit is 4 million; a tolerance of 5.3e-05 would do, or a higher limit"},
      {{"1e-9", kPipe, true},
       "",
       "a tolerance of 1e-09 asks for 70265 segments around this part, whose triangles lie side by "
       "side: about 2.47e+09 pairs to compare; the limit is 40 million; a tolerance of 6.6e-08 "
       "would do, or a higher limit"},
      {{"0.05", elbow("1e4"), true},
       R"("segments": 60000, )",
       "60000 segments and a tolerance of 0.05 ask for 60000 segments around this part, whose "
       "triangles lie side by side: about 1.81e+09 pairs to compare; the limit is 40 million; "
       "fewer segments may do, smaller parts, or a higher limit"},
  };
  for (const auto& [row, keys, message] : table) {
    EXPECT_EQ(refusal(document(row, keys)), message);
  }
}

std::string tee(const std::string& from) {
  return R"({"name": "run", "pipe": {"from": [)" + from +
         R"(,0,0], "to": [150,0,0], "radius": 44}},
             {"name": "branch", "pipe": {"from": [0,0,0], "to": [0,0,130], "radius": 30}},
             {"name": "f", "fillet": {"between": ["run", "branch"], "radius": 8}})";
}

// The far part of a straight pipe is no finer for a fillet at its end.
TEST(CostLimit, fillets_of_long_pipes_cost_no_more_than_those_of_short_ones) {
  const auto triangles = [](const std::string& from) {
    return build(document({"0.05", tee(from), false})).solid.triangles().size();
  };
  const std::size_t few = triangles("-150");
  for (const char* from : {"-1e4", "-1e7", "-1e9"}) {
    EXPECT_LT(triangles(from), few + 2000) << from;
  }
}

TEST(CostLimit, counts_fillets_and_the_faces_beside_them) {
  for (const char* tolerance : {"0.5", "0.05", "0.005"}) {
    for (const char* from : {"-150", "-1e4", "-1e7"}) {
      const Assembly assembly = document({tolerance, tee(from), false});
      const ResolvedAssembly resolved = resolve(assembly);
      const double expected = expected_triangles(assembly, resolved, welded_runs(resolved),
                                                 lattice_spacing(assembly, resolved));
      const auto made = double(build(assembly).solid.triangles().size());
      EXPECT_GT(expected, made / 2) << tolerance << ' ' << from;
      EXPECT_LT(expected, made * 2) << tolerance << ' ' << from;
    }
  }
  const Assembly fine = document({"1e-5", tee("-150"), true});
  EXPECT_THAT(refusal(fine), testing::HasSubstr("triangles"));
  EXPECT_EQ(refusal(document({"0.001", tee("-150"), false})), "");
}

TEST(CostLimit, counts_crossings_but_not_where_parts_are_joined) {
  const auto crossings = [](const std::string& parts) {
    const Assembly assembly = document({"0.05", parts, false});
    const ResolvedAssembly resolved = resolve(assembly);
    Boxes boxes;
    for (const ResolvedPart& part : resolved.parts) {
      boxes.push_back(part_box(part.shape, {}));
    }
    return expected_crossings(assembly, resolved, boxes, welded_runs(resolved),
                              lattice_spacing(assembly, resolved));
  };
  const auto pipe = [](const std::string& name, const std::string& from, const std::string& to) {
    return R"({"name": ")" + name + R"(", "pipe": {"from": )" + from + R"(, "to": )" + to +
           R"(, "radius": 30}})";
  };
  const std::string a = pipe("a", "[-200,0,0]", "[200,0,0]"),
                    b = pipe("b", "[0,-200,0]", "[0,200,0]");
  EXPECT_EQ(crossings(a), 0);
  EXPECT_EQ(crossings(a + "," + pipe("b", "[0,-200,61]", "[0,200,61]")), 0) << "they do not touch";
  EXPECT_EQ(crossings(a + "," + R"({"name": "b", "pipe": {"from": "a.end", "length": 100}})"), 0);
  EXPECT_EQ(crossings(tee("-150")), 0) << "there is a fillet";
  const double one = crossings(a + "," + b);
  EXPECT_EQ(crossings(a + "," + b + "," + pipe("c", "[100,-200,0]", "[100,200,0]")), 2 * one);
  const Assembly cross = document({"0.05", a + "," + b, false});
  const auto made = double(build(cross).solid.triangles().size());
  EXPECT_GT(one, made / 2);
  EXPECT_LT(one, made * 2);
}

TEST(CostLimit, names_the_part_that_asks_for_most) {
  const Assembly assembly = document({"1e-6", elbow("3"), true});
  try {
    (void)build(assembly);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "e");
    EXPECT_EQ(error.where(), "d.json#/parts/1");
  }
  EXPECT_THROW((void)certify(assembly), Error);
}

TEST(CostLimit, can_be_raised) {
  const Row row{"5e-6", elbow("3"), false};
  EXPECT_NE(refusal(document(row), 1'000'000), "");
  EXPECT_EQ(refusal(document(row), 10'000'000), "");
}

// The limit that it is told and refused for differ.
TEST(CostLimit, is_told_as_less_than_what_is_asked_for) {
  const std::string about = "about ", limit = "the limit is ";
  for (const char* tolerance : {"0.05", "0.04", "0.03", "0.02", "0.01"}) {
    const Assembly assembly = document({tolerance, elbow("3"), false});
    const auto asked = [&](std::size_t most) {
      const std::string message = refusal(assembly, most);
      const std::size_t at = message.find(about);
      return at == std::string::npos ? 0 : std::stoul(message.substr(at + about.size()));
    };
    const std::size_t most = asked(10);
    ASSERT_GT(most, 10U);
    EXPECT_EQ(asked(most), 0U) << tolerance;
    EXPECT_EQ(asked(most - 1), most) << tolerance;
  }
}

}  // namespace
}  // namespace dupin::assembly
