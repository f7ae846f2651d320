#include "rounding/shell_check.h"

#include <utility>

#include "mesh/coincident_points.h"
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

std::vector<Contact> contacts_of(const TriMesh& mesh, const Vec3& origin) {
  const mesh::MeshView view(mesh.points, mesh.triangles);
  std::vector<Contact> contacts;
  for (const mesh::ContactPlace& place :
       mesh::find_contacts(view, mesh::coincident_representatives(mesh.points))) {
    Contact contact = mesh::to_contact(place, view, mesh.labels, mesh.names);
    contact.from += origin;
    contact.to += origin;
    contacts.push_back(std::move(contact));
  }
  return contacts;
}

}  // namespace dupin::rounding
