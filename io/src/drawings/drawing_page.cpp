#include "dupin/io/drawing_page.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>

#include "drawings/paper_sheet.h"
#include "drawings/shading.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "text/drawable_text.h"

#ifdef DUPIN_WITH_CAIRO
#include "drawings/late_cairo.h"
#endif

namespace dupin {

#ifdef DUPIN_WITH_CAIRO
namespace {

using drawings::cairo;
using drawings::PaperSheet;
using drawings::Pen;

constexpr double kPointsPerMillimetre = 72 / 25.4, kMillimetresPerInch = 25.4;
constexpr double kMostPixels = 1e8;

struct Release {
  void operator()(cairo_surface_t* surface) const { cairo().surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo().destroy(context); }
};
using Surface = std::unique_ptr<cairo_surface_t, Release>;
using Context = std::unique_ptr<cairo_t, Release>;

cairo_status_t append_bytes(void* text, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) {
    throw std::bad_alloc();
  }
  if (status != CAIRO_STATUS_SUCCESS) {
    throw Error(Errc::internal, std::string("cairo fails: ") + cairo().status_to_string(status));
  }
}

void draw_line(cairo_t* context, const drawings::PaperLine& line) {
  for (const Eigen::Vector2d& point : line.points) {
    cairo().line_to(context, point[0], point[1]);
  }
  if (line.is_closed) {
    cairo().close_path(context);
  }
  if (line.pen == Pen::arrow) {
    cairo().fill(context);
    return;
  }
  const bool is_wide = line.pen == Pen::contour || line.pen == Pen::edge;
  cairo().set_line_width(context, is_wide ? drawings::kWide : drawings::kNarrow);
  const std::vector<double> dashes = drawings::dashes(line.pen);
  cairo().set_dash(context, dashes.data(), int(dashes.size()), 0);
  cairo().set_line_cap(context,
                       line.pen == Pen::center ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
  cairo().stroke(context);
}

void draw_text(cairo_t* context, const drawings::PaperText& text) {
  cairo().save(context);
  cairo().translate(context, text.at[0], text.at[1]);
  if (text.is_upright) {
    cairo().rotate(context, -std::acos(-1.0) / 2);
  }
  const std::string drawn = text::drawable(text.text);
  cairo_text_extents_t extents;
  cairo().text_extents(context, drawn.c_str(), &extents);
  const double begin = text.is_centered ? -extents.x_advance / 2 : 0;
  // Lines end beside it.
  cairo().move_to(context, begin, 0);
  cairo().text_path(context, drawn.c_str());
  cairo().set_source_rgb(context, 1, 1, 1);
  cairo().set_line_width(context, drawings::kTextMargin);
  cairo().set_dash(context, nullptr, 0, 0);
  cairo().stroke(context);
  cairo().set_source_rgb(context, 0, 0, 0);
  cairo().move_to(context, begin, 0);
  cairo().show_text(context, drawn.c_str());
  cairo().restore(context);
}

// PDF has pages of up to 14400 points (ISO 32000-1, annex C); cairo's own numbers end at 2^23.
constexpr double kLongestPage = 14400 / kPointsPerMillimetre;

bool fits_page(const PaperSheet& sheet) { return sheet.size.maxCoeff() <= kLongestPage; }

// Texts and margins do not shrink with the drawing.
std::string scale_that_fits(const PaperSheet& sheet, const Drawing& drawing,
                            const DrawingScale& scale, const SheetOptions& options) {
  constexpr int kTries = 8;
  double ratio = scale.real / scale.paper * (sheet.size.maxCoeff() / kLongestPage);
  for (int i = 0; i < kTries && std::isnormal(ratio); ++i) {
    const DrawingScale smaller = drawings::usual_scale(ratio);
    if (fits_page(drawings::paper_sheet(drawing, smaller, options))) {
      return "a scale of " + to_string(smaller) + " would do, or an SVG";
    }
    ratio *= 2;
  }
  return "a smaller scale may do, or an SVG";
}

void require_page(const PaperSheet& sheet, const Drawing& drawing, const DrawingScale& scale,
                  const SheetOptions& options) {
  if (!fits_page(sheet)) {
    throw Error(Errc::limit_exceeded,
                "the drawing would be " + decimal(sheet.size[0], kMessageDigits) + " x " +
                    decimal(sheet.size[1], kMessageDigits) +
                    " mm on paper, and a page of PDF is at most " + decimal(kLongestPage, 4) +
                    " mm wide and high; " + scale_that_fits(sheet, drawing, scale, options));
  }
}

// In millimetres.
void draw_sheet(cairo_t* context, const PaperSheet& sheet) {
  cairo().set_source_rgb(context, 0, 0, 0);
  cairo().set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo().select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
  cairo().set_font_size(context, drawings::kFontSize);
  for (const drawings::PaperLine& line : sheet.lines) {
    draw_line(context, line);
  }
  for (const drawings::PaperText& text : sheet.texts) {
    draw_text(context, text);
  }
  check(cairo().status(context));
}

}  // namespace

bool can_draw_pages() { return drawings::find_cairo() != nullptr; }

std::string drawing_pdf(const Drawing& drawing, const DrawingScale& scale,
                        const SheetOptions& options) {
  const UsualArithmetic usual;
  const PaperSheet sheet = drawings::paper_sheet(drawing, scale, options);
  require_page(sheet, drawing, scale, options);
  std::string bytes;
  const Surface surface(cairo().pdf_surface_create_for_stream(
      append_bytes, &bytes, sheet.size[0] * kPointsPerMillimetre,
      sheet.size[1] * kPointsPerMillimetre));
  cairo().pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE,
                                   text::drawable(sheet.title).c_str());
  cairo().pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE,
                                   "1970-01-01T00:00:00Z");
  {
    const Context context(cairo().create(surface.get()));
    cairo().scale(context.get(), kPointsPerMillimetre, kPointsPerMillimetre);
    draw_sheet(context.get(), sheet);
  }
  cairo().surface_finish(surface.get());
  check(cairo().surface_status(surface.get()));
  return bytes;
}

std::string drawing_png(const Drawing& drawing, const DrawingScale& scale,
                        const SheetOptions& options, const PictureOptions& picture) {
  const UsualArithmetic usual;
  if (!(picture.dots_per_inch > 0 && std::isfinite(picture.dots_per_inch))) {
    throw Error(Errc::invalid_argument,
                "a picture needs a positive number of dots per inch, such as 150, not " +
                    decimal(picture.dots_per_inch, kMessageDigits));
  }
  const PaperSheet sheet = drawings::paper_sheet(drawing, scale, options);
  const double per_millimetre = picture.dots_per_inch / kMillimetresPerInch;
  const double width = std::ceil(sheet.size[0] * per_millimetre),
               height = std::ceil(sheet.size[1] * per_millimetre);
  if (!(width * height <= kMostPixels) || std::max(width, height) > 30000) {
    throw Error(Errc::limit_exceeded,
                "the picture would have more than 100 million pixels; take fewer dots per inch, or "
                "a smaller scale");
  }
  const Surface surface(cairo().image_surface_create(CAIRO_FORMAT_RGB24, int(width), int(height)));
  const Context context(cairo().create(surface.get()));
  cairo().set_source_rgb(context.get(), 1, 1, 1);
  cairo().paint(context.get());
  if (picture.shaded != nullptr) {
    drawings::Picture shades =
        drawings::shaded(*picture.shaded, picture.colours, drawing.view, sheet, per_millimetre);
    const Surface image(cairo().image_surface_create_for_data(
        reinterpret_cast<unsigned char*>(shades.pixels.data()), CAIRO_FORMAT_ARGB32, shades.width,
        shades.height, 4 * shades.width));
    cairo().set_source_surface(context.get(), image.get(), 0, 0);
    cairo().paint(context.get());
  }
  cairo().scale(context.get(), per_millimetre, per_millimetre);
  draw_sheet(context.get(), sheet);
  std::string bytes;
  check(cairo().surface_write_to_png_stream(surface.get(), append_bytes, &bytes));
  return bytes;
}

#else

namespace {

[[noreturn]] void refuse() {
  throw Error(Errc::invalid_argument,
              "PDF and PNG need cairo, which this build of dupin has not got: build it where "
              "libcairo2-dev is installed, or write .svg");
}

}  // namespace

bool can_draw_pages() { return false; }

std::string drawing_pdf(const Drawing& /*drawing*/, const DrawingScale& /*scale*/,
                        const SheetOptions& /*options*/) {
  refuse();
}

std::string drawing_png(const Drawing& /*drawing*/, const DrawingScale& /*scale*/,
                        const SheetOptions& /*options*/, const PictureOptions& /*picture*/) {
  refuse();
}

#endif

}  // namespace dupin
