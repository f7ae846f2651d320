#pragma once

#include "assembly/parts/part_rules_of_shape.h"

namespace dupin::assembly {

template <KeyName key>
References references_by_rules(const PartShape& shape) {
  return of_shape<key, References>(
      shape, [](const auto& given) { return PartRules<key>::references(given); });
}

template <KeyName key>
std::string_view portless_by_rules(const PartShape& shape) {
  return of_shape<key, std::string_view>(
      shape, []([[maybe_unused]] const auto& given) -> std::string_view {
        if constexpr (requires { PartRules<key>::portless(given); }) {
          return PartRules<key>::portless(given);
        } else {
          return {};
        }
      });
}

template <KeyName key>
PartSurface geometry_by_rules(const PartContext& context, const PartShape& shape) {
  return of_shape<key, PartSurface>(shape, [&]([[maybe_unused]] const auto& given) -> PartSurface {
    if constexpr (requires { PartRules<key>::geometry(context, given); }) {
      return PartRules<key>::geometry(context, given);
    } else {
      throw std::bad_variant_access();
    }
  });
}

template <KeyName key>
PartNotes notes_by_rules(const PartShape& shape, const PartSurface& surface) {
  return of_shape<key, PartNotes>(shape, [&]([[maybe_unused]] const auto& given) -> PartNotes {
    if constexpr (requires { PartRules<key>::notes(given, surface); }) {
      return PartRules<key>::notes(given, surface);
    } else {
      return {};
    }
  });
}

template <KeyName key>
FilletPipes pipes_by_rules(const PartShape& shape) {
  return of_shape<key, FilletPipes>(shape,
                                    [](const auto& given) { return PartRules<key>::pipes(given); });
}

template <KeyName key>
Fillet fillet_by_rules(const PartContext& context, const PartShape& shape,
                       const TubesToFillet& pipes) {
  return of_shape<key, Fillet>(
      shape, [&](const auto& given) { return PartRules<key>::fillet(context, given, pipes); });
}

template <KeyName key>
void find_loops_by_rules(const Assembly& assembly, const PartShape& shape,
                         const TubesToFillet& pipes, Fillet& fillet) {
  of_shape<key, void>(shape, [&](const auto& given) {
    PartRules<key>::find_loops(assembly, given, pipes, fillet);
  });
}

template <KeyName key>
void prove_by_rules(const Assembly& assembly, const PartShape& shape, const TubesToFillet& pipes,
                    Fillet& fillet) {
  of_shape<key, void>(
      shape, [&](const auto& given) { PartRules<key>::prove(assembly, given, pipes, fillet); });
}

template <KeyName key>
References ends_by_rules(const PartShape& shape) {
  return of_shape<key, References>(shape,
                                   [](const auto& given) { return PartRules<key>::ends(given); });
}

template <KeyName key>
JunctionOfEnds junction_by_rules(const PartContext& context, const PartShape& shape) {
  return of_shape<key, JunctionOfEnds>(
      shape, [&](const auto& given) { return PartRules<key>::junction(context, given); });
}

template <KeyName key>
std::vector<Need> needs_by_rules(const PartShape& shape) {
  return of_shape<key, std::vector<Need>>(
      shape, []([[maybe_unused]] const auto& given) -> std::vector<Need> {
        if constexpr (requires { PartRules<key>::needs(given); }) {
          return PartRules<key>::needs(given);
        } else {
          return {};
        }
      });
}

template <KeyName key>
PartSurface bore_by_rules(const PartShape& shape, const PartSurface& surface, double wall) {
  return of_shape<key, PartSurface>(
      shape, [&](const auto& given) { return PartRules<key>::bore(given, surface, wall); });
}

template <KeyName key>
double least_wall_by_rules(const PartShape& shape, const PartSurface& surface, double wall) {
  return of_shape<key, double>(
      shape, [&](const auto& given) { return PartRules<key>::least_wall(given, surface, wall); });
}

template <KeyName key>
constexpr PartKind with_walls(PartKind kind) {
  if constexpr (requires { PartRules<key>::kClosedEnds; }) {
    kind.closed_ends = PartRules<key>::kClosedEnds;
  }
  if constexpr (requires { PartRules<key>::kIsPad; }) {
    kind.is_pad = PartRules<key>::kIsPad;
  }
  if constexpr (requires { PartRules<key>::kHasBore; }) {
    kind.bore = bore_by_rules<key>;
    kind.least_wall = least_wall_by_rules<key>;
  }
  return kind;
}

template <KeyName key>
constexpr PartKind with_fillet(PartKind kind) {
  if constexpr (requires { PartRules<key>::pipes; }) {
    kind.pipes = pipes_by_rules<key>;
    kind.fillet = fillet_by_rules<key>;
  }
  if constexpr (requires { PartRules<key>::prove; }) {
    kind.find_loops = find_loops_by_rules<key>;
    kind.prove = prove_by_rules<key>;
  }
  if constexpr (requires { PartRules<key>::ends; }) {
    kind.ends = ends_by_rules<key>;
    kind.junction = junction_by_rules<key>;
  }
  return kind;
}

template <KeyName key>
const PartKind& part_kind() {
  static_assert(PartKeys::kHas<key>, "the table of keys, PartKeys, lacks this one");
  using Rules = PartRules<key>;
  static constexpr PartKind kKind = with_walls<key>(with_fillet<key>(
      {key.view(), IsTangent<Rules>, NamesEnd<Rules>, references_by_rules<key>,
       portless_by_rules<key>, geometry_by_rules<key>, notes_by_rules<key>, needs_by_rules<key>}));
  return kKind;
}

}  // namespace dupin::assembly
