#include "dupin/io/glb.h"

namespace dupin {
namespace {

Evidence recognise(std::string_view bytes) {
  return bytes.starts_with("glTF") ? Evidence::signature : Evidence::none;
}

}  // namespace

constinit const MeshFormat kGlb = {.key = "glb",
                                   .name = "binary glTF",
                                   .extension = ".glb",
                                   .coordinates = Coordinates::binary32,
                                   .has_normals = true,
                                   .read = read_glb,
                                   .write = glb_bytes,
                                   .recognises = recognise,
                                   .unit = unit_of_glb};

}  // namespace dupin
