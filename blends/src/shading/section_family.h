#pragma once

#include <functional>
#include <vector>

#include "dupin/blends/canal_fillet.h"
#include "dupin/blends/part_surface.h"
#include "dupin/kernel/vec.h"

// This folder: the normals of the smooth surfaces that a mesh stands for, at its points, for
// viewers. A piece of a tube is a family of circles or ellipses (section_family.h), in whose
// planes points find their parameter (swept_patch.h); with balls, discs and rims these are the
// patches (patch.h) that names stand for and that may be tangent to each other (patch_table.h).
// vertex_normals.h puts one normal for each patch, or for several that are tangent, at each point.

namespace dupin::shading {

/// The circle or ellipse of a tube at one parameter.
struct Section {
  Vec3 center = Vec3::Zero(), normal = Vec3::UnitZ();  ///< the latter unit, along increasing t
  Vec3 axis = Vec3::UnitX();                           ///< unit, of the semi-axis `along`
  double along = 1, across = 1;                        ///< semi-axes; equal for circles

  /// How far the curve is from the centre in a unit direction across the normal.
  [[nodiscard]] double radius(const Vec3& direction) const;
};

/// A tube, or part of one, swept by sections for t in [0, 1].
struct SectionFamily {
  std::function<Section(double t)> section;
  /// The surface's normal, to either side, where the section at t is met in a unit direction from
  /// its centre. Of length 1 to rounding, or not finite where there is none.
  std::function<Vec3(double t, const Vec3& direction)> normal;
};

[[nodiscard]] SectionFamily section_family(const Piece& piece);

/// The whole envelope of the rolling ball, of which the fillet is the arc between its feet: one
/// family for each stretch between two corners, where the ball turns without moving.
[[nodiscard]] std::vector<SectionFamily> section_families(const CanalFillet& fillet);

}  // namespace dupin::shading
