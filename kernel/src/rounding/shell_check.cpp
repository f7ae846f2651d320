#include "rounding/shell_check.h"

#include "mesh/self_contact.h"

namespace dupin::rounding {

std::vector<std::uint32_t> crossed_contacts(const mesh::MeshView& mesh,
                                            std::span<const std::uint32_t> representatives) {
  std::vector<std::uint32_t> crossed;
  for (const mesh::ContactPlace& place : mesh::find_contacts(mesh, representatives)) {
    if (!place.alternating) {
      crossed.insert(crossed.end(), place.faces.begin(), place.faces.end());
    }
  }
  return crossed;
}

}  // namespace dupin::rounding
