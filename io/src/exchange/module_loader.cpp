#include "exchange/module_loader.h"

#include "dupin/kernel/error.h"
#include "files/late_library.h"

namespace dupin::exchange {
namespace {

struct Found {
  const Module* module = nullptr;
  std::string why;
};

Found load() {
  files::LateLibrary library(kModuleFile);
  const Module* (*entry)() = nullptr;
  library.find(entry, kEntryPoint);
  return {entry == nullptr ? nullptr : entry(), library.missing()};
}

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
