#include "dupin/io/named_nurbs.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

using testing::ElementsAre;

std::vector<NamedNurbs> of_example(const std::string& name, double tolerance) {
  return named_nurbs(read_assembly(test::source_folder() / "examples" / name), tolerance);
}

std::vector<std::string> kinds(const std::vector<NamedNurbs>& parts) {
  std::vector<std::string> result;
  std::ranges::transform(parts, std::back_inserter(result), &NamedNurbs::kind);
  return result;
}

TEST(NamedNurbs, are_of_parts_and_then_of_fillets) {
  const auto parts = of_example("tee.json", 0.01);
  EXPECT_THAT(kinds(parts), ElementsAre("pipe", "pipe", "fillet"));
  for (const NamedNurbs& part : parts) {
    EXPECT_LE(part.form.error_bound, 0.01) << part.part;
    EXPECT_FALSE(part.form.surfaces.empty()) << part.part;
  }
}

TEST(NamedNurbs, of_a_cope_there_are_none) {
  EXPECT_THAT(kinds(of_example("cope.json", 0.01)), ElementsAre("pipe", "pipe", "pipe"));
}

TEST(NamedNurbs, of_a_hub_are_trimmed_by_a_circle_for_each_arm) {
  const auto parts = of_example("junction.json", 0.01);
  const auto& hub = parts.back();
  EXPECT_EQ(hub.kind, "junction");
  EXPECT_EQ(hub.form.trims.size(), 5);
  EXPECT_TRUE(std::ranges::all_of(parts, [](const NamedNurbs& part) {
    return part.kind == "junction" || part.form.trims.empty();
  }));
}

TEST(NamedNurbs, that_are_refused_are_so_with_the_parts_name) {
  try {
    (void)of_example("reducer.json", 1e-30);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "blend");
  }
}

TEST(NamedNurbs, are_refused_for_a_tolerance_that_is_none) {
  for (const char* const name : {"reducer.json", "tee.json", "oblique-nozzle.json"}) {
    for (const double none : {0., -1., HUGE_VAL, std::nan("")}) {
      try {
        (void)of_example(name, none);
        ADD_FAILURE() << name << " " << none;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::invalid_argument) << error.what();
        EXPECT_EQ(error.part(), "");
      }
    }
  }
}

}  // namespace
}  // namespace dupin
