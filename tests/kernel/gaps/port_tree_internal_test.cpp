#include <numeric>
#include <random>

#include <gmpxx.h>
#include <gtest/gtest.h>

#include "gaps/port_tree.h"

namespace dupin::gaps {
namespace {

mpq_class squared_distance(const Vec3& a, const Vec3& b) {
  mpq_class sum = 0;
  for (int k = 0; k < 3; ++k) {
    const mpq_class d = mpq_class(a[k]) - mpq_class(b[k]);
    sum += d * d;
  }
  return sum;
}

TEST(CompareDistances, is_exact) {
  std::mt19937 random(1);
  const auto point = [&] {
    const auto number = [&] {
      return static_cast<double>(random() % 3) * (random() % 2 ? 0.1 : 1);
    };
    return Vec3(number(), number(), number());
  };
  int ties = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = point(), b = point(), c = point(), d = point();
    const int expected = cmp(squared_distance(a, b), squared_distance(c, d));
    const int found = compare_distances(a, b, c, d);
    ASSERT_EQ((found > 0) - (found < 0), (expected > 0) - (expected < 0));
    ties += expected == 0 ? 1 : 0;
  }
  EXPECT_GT(ties, 100);
}

/// Ports of a few parts on a coarse grid, so that distances tie and centres coincide.
std::vector<Port> random_ports(std::size_t count, std::mt19937& random) {
  std::vector<Port> ports(count);
  for (Port& port : ports) {
    for (double& x : port.ring.center) {
      x = static_cast<double>(random() % 6);
    }
    const int axis = static_cast<int>(random() % 3);
    port.ring.normal = Vec3::Unit(axis) * (random() % 2 ? 1.0 : -1.0);
    const auto part = random() % 8;
    port.part = part == 0 ? "" : std::string(1, static_cast<char>('a' + part));
  }
  return ports;
}

std::optional<std::uint32_t> nearest_of_all(const std::vector<Port>& ports,
                                            const std::vector<std::uint32_t>& rank,
                                            const std::vector<bool>& held, std::uint32_t port,
                                            double reach) {
  std::optional<std::uint32_t> best;
  std::pair<mpq_class, std::uint32_t> least;
  for (std::uint32_t i = 0; i < ports.size(); ++i) {
    const Ring &a = ports[port].ring, &b = ports[i].ring;
    const bool may_pair = ports[i].part.empty() || ports[i].part != ports[port].part;
    const mpq_class squared = squared_distance(a.center, b.center);
    if (i == port || !held[i] || !may_pair || a.normal.dot(b.normal) >= 0 ||
        squared > mpq_class(reach) * reach) {
      continue;
    }
    if (!best || std::pair(squared, rank[i]) < least) {
      best = i;
      least = {squared, rank[i]};
    }
  }
  return best;
}

TEST(PortTree, finds_the_nearest_facing_port_of_another_part) {
  std::mt19937 random(2);
  std::size_t found = 0;
  for (const std::size_t count : {1U, 2U, 9U, 60U, 400U}) {
    const std::vector<Port> ports = random_ports(count, random);
    std::vector<std::uint32_t> rank(count);
    std::iota(rank.begin(), rank.end(), 0U);
    std::shuffle(rank.begin(), rank.end(), random);
    PortTree tree(ports, rank);
    std::vector<bool> held(count, true);
    for (int round = 0; round < 300; ++round) {
      const auto port = static_cast<std::uint32_t>(random() % count);
      const double reach = static_cast<double>(random() % 5);
      const auto nearest = tree.nearest(port, reach);
      ASSERT_EQ(nearest, nearest_of_all(ports, rank, held, port, reach)) << count;
      found += nearest ? 1 : 0;
      const auto gone = static_cast<std::uint32_t>(random() % count);
      if (round % 2 == 0 && held[gone]) {
        tree.remove(gone);
        held[gone] = false;
      }
      ASSERT_EQ(tree.holds(gone), held[gone]);
    }
  }
  EXPECT_GT(found, 300);
}

}  // namespace
}  // namespace dupin::gaps
