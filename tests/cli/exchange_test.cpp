#include "dupin/io/exchange.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

class Exchange : public Tool {
 protected:
  void SetUp() override {
    if (!can_exchange()) {
      GTEST_SKIP() << "built without OpenCASCADE";
    }
  }
};

TEST_F(Exchange, writes_a_solid_that_agrees_with_the_exact_one) {
  const auto report = json({"build", example("reducer.json"), "-o", "a.step"}, 0);
  const auto& output = report.at("output");
  EXPECT_EQ(output.at("file"), "a.step");
  ASSERT_EQ(output.at("solids").size(), 1U);
  EXPECT_EQ(output.at("solids")[0].at("euler_number"), 2);
  EXPECT_EQ(output.at("exact_surfaces"), 4);
  EXPECT_EQ(output.at("lofted_surfaces"), 1);
  EXPECT_LE(output.at("error_bound"), 0.05 / 10);
  EXPECT_LE(std::abs(double(output.at("volume")) - double(output.at("expected_volume"))),
            double(output.at("volume_bound")));
  // The parts' volumes by formula: docs/cli.md.
  EXPECT_NEAR(output.at("volume"), 255.84231, 0.05);
  const std::string step = folder_.read("a.step");
  EXPECT_THAT(step, HasSubstr("CYLINDRICAL_SURFACE"));
  EXPECT_THAT(step, HasSubstr("ADVANCED_FACE('inlet.start'"));
  EXPECT_EQ(dupin({"build", example("reducer.json"), "-o", "-", "--format", "step"}).out, step);
}

// One of each kind: what crosses, what is joined by a hub, what is rounded off, cut and hollow.
TEST_F(Exchange, of_every_kind_of_part_is_valid) {
  for (const auto& [name, solids] :
       std::vector<std::pair<std::string, std::size_t>>{{"cope", 1},
                                                        {"junction", 1},
                                                        {"tee", 1},
                                                        {"equal-tee", 1},
                                                        {"parallel-cone", 1},
                                                        {"hollow-tee", 1},
                                                        {"jet-engine", 1},
                                                        {"crane-hook", 1},
                                                        {"oval-duct", 1},
                                                        {"cyclide-blends", 4}}) {
    const auto report = json({"build", example(name + ".json"), "-o", name + ".step"}, 0);
    EXPECT_EQ(report.at("output").at("solids").size(), solids) << name;
  }
}

// Of which every region is written.
TEST_F(Exchange, of_insulation_is_what_lies_around_the_pipes) {
  folder_.write("corner.json", R"({"units": "mm", "tolerance": 0.05, "insulation": 4, "parts": [
    {"name": "a", "pipe": {"from": [0, 0, 0], "to": [40, 0, 0], "radius": 5}},
    {"name": "b", "elbow": {"from": "a.end", "bend_radius": 20, "angle": 90, "toward": [0, 1, 0]}},
    {"name": "c", "pipe": {"from": [20, 0, 0], "to": [20, 0, 40], "radius": 3}}]})");
  const auto report = json({"build", "corner.json", "-o", "i.step", "--region", "insulation"}, 0);
  const auto& output = report.at("output");
  ASSERT_EQ(output.at("solids").size(), 1U);
  EXPECT_LE(std::abs(double(output.at("volume")) - double(output.at("expected_volume"))),
            double(output.at("volume_bound")));
  EXPECT_THAT(folder_.read("i.step"), HasSubstr("'b.insulation'"));
  for (const std::string name : {"tee", "header", "cope"}) {
    (void)json({"build", example(name + ".json"), "--insulation", "0.2", "--region", "insulation",
                "-o", name + ".step"},
               0);
  }
}

TEST_F(Exchange, the_same_names_are_in_the_same_order_each_time) {
  (void)json({"nurbs", example("junction.json"), "-o", "a.iges"}, 0);
  const std::string first = folder_.read("a.iges");
  EXPECT_THAT(first, HasSubstr("406,1,5Hriser;"));
  for (int i = 0; i < 3; ++i) {  // the library would write them by address
    (void)json({"nurbs", example("junction.json"), "-o", "a.iges"}, 0);
    EXPECT_EQ(folder_.read("a.iges"), first);
  }
}

TEST_F(Exchange, by_parts_has_their_names) {
  const auto report =
      json({"build", example("reducer.json"), "-o", "a.stp", "--solids", "parts"}, 0);
  const auto& solids = report.at("output").at("solids");
  ASSERT_EQ(solids.size(), 3U);
  EXPECT_EQ(solids[0].at("name"), "inlet");
  EXPECT_NEAR(solids[0].at("volume"), 10 * std::acos(-1.0), 1e-4);
  EXPECT_TRUE(report.at("output").at("expected_volume").is_null());
}

TEST_F(Exchange, refuses_what_it_cannot_write_and_leaves_no_file) {
  for (const auto& [arguments, code, text] :
       std::vector<std::tuple<std::vector<std::string>, int, std::string>>{
           {{"tee.json", "-o", "a.step", "--solids", "parts"}, 4, "fillets"},
           // Before triangles are counted.
           {{"tee.json", "-o", "a.step", "--solids", "runs", "--tolerance", "1e-9"}, 4, "fillets"},
           {{"hollow-tee.json", "-o", "a.step", "--solids", "parts", "--tolerance", "1e-9"},
            4,
            "--region outer"},
           {{"tee.json", "-o", "a.step", "--patches", "p.json"}, 2, "--patches"},
           {{"tee.json", "-o", "a.stl", "--solids", "runs"}, 2, "--solids"}}) {
    std::vector<std::string> all{"build", example(arguments.front())};
    all.insert(all.end(), arguments.begin() + 1, arguments.end());
    const ProcessResult refused = dupin(all);
    EXPECT_EQ(refused.exit_code, code) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(text));
    EXPECT_TRUE(folder_.files().empty());
  }
  EXPECT_EQ(dupin({"build", example("reducer.json"), "-o", "no/such/a.step"}).exit_code, 5);
}

TEST_F(Exchange, writes_single_surfaces) {
  for (const auto& [file, word] : std::vector<std::pair<std::string, std::string>>{
           {"a.step", "B_SPLINE_SURFACE"}, {"a.iges", "128,"}}) {
    (void)json({"nurbs", example("reducer.json"), "-o", file}, 0);
    EXPECT_THAT(folder_.read(file), HasSubstr(word));
  }
}

}  // namespace
}  // namespace dupin::test
