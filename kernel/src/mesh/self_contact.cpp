#include "mesh/self_contact.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "exact/exact_numbers.h"
#include "mesh/coincident_points.h"
#include "mesh/edge_table.h"
#include "mesh/radial_order.h"
#include "support/blocks.h"
#include "support/sequences.h"

namespace dupin::mesh {
namespace {

// (X, Y, Z) / W scaled by the other's W, so that both have one denominator.
exact::ExactVector difference(const ExactPoint& a, const ExactPoint& b) {
  return {a[0] * b[3] - b[0] * a[3], a[1] * b[3] - b[1] * a[3], a[2] * b[3] - b[2] * a[3]};
}

// A face as a half-plane that ends in the edge.
struct HalfPlane {
  exact::ExactVector direction;  // from the edge into the face
  std::uint32_t half_edge = 0;
};

}  // namespace

std::vector<std::uint32_t> sorted_around(const MeshView& mesh, const EdgeTable& edges,
                                         const Edge& edge) {
  const ExactPoint low = mesh.exact(edge.low);
  const exact::ExactVector axis = difference(mesh.exact(edge.high), low);
  std::vector<HalfPlane> half_planes;
  for (const std::uint32_t half_edge : edge.half_edges) {
    const std::uint32_t apex = edges.target(next_half_edge(half_edge));
    half_planes.push_back({difference(mesh.exact(apex), low), half_edge});
  }
  sort_around_edge(
      half_planes,
      [&axis](const HalfPlane& a, const HalfPlane& b) {
        return exact::sign(exact::dot(axis, exact::cross(a.direction, b.direction)));
      },
      [&axis](const HalfPlane& a, const HalfPlane& b) {
        return exact::sign(exact::dot(exact::cross(axis, a.direction),
                                      exact::cross(axis, b.direction))) < 0;
      });
  std::vector<std::uint32_t> half_edges;
  half_edges.reserve(half_planes.size());
  for (const HalfPlane& h : half_planes) {
    half_edges.push_back(h.half_edge);
  }
  return half_edges;
}

bool alternates(const MeshView& mesh, const EdgeTable& edges, const Edge& edge) {
  const std::vector<std::uint32_t> around = sorted_around(mesh, edges, edge);
  const auto same_way = [&](std::uint32_t a, std::uint32_t b) {
    return edges.origin(a) == edges.origin(b);
  };
  return !same_way(around.front(), around.back()) &&
         std::adjacent_find(around.begin(), around.end(), same_way) == around.end();
}

bool in_one_half_plane(const MeshView& mesh, const EdgeTable& edges, const Edge& edge,
                       std::uint32_t first, std::uint32_t second) {
  const ExactPoint low = mesh.exact(edge.low);
  const auto normal = [&](std::uint32_t half_edge) {
    const std::uint32_t apex = edges.target(next_half_edge(half_edge));
    return exact::cross(difference(mesh.exact(edge.high), low), difference(mesh.exact(apex), low));
  };
  const exact::ExactVector a = normal(first), b = normal(second), across = exact::cross(a, b);
  return exact::sign(exact::dot(across, across)) == 0 && exact::sign(exact::dot(a, b)) > 0;
}

std::vector<ContactPlace> find_contacts(const MeshView& mesh,
                                        std::span<const std::uint32_t> representatives) {
  const std::vector<std::uint8_t> is_shared = shared_places(representatives);
  // Lemma: an edge has more than two faces only where one of its ends is where other points are,
  // and a place has more than one fan only if several points are there.
  const auto touching = support::indices_where(mesh.triangles.size(), [&](std::uint32_t face) {
    const auto& [a, b, c] = mesh.triangles[face];
    return (is_shared[a] | is_shared[b] | is_shared[c]) != 0;
  });
  if (touching.empty()) {
    return {};
  }
  std::vector<Triangle> merged = support::selected(mesh.triangles, touching);
  for (Triangle& corners : merged) {
    for (std::uint32_t& corner : corners) {
      corner = representatives[corner];
    }
  }
  const EdgeTable edges(merged, mesh.points.size());
  std::vector<ContactPlace> places;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge edge = edges[i];
    if (edge.half_edges.size() > 2) {
      ContactPlace place{Contact::Kind::edge, edge.low, edge.high, {}, true};
      for (const std::uint32_t half_edge : edge.half_edges) {
        place.faces.push_back(touching[half_edge / 3]);
      }
      support::sort_unique(place.faces);
      place.alternating = alternates(mesh, edges, edge);
      places.push_back(std::move(place));
    }
  }

  const auto fans = corner_fans(merged, edges);
  const auto point_of = [&](std::uint32_t corner) { return merged[corner / 3][corner % 3]; };
  std::vector<std::uint32_t> fan_count(mesh.points.size());
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    const bool is_first = fans[corner] == corner && is_shared[point_of(corner)] != 0;
    fan_count[point_of(corner)] += is_first ? 1 : 0;
  }
  std::vector<std::uint32_t> place_of(mesh.points.size());
  for (std::uint32_t point = 0; point < fan_count.size(); ++point) {
    if (fan_count[point] > 1) {
      place_of[point] = static_cast<std::uint32_t>(places.size());
      places.push_back({Contact::Kind::vertex, point, point, {}, true});
    }
  }
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    if (fan_count[point_of(corner)] > 1) {
      places[place_of[point_of(corner)]].faces.push_back(touching[corner / 3]);
    }
  }
  return places;
}

Contact to_contact(const ContactPlace& place, const MeshView& mesh,
                   std::span<const std::uint32_t> labels, std::span<const std::string> names) {
  std::set<std::string> involved;
  if (!labels.empty()) {
    for (const std::uint32_t face : place.faces) {
      involved.insert(names[labels[face]]);
    }
  }
  return {place.kind,
          mesh.points[place.from],
          mesh.points[place.to],
          {involved.begin(), involved.end()}};
}

void separate_contacts(ExactMesh& mesh) {
  const EdgeTable edges(mesh.triangles, mesh.points.size());
  separate_fans(mesh, corner_fans(mesh.triangles, edges));
}

void separate_fans(ExactMesh& mesh, std::span<const std::uint32_t> fans) {
  const auto point_of = [&](std::uint32_t corner) {
    return mesh.triangles[corner / 3][corner % 3];
  };
  std::vector<std::uint32_t> next_index(mesh.points.size() + 1);  // of a point's first fan
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    next_index[point_of(corner) + 1] += fans[corner] == corner ? 1 : 0;
  }
  std::partial_sum(next_index.begin(), next_index.end(), next_index.begin());

  ExactMesh separate;
  for (std::uint32_t point = 0; point < mesh.points.size(); ++point) {
    for (std::uint32_t i = next_index[point]; i < next_index[point + 1]; ++i) {
      separate.points.push_back(mesh.points[point]);
      if (point >= mesh.double_count()) {
        separate.implicit.push_back(mesh.implicit, point - mesh.double_count());
      }
    }
  }
  std::vector<std::uint32_t> index_of_fan(fans.size());
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    if (fans[corner] == corner) {
      index_of_fan[corner] = next_index[point_of(corner)]++;
    }
  }
  for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
    mesh.triangles[corner / 3][corner % 3] = index_of_fan[fans[corner]];
  }
  mesh.points = std::move(separate.points);
  mesh.implicit = std::move(separate.implicit);

  mesh.contacts.clear();
  const MeshView view(mesh);
  for (const ContactPlace& place : find_contacts(view, coincident_representatives(mesh))) {
    mesh.contacts.push_back(to_contact(place, view, mesh.labels, mesh.names));
  }
}

}  // namespace dupin::mesh
