#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/edge_table.h"
#include "mesh/exact_mesh.h"

namespace dupin::mesh {

/// A contact with the faces that meet there.
struct ContactPlace {
  Contact::Kind kind = Contact::Kind::vertex;
  std::uint32_t from = 0, to = 0;    ///< points
  std::vector<std::uint32_t> faces;  ///< ascending
  /// False at an edge around which the faces do not bound inside and outside in turn: there the
  /// surface crosses or covers itself.
  bool alternating = true;
};

/// The half-edges along an edge in the order of their faces around it, counter-clockwise about its
/// direction from low to high, exactly.
[[nodiscard]] std::vector<std::uint32_t> sorted_around(const MeshView& mesh, const EdgeTable& edges,
                                                       const Edge& edge);

/// Whether the faces around the edge bound inside and outside in turn, exactly.
[[nodiscard]] bool alternates(const MeshView& mesh, const EdgeTable& edges, const Edge& edge);

/// Whether the faces of two half-edges along the edge begin in one half-plane, exactly.
[[nodiscard]] bool in_one_half_plane(const MeshView& mesh, const EdgeTable& edges, const Edge& edge,
                                     std::uint32_t first, std::uint32_t second);

/// Where a closed oriented 2-manifold surface touches itself: edges first, then vertices that are
/// in no such edge. `representatives` names for each point the first one of the same coordinates.
/// Faces may meet in such points only.
[[nodiscard]] std::vector<ContactPlace> find_contacts(
    const MeshView& mesh, std::span<const std::uint32_t> representatives);

/// The public form, with the names of the faces' labels.
[[nodiscard]] Contact to_contact(const ContactPlace& place, const MeshView& mesh,
                                 std::span<const std::uint32_t> labels,
                                 std::span<const std::string> names);

/// Gives each fan of faces a point of its own, so that the surface is 2-manifold combinatorially
/// wherever its edges are, and lists the contacts. Every edge has two faces that run along it in
/// opposite directions.
void separate_contacts(ExactMesh& mesh);

/// The same for fans given like those of corner_fans(), whatever number of faces edges have.
void separate_fans(ExactMesh& mesh, std::span<const std::uint32_t> fans);

}  // namespace dupin::mesh
