#pragma once

#include <string>

#include <cairo-pdf.h>
#include <cairo.h>

// Of cairo what pages are drawn with; it brings twenty libraries along.
#define DUPIN_CAIRO_FUNCTIONS(FUNCTION)   \
  FUNCTION(close_path)                    \
  FUNCTION(create)                        \
  FUNCTION(destroy)                       \
  FUNCTION(fill)                          \
  FUNCTION(image_surface_create)          \
  FUNCTION(image_surface_create_for_data) \
  FUNCTION(line_to)                       \
  FUNCTION(move_to)                       \
  FUNCTION(paint)                         \
  FUNCTION(pdf_surface_create_for_stream) \
  FUNCTION(pdf_surface_set_metadata)      \
  FUNCTION(restore)                       \
  FUNCTION(rotate)                        \
  FUNCTION(save)                          \
  FUNCTION(scale)                         \
  FUNCTION(select_font_face)              \
  FUNCTION(set_dash)                      \
  FUNCTION(set_font_size)                 \
  FUNCTION(set_line_cap)                  \
  FUNCTION(set_line_join)                 \
  FUNCTION(set_line_width)                \
  FUNCTION(set_source_rgb)                \
  FUNCTION(set_source_surface)            \
  FUNCTION(show_text)                     \
  FUNCTION(status)                        \
  FUNCTION(status_to_string)              \
  FUNCTION(stroke)                        \
  FUNCTION(surface_destroy)               \
  FUNCTION(surface_finish)                \
  FUNCTION(surface_status)                \
  FUNCTION(surface_write_to_png_stream)   \
  FUNCTION(text_extents)                  \
  FUNCTION(text_path)                     \
  FUNCTION(translate)

namespace dupin::drawings {

/// Its functions, without "cairo_".
struct Cairo {
// A declared name takes no parentheses.  NOLINTNEXTLINE(bugprone-macro-parentheses)
#define DUPIN_CAIRO_MEMBER(name) decltype(&::cairo_##name) name = nullptr;
  DUPIN_CAIRO_FUNCTIONS(DUPIN_CAIRO_MEMBER)
#undef DUPIN_CAIRO_MEMBER
};

/// Loaded when it is first asked for; none if it is not there. What `why` points to says what the
/// system says.
[[nodiscard]] const Cairo* find_cairo(std::string* why = nullptr);

/// The same. Throws Error{invalid_argument} if it is not there.
[[nodiscard]] const Cairo& cairo();

}  // namespace dupin::drawings
