#include <gtest/gtest.h>

#include "dupin/io/drawing_page.h"

#ifdef DUPIN_WITH_CAIRO
#include "drawings/late_cairo.h"

namespace dupin::drawings {
namespace {

TEST(LateCairo, has_every_function_that_it_names) {
  std::string why;
  ASSERT_NE(find_cairo(&why), nullptr) << why;
  EXPECT_EQ(&cairo(), find_cairo());
  EXPECT_EQ(why, "");
#define DUPIN_CAIRO_EXPECT(name) EXPECT_NE(cairo().name, nullptr) << #name;
  DUPIN_CAIRO_FUNCTIONS(DUPIN_CAIRO_EXPECT)
#undef DUPIN_CAIRO_EXPECT
}

}  // namespace
}  // namespace dupin::drawings
#endif
