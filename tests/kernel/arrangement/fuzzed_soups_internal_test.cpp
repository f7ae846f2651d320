#include <chrono>
#include <random>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/repair.h"
#include "kernel/exact_validity_internal.h"
#include "support/shapes.h"

namespace dupin {
namespace {

std::size_t below(std::mt19937& random, std::size_t bound) { return random() % bound; }

TriMesh any_mesh(std::mt19937& random) {
  switch (below(random, 4)) {
    case 0:
      return test::box({0, 0, 0}, {4, 4, 4});
    case 1:
      return test::frame();
    case 2:
      return test::tube(2, 0, 4, static_cast<std::uint32_t>(3 + below(random, 9)));
    default:
      return test::joined({test::box({0, 0, 0}, {2, 2, 2}),
                           test::moved(test::tetrahedron({1, 1, 1}), Vec3(0.5, 0, 0))});
  }
}

Vec3 any_place(std::mt19937& random) {
  const auto coordinate = [&] { return static_cast<double>(below(random, 9)) - 2; };
  return {coordinate(), coordinate(), coordinate()};
}

// Moves, duplicates, flips or removes triangles, and worse.
void mutate(TriMesh& mesh, std::mt19937& random) {
  const std::size_t t = below(random, mesh.triangles.size()), p = below(random, mesh.points.size());
  switch (below(random, 9)) {
    case 0:
      mesh.points[p] = any_place(random);
      break;
    case 1:
      mesh.points[p] += 0.25 * any_place(random);
      break;
    case 2:
      mesh.points[p] = mesh.points[below(random, mesh.points.size())];
      break;
    case 3:
      mesh.triangles.push_back(mesh.triangles[t]);
      break;
    case 4:
      std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
      break;
    case 5:
      if (mesh.triangles.size() > 1) {
        mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      }
      break;
    case 6: {  // moved as a whole, with points of its own
      const auto first = static_cast<std::uint32_t>(mesh.points.size());
      const Vec3 by = 0.5 * any_place(random);
      for (std::uint32_t& corner : mesh.triangles[t]) {
        mesh.points.emplace_back(mesh.points[corner] + by);
      }
      mesh.triangles[t] = {first, first + 1, first + 2};
      break;
    }
    case 7: {  // split at a point that its neighbour lacks
      const Triangle old = mesh.triangles[t];
      const auto middle = static_cast<std::uint32_t>(mesh.points.size());
      mesh.points.emplace_back((mesh.points[old[0]] + mesh.points[old[1]]) / 2);
      mesh.triangles[t] = {old[0], middle, old[2]};
      mesh.triangles.push_back({middle, old[1], old[2]});
      if (below(random, 2) == 0) {
        mesh.triangles.push_back({old[0], old[1], middle});
      }
      break;
    }
    default: {  // the whole mesh again, elsewhere
      const TriMesh copy = test::moved(mesh, 0.5 * any_place(random));
      if (mesh.triangles.size() < 100) {
        mesh = test::joined({mesh, below(random, 2) == 0 ? copy : test::reversed(copy)});
      }
    }
  }
}

void expect_valid(const Solid& solid) {
  EXPECT_TRUE(test::is_closed_manifold(solid.exact()));
  EXPECT_EQ(test::self_intersections(solid.exact()), 0U);
  EXPECT_GE(solid.exact_volume(), 0);
}

// Whatever is taken for a solid takes part in set operations.
template <class Make>
bool survives(const Make& make, const Solid& other) {
  Solid solid;
  try {
    solid = make();
  } catch (const Error& error) {
    EXPECT_STRNE(error.what(), "");
    return false;
  }
  expect_valid(solid);
  const std::vector<Solid> both = {solid, other};
  const Solid united = unite(both), common = intersect(both);
  expect_valid(united);
  expect_valid(common);
  EXPECT_EQ(united.exact_volume() + common.exact_volume(),
            solid.exact_volume() + other.exact_volume());
  return true;
}

TEST(FuzzedSoups, are_refused_or_become_valid_solids_in_time) {
#ifdef DUPIN_ALL_SEEDS
  constexpr unsigned kSoups = 5000;
#else
  constexpr unsigned kSoups = 300;
#endif
  const Solid other = Solid::from(test::tube(1.5, -1, 3, 5));
  std::size_t solids = 0, repaired = 0;
  for (unsigned seed = 0; seed < kSoups; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    TriMesh mesh = any_mesh(random);
    for (std::size_t faults = below(random, 6); faults > 0; --faults) {
      mutate(mesh, random);
    }
    const auto begin = std::chrono::steady_clock::now();
    solids += survives([&] { return Solid::from(mesh); }, other) ? 1 : 0;
    repaired += survives([&] { return repair(mesh).solid; }, other) ? 1 : 0;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
    if (testing::Test::HasFailure()) {
      break;
    }
  }
  // The mutations hit all three: solids, what can be repaired, and what cannot.
  EXPECT_GT(solids, kSoups / 10);
  EXPECT_GT(repaired, solids + kSoups / 10);
  EXPECT_LT(repaired, kSoups * 9 / 10);
}

}  // namespace
}  // namespace dupin
