#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>

#include "dupin/kernel/error.h"
#include "dupin/kernel/gap.h"

namespace dupin {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Port port(std::string name, const Vec3& center, const Vec3& normal, double radius = 1,
          std::string part = {}) {
  return {std::move(name), {center, normal, radius}, std::move(part)};
}
const Vec3 kForth = Vec3::UnitX(), kBack = -Vec3::UnitX();

/// "first-second verdict" by name.
std::vector<std::string> summary(const std::vector<Port>& ports, double connect) {
  std::vector<std::string> lines;
  for (const GapPair& pair : pair_ends(ports, connect)) {
    lines.push_back(ports[pair.first].name +
                    (pair.second ? "-" + ports[*pair.second].name : std::string()) + " " +
                    std::string(name(pair.report.verdict)));
  }
  return lines;
}

TEST(PairEnds, welded_ports_come_first_though_others_are_as_near) {
  EXPECT_THAT(summary({port("a", {0, 0, 0}, kForth, 2), port("b", {0, 0, 0}, kBack, 1),
                       port("c", {0, 0, 0}, kBack, 2)},
                      10),
              ElementsAre("a-c welded", "b open"));
}

TEST(PairEnds, nearest_facing_ports_belong_together) {
  EXPECT_THAT(summary({port("a", {0, 0, 0}, kForth), port("b", {1, 0, 0}, kForth),
                       port("c", {3, 0, 0}, kBack), port("d", {3, 4, 0}, kBack)},
                      10),
              ElementsAre("a-d gap", "b-c gap"));
}

// 89.9, 90, 101, 120 and 121 degrees off a straight line.
TEST(PairEnds, ends_that_meet_at_a_sharp_angle_have_a_kink) {
  const auto off = [](double degrees) -> Vec3 {
    const double angle = degrees * std::numbers::pi / 180;
    return {-std::cos(angle), std::sin(angle), 0};
  };
  for (const double degrees : {89.9, 90.0, 101.0, 119.99}) {
    const std::vector<Port> ports = {port("a", {0, 0, 0}, kForth),
                                     port("b", {0, 0.001, 0}, off(degrees))};
    const auto pairs = pair_ends(ports, 0.01);
    ASSERT_EQ(pairs.size(), 1) << degrees;
    EXPECT_EQ(pairs[0].report.verdict, GapVerdict::kink) << degrees;
    EXPECT_NEAR(pairs[0].report.kink.upper, degrees * std::numbers::pi / 180, 1e-12);
  }
  for (const double degrees : {120.01, 150.0, 180.0}) {
    EXPECT_THAT(summary({port("a", {0, 0, 0}, kForth), port("b", {0, 0, 0}, off(degrees))}, 0.01),
                ElementsAre("a open", "b open"))
        << "as pipes that start side by side";
  }
}

TEST(PairEnds, ends_that_face_each_other_come_before_those_that_do_not) {
  EXPECT_THAT(summary({port("a", {0, 0, 0}, kForth), port("b", {0, 0, 0}, Vec3::UnitY()),
                       port("c", {0.1, 0, 0}, kBack)},
                      1),
              ElementsAre("a-c gap", "b open"));
}

TEST(PairEnds, ends_in_a_part_belong_to_those_that_they_face) {
  const std::vector<Port> ports = {port("a", {0, 0, 0}, kForth),
                                   port("b", {0, 0, 0}, Vec3::UnitY()),
                                   port("c", {0, 0, 0}, Vec3::UnitZ())};
  const auto paired_without = [&](std::size_t in_part) {
    std::vector<std::optional<std::size_t>> seconds;
    for (const GapPair& pair :
         pair_ends(ports, 1, [=](std::size_t i, std::size_t) { return i == in_part; })) {
      seconds.push_back(pair.second);
    }
    return seconds;
  };
  using Seconds = std::vector<std::optional<std::size_t>>;
  EXPECT_EQ(paired_without(0), (Seconds{std::nullopt, 2}));
  EXPECT_EQ(paired_without(1), (Seconds{2, std::nullopt}));
  EXPECT_EQ(paired_without(3), (Seconds{1, std::nullopt}));
}

TEST(PairEnds, only_what_lies_within_reach_is_paired) {
  const std::vector<Port> ports = {port("a", {0, 0, 0}, kForth), port("b", {3, 4, 0}, kBack)};
  EXPECT_THAT(summary(ports, 5), ElementsAre("a-b gap"));
  EXPECT_THAT(summary(ports, std::nextafter(5, 0)), ElementsAre("a open", "b open"));
}

TEST(PairEnds, ties_go_to_the_smaller_names) {
  std::vector<Port> ports = {port("m", {0, 0, 0}, kForth), port("z", {2, 0, 0}, kBack),
                             port("a", {-2, 0, 0}, kBack)};
  EXPECT_THAT(summary(ports, 5), ElementsAre("m-a overlap", "z open"));
  std::swap(ports[1].name, ports[2].name);
  EXPECT_THAT(summary(ports, 5), ElementsAre("m-a gap", "z open"));
}

TEST(PairEnds, distances_that_round_to_the_same_double_are_told_apart) {
  // 2^80 + 2^-60 and 2^80 are the same double.
  const double far = std::ldexp(1.0, 40), near = std::ldexp(1.0, -30);
  EXPECT_THAT(summary({port("m", {0, 0, 0}, kForth), port("a", {far, near, 0}, kBack),
                       port("z", {far, 0, 0}, kBack)},
                      2 * far),
              ElementsAre("m-z gap", "a open"));
}

TEST(PairEnds, ends_of_one_part_are_never_paired) {
  EXPECT_THAT(summary({port("disc.start", {0, 0, 0}, kBack, 1, "disc"),
                       port("disc.end", {0.1, 0, 0}, kForth, 1, "disc"),
                       port("pipe.start", {0.5, 0, 0}, kBack, 1, "pipe")},
                      1),
              ElementsAre("disc.start open", "disc.end-pipe.start gap"));
}

TEST(PairEnds, bad_arguments_are_refused_by_name) {
  EXPECT_THROW((void)pair_ends({}, -1), Error);
  EXPECT_THROW((void)pair_ends({}, std::nan("")), Error);
  try {
    (void)pair_ends(std::vector<Port>{port("tee.branch", {0, 0, 0}, kForth, 0)}, 1);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.part(), "tee.branch");
    EXPECT_THAT(error.what(), HasSubstr("radius must be positive"));
  }
}

TEST(PairEnds, of_nothing_is_nothing) { EXPECT_TRUE(pair_ends({}, 1).empty()); }

/// Whether the normals are less than 60 degrees apart.
bool look_the_same_way(const GapReport& report) {
  return report.kink.lower > std::numbers::pi / 2 && report.kink_cosine_squared > mpq_class(1, 4);
}

/// All pairs in order of (welded, facing, distance, names); each taken if both ends are free.
std::vector<std::optional<std::size_t>> by_brute_force(const std::vector<Port>& ports,
                                                       double connect) {
  std::vector<std::tuple<int, mpq_class, std::string, std::string, std::size_t, std::size_t>> all;
  for (std::size_t i = 0; i < ports.size(); ++i) {
    for (std::size_t j = i + 1; j < ports.size(); ++j) {
      const GapReport report = measure_gap(ports[i].ring, ports[j].ring);
      const auto [low, high] = std::minmax(ports[i].name, ports[j].name);
      if (!look_the_same_way(report) && ports[i].part != ports[j].part &&
          report.distance_squared <= mpq_class(connect) * connect) {
        all.emplace_back(report.verdict == GapVerdict::welded ? 0
                         : report.verdict == GapVerdict::open ? 2
                                                              : 1,
                         report.distance_squared, low, high, i, j);
      }
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<std::optional<std::size_t>> partner(ports.size());
  for (const auto& [order, distance, low, high, i, j] : all) {
    if (!partner[i] && !partner[j]) {
      partner[i] = j;
      partner[j] = i;
    }
  }
  return partner;
}

TEST(PairEnds, agrees_with_brute_force_on_lattices_full_of_ties) {
  std::mt19937 random(20261);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const Vec3 oblique(0.6, 0, 0.8);
  const std::vector<Vec3> normals = {kForth, kBack, Vec3::UnitY(), oblique, -oblique};
  for (int round = 0; round < 12; ++round) {
    std::vector<Port> ports;
    ports.reserve(60);
    for (int i = 0; i < 60; ++i) {
      ports.push_back(port("p" + std::to_string(1000 + (i * 37) % 60),
                           {0.1 * below(4), 0.1 * below(4), 0.1 * below(3)}, normals[below(5)],
                           1 + below(2), std::to_string(below(40))));
    }
    const auto expected = by_brute_force(ports, 0.25);
    std::vector<std::optional<std::size_t>> found(ports.size());
    for (const GapPair& pair : pair_ends(ports, 0.25)) {
      if (pair.second) {
        found[pair.first] = pair.second;
        found[*pair.second] = pair.first;
      }
    }
    EXPECT_EQ(found, expected) << "round " << round;
  }
}

TEST(PairEnds, copes_with_a_hundred_thousand_ports) {
  std::mt19937 random(20262);
  std::uniform_real_distribution<double> coordinate(0, 1000), small(0.001, 0.002);
  std::vector<Port> ports;
  for (int i = 0; i < 50000; ++i) {
    const Vec3 center(coordinate(random), coordinate(random), coordinate(random));
    ports.push_back(port("a" + std::to_string(i), center, kForth));
    ports.push_back(port("b" + std::to_string(i), center + small(random) * kForth, kBack));
  }
  const auto pairs = pair_ends(ports, 0.01);
  std::size_t gaps = 0;
  for (const GapPair& pair : pairs) {
    gaps += pair.second == pair.first + 1 && pair.report.verdict == GapVerdict::gap ? 1 : 0;
  }
  EXPECT_EQ(gaps, 50000U);
}

}  // namespace
}  // namespace dupin
