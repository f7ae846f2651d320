#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <gmpxx.h>

#include "dupin/kernel/boolean_expression.h"
#include "dupin/kernel/progress.h"
#include "dupin/kernel/set_operation.h"
#include "dupin/kernel/solid.h"

/// A second opinion on set operations, by engines of CGAL that share no code with ours. Both
/// construct points with exact coordinates, so results are compared without any tolerance: volumes
/// as rationals, and sets by their boundaries, which are the same or differ in a place.
///
/// Needs packages of CGAL under the GPL, so it is an option of the build (DUPIN_CROSS_CHECK);
/// without it, the functions throw Error{invalid_argument}.
namespace dupin {

enum class CrossCheckEngine : std::uint8_t {
  /// Nef polyhedra: general; hundreds to thousands of times slower than ours.
  nef,
  /// Corefinement of two surfaces at a time: refuses results that touch themselves along an edge;
  /// where they do in a point, CGAL 5.5's may never end. For operands in general position.
  corefinement,
};

[[nodiscard]] std::string_view name(CrossCheckEngine engine);  ///< as its enumerator

/// Whether the engines are part of this build.
[[nodiscard]] bool has_cross_check();

/// The same set by another engine; without labels, its sources are {0, i}. Throws
/// Error{boolean_failed} with the engine's own words where it fails: both refuse an operand of
/// which one shell touches itself (corefinement: any shells), and a result whose boundary is no
/// 2-manifold (corefinement: along an edge). Throws Error{cancelled}; progress is told between the
/// operations on two sets, and nothing stops within one. What the caller's callback throws passes
/// through all of these as it is.
[[nodiscard]] Solid combine_by(CrossCheckEngine engine, SetOperation operation,
                               std::span<const Solid> operands, const Progress& progress = {});
/// Throws Error{invalid_argument} for an operand that is missing.
[[nodiscard]] Solid evaluate_by(CrossCheckEngine engine, const Expression& expression,
                                const std::map<std::string, Solid>& operands,
                                const Progress& progress = {});

/// What another engine says about a result.
struct CrossCheck {
  enum class Verdict : std::uint8_t {
    agrees,         ///< it is the same set: the boundaries are equal, and so are the volumes
    disagrees,      ///< it is another set
    engine_failed,  ///< the other engine has no result: no opinion
  };
  CrossCheckEngine engine = CrossCheckEngine::nef;
  Verdict verdict = Verdict::engine_failed;
  mpq_class volume;        ///< of the result
  mpq_class other_volume;  ///< of the other engine's, 0 where it has none
  /// Where they disagree: a corner of the symmetric difference (the nearest doubles), the first in
  /// the order of coordinates. Any neighbourhood of it holds places in just one of both sets.
  std::optional<Vec3> place;
  std::string failure;  ///< why the other engine has no result, in its own words
};

[[nodiscard]] std::string_view name(CrossCheck::Verdict verdict);

/// Does the operation again by another engine and compares. Results that touch themselves are
/// compared like any other where Nef polyhedra do it. Besides the engine's own cost O(n log n).
/// Throws Error{cancelled}; the engine's own failures are a verdict.
[[nodiscard]] CrossCheck second_opinion(const Solid& result, CrossCheckEngine engine,
                                        SetOperation operation, std::span<const Solid> operands,
                                        const Progress& progress = {});
/// Throws Error{invalid_argument} for an operand that is missing.
[[nodiscard]] CrossCheck second_opinion(const Solid& result, CrossCheckEngine engine,
                                        const Expression& expression,
                                        const std::map<std::string, Solid>& operands,
                                        const Progress& progress = {});

}  // namespace dupin
