#pragma once

#include <span>
#include <vector>

#include "dupin/kernel/mesh.h"
#include "rounding/edits/edited_mesh.h"

namespace dupin::rounding {

/// Where an edge at which the surface touches itself is as short as a step of the lattice, and both
/// of its ends are one point each, so that the middle is there twice to tell two edges (contact.h):
/// neither copy has a place between the ends, and without them the surface were no manifold. What
/// is left of them in `mesh` are faces without area, or two on the same corners. These are the
/// places of such copies; `representatives` names of each point as given the first in its place,
/// and `moved` tells what rounding has moved.
[[nodiscard]] std::vector<Vec3> pinched_places(const EditedMesh& mesh,
                                               std::span<const std::uint32_t> representatives,
                                               std::span<const std::uint8_t> moved);

/// Takes all points at each place to the nearest other corner of triangles there that is no further
/// than `farthest`, and is none of these places: then the surface touches itself in a point.
/// Returns how far the longest way is; `faults` get those that come of it.
double close_pinches(std::span<const Vec3> places, double farthest, TriMesh& surface,
                     std::vector<Fault>& faults);

}  // namespace dupin::rounding
