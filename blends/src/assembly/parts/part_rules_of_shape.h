#pragma once

#include <concepts>
#include <variant>

#include "assembly/parts/part_kind.h"

namespace dupin::assembly {

/// What a key means, for each of its shapes. The file of the key's name specialises it with static
/// members and then instantiates part_kind for the key, which checks that nothing is missing:
///
///     template <>
///     struct PartRules<"sphere"> {
///       static References references(const SphereAt& sphere);
///       static PartSurface geometry(const PartContext& context, const SphereAt& sphere);
///     };
///     template const PartKind& part_kind<"sphere">();
///
/// A fillet has, instead of a geometry, `pipes(shape)` and `fillet(context, shape, pipes)`.
/// What it need not say: `needs(shape)` (no other parts' surfaces), `kIsTangent` and `kNamesEnd`
/// (false; a kind that names an end has no geometry), `kClosedEnds` (none), `kIsPad` (false),
/// `portless(shape)` (it has ports), `notes(shape, surface)` (none), `kHasBore` with
/// `bore(shape, surface, wall)` and `least_wall(shape, surface, wall)` (the same rings, less by the
/// wall).
template <KeyName key>
struct PartRules;

template <class Rules>
concept IsTangent = requires {
  requires Rules::kIsTangent;
};

template <class Rules>
concept NamesEnd = requires {
  requires Rules::kNamesEnd;
};

template <class Rules, class Shape>
concept IsFillet = requires(const PartContext& context, const Shape& shape,
                            const TubesToFillet& pipes) {
  { Rules::pipes(shape) } -> std::same_as<FilletPipes>;
  { Rules::fillet(context, shape, pipes) } -> std::same_as<Fillet>;
};

template <class Rules, class Shape>
concept IsJunction = requires(const PartContext& context, const Shape& shape) {
  { Rules::ends(shape) } -> std::same_as<References>;
  { Rules::junction(context, shape) } -> std::same_as<JunctionOfEnds>;
};

template <class Rules, class Shape>
concept HasGeometry = requires(const PartContext& context, const Shape& shape) {
  { Rules::geometry(context, shape) } -> std::convertible_to<PartSurface>;
};

template <class Rules, class Shape>
concept HasReferences = requires(const Shape& shape) {
  { Rules::references(shape) } -> std::same_as<References>;
};

template <class Rules, class Shape>
concept RulesFor = HasReferences<Rules, Shape> &&
    (NamesEnd<Rules> || IsFillet<Rules, Shape> || IsJunction<Rules, Shape> ||
     HasGeometry<Rules, Shape>);

/// What `work` returns of the shape, which is one of the key's.
template <KeyName key, class Result, class Work>
Result of_shape(const PartShape& shape, const Work& work) {
  return std::visit(
      [&]<class Shape>(const Shape& given) -> Result {
        if constexpr (PartKeys::kNameOf<Shape> == key) {
          static_assert(RulesFor<PartRules<key>, Shape>,
                        "PartRules need references() and geometry() of every shape of their key");
          return work(given);
        } else {
          throw std::bad_variant_access();
        }
      },
      shape);
}

}  // namespace dupin::assembly
