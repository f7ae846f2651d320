#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "dupin/kernel/mesh.h"

namespace dupin::test {

/// The operands of a named arrangement of pipes; names ending in `_rot` are turned by an irrational
/// angle about an irrational axis. Besides those listed, there are families of any size K:
/// `star_K`, `star_general_K`, `coaxial_K` and `coaxial_flush_K` have K pipes through one point,
/// about axes in a plane or in space, or about one axis; `bundle_K` has K parallel ones that touch,
/// `row_K` K that do not; `rack_K` and `rack_eq_K` have K by K that cross; `header_K` and
/// `header_coarse_K` have K branches; `tee_thousands_K` has about K thousand triangles; `flush_K`
/// has two of K sides whose ends lie in one plane; `prismspin_K` and `gears_K` have K prisms, over
/// triangles and over stars, turned about their common axis, all ends in two planes. Throws
/// std::out_of_range for other names.
[[nodiscard]] std::vector<TriMesh> pipe_case(std::string_view name);

[[nodiscard]] std::vector<std::string> pipe_case_names();

}  // namespace dupin::test
