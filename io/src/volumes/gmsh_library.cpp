#include "volumes/gmsh_library.h"

#include <string>

#include <dlfcn.h>

namespace dupin::volumes {
namespace {

/// Of the version whose header this was compiled with: others may take other arguments.
std::string file_name() {
  return "libgmsh.so." + std::to_string(GMSH_API_VERSION_MAJOR) + "." +
         std::to_string(GMSH_API_VERSION_MINOR);
}

template <class Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

}  // namespace

GmshLibrary::GmshLibrary() {
  void* const library = dlopen(file_name().c_str(), RTLD_NOW | RTLD_LOCAL);
  is_complete_ = library != nullptr && find(library, "gmshInitialize", initialize) &&
                 find(library, "gmshFinalize", finalize) && find(library, "gmshFree", free) &&
                 find(library, "gmshOptionSetNumber", set_number) &&
                 find(library, "gmshLoggerStart", start_log) &&
                 find(library, "gmshLoggerGet", get_log) &&
                 find(library, "gmshModelAdd", add_model) &&
                 find(library, "gmshModelAddDiscreteEntity", add_discrete_entity) &&
                 find(library, "gmshModelMeshAddNodes", add_nodes) &&
                 find(library, "gmshModelMeshAddElementsByType", add_elements) &&
                 find(library, "gmshModelGeoAddSurfaceLoop", add_surface_loop) &&
                 find(library, "gmshModelGeoAddVolume", add_volume) &&
                 find(library, "gmshModelGeoSynchronize", synchronize) &&
                 find(library, "gmshModelMeshGenerate", generate) &&
                 find(library, "gmshModelMeshGetNodes", get_nodes) &&
                 find(library, "gmshModelMeshGetElementsByType", get_elements);
}

const GmshLibrary* GmshLibrary::instance() {
  static const GmshLibrary library;
  return library.is_complete_ ? &library : nullptr;
}

}  // namespace dupin::volumes
