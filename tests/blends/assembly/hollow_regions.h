#pragma once

#include <optional>

#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/rounding.h"

namespace dupin::test {

inline Built built(const Assembly& assembly, std::optional<Region> region) {
  BuildOptions options;
  options.region = region;
  return build(assembly, options);
}

struct Regions {
  Built outer, metal, fluid;
};

// All three, of which the outer one is the sum.
inline Regions regions(const Assembly& assembly) {
  Regions all{built(assembly, Region::outer), built(assembly, Region::metal),
              built(assembly, Region::fluid)};
  EXPECT_EQ(all.outer.solid.exact_volume(),
            all.metal.solid.exact_volume() + all.fluid.solid.exact_volume());
  EXPECT_GT(all.metal.solid.volume(), 0);
  EXPECT_GT(all.fluid.solid.volume(), 0);
  double metal = 0;
  for (const Solid& district : all.metal.districts) {
    metal += district.volume();
  }
  for (const Built* one : {&all.outer, &all.metal, &all.fluid}) {
    EXPECT_TRUE(check(to_mesh(one->solid).mesh()).is_solid());
    EXPECT_EQ(one->volumes->metal, metal);
  }
  return all;
}

}  // namespace dupin::test
