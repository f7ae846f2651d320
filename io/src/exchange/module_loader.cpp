#include "exchange/module_loader.h"

#include <dlfcn.h>

#include "dupin/kernel/error.h"

namespace dupin::exchange {
namespace {

struct Found {
  const Module* module = nullptr;
  std::string why;
};

Found load() {
  void* const library = dlopen(kModuleFile, RTLD_NOW | RTLD_LOCAL);
  void* const entry = library == nullptr ? nullptr : dlsym(library, kEntryPoint);
  if (entry == nullptr) {
    const char* const why = dlerror();
    return {nullptr, why == nullptr ? "" : why};
  }
  using Entry = const Module* (*)();
  return {reinterpret_cast<Entry>(entry)(), {}};
}

// It stays loaded, for as long as the program runs.
const Found& found() {
  static const Found kFound = load();
  return kFound;
}

}  // namespace

const Module* find_module(std::string* why) {
  if (why != nullptr) {
    *why = found().why;
  }
  return found().module;
}

const Module& loaded_module() {
  std::string why;
  if (const Module* const module = find_module(&why)) {
    return *module;
  }
  throw Error(Errc::invalid_argument,
              "STEP and IGES need OpenCASCADE, which this build of dupin has not got: build it "
              "where libocct-data-exchange-dev is installed (" +
                  why + ")");
}

}  // namespace dupin::exchange
