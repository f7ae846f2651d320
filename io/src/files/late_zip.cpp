#include "files/late_zip.h"

#include "dupin/kernel/error.h"
#include "files/late_library.h"

namespace dupin::files {
namespace {

Zip loaded() {
  LateLibrary library(DUPIN_ZIP_FILE);
  Zip zip;
#define DUPIN_ZIP_FIND(name) library.find(zip.name, "zip_" #name);
  DUPIN_ZIP_FUNCTIONS(DUPIN_ZIP_FIND)
#undef DUPIN_ZIP_FIND
  if (!library.missing().empty()) {
    throw Error(Errc::invalid_argument,
                "3MF needs libzip, which is not there (" + library.missing() + ")");
  }
  return zip;
}

}  // namespace

const Zip& zip() {
  static const Zip kZip = loaded();
  return kZip;
}

}  // namespace dupin::files
