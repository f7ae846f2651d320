#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dupin/blends/assembly.h"
#include "dupin/blends/certificate.h"
#include "dupin/blends/tessellation.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/vec.h"

namespace dupin {

struct CertifyOptions {
  /// To be proven of every part, in [0, 1); none: nearly the largest that holds.
  std::optional<double> margin = {};
  /// Boxes of parameters that one claim may be divided into before it is left undecided.
  std::size_t boxes = 1 << 14;
  /// That all searches together may take for each 64 parts, in units of a few microseconds; far
  /// pairs are not counted. When it is used up, what is not found at the first look is undecided.
  std::uint64_t work = 3 << 18;
  /// Pairs of parts that are certain to be at least so far from each other have one claim for all;
  /// 0: none of them, all have a claim of their own. None: 0 for up to 64 parts, else twice the
  /// tolerance, so that the meshes of those pairs cannot cross either.
  std::optional<double> apart = {};
  /// What the parts' meshes may have together, as in BuildOptions.
  std::size_t most_triangles = kUsualTriangles;
  Progress progress = {};  ///< may be empty
};

/// Proves what it can about the smooth parts and their meshes, in exact rational or outward rounded
/// arithmetic; what it cannot is undecided. Throws as `resolve` and `tessellate` do, and
/// Error{invalid_argument} for a margin outside [0, 1) or a negative distance. Tells the stages
/// "certify parts", "certify meshes" and "certify clearances".
[[nodiscard]] Certificate certify(const Assembly& assembly, const CertifyOptions& options = {});

/// Where a part comes nearest to folding.
struct MarginPlace {
  std::string part;
  double parameter = 0;        ///< i + t on the i-th piece of the part
  Vec3 center = Vec3::Zero();  ///< of its disc there
  double radius = 0;           ///< about that of the disc
};

/// Of each part but spheres and the arms of junctions, in document order: the middle of the 32nd
/// of a piece on which the bound of min(1 - kappa R) is least. For looking: the margins that are
/// certified are those of PartReport. Throws as `resolve`.
[[nodiscard]] std::vector<MarginPlace> margin_places(const Assembly& assembly);

}  // namespace dupin
