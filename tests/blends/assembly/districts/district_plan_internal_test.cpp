#include <gtest/gtest.h>

#include "assembly/districts/district_plan.h"
#include "dupin/io/assembly_json.h"
#include "support/named_parts.h"
#include "support/source_folder.h"

namespace dupin::assembly {
namespace {

using test::pipe;

// Two pipes that go on as one, one apart by 2, and one through that.
Assembly four_pipes() {
  return {"plant.json",
          Unit::millimetre,
          0.01,
          {},
          {pipe("a", {0, 0, 0}, {10, 0, 0}, 1),
           pipe("c", {0, 4, 0}, {10, 4, 0}, 1),
           {"b", PipeAlong{PortReference{"a", End::end}, 5}},
           pipe("d", {5, 4, -5}, {5, 4, 5}, .5)}};
}

TEST(DistrictPlan, parts_that_touch_are_in_one) {
  const auto districts = districts_of_parts(resolve(four_pipes()), .5);
  ASSERT_EQ(districts.size(), 2);
  EXPECT_EQ(districts[0].parts, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(districts[1].parts, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(districts[1].boxes.size(), 2);
}

TEST(DistrictPlan, margins_make_them_touch) {
  const ResolvedAssembly resolved = resolve(four_pipes());
  EXPECT_EQ(districts_of_parts(resolved, .99).size(), 2);
  EXPECT_EQ(districts_of_parts(resolved, 1.01).size(), 1);
  EXPECT_EQ(districts_of_parts(resolved, 0, 1.01 / 15).size(), 1);
  EXPECT_EQ(districts_of_parts(resolved, 0, .9 / 15).size(), 2);
  EXPECT_TRUE(districts_of_parts({}, 1).empty());
}

// Of some collars no bound is found, and a size times no margin is none.
TEST(DistrictPlan, what_may_be_anywhere_touches_all) {
  ResolvedAssembly resolved = resolve(four_pipes());
  resolved.parts[1].shape = Chain{};
  for (const double relative : {0., 1e-9}) {
    for (const double margin : {0., .5}) {
      const auto districts = districts_of_parts(resolved, margin, relative);
      ASSERT_EQ(districts.size(), 1);
      EXPECT_EQ(districts[0].parts.size(), 4);
    }
  }
}

TEST(DistrictPlan, a_district_is_a_document_of_its_own) {
  const Assembly assembly = four_pipes();
  const ResolvedAssembly resolved = resolve(assembly);
  const auto districts = districts_of_parts(resolved, .5);
  const District second = district(assembly, resolved, districts.at(1));
  ASSERT_EQ(second.assembly.parts.size(), 2);
  EXPECT_EQ(second.assembly.parts[1].name, "d");
  EXPECT_EQ(second.resolved.parts[1].index, 1);
  EXPECT_EQ(second.parts, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(document_place(second.assembly, 1), "plant.json#/parts/3");
  const District first = district(assembly, resolved, districts.at(0));
  EXPECT_EQ(first.resolved.parts[0].joined[1], (EndIndex{1, End::start}));
  EXPECT_EQ(first.resolved.parts[1].joined[0], (EndIndex{0, End::end}));
}

TEST(DistrictPlan, fillets_and_junctions_stay_with_their_parts) {
  for (const char* name : {"tee.json", "junction.json", "skew-cross.json"}) {
    const Assembly assembly = read_assembly(test::source_folder() / "examples" / name);
    const ResolvedAssembly resolved = resolve(assembly);
    const auto districts = districts_of_parts(resolved, 0);
    ASSERT_EQ(districts.size(), 1) << name;
    const District all = district(assembly, resolved, districts.front());
    EXPECT_EQ(all.resolved.fillets.size(), resolved.fillets.size());
    EXPECT_EQ(all.resolved.junctions.size(), resolved.junctions.size());
    EXPECT_EQ(all.resolved.parts.size(), resolved.parts.size());
    for (std::size_t i = 0; i < resolved.fillets.size(); ++i) {
      EXPECT_EQ(all.parts.at(all.resolved.fillets[i].index), resolved.fillets[i].index);
    }
  }
}

}  // namespace
}  // namespace dupin::assembly
