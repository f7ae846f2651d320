#pragma once

#include <optional>
#include <span>

#include "dupin/kernel/vec.h"

namespace dupin {

/// How a viewer infinitely far away sees: three orthonormal vectors, of which `right` and `up` span
/// the picture and right x up = towards points to the viewer.
struct View {
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), towards = Vec3::UnitZ();

  /// The place in the picture, and how near it is to the viewer.
  [[nodiscard]] Vec3 operator()(const Vec3& point) const {
    return {right.dot(point), up.dot(point), towards.dot(point)};
  }
};

/// Looking along `direction`. What points along `up` is upwards in the picture; none: z, or where
/// that is the direction looked along, y. Throws Error{invalid_argument} for vectors that are not
/// finite or zero, and for an `up` along the direction.
[[nodiscard]] View view_along(const Vec3& direction, const std::optional<Vec3>& up = {});

/// The picture in which most of the vectors are seen along `right`, by length and either way round,
/// and of what they have across that most along `up`; none where no vector has a length. Looks at
/// each some 30 times.
[[nodiscard]] std::optional<View> view_of_most(std::span<const Vec3> vectors);

}  // namespace dupin
