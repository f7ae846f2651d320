#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pcf/bores.h"

namespace dupin::pcf {
namespace {

PcfFile file_with(std::initializer_list<double> bores) {
  PcfFile file;
  for (const double bore : bores) {
    PipingComponent component;
    component.ports = {{Vec3::Zero(), bore / 2, file.line.components.size() + 1}};
    file.line.components.push_back(component);
  }
  return file;
}

std::vector<double> diameters(std::initializer_list<double> bores, BoreUnit unit,
                              double millimetres, BoreMeaning meaning) {
  PcfFile file = file_with(bores);
  give_meaning(file, unit, millimetres, meaning);
  std::vector<double> result;
  for (const PipingComponent& component : file.line.components) {
    result.push_back(2 * *component.ports[0].radius);
  }
  return result;
}

using testing::ElementsAre;

TEST(PcfBores, are_taken_one_by_one) {
  EXPECT_THAT(diameters({100, 168.3, 102.375}, BoreUnit::millimetre, 1, BoreMeaning::automatic),
              ElementsAre(114.3, 168.3, 102.375));
  EXPECT_THAT(diameters({100, 168.3}, BoreUnit::millimetre, 1, BoreMeaning::outside),
              ElementsAre(100, 168.3));
}

TEST(PcfBores, in_doubt_go_with_the_majority) {
  EXPECT_THAT(diameters({101.6, 203.2}, BoreUnit::millimetre, 1, BoreMeaning::automatic),
              ElementsAre(114.3, 219.1));
  EXPECT_THAT(diameters({101.6, 60.3}, BoreUnit::millimetre, 1, BoreMeaning::automatic),
              ElementsAre(101.6, 60.3));
  EXPECT_THAT(diameters({101.6, 88.9}, BoreUnit::millimetre, 1, BoreMeaning::automatic),
              ElementsAre(114.3, 88.9));
}

TEST(PcfBores, in_inches_are_names_before_they_are_diameters) {
  EXPECT_THAT(diameters({4, 0.5}, BoreUnit::inch, 25.4, BoreMeaning::automatic),
              ElementsAre(114.3, 21.3));
}

TEST(PcfBores, are_noted_once_each) {
  PcfFile file = file_with({100, 100, 5});
  give_meaning(file, BoreUnit::millimetre, 1, BoreMeaning::automatic);
  ASSERT_EQ(file.notes.size(), 2);
  EXPECT_EQ(file.notes[0].line, 3);
  EXPECT_THAT(file.notes[0].text, testing::HasSubstr("5 is no size of ASME B36.10M"));
}

// They are of components that say their diameter.
TEST(PcfBores, that_are_not_used_are_not_noted) {
  PcfFile file = file_with({100, 100, 5, 5});
  const std::vector<std::optional<double>> own{55, {}, 55, 55};
  give_meaning(file, BoreUnit::millimetre, 1, BoreMeaning::automatic, own);
  ASSERT_EQ(file.notes.size(), 1);
  EXPECT_EQ(file.notes[0].line, 2);
  EXPECT_THAT(file.notes[0].text, testing::HasSubstr("bore 100: outside diameter 114.3"));
}

}  // namespace
}  // namespace dupin::pcf
