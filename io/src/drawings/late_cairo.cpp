#include "drawings/late_cairo.h"

#include "dupin/kernel/error.h"
#include "files/late_library.h"

namespace dupin::drawings {
namespace {

struct Found {
  Cairo cairo;
  std::string missing;
};

Found load() {
  files::LateLibrary library(DUPIN_CAIRO_FILE);
  Found found;
#define DUPIN_CAIRO_FIND(name) library.find(found.cairo.name, "cairo_" #name);
  DUPIN_CAIRO_FUNCTIONS(DUPIN_CAIRO_FIND)
#undef DUPIN_CAIRO_FIND
  found.missing = library.missing();
  return found;
}

}  // namespace

const Cairo* find_cairo(std::string* why) {
  static const Found found = load();
  if (why != nullptr) {
    *why = found.missing;
  }
  return found.missing.empty() ? &found.cairo : nullptr;
}

const Cairo& cairo() {
  std::string why;
  if (const Cairo* const found = find_cairo(&why)) {
    return *found;
  }
  throw Error(Errc::invalid_argument,
              "PDF and PNG need cairo, which is not there (" + why + "); or write .svg");
}

}  // namespace dupin::drawings
