#include "dupin/io/mesh_file.h"

namespace dupin {

std::string_view name(MeshFormat format) {
  switch (format) {
    case MeshFormat::off:
      return "OFF";
    case MeshFormat::stl_ascii:
      return "ASCII STL";
    case MeshFormat::stl_binary:
      return "binary STL";
  }
  return "unknown";
}

}  // namespace dupin
