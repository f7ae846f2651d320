#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "network/line_notes.h"

namespace dupin::network {
namespace {

PipingComponent component(const std::string& name, std::size_t line) {
  PipingComponent result;
  result.name = name;
  result.line = line;
  return result;
}

TEST(LineNotes, come_by_line_whatever_the_order) {
  LineNotes notes("a.pcf", true);
  notes.add(component("b", 9), "second");
  notes.refuse(component("a", 4), "it is bad");
  notes.add(component("a", 4), "third");
  const auto all = std::move(notes).take();
  ASSERT_EQ(all.size(), 3);
  EXPECT_EQ(all[0].text, "a: left out, as it is bad");
  EXPECT_TRUE(all[0].is_refusal);
  EXPECT_EQ(all[1].text, "a: third");
  EXPECT_FALSE(all[2].is_refusal);
}

TEST(LineNotes, throw_what_is_refused_unless_told_to_keep_going) {
  LineNotes notes("a.pcf", false);
  try {
    notes.refuse(component("a", 4), "it is bad");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a.pcf:4: 'a': it is bad; --keep-going leaves it out");
    EXPECT_EQ(error.code(), Errc::invalid_argument);
  }
  try {
    notes.refuse(component("a", 4), "it folds", Errc::irregular_surface);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::irregular_surface);
  }
}

}  // namespace
}  // namespace dupin::network
