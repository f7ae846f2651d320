#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/rounding.h"
#include "support/nasty_shapes.h"

/// Every pair of shapes that are hard on set operations, by four operations each.
namespace dupin {
namespace {

struct Named {
  std::string name;
  Solid solid;
};

const std::vector<Named>& solids() {
  static const std::vector<Named> all = [] {
    std::vector<Named> solids;
    for (const test::NastyShape& shape : test::nasty_shapes()) {
      if (!shape.refused) {
        solids.push_back({shape.name, Solid::from(shape.mesh)});
      }
    }
    return solids;
  }();
  return all;
}

/// Read back as it would be written, it is a solid; or the reason is that doubles cannot tell it.
void expect_writable(const Solid& solid) {
  try {
    const Rounded rounded = to_mesh(solid, Coordinates::binary64);
    EXPECT_TRUE(rounded.mesh().triangles.empty() || check(rounded.mesh()).is_solid());
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::unroundable) << error.what();
  }
}

void expect_volumes_add_up(const Solid& a, const Solid& b) {
  const Solid either = unite(std::vector{a, b}), both = intersect(std::vector{a, b});
  const Solid less = subtract(a, std::vector{b}), other_less = subtract(b, std::vector{a});
  const mpq_class common = both.exact_volume();
  EXPECT_EQ(either.exact_volume(), a.exact_volume() + b.exact_volume() - common);
  EXPECT_EQ(less.exact_volume(), a.exact_volume() - common);
  EXPECT_EQ(other_less.exact_volume(), b.exact_volume() - common);
  EXPECT_GE(common, 0);
  EXPECT_EQ(intersect(std::vector{b, a}).exact_volume(), common);
  for (const Solid* result : {&either, &both, &less, &other_less}) {
    expect_writable(*result);
  }
}

TEST(NastyPairs, of_solids_give_volumes_that_add_up) {
  const std::vector<Named>& all = solids();
  ASSERT_GE(all.size(), 20);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i; k < all.size(); ++k) {
      SCOPED_TRACE(all[i].name + " and " + all[k].name);
      expect_volumes_add_up(all[i].solid, all[k].solid);
    }
  }
}

TEST(NastyPairs, with_what_is_no_solid_are_refused_or_repaired) {
  for (const test::NastyShape& shape : test::nasty_shapes()) {
    if (!shape.refused) {
      continue;
    }
    SCOPED_TRACE(shape.name);
    try {
      static_cast<void>(Solid::from(shape.mesh));
      ADD_FAILURE() << "not refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), *shape.refused) << error.what();
    }
    std::optional<Solid> repaired;
    try {
      repaired = repair(shape.mesh).solid;
    } catch (const Error& error) {
      EXPECT_THAT(error.code(), testing::AnyOf(Errc::not_closed, Errc::invalid_argument))
          << error.what();
      continue;
    }
    EXPECT_NE(shape.refused, Errc::not_closed);
    for (const Named& other : solids()) {
      SCOPED_TRACE(other.name);
      expect_volumes_add_up(*repaired, other.solid);
    }
  }
}

}  // namespace
}  // namespace dupin
