#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/solid.h"
#include "kernel/exact_validity_internal.h"
#include "support/pipe_cases.h"

namespace dupin::test {

inline std::vector<Solid> operands(std::string_view name) {
  std::vector<Solid> solids;
  for (const TriMesh& mesh : pipe_case(name)) {
    solids.push_back(Solid::from(mesh));
  }
  return solids;
}

inline void expect_valid(const Solid& solid) {
  EXPECT_TRUE(test::is_closed_manifold(solid.exact()));
  EXPECT_EQ(test::self_intersections(solid.exact()), 0U);
}

inline void expect_valid_when_rounded(const Solid& solid) {
  for (const Coordinates coordinates : {Coordinates::binary64, Coordinates::binary32}) {
    const Rounded rounded = to_mesh(solid, coordinates);
    const Report report = check(rounded.mesh());
    EXPECT_TRUE(report.is_solid());
    EXPECT_NEAR(report.volume, solid.volume(), 1e-6 * solid.volume());
  }
}

struct Row {
  const char* name;
  double volume;  // by Nef polyhedra or corefinement, where one of them could
  std::size_t components, contacts;
};

inline void expect_known_union(const Row& row) {
  const Solid united = unite(operands(row.name));
  EXPECT_NEAR(united.volume(), row.volume, 1e-11 * row.volume);
  EXPECT_EQ(united.components(), row.components);
  EXPECT_EQ(united.contacts().size(), row.contacts);
  expect_valid(united);
  expect_valid_when_rounded(united);
}

}  // namespace dupin::test
