#include "contact_options.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "exit_code.h"
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

TEST(ContactOptions, lengths_too_short_are_no_fault_of_the_solid) {
  const Solid touching = unite(std::vector{Solid::from(test::box({0, 0, 0}, {1, 1, 1})),
                                           Solid::from(test::box({1, 1, 0}, {2, 2, 1}))});
  OutputReport report;
  for (const std::string text : {"separate=1e-30", "bridge=1e-30"}) {
    try {
      (void)settle(touching, contact_choice(text, ""), report);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::contact);
      EXPECT_NE(error.message().find("the length must be above"), std::string::npos);
    }
    EXPECT_FALSE(report.settled.has_value());
  }
}

TEST(ContactOptions, lengths_that_leave_nothing_are_refused) {
  const Solid touching = unite(std::vector{Solid::from(test::box({0, 0, 0}, {1, 1, 1})),
                                           Solid::from(test::box({1, 1, 0}, {2, 2, 1}))});
  OutputReport report;
  const Solid left = settle(touching, contact_choice("separate=3", ""), report);
  ASSERT_TRUE(left.empty());
  try {
    require_something_left(report, left.triangle_count());
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::contact);
    EXPECT_NE(error.message().find("within 3 leaves nothing"), std::string::npos);
  }
  EXPECT_NO_THROW(require_something_left({}, 0)) << "nothing was separated";
}

TEST(ContactOptions, tell_what_was_ended_for_the_format) {
  const std::vector<Solid> boxes = {Solid::from(test::box({0, 0, 0}, {1, 1, 1})),
                                    Solid::from(test::box({1, 1, 0}, {2, 2, 1}))};
  OutputReport report;
  EXPECT_TRUE(rounded_apart(unite(boxes), Coordinates::binary32, {}, report).contacts().empty());
  ASSERT_TRUE(report.settled);
  EXPECT_EQ(report.settled->policy, "separate");
  EXPECT_EQ(report.settled->contacts.size(), 1U);
  OutputReport none;
  EXPECT_TRUE(rounded_apart(boxes.front(), Coordinates::binary32, {}, none).contacts().empty());
  EXPECT_FALSE(none.settled);
}

}  // namespace
}  // namespace dupin::cli
