#pragma once

#include <cmath>
#include <string_view>

/// The unions of pipes (tests/support/pipe_cases.h) whose volume is known, for all programs that
/// measure unions.
namespace dupin::bench {

struct UnionCase {
  std::string_view name;
  double volume;
  bool is_quick;
  bool corefine;  ///< CGAL's corefinement takes this pair in a few seconds
};

/// Volumes by Nef polyhedra, else by CGAL's corefinement, else by Manifold, to the digits given;
/// those of stars and coaxial pipes by an arrangement of all at once.
inline constexpr UnionCase kUnionCases[] = {{"tee_10k", 45.3536257847, true, true},
                                            {"tee_10k_rot", 45.3536257847, true, true},
                                            {"tee_100k", 45.3704349115, true, true},
                                            {"tee_100k_rot", 45.3704349115, true, true},
                                            {"tee_1M", 45.3714856204, false, true},
                                            {"tee_1M_rot", 45.3714856204, false, true},
                                            {"header_10", 33.9090906937, true, true},
                                            {"header_10_rot", 33.9090906937, true, true},
                                            {"header_100", 310.861969283, true, true},
                                            {"header_100_rot", 310.861969283, true, true},
                                            {"header_1000", 3080.39075241, false, false},
                                            {"header_1000_rot", 3080.39075241, false, false},
                                            {"rack", 766.619264157, false, true},
                                            {"rack_rot", 766.619264157, false, false},
                                            {"rack_fine", 766.619264157, false, true},
                                            {"rack_fine_rot", 766.619264157, false, true},
                                            {"rack_eq", 666.751802906, false, false},
                                            {"rack_eq_rot", 666.751802906, false, false},
                                            {"blend_1", 3.66059546586, true, true},
                                            {"blend_1_fan", 3.66059546586, true, false},
                                            {"chain_100", 244.585937639, false, true},
                                            {"chain_100_fan", 244.585937639, false, false},
                                            {"star_8", 17.2239547743, true, false},
                                            {"star_8_rot", 17.2239547743, true, false},
                                            {"star_20", 22.011367079, true, false},
                                            {"star_20_rot", 22.011367079, true, false},
                                            {"star_40", 22.586871262, false, false},
                                            {"star_40_rot", 22.586871262, false, false},
                                            {"star_general_20", 43.1917098307, true, false},
                                            {"star_general_40", 71.8331703636, false, false},
                                            {"coaxial_20", 34.3840263024, true, false},
                                            {"coaxial_20_rot", 34.3840263024, true, false},
                                            {"coaxial_40", 37.5256094212, false, false},
                                            {"coaxial_flush_20", 31.4026038202, false, false},
                                            {"coaxial_flush_20_rot", 31.4026038202, false, false}};

/// Whether a volume is that of the case, as far as it is known.
inline bool has_known_volume(std::string_view name, double volume, double tolerance) {
  for (const UnionCase& row : kUnionCases) {
    if (row.name == name) {
      return std::abs(volume - row.volume) < tolerance * row.volume;
    }
  }
  return true;
}

}  // namespace dupin::bench
