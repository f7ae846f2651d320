#include "dupin/blends/resolve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/single_piece.h"

namespace dupin {
namespace {

constexpr double kPi = std::numbers::pi;

PortReference start_of(const std::string& part) { return {part, End::start}; }
PortReference end_of(const std::string& part) { return {part, End::end}; }

ResolvedAssembly resolved(std::vector<Part> parts) {
  return resolve({"", Unit::millimetre, 0.05, {}, std::move(parts)});
}

const RingedSurface& surface(const ResolvedAssembly& assembly, std::size_t part) {
  return test::single_piece<RingedSurface>(assembly.parts.at(part).shape);
}

// A chain of all kinds of parts that begin at ports, from a place in general position.
std::vector<Part> chain(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  return {{"a", PipeAlong{Place{100 * vector(), vector(), 1}, 5}},
          {"b", ElbowTurning{end_of("a"), 3, 1 + uniform(random), vector()}},
          {"c", PipeAlong{end_of("b"), 2}},
          {"d", ConeAlong{end_of("c"), 3, 1.5}},
          {"e", PipeAlong{end_of("d"), 2}},
          {"f", ElbowTurning{end_of("e"), 4, kPi / 2, vector()}},
          {"g", PipeAlong{start_of("a"), 2}}};
}

TEST(Resolve, shares_rings_bitwise) {
  std::mt19937_64 random(20303);
  for (int i = 0; i < 100; ++i) {
    const auto assembly = resolved(chain(random));
    int joints = 0;
    for (std::size_t part = 0; part < assembly.parts.size(); ++part) {
      for (const auto end : {End::start, End::end}) {
        const auto& joined = assembly.parts[part].joined.at(end == End::start ? 0 : 1);
        if (!joined) {
          continue;
        }
        ++joints;
        const auto ring = [&](std::size_t index, End which) {
          return which == End::start ? surface(assembly, index).start
                                     : surface(assembly, index).end;
        };
        EXPECT_EQ(ring(part, end), flipped(ring(joined->part, joined->end)));
      }
    }
    EXPECT_EQ(joints, 12);
  }
}

TEST(Resolve, spines_and_laws_agree_with_the_stored_rings) {
  std::mt19937_64 random(20304);
  for (int i = 0; i < 100; ++i) {
    const auto assembly = resolved(chain(random));
    for (std::size_t part = 0; part < assembly.parts.size(); ++part) {
      const auto& s = surface(assembly, part);
      const SpinePoint from = evaluate(s.spine, 0), to = evaluate(s.spine, 1);
      // A few units in the last place of coordinates of 100.
      constexpr double kClose = 1e-12;
      EXPECT_LT((from.position - s.start.center).norm(), kClose);
      EXPECT_LT((to.position - s.end.center).norm(), kClose);
      EXPECT_LT((from.first.normalized() + s.start.normal).norm(), kClose);
      EXPECT_LT((to.first.normalized() - s.end.normal).norm(), kClose);
      EXPECT_EQ(evaluate(s.radius, 0).value, s.start.radius);
      EXPECT_EQ(evaluate(s.radius, 1).value, s.end.radius);
    }
  }
}

TEST(Resolve, does_not_depend_on_the_order_of_parts) {
  std::mt19937_64 random(20305);
  auto parts = chain(random);
  const auto forward = resolved(parts);
  std::reverse(parts.begin(), parts.end());
  const auto backward = resolved(parts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t mirrored = parts.size() - 1 - i;
    EXPECT_EQ(forward.parts[i].name, backward.parts[mirrored].name);
    EXPECT_EQ(surface(forward, i).start, surface(backward, mirrored).start);
    EXPECT_EQ(surface(forward, i).end, surface(backward, mirrored).end);
  }
}

TEST(Resolve, turns_elbows_exactly_by_quarter_turns) {
  for (int quarters = 1; quarters <= 3; ++quarters) {
    const auto assembly = resolved({{"a", ElbowTurning{Place{Vec3::Zero(), Vec3::UnitX(), 1}, 3,
                                                       quarters * kPi / 2, Vec3::UnitY()}}});
    const Vec3 centers[] = {Vec3(3, 3, 0), Vec3(0, 6, 0), Vec3(-3, 3, 0)};
    const Vec3 normals[] = {Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)};
    EXPECT_EQ(surface(assembly, 0).end.center, centers[quarters - 1]);
    EXPECT_EQ(surface(assembly, 0).end.normal, normals[quarters - 1]);
  }
}

TEST(Resolve, an_elbow_to_a_point_is_the_tangent_arc) {
  std::mt19937_64 random(20306);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 direction = Vec3(uniform(random), uniform(random), uniform(random)).normalized();
    const Vec3 toward(uniform(random), uniform(random), uniform(random));
    const double angle = 0.1 + 3 * (1 + uniform(random));
    const auto turned =
        resolved({{"a", ElbowTurning{Place{Vec3(1, 2, 3), direction, 1}, 5, angle, toward}}});
    const Ring expected = surface(turned, 0).end;
    const auto led =
        resolved({{"a", ElbowTo{Place{Vec3(1, 2, 3), direction, 1}, expected.center}}});
    const auto& arc = std::get<ArcSpine>(surface(led, 0).spine);
    EXPECT_EQ(surface(led, 0).end.center, expected.center);
    EXPECT_LT((surface(led, 0).end.normal - expected.normal).norm(), 1e-11);
    EXPECT_NEAR(arc.angle, angle, 1e-11);
    EXPECT_NEAR((arc.start - arc.center).norm(), 5, 1e-9);
  }
}

TEST(Resolve, an_elbow_round_a_corner_ends_along_its_second_leg) {
  const auto assembly = resolved(
      {{"a", PipeBetween{Vec3(-5, 0, 0), Vec3(0, 0, 0), 1}},
       {"b", ElbowCorner{end_of("a"), Vec3(3, 0, 0), Vec3(3, 0, 3)}},
       {"c", ElbowCorner{end_of("b"), Vec3(3, 0, 6.01), Vec3(1.5, 1.5, 6.01 + std::sqrt(4.5))}}});
  EXPECT_EQ(surface(assembly, 1).end, (Ring{Vec3(3, 0, 3), Vec3(0, 0, 1), 1, 0}));
  EXPECT_DOUBLE_EQ(std::get<ArcSpine>(surface(assembly, 1).spine).angle, kPi / 2);
  // The legs of 3.01 and 3 leave the end 0.01 short along the first.
  EXPECT_LT((surface(assembly, 2).end.center - Vec3(1.5, 1.5, 6 + std::sqrt(4.5))).norm(), 1e-14);
  EXPECT_LT((surface(assembly, 2).end.normal - Vec3(-0.5, 0.5, std::sqrt(0.5))).norm(), 1e-15);
}

TEST(Resolve, cones_know_their_half_angle) {
  const auto assembly = resolved(
      {{"a", ConeBetween{Vec3(0, 0, 0), Vec3(4, 0, 0), 1, 3}}, {"b", PipeAlong{end_of("a"), 2}}});
  EXPECT_EQ(surface(assembly, 0).start.slope, -0.5);
  EXPECT_EQ(surface(assembly, 0).end.slope, 0.5);
  EXPECT_EQ(surface(assembly, 1).start.slope, -0.5);  // the shared ring's
  EXPECT_EQ(surface(assembly, 1).end.slope, 0);
}

TEST(Resolve, names_ends_after_caps_or_ports) {
  const auto assembly = resolved({{"a", PipeBetween{Vec3(0, 0, 0), Vec3(4, 0, 0), 1}},
                                  {"lid", CapAt{start_of("a")}},
                                  {"b", SphereAt{Vec3(9, 9, 9), 1}}});
  ASSERT_EQ(assembly.parts.size(), 2U);
  EXPECT_EQ(assembly.parts[0].end_names[0], "lid");
  EXPECT_EQ(assembly.parts[0].end_names[1], "a.end");
  EXPECT_EQ(assembly.parts[1].index, 2U);
  std::vector<std::string> names;
  for (const auto& port : ports(assembly)) {
    names.push_back(port.name);
  }
  EXPECT_THAT(names, testing::ElementsAre("a.start", "a.end"));
}

std::vector<std::string> port_names(std::vector<Part> parts) {
  std::vector<std::string> names;
  for (const Port& port : ports(resolved(std::move(parts)))) {
    names.push_back(port.name);
  }
  return names;
}

TEST(Resolve, starts_of_branches_in_their_runs_are_no_ports_unless_they_are_joined) {
  using testing::Contains;
  using testing::ElementsAre;
  using testing::Not;
  const Part run{"run", PipeBetween{{0, 0, 0}, {20, 0, 0}, 2}};
  const auto branch = [](double at, double radius) {
    return Part{"branch", PipeOn{"run", at, Vec3::UnitY(), 5, radius}};
  };
  EXPECT_THAT(port_names({run, branch(10, 1)}), ElementsAre("run.start", "run.end", "branch.end"));
  EXPECT_THAT(port_names({branch(10, 2), run}), Not(Contains("branch.start")));  // as thick
  EXPECT_THAT(port_names({run, branch(10, 2.1)}), Contains("branch.start"));     // stands out
  EXPECT_THAT(port_names({run, branch(0.5, 1)}), Contains("branch.start"));      // at its rim
  EXPECT_THAT(port_names({run, branch(10, 1), {"back", PipeAlong{start_of("branch"), 5}}}),
              Contains("branch.start"));
}

TEST(Resolve, refuses_numbers_that_are_not) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const std::pair<PartShape, std::string> rows[] = {
      {PipeBetween{Vec3(0, 0, nan), Vec3(4, 0, 0), 1}, "/parts/0/pipe/from"},
      {PipeBetween{Vec3(0, 0, 0), Vec3(infinity, 0, 0), 1}, "/parts/0/pipe/to"},
      {PipeBetween{Vec3(0, 0, 0), Vec3(4, 0, 0), nan}, "/parts/0/pipe/radius"},
      {PipeAlong{Place{Vec3(0, 0, 0), Vec3(nan, 0, 0), 1}, 1}, "/parts/0/pipe/direction"},
      {ElbowTurning{Place{Vec3(0, 0, 0), Vec3(1, 0, 0), 1}, 3, nan, Vec3(0, 1, 0)},
       "/parts/0/elbow/angle"},
      {SphereAt{Vec3(0, -infinity, 0), 1}, "/parts/0/sphere/center"},
  };
  for (const auto& [shape, where] : rows) {
    try {
      (void)resolved({{"a", shape}});
      ADD_FAILURE() << where;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      EXPECT_EQ(error.part(), "a");
      EXPECT_EQ(error.where(), where);
    }
  }
}

struct Refusal {
  std::vector<Part> parts;
  std::string part, where, message;
};

TEST(Resolve, refuses_parts_that_do_not_hang_together) {
  const PartShape free = PipeBetween{Vec3(0, 0, 0), Vec3(4, 0, 0), 1};
  const auto after = [](const std::string& part) { return PipeAlong{end_of(part), 1}; };
  const std::string kOneLine =
      "a part's name must be one line, without control characters or blanks around it";
  const Refusal rows[] = {
      {{}, "", "d#/parts", "an assembly needs at least one part"},
      {{{"a", free}, {"a", free}}, "a", "d#/parts/1/name", "the name is already taken by /parts/0"},
      {{{"a.b", free}},
       "a.b",
       "d#/parts/0/name",
       "a part's name must not be empty and not contain a dot"},
      {{{"a\tb", free}}, "a\tb", "d#/parts/0/name", kOneLine},
      {{{std::string("a\0", 2), free}}, std::string("a\0", 2), "d#/parts/0/name", kOneLine},
      {{{"a\x7F", free}}, "a\x7F", "d#/parts/0/name", kOneLine},
      {{{"a\u202E", free}}, "a\u202E", "d#/parts/0/name", kOneLine},
      {{{"a\xC2\x9B", free}}, "a\xC2\x9B", "d#/parts/0/name", kOneLine},
      {{{" a", free}}, " a", "d#/parts/0/name", kOneLine},
      {{{"a ", free}}, "a ", "d#/parts/0/name", kOneLine},
      {{{"a", after("b")}}, "a", "d#/parts/0/pipe/from", "there is no part named 'b'"},
      {{{"a", free}, {"b", after("a")}, {"c", after("a")}},
       "c",
       "d#/parts/2/pipe/from",
       "the port 'a.end' is already taken by 'b'"},
      {{{"a", free}, {"b", after("a")}, {"c", PipeAlong{start_of("b"), 1}}},
       "c",
       "d#/parts/2/pipe/from",
       "the port 'b.start' is already taken by 'a'"},
      {{{"a", SphereAt{Vec3::Zero(), 1}}, {"b", after("a")}},
       "b",
       "d#/parts/1/pipe/from",
       "'a' is a sphere and has no ports"},
      {{{"d", after("c")}, {"c", PipeAlong{start_of("b"), 1}}, {"b", after("c")}},
       "b",
       "d#/parts/2/pipe/from",
       "the port 'c.end' is already taken by 'd'"},
      {{{"d", after("c")}, {"c", after("b")}, {"a", after("a")}, {"b", free}},
       "a",
       "d#/parts/2/pipe/from",
       "parts must not begin at each other in a circle: 'a' -> 'a'"},
      {{{"f", free}, {"c", after("b")}, {"b", after("a")}, {"a", after("c")}},
       "c",
       "d#/parts/1/pipe/from",
       "parts must not begin at each other in a circle: 'c' -> 'b' -> 'a' -> 'c'"},
  };
  for (const Refusal& row : rows) {
    try {
      (void)resolve({"d", Unit::millimetre, 0.05, {}, row.parts});
      ADD_FAILURE() << row.message;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      EXPECT_EQ(error.part(), row.part);
      EXPECT_EQ(error.where(), row.where);
      EXPECT_EQ(error.message(), row.message);
    }
  }
}

}  // namespace
}  // namespace dupin
