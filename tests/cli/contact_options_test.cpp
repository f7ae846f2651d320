#include "contact_options.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "exit_code.h"
#include "support/pipe_unions.h"
#include "support/shapes.h"

namespace dupin::cli {
namespace {

using Kind = ContactChoice::Kind;

TEST(ContactOptions, say_what_to_do) {
  EXPECT_EQ(contact_choice("", "mm").kind, Kind::standard);
  EXPECT_EQ(contact_choice("report", "mm").kind, Kind::report);
  EXPECT_EQ(contact_choice("refuse", "mm").kind, Kind::refuse);
  EXPECT_EQ(contact_choice("separate=1in", "mm").kind, Kind::separate);
  EXPECT_EQ(contact_choice("separate=1in", "mm").length, 25.4);
  EXPECT_EQ(contact_choice("bridge=1", "in").kind, Kind::bridge);
  EXPECT_EQ(contact_choice("bridge=1", "in").length, 1);
  for (const std::string text : {"hide", "bridge", "bridge=", "refuse=1", "=1", "bridge=far"}) {
    EXPECT_THROW((void)contact_choice(text, "mm"), UsageError) << text;
  }
}

TEST(ContactOptions, only_refusal_is_the_operations_own_business) {
  EXPECT_EQ(contact_choice("refuse", "").policy(), ContactPolicy::refuse);
  for (const std::string text : {"report", "separate=1", "bridge=1"}) {
    EXPECT_EQ(contact_choice(text, "").policy(), ContactPolicy::report) << text;
  }
}

TEST(ContactOptions, settle_contacts_and_tell) {
  const std::vector<Solid> boxes = {Solid::from(test::box({0, 0, 0}, {1, 1, 1})),
                                    Solid::from(test::box({1, 1, 0}, {2, 2, 1}))};
  const Solid touching = unite(boxes);
  ASSERT_EQ(touching.contacts().size(), 1U);
  OutputReport report;
  EXPECT_EQ(settle(touching, contact_choice("report", ""), report).contacts().size(), 1U);
  EXPECT_FALSE(report.settled.has_value());
  EXPECT_TRUE(settle(touching, contact_choice("bridge=0.25", ""), report).contacts().empty());
  ASSERT_TRUE(report.settled.has_value());
  EXPECT_EQ(report.settled->policy, "bridge");
  EXPECT_EQ(report.settled->length, 0.25);
  EXPECT_EQ(report.settled->contacts.size(), 1U);
  EXPECT_TRUE(settle(touching, contact_choice("separate=0.25", ""), report).contacts().empty());
  EXPECT_EQ(report.settled->policy, "separate");
}

TEST(ContactOptions, part_what_touches_itself_once_it_is_rounded) {
  std::size_t parted = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const Solid solid = unite(test::resting_pipes(8, seed));
    const auto contacts = to_mesh(solid, Coordinates::binary32).contacts().size();
    OutputReport report;
    EXPECT_TRUE(rounded_apart(solid, Coordinates::binary32, {}, report).contacts().empty());
    EXPECT_EQ(report.settled.has_value(), contacts > 0);
    if (report.settled) {
      ++parted;
      EXPECT_EQ(report.settled->policy, "separate");
      EXPECT_GE(report.settled->contacts.size(), contacts);
      EXPECT_GT(report.settled->length, 0);
    }
  }
  EXPECT_GT(parted, 0U);
}

}  // namespace
}  // namespace dupin::cli
