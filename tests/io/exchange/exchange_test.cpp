#include "dupin/io/exchange.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/part_measures.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

Assembly example(const std::string& name) {
  return read_assembly(test::source_folder() / "examples" / (name + ".json"));
}

TEST(Exchange, solids_of_parts_have_the_volumes_of_their_formulas) {
  if (!can_exchange()) {
    GTEST_SKIP() << "built without OpenCASCADE";
  }
  for (const char* name : {"reducer", "reducing-elbow"}) {
    const Assembly assembly = example(name);
    const ExchangeFile file = step_file(assembly, build(assembly), {1e-4, ExchangeSolids::parts});
    const ResolvedAssembly resolved = resolve(assembly);
    ASSERT_EQ(file.report.solids.size(), resolved.parts.size());
    for (std::size_t i = 0; i < resolved.parts.size(); ++i) {
      EXPECT_EQ(file.report.solids[i].name, resolved.parts[i].name);
      const PartMeasures exact = measures(resolved.parts[i].shape);
      const double bound = file.report.error_bound * exact.area + 1e-6 * exact.solid->volume;
      EXPECT_NEAR(file.report.solids[i].volume, exact.solid->volume, bound);
    }
  }
}

// Before anything is built, which takes long, and so does what is tried for advice.
TEST(Exchange, says_at_once_what_runs_and_parts_have_not) {
  if (!can_exchange()) {
    GTEST_SKIP() << "built without OpenCASCADE";
  }
  const auto fault = [](const Assembly& assembly, std::optional<Region> region,
                        ExchangeSolids solids) {
    try {
      require_exchange(assembly, region, solids);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::boolean_failed);
      return error.part() + ": " + error.message();
    }
    return std::string();
  };
  using testing::HasSubstr;
  Assembly assembly = example("reducer");
  for (const ExchangeSolids solids : {ExchangeSolids::runs, ExchangeSolids::parts}) {
    EXPECT_EQ(fault(assembly, {}, solids), "");
    EXPECT_THAT(fault(assembly, Region::fluid, solids), HasSubstr("this is its fluid region"));
    EXPECT_THAT(fault(example("tee"), {}, solids), HasSubstr("throat: solids of runs"));
    EXPECT_THAT(fault(example("hollow-tee"), {}, solids), HasSubstr("this is its metal region"));
    Assembly network = example("tee");
    network.is_of_network = true;
    EXPECT_EQ(fault(network, {}, solids), "");
  }
  EXPECT_EQ(fault(example("hollow-tee"), Region::fluid, ExchangeSolids::united), "");
}

Assembly kneecaps(const std::string& spheres) {
  return parse_assembly(R"({"units": "mm", "tolerance": 0.01, "parts": [{"name": "arm",
      "cyclide_chain": {"joints": "kneecaps", "spheres": [)" +
                        spheres + "]}}]}");
}

// Discs whose circles cross, which do not and lie apart, and which overtake each other. The finer
// the mesh, the nearer are both volumes.
TEST(Exchange, chains_with_kneecaps_are_what_their_mesh_is) {
  if (!can_exchange()) {
    GTEST_SKIP() << "built without OpenCASCADE";
  }
  for (const char* spheres :
       {"[0, 0, 0, 1], [2, 1, 0, 0.8], [4, 1, 0, 1], [6, 0.2, 0, 0.9], [8, 1, 0, 0.7]",
        "[0, 0, 0, 0.85], [3.4, -0.1, 0, 0.79], [6.5, -0.5, 0.1, 0.76], [8.6, -0.7, 0.15, 0.43], "
        "[11.9, -0.7, -0.06, 0.4]",
        "[0, 0, 0, 1.7], [2, 0.4, 0, 0.9], [4, 0, 0, 1], [6, -1, 0, 1.8], [8, -0.7, 0, 0.85]"}) {
    Assembly assembly = kneecaps(spheres);
    std::vector<double> off;
    for (const double tolerance : {1e-2, 2.5e-3}) {
      assembly.tolerance = tolerance;
      const ExchangeReport report = step_file(assembly, build(assembly), {}).report;
      ASSERT_EQ(report.solids.size(), 1U) << spheres;
      EXPECT_EQ(report.solids.front().euler_number, 2) << spheres;
      off.push_back(std::abs(report.volume - report.expected_volume.value()));
    }
    EXPECT_LT(off[1], off[0] / 2) << spheres;
  }
}

// The neck by itself; united with its blend it is one.
TEST(Exchange, refuses_what_is_no_valid_boundary_and_says_what_may_do) {
  if (!can_exchange()) {
    GTEST_SKIP() << "built without OpenCASCADE";
  }
  const Assembly assembly = example("oblique-nozzle");
  const Built built = build(assembly);
  try {
    (void)step_file(assembly, built, {1e-4, ExchangeSolids::parts});
    FAIL() << "written";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::boolean_failed);
    EXPECT_EQ(error.part(), "neck");
    EXPECT_THAT(error.what(), testing::HasSubstr("--solids united"));
  }
  EXPECT_EQ(step_file(assembly, built, {}).report.solids.size(), 1U);
}

// Neither way is named that is refused for the fillet's sake.
TEST(Exchange, names_no_way_that_does_not_write_fillets) {
  if (!can_exchange()) {
    GTEST_SKIP() << "built without OpenCASCADE";
  }
  // Nearly equal pipes: OpenCASCADE does not unite them.
  const Assembly assembly = parse_assembly(R"({"units": "mm", "tolerance": 0.05, "parts": [
      {"name": "run", "pipe": {"from": [0, 0, 0], "to": [300, 0, 0], "radius": 12.687284882}},
      {"name": "branch", "pipe": {"from": [150, 0, 0], "direction": [0.44, 0, 0.898],
                                  "length": 200, "radius": 12.687272195}},
      {"name": "f", "fillet": {"between": ["run", "branch"], "radius": 1.2687284882}}]})",
                                           "d.json");
  const Built built = build(assembly);
  for (const ExchangeSolids solids : {ExchangeSolids::united, ExchangeSolids::runs}) {
    try {
      (void)step_file(assembly, built, {.solids = solids});
      EXPECT_EQ(solids, ExchangeSolids::united) << "runs have no fillets";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::boolean_failed);
      EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("--solids runs writes")));
      EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("united they can be")));
      EXPECT_THAT(error.what(), testing::HasSubstr("very mesh format has the union"));
    }
  }
}

// Spheres of a thousandth of a millimetre are too small for OpenCASCADE's tolerances.
TEST(Exchange, names_what_does_alone) {
  if (!can_exchange()) {
    GTEST_SKIP() << "built without OpenCASCADE";
  }
  const auto document = [](const std::string& unit) {
    return parse_assembly(R"({"units": ")" + unit + R"(", "tolerance": 5e-06, "parts": [
        {"name": "c", "cyclide_chain": {"spheres": [
            [0, 0, 0, 0.0006726239899011477],
            [0.0015145437095126378, -0.0001286519991355074, -2.0873367569463495e-05,
             0.0006465795282623536],
            [0.004195761207259343, -0.0004950458782039984, -0.00014182300625693623,
             0.000815609364633038],
            [0.005635258606837377, -0.0005314176812789162, -0.0005619595733320872,
             0.0009401990489104069],
            [0.007088932568480666, -0.0005668730355348788, -0.0009167519127324174,
             0.0008940850692624137]],
          "joints": "kneecaps", "wall": 0.0001916119066209291}}]})",
                          "d.json");
  };
  const Assembly assembly = document("mm");
  const Built built = build(assembly);
  for (const ExchangeSolids solids :
       {ExchangeSolids::united, ExchangeSolids::runs, ExchangeSolids::parts}) {
    try {
      (void)step_file(assembly, built, {.solids = solids});
      ADD_FAILURE() << name(solids);
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find("--solids runs") != std::string::npos,
                solids == ExchangeSolids::united);
      EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("--solids united")));
      EXPECT_THAT(error.what(), testing::HasSubstr("1000 times as large, \"units\": \"m\","));
    }
  }
  const Assembly larger = document("m");
  EXPECT_EQ(step_file(larger, build(larger), {.solids = ExchangeSolids::runs}).report.solids.size(),
            1U);
}

// Red, green and blue are written as numbers from 0 to 1, in single precision.
TEST(Exchange, parts_have_the_colours_that_are_chosen) {
  if (!can_exchange()) {
    GTEST_SKIP() << "built without OpenCASCADE";
  }
  const Assembly assembly = example("reducer");
  const Built built = build(assembly);
  ASSERT_FALSE(assembly.parts.empty());
  const std::string& part = assembly.parts.front().name;
  const std::string chosen = "COLOUR_RGB('',0.19999";
  const auto bytes = [&](const ExchangeOptions& options) {
    return step_file(assembly, built, options).bytes;
  };
  EXPECT_THAT(bytes({}), testing::Not(testing::HasSubstr(chosen)));
  EXPECT_THAT(bytes({.colours = {{part, "#3366cc"}}}), testing::HasSubstr(chosen));
}

TEST(Exchange, refuses_a_tolerance_that_is_none) {
  const Assembly assembly = example("reducer");
  const Built built = build(assembly);
  for (const double none : {0., -1., HUGE_VAL, std::nan("")}) {
    try {
      (void)step_file(assembly, built, {.tolerance = none});
      ADD_FAILURE() << none;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument) << error.what();
    }
  }
}

// Those of ADVANCED_FACE, each once.
std::set<std::string> face_names(const std::string& step) {
  const std::string key = "ADVANCED_FACE('";
  std::set<std::string> names;
  for (std::size_t at = step.find(key); at != std::string::npos; at = step.find(key, at)) {
    at += key.size();
    names.insert(step.substr(at, step.find('\'', at) - at));
  }
  return names;
}

// Of parts that coincide, that of the first.
TEST(Exchange, faces_have_the_names_of_the_mesh) {
  if (!can_exchange()) {
    GTEST_SKIP() << "built without OpenCASCADE";
  }
  const std::string pipes =
      R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [10, 0, 0], "radius": 2}},
      {"name": "inlet", "cap": {"at": "a.start"}})";
  const std::string balls = R"({"name": "a", "sphere": {"center": [0, 0, 0], "radius": 10}},
      {"name": "b", "sphere": {"center": [0, 0, 0], "radius": 10}})";
  struct Case {
    std::string patches, parts;
    std::set<std::string> names;
  };
  for (const auto& [patches, parts, names] :
       {Case{R"({"a.end": "outlet", "a": "wall"})", pipes, {"inlet", "outlet", "wall"}},
        Case{"{}", pipes, {"a", "a.end", "inlet"}}, Case{"{}", balls, {"a"}},
        Case{R"({"a": "b"})", balls, {"b"}}}) {
    const Assembly assembly = parse_assembly(R"({"units": "mm", "tolerance": 0.1, "patches": )" +
                                             patches + R"(, "parts": [)" + parts + "]}");
    const Built built = build(assembly);
    EXPECT_EQ(face_names(step_file(assembly, built, {}).bytes), names);
    const std::set<std::string> of_mesh(built.solid.names().begin(), built.solid.names().end());
    EXPECT_TRUE(std::ranges::includes(of_mesh, names));
  }
}

TEST(Exchange, has_names) {
  EXPECT_EQ(name(ExchangeSolids::united), "united");
  EXPECT_EQ(name(ExchangeSolids::runs), "runs");
  EXPECT_EQ(name(ExchangeSolids::parts), "parts");
}

}  // namespace
}  // namespace dupin
