#include "dupin/io/drawing_page.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/message_of.h"

namespace dupin {
namespace {

Drawing drawing() {
  Drawing result{"a.json", Unit::millimetre, view_along(-Vec3::UnitZ()), 0.01, {}};
  result.lines.push_back({"p", LineKind::contour, false, {{0, 0}, {40, 0}, {40, 20}}});
  return result;
}

TEST(DrawingPage, is_pdf_and_png_of_the_same_bytes_every_time) {
  if (!can_draw_pages()) {
    EXPECT_THROW((void)drawing_pdf(drawing(), {1, 1}), Error);
    return;
  }
  const std::string pdf = drawing_pdf(drawing(), {1, 1}), png = drawing_png(drawing(), {1, 1});
  EXPECT_THAT(pdf, testing::StartsWith("%PDF-"));
  EXPECT_THAT(png, testing::StartsWith("\x89PNG\r\n"));
  EXPECT_EQ(pdf, drawing_pdf(drawing(), {1, 1}));
  EXPECT_EQ(png, drawing_png(drawing(), {1, 1}));
  // 50 mm at 254 dots per inch, in the header.
  const std::string fine = drawing_png(drawing(), {1, 1}, {}, {254});
  EXPECT_EQ(std::uint8_t(fine[18]) * 256 + std::uint8_t(fine[19]), 500);
}

TEST(DrawingPage, refuses_pictures_that_are_too_large) {
  if (can_draw_pages()) {
    EXPECT_THROW((void)drawing_png(drawing(), {1000, 1}), Error);
  }
}

TEST(DrawingPage, refuses_pages_that_pdf_has_not_and_says_what_would_do) {
  if (!can_draw_pages()) {
    return;
  }
  EXPECT_THAT(drawing_pdf(drawing(), {100, 1}), testing::StartsWith("%PDF-"));
  for (const double paper : {127.0, 1e4, 1e9, 1e300}) {
    const auto message = [&](const SheetOptions& options) {
      return test::message_of(
          [&] {
            (void)drawing_pdf(drawing(), {paper, 1}, options);
          },
          Errc::limit_exceeded);
    };
    EXPECT_THAT(message({}), testing::HasSubstr("a page of PDF is at most 5080 mm wide and high"));
    EXPECT_THAT(message({}), testing::EndsWith("a scale of 100:1 would do, or an SVG"));
    EXPECT_THAT(message({.names = true}), testing::EndsWith("or an SVG"));
  }
}

TEST(DrawingPage, draws_names_of_noncharacters_and_bytes) {
  if (!can_draw_pages()) {
    return;
  }
  Drawing named = drawing();
  named.source = "\xFF\xEF\xBF\xBF.json";
  named.parts.push_back({"a\xEF\xBF\xBE", {20, 10}, {1, 1}});
  const SheetOptions options{.names = true, .dimensions = true};
  EXPECT_THAT(drawing_pdf(named, {1, 1}, options), testing::StartsWith("%PDF-"));
  EXPECT_THAT(drawing_png(named, {1, 1}, options), testing::StartsWith("\x89PNG\r\n"));
}

TEST(DrawingPage, needs_a_positive_number_of_dots) {
  if (!can_draw_pages()) {
    return;
  }
  for (const double dots : {0.0, -150.0, std::nan(""), double(INFINITY)}) {
    EXPECT_THAT(test::message_of(
                    [&] {
                      (void)drawing_png(drawing(), {1, 1}, {}, {dots});
                    },
                    Errc::invalid_argument),
                testing::StartsWith("a picture needs a positive number of dots per inch"));
  }
}

}  // namespace
}  // namespace dupin
