#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <gmshc.h>

/// Tetrahedra by gmsh, and how they are written. The library is loaded when it is first asked for,
/// not when the program starts: it and what it is linked with take a fifth of a second.
namespace dupin::volumes {

/// The functions of gmsh that are used, by their types in its header. Those that are missing make
/// `instance` return nothing.
class GmshLibrary {
 public:
  /// None where it cannot be loaded.
  [[nodiscard]] static const GmshLibrary* instance();

  decltype(&gmshInitialize) initialize = nullptr;
  decltype(&gmshFinalize) finalize = nullptr;
  decltype(&gmshFree) free = nullptr;
  decltype(&gmshOptionSetNumber) set_number = nullptr;
  decltype(&gmshLoggerStart) start_log = nullptr;
  decltype(&gmshLoggerGet) get_log = nullptr;
  decltype(&gmshModelAdd) add_model = nullptr;
  decltype(&gmshModelAddDiscreteEntity) add_discrete_entity = nullptr;
  decltype(&gmshModelMeshAddNodes) add_nodes = nullptr;
  decltype(&gmshModelMeshAddElementsByType) add_elements = nullptr;
  decltype(&gmshModelGeoAddSurfaceLoop) add_surface_loop = nullptr;
  decltype(&gmshModelGeoAddVolume) add_volume = nullptr;
  decltype(&gmshModelGeoSynchronize) synchronize = nullptr;
  decltype(&gmshModelMeshGenerate) generate = nullptr;
  decltype(&gmshModelMeshGetNodes) get_nodes = nullptr;
  decltype(&gmshModelMeshGetElementsByType) get_elements = nullptr;

 private:
  GmshLibrary();
  bool is_complete_ = false;
};

}  // namespace dupin::volumes
