#include "files/late_library.h"

#include <dlfcn.h>

namespace dupin::files {
namespace {

std::string what_the_loader_says() {
  const char* const why = dlerror();
  return why == nullptr ? "" : why;
}

}  // namespace

LateLibrary::LateLibrary(const char* file) : handle_(dlopen(file, RTLD_NOW | RTLD_LOCAL)) {
  if (handle_ == nullptr) {
    missing_ = what_the_loader_says();
  }
}

void* LateLibrary::address(const char* name) {
  void* const found = handle_ == nullptr ? nullptr : dlsym(handle_, name);
  if (found == nullptr && missing_.empty()) {
    missing_ = what_the_loader_says();
  }
  return found;
}

}  // namespace dupin::files
