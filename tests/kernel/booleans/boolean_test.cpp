#include "dupin/kernel/boolean.h"

#include <cfenv>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "dupin/kernel/ring.h"
#include "dupin/kernel/rounding.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::joined;
using test::labelled;
using test::moved;

Solid box(const Vec3& low, const Vec3& high) { return Solid::from(test::box(low, high)); }
Solid cube(double low, double high) { return box(Vec3::Constant(low), Vec3::Constant(high)); }

// A triangular prism with the corners (0,0), (3,0), (0,3) of its base and a height of 3.
Solid wedge(const Vec3& offset) {
  TriMesh mesh;
  for (const double z : {0, 3}) {
    mesh.points.insert(mesh.points.end(), {Vec3(0, 0, z), Vec3(3, 0, z), Vec3(0, 3, z)});
  }
  mesh.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                    {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return Solid::from(moved(mesh, offset));
}

struct Case {
  const char* description;
  Solid a, b;
  mpq_class united, intersected, subtracted;  // volumes
  std::size_t shells, components;             // of the union
  std::int64_t genus;
};

std::vector<Case> cases() {
  const double third = 1.0 / 3;  // the double, no third
  const mpq_class side = mpq_class(1) - mpq_class(third), longer = side + 1;
  const mpq_class overlap = side * side * side, larger = longer * longer * longer;
  return {
      {"corners that overlap", cube(0, 2), cube(1, 3), 15, 1, 7, 1, 1, 0},
      {"by a length that is no short fraction", cube(0, 1), cube(third, 2), 1 + larger - overlap,
       overlap, 1 - overlap, 1, 1, 0},
      {"apart", cube(0, 1), cube(2, 3), 2, 0, 1, 2, 2, 0},
      {"one inside the other", cube(0, 5), cube(1, 2), 125, 1, 124, 1, 1, 0},
      {"equal", cube(0, 2), cube(0, 2), 8, 8, 0, 1, 1, 0},
      {"bar through a cube", cube(0, 3), box(Vec3(1, 1, -1), Vec3(2, 2, 4)), 29, 3, 24, 1, 1, 0},
      {"a whole face in common", cube(0, 2), box(Vec3(2, 0, 0), Vec3(4, 2, 2)), 16, 0, 8, 1, 1, 0},
      {"part of a face in common", cube(0, 2), box(Vec3(2, 1, 1), Vec3(4, 3, 3)), 16, 0, 8, 1, 1,
       0},
      {"a face inside a face", cube(0, 3), box(Vec3(3, 1, 1), Vec3(4, 2, 2)), 28, 0, 27, 1, 1, 0},
      {"two sides in common", cube(0, 2), box(Vec3(0, 0, 1), Vec3(2, 2, 3)), 12, 4, 4, 1, 1, 0},
      {"wedges crossing", wedge(Vec3::Zero()), wedge(Vec3(1, 1, 1)), mpq_class(26), mpq_class(1),
       mpq_class(25, 2), 1, 1, 0},
      {"a frame and the bar that fills it", Solid::from(test::frame()),
       box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), 72, 0, 64, 1, 1, 0},
      {"a frame and a bar across its hole", Solid::from(test::frame()),
       box(Vec3(-2, -0.5, -0.5), Vec3(2, 0.5, 0.5)), 66, 2, 62, 1, 1, 2},
      {"a bowl and its lid",
       Solid::from(joined({test::box(Vec3::Zero(), Vec3::Constant(5)),
                           test::reversed(test::box(Vec3::Constant(1), Vec3::Constant(4)))})),
       cube(2, 3), 99, 0, 98, 3, 2, 0},
  };
}

TEST(Boolean, volumes_and_topology_are_exact) {
  for (const Case& row : cases()) {
    SCOPED_TRACE(row.description);
    const std::vector<Solid> both = {row.a, row.b}, turned = {row.b, row.a};
    const Solid united = unite(both);
    EXPECT_EQ(united.exact_volume(), row.united);
    EXPECT_EQ(unite(turned).exact_volume(), row.united);
    EXPECT_EQ(intersect(both).exact_volume(), row.intersected);
    EXPECT_EQ(intersect(both).empty(), row.intersected == 0);
    EXPECT_EQ(subtract(row.a, {&row.b, 1}).exact_volume(), row.subtracted);
    EXPECT_EQ(united.shells(), row.shells);
    EXPECT_EQ(united.components(), row.components);
    EXPECT_EQ(united.genus(), row.genus);
  }
}

TEST(Boolean, laws_hold) {
  for (const Case& row : cases()) {
    SCOPED_TRACE(row.description);
    const std::vector<Solid> both = {row.a, row.b};
    EXPECT_EQ(row.a.exact_volume() + row.b.exact_volume(),
              unite(both).exact_volume() + intersect(both).exact_volume());
    EXPECT_EQ(row.a.exact_volume(),
              subtract(row.a, {&row.b, 1}).exact_volume() + intersect(both).exact_volume());
    const Solid itself[] = {row.a, row.a};
    EXPECT_EQ(unite(itself).exact_volume(), row.a.exact_volume());
  }
}

TEST(Boolean, many_operands_at_once) {
  std::vector<Solid> beam;
  for (int i = 0; i < 9; ++i) {
    const double x = i;
    beam.push_back(box(Vec3(x, 0, 0), Vec3(x + 1.5, 1, 1)));
    beam.push_back(box(Vec3(x, 5, 0), Vec3(x + 0.5, 6, 1)));
  }
  const Solid united = unite(beam);
  EXPECT_EQ(united.exact_volume(), mpq_class(19, 2) + mpq_class(9, 2));
  EXPECT_EQ(united.components(), 10U);

  const std::vector<Solid> nested = {cube(0, 4), cube(1, 5), cube(2, 6)};
  EXPECT_EQ(intersect(nested).exact_volume(), 8);
  const std::vector<Solid> cuts = {box(Vec3(1, 0, 0), Vec3(2, 4, 4)),
                                   box(Vec3(3, 0, 0), Vec3(9, 9, 9))};
  EXPECT_EQ(subtract(cube(0, 4), cuts).exact_volume(), 32);
}

// 3000 copies of a box were searched for what they have in common, all with all.
TEST(Boolean, an_operand_that_is_there_twice_does_what_it_does_once) {
  const Solid a = cube(0, 4), b = cube(1, 5);
  const std::vector<Solid> distinct = {a, b}, copies = {a, b, cube(0, 4), a, cube(1, 5)};
  const auto expect_alike = [](const Solid& x, const Solid& y) {
    EXPECT_EQ(x.triangles(), y.triangles());
    ASSERT_EQ(x.sources().size(), y.sources().size());
    for (std::size_t t = 0; t < x.sources().size(); ++t) {
      EXPECT_EQ(x.sources()[t].operand, y.sources()[t].operand);
      EXPECT_EQ(x.sources()[t].triangle, y.sources()[t].triangle);
    }
  };
  expect_alike(unite(copies), unite(distinct));
  expect_alike(intersect(copies), intersect(distinct));
  const std::vector<Solid> cut(3, b);
  expect_alike(subtract(a, cut), subtract(a, {&b, 1}));
  EXPECT_EQ(subtract(a, cut).exact_volume(), 64 - 27);
  EXPECT_EQ(unite(std::vector<Solid>(3, a)).exact_volume(), 64);
  EXPECT_TRUE(subtract(a, std::vector<Solid>(2, a)).empty());
}

TEST(Boolean, empty_operands_are_neutral) {
  const std::vector<Solid> with_nothing = {Solid(), cube(0, 2), Solid()};
  EXPECT_EQ(unite(with_nothing).exact_volume(), 8);
  EXPECT_TRUE(intersect(with_nothing).empty());
  EXPECT_EQ(subtract(with_nothing[1], {with_nothing.data(), 1}).exact_volume(), 8);
  EXPECT_TRUE(subtract(Solid(), with_nothing).empty());
  EXPECT_TRUE(unite({}).empty());
  EXPECT_TRUE(intersect({}).empty());
}

TEST(Boolean, a_hollow_stays_hollow_when_cut_from_inside) {
  const Solid inner = cube(1, 2);
  const Solid hollow = subtract(cube(0, 3), {&inner, 1});
  EXPECT_EQ(hollow.shells(), 2U);
  EXPECT_EQ(hollow.components(), 1U);
  EXPECT_EQ(hollow.euler_number(), 4);
}

// The pipe between two rings of one sampling; its end discs are fans from the first points.
TriMesh pipe(const Ring& from, const Ring& to, const RingSampling& sampling) {
  TriMesh mesh;
  mesh.points = sample(flipped(from), sampling);
  const auto end = sample(flipped(to), sampling);
  const std::uint32_t n = sampling.segments;
  mesh.points.insert(mesh.points.end(), end.begin(), end.end());
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
    if (i > 0 && i + 1 < n) {
      mesh.triangles.push_back({0, i + 1, i});
      mesh.triangles.push_back({n, n + i, n + i + 1});
    }
  }
  return mesh;
}

TEST(Boolean, a_chain_of_parts_that_share_rings_becomes_one_part) {
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  constexpr std::size_t kSegments = 16;
  constexpr std::size_t kParts = 12;
  const RingSampling sampling{kSegments, 0.37, 0};
  std::vector<Solid> parts;
  mpq_class volume;
  for (std::size_t i = 0; i < kParts; ++i) {
    const auto ring = [&](std::size_t station) {
      const auto at = static_cast<double>(station);
      return Ring{Vec3(0.1, 0.2, 0.3) + at * axis, -axis, 1 + 0.1 * (at * at - 3 * at)};
    };
    parts.push_back(Solid::from(pipe(ring(i), ring(i + 1), sampling)));
    volume += parts.back().exact_volume();
  }
  const Solid chain = unite(parts);
  EXPECT_EQ(chain.exact_volume(), volume);
  EXPECT_EQ(chain.shells(), 1U);
  EXPECT_EQ(chain.genus(), 0);
  EXPECT_EQ(chain.point_count(), (kParts + 1) * kSegments);
  EXPECT_EQ(chain.triangle_count(), kParts * 2 * kSegments + 2 * (kSegments - 2));
}

TEST(Boolean, results_know_their_sources_and_labels) {
  const std::vector<Solid> both = {
      Solid::from(labelled(test::box(Vec3::Zero(), Vec3::Constant(2)), "low")),
      Solid::from(labelled(test::box(Vec3::Constant(1), Vec3::Constant(3)), "high"))};
  const Solid united = unite(both);
  EXPECT_EQ(united.names(), (std::vector<std::string>{"low", "high"}));
  ASSERT_EQ(united.sources().size(), united.triangle_count());
  std::array<std::array<bool, 12>, 2> seen{};
  for (std::size_t i = 0; i < united.triangle_count(); ++i) {
    const Source source = united.sources()[i];
    ASSERT_LT(source.operand, 2U);
    ASSERT_LT(source.triangle, 12U);
    EXPECT_EQ(united.labels()[i], source.operand);
    seen[source.operand][source.triangle] = true;
    // A face of the result lies in the plane of its source: all faces are axis-parallel here.
    const Triangle& whole = both[source.operand].triangles()[source.triangle];
    const auto& corners = both[source.operand].nearest_points();
    for (int axis = 0; axis < 3; ++axis) {
      const double level = corners[whole[0]][axis];
      if (corners[whole[1]][axis] == level && corners[whole[2]][axis] == level) {
        for (const std::uint32_t corner : united.triangles()[i]) {
          EXPECT_EQ(united.exact_point(corner)[static_cast<std::size_t>(axis)], level);
        }
      }
    }
  }
  for (const auto& operand : seen) {
    for (std::size_t side = 0; side < operand.size(); side += 2) {
      EXPECT_TRUE(operand[side] || operand[side + 1]) << "each side keeps a part outside the other";
    }
  }
}

TEST(Boolean, booleans_of_booleans_stay_exact) {
  const Solid a = wedge(Vec3::Zero()), b = wedge(Vec3(0.1, 0.2, 0.3)),
              c = wedge(Vec3(0.7, 0.1, 0.9));
  const std::vector<Solid> ab = {a, b};
  const Solid first = unite(ab);
  bool all_doubles = true;
  for (std::uint32_t i = 0; i < first.point_count(); ++i) {
    all_doubles = all_doubles && first.exact_point(i)[0] == first.nearest_points()[i].x();
  }
  EXPECT_FALSE(all_doubles);
  const std::vector<Solid> stepwise = {first, c}, at_once = {c, a, b};
  EXPECT_EQ(unite(stepwise).exact_volume(), unite(at_once).exact_volume());
  EXPECT_EQ(unite(stepwise).volume(), unite(at_once).volume());
}

TEST(Boolean, a_contact_in_a_point_is_reported_or_refused) {
  const std::vector<Solid> both = {cube(0, 1), cube(1, 2)};
  const Solid united = unite(both);
  EXPECT_EQ(united.exact_volume(), 2);
  EXPECT_EQ(united.components(), 2U);
  EXPECT_EQ(united.point_count(), 16U);
  ASSERT_EQ(united.contacts().size(), 1U);
  EXPECT_EQ(united.contacts()[0].kind, Contact::Kind::vertex);
  EXPECT_EQ(united.contacts()[0].from, Vec3(1, 1, 1));
  try {
    (void)unite(both, {.contacts = ContactPolicy::refuse});
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::contact);
    EXPECT_STREQ(error.what(), "the result touches itself in 1 place, first at (1, 1, 1)");
  }
}

TEST(Boolean, a_callback_can_cancel) {
  const std::vector<Solid> both = {cube(0, 2), cube(1, 3)};
  try {
    (void)unite(both, {.progress = [](std::string_view, double) { return false; }});
    FAIL() << "should have thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::cancelled);
  }
}

TEST(Boolean, is_the_same_whatever_way_the_caller_rounds) {
  std::vector<TriMesh> meshes;
  for (const double turn : {0.1, 0.7, 1.3}) {
    TriMesh& tube = meshes.emplace_back(test::tube(1, -3, 3, 12));
    for (Vec3& p : tube.points) {
      p = Eigen::AngleAxisd(turn, Vec3(turn, 1, 2).normalized()) * p;
    }
  }
  const auto made = [&] {
    std::vector<Solid> tubes;
    for (const TriMesh& mesh : meshes) {
      tubes.push_back(Solid::from(mesh));
    }
    const Solid united = unite(tubes);
    return std::pair(united.exact_volume(), to_mesh(united, Coordinates::binary32).mesh().points);
  };
  const auto usual = made();
  std::fesetround(FE_UPWARD);
  const auto upward = made();
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(upward, usual);
}

}  // namespace
}  // namespace dupin
