#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "kernel/torus.h"
#include "predicates/triangle_overlap.h"
#include "rounding/edits/fault_tracker.h"
#include "support/shapes.h"

namespace dupin::rounding {
namespace {

/// A closed mesh some of whose triangles meet.
struct Broken {
  explicit Broken(std::uint32_t seed) : mesh(test::torus(12, 24, 2, 1)) {
    std::mt19937 random(seed);
    test::shake(mesh, 0.12, random);
    mesh.points[50] = mesh.points[51];  // degenerate triangles, and points that should not coincide
    representatives.resize(mesh.points.size());
    std::iota(representatives.begin(), representatives.end(), 0U);
    alive.assign(mesh.triangles.size(), 1);
  }
  [[nodiscard]] Embedding embedding() const {
    return {mesh.points, mesh.triangles, representatives};
  }
  [[nodiscard]] FaultTracker::Mesh now() const { return {embedding(), alive}; }

  /// Of the faces still there that involve one with a mark, by looking at all pairs.
  [[nodiscard]] std::vector<Fault> faults(const std::vector<std::uint8_t>& marked) const {
    std::vector<Fault> all;
    for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
      for (std::uint32_t g = f; g < mesh.triangles.size(); ++g) {
        if ((marked[f] != 0 || marked[g] != 0) && FaultTracker::is_fault(now(), {f, g})) {
          all.push_back({f, g});
        }
      }
    }
    return all;
  }
  TriMesh mesh;
  std::vector<std::uint32_t> representatives;
  std::vector<std::uint8_t> alive;
};

TEST(Faults, are_degenerate_triangles_and_those_that_meet_where_they_should_not) {
  const TriMesh mesh =
      test::joined({test::tetrahedron(), test::tetrahedron(Vec3(0.25, 0.25, -1), 2),
                    test::tetrahedron(Vec3(0, 0, 1))});
  std::vector<std::uint32_t> own(mesh.points.size());
  std::iota(own.begin(), own.end(), 0U);
  const Embedding apart{mesh.points, mesh.triangles, own};
  EXPECT_FALSE(is_degenerate(apart, 0));
  EXPECT_FALSE(is_faulty_pair(apart, 0, 1)) << "neighbours";
  EXPECT_TRUE(is_faulty_pair(apart, 0, 5)) << "the second one's side goes through the bottom";
  EXPECT_TRUE(is_faulty_pair(apart, 1, 8)) << "a point where another one is";
  std::vector<std::uint32_t> touching = own;
  touching[8] = 3;  // a contact
  EXPECT_FALSE(is_faulty_pair({mesh.points, mesh.triangles, touching}, 1, 8));
}

TEST(Faults, are_not_where_a_triangle_is_certainly_apart) {
  int apart = 0, neighbours = 0, faults = 0;
  for (std::uint32_t seed = 0; seed < 3; ++seed) {
    const Broken broken(seed);
    const auto count = static_cast<std::uint32_t>(broken.mesh.triangles.size());
    for (std::uint32_t f = 0; f < count; ++f) {
      const Embedding mesh = broken.embedding();
      FaultTest test(mesh, f);
      for (std::uint32_t g = 0; g < count && !test.is_degenerate(); ++g) {
        if (g == f || is_degenerate(mesh, g)) {
          ASSERT_TRUE(g != f || !test.is_apart_from(g)) << "of its own place, " << f;
          continue;
        }
        const bool is_fault = test.is_faulty_with(g);
        ASSERT_FALSE(is_fault && test.is_apart_from(g)) << f << " and " << g;
        const bool shares = std::ranges::any_of(mesh.triangles[f], [&](std::uint32_t v) {
          return std::ranges::count(mesh.triangles[g], v) > 0;
        });
        apart += test.is_apart_from(g) ? 1 : 0;
        neighbours += shares && test.is_apart_from(g) ? 1 : 0;
        faults += is_fault ? 1 : 0;
      }
    }
  }
  EXPECT_GT(apart, 100000);
  EXPECT_GT(neighbours, 5000) << "those with points in common too";
  EXPECT_GT(faults, 50);
}

TEST(Faults, of_marked_faces_are_all_found) {
  std::size_t found = 0;
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    const Broken broken(seed);
    std::mt19937 random(seed);
    std::vector<std::uint8_t> marked_points(broken.mesh.points.size());
    std::ranges::generate(marked_points, [&] { return random() % 8 == 0 ? 1 : 0; });
    const auto marks = marked_faces(broken.mesh.triangles, marked_points);
    const std::vector<std::uint8_t> marked(marks.begin(), marks.end());
    for (std::uint32_t f = 0; f < marked.size(); ++f) {
      const bool has_one = std::ranges::any_of(
          broken.mesh.triangles[f], [&](std::uint32_t v) { return marked_points[v] != 0; });
      ASSERT_EQ(marked[f] != 0, has_one);
    }
    auto faults = find_faults(broken.embedding(), marked);  // in no order that is promised
    std::ranges::sort(faults, {},
                      [](const Fault& fault) { return std::pair(fault.first, fault.second); });
    EXPECT_TRUE(faults == broken.faults(marked));
    const std::size_t pairs = static_cast<std::size_t>(std::ranges::count_if(
        faults, [](const Fault& fault) { return fault.first != fault.second; }));
    const auto below = [&](std::size_t count) {
      return find_faults_below(count, broken.embedding(), marked);
    };
    const auto even = find_faults(
        broken.embedding(), marked,
        [](std::uint32_t first, std::uint32_t second) { return (first ^ second) % 2 == 0; });
    EXPECT_EQ(even.size(), std::ranges::count_if(faults, [](const Fault& fault) {
                return (fault.first ^ fault.second) % 2 == 0;
              }));
    EXPECT_EQ(below(pairs), std::nullopt);
    EXPECT_EQ(below(pairs + 1), find_faults(broken.embedding(), marked));
    found += faults.size();
  }
  EXPECT_GT(found, 50);
}

TEST(FaultTracker, finds_what_all_pairs_tell) {
  for (const bool is_part : {false, true}) {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
      Broken broken(seed);
      if (is_part) {  // else whole shells go
        broken.alive[7] = broken.alive[200] = 0;
      }
      std::vector<std::uint8_t> all(broken.alive.size(), 1), some = all;
      std::fill(some.begin() + 100, some.end(), std::uint8_t{0});
      FaultTracker tracker(broken.mesh.points, broken.mesh.triangles, is_part);
      tracker.find(broken.now(), all, {});
      const std::vector<Fault> faults = broken.faults(all);
      EXPECT_TRUE(tracker.faults() == faults);
      tracker.find(broken.now(), some, faults);
      EXPECT_TRUE(tracker.faults() == faults) << "the others are known";
      tracker.find(broken.now(), some, {});
      EXPECT_TRUE(tracker.faults() == broken.faults(some));
    }
  }
}

TEST(FaultTracker, finds_nothing_of_shells_that_are_gone) {
  const TriMesh mesh =
      test::joined({test::tetrahedron(), test::tetrahedron(Vec3(0.25, 0.25, -1), 2),
                    test::tetrahedron(Vec3(0.5, 0, 0))});
  std::vector<std::uint32_t> own(mesh.points.size());
  std::iota(own.begin(), own.end(), 0U);
  const Embedding embedding{mesh.points, mesh.triangles, own};
  std::vector<std::uint8_t> alive(mesh.triangles.size(), 1);
  const std::vector<std::uint8_t> all = alive;
  FaultTracker tracker(mesh.points, mesh.triangles, false);
  tracker.find({embedding, alive}, all, {});
  std::vector<Fault> expected = tracker.faults();
  const auto of_second = [](const Fault& fault) {
    return (fault.first >= 4 && fault.first < 8) || (fault.second >= 4 && fault.second < 8);
  };
  EXPECT_GT(std::erase_if(expected, of_second), 0);
  ASSERT_FALSE(expected.empty());
  std::fill(alive.begin() + 4, alive.begin() + 8, std::uint8_t{0});
  tracker.find({embedding, alive}, all, {});
  EXPECT_TRUE(tracker.faults() == expected);
}

TEST(FaultTracker, accepts_what_makes_faults_fewer_and_keeps_its_books) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> offset(-0.1, 0.1);
  std::size_t accepted = 0, refused = 0;
  for (const bool is_part : {false, true}) {
    Broken broken(3);
    const std::vector<std::uint8_t> all(broken.alive.size(), 1);
    FaultTracker tracker(broken.mesh.points, broken.mesh.triangles, is_part);
    tracker.find(broken.now(), all, {});
    for (int i = 0; i < 300; ++i) {
      const auto v = static_cast<std::uint32_t>(random() % broken.mesh.points.size());
      const FaultRule rule = i % 2 == 0 ? FaultRule::fewer : FaultRule::none;
      std::vector<std::uint32_t> around;
      std::vector<std::uint8_t> marked(all.size(), 0);
      for (std::uint32_t f = 0; f < broken.mesh.triangles.size(); ++f) {
        if (std::ranges::find(broken.mesh.triangles[f], v) != broken.mesh.triangles[f].end()) {
          around.push_back(f);
          marked[f] = 1;
        }
      }
      const std::size_t before = broken.faults(marked).size();
      ASSERT_EQ(tracker.may_try(broken.now(), around, rule), rule == FaultRule::none || before > 0);
      const Vec3 here = broken.mesh.points[v];
      broken.mesh.points[v] += Vec3(offset(random), offset(random), offset(random));
      const std::size_t after = broken.faults(marked).size();
      const bool is_better = rule == FaultRule::none ? after == 0 : after < before;
      ASSERT_EQ(tracker.accept(broken.now(), around, around, rule), is_better);
      if (!is_better) {
        broken.mesh.points[v] = here;
      }
      (is_better ? accepted : refused) += 1;
    }
    EXPECT_TRUE(tracker.faults() == broken.faults(all));
    EXPECT_EQ(tracker.trials(), 300);
  }
  EXPECT_GT(accepted, 50);
  EXPECT_GT(refused, 50);
}

// A collapse was tried before any other, in vain: faces that it takes away were taken for gone.
TEST(FaultTracker, sees_faces_again_that_a_trial_in_vain_has_taken_away) {
  for (const bool is_part : {false, true}) {
    TriMesh mesh = test::joined({test::tetrahedron(Vec3(0, 0, 0)), test::tetrahedron(Vec3(4, 0, 0)),
                                 test::tetrahedron(Vec3(8, 0, 0))});
    std::vector<std::uint32_t> own(mesh.points.size());
    std::iota(own.begin(), own.end(), 0U);
    std::vector<std::uint8_t> alive(mesh.triangles.size(), 1);
    const FaultTracker::Mesh now{{mesh.points, mesh.triangles, own}, alive};
    FaultTracker tracker(mesh.points, mesh.triangles, is_part);
    const std::vector<std::uint32_t> first{0, 1, 2, 3}, kept{3}, second{4, 5, 6, 7};
    ASSERT_TRUE(tracker.may_try(now, first, FaultRule::none));
    const Triangle before = mesh.triangles[3];
    alive[0] = alive[1] = alive[2] = 0;
    mesh.triangles[3] = {before[0], before[1], 8};  // through the second and into the third
    EXPECT_FALSE(tracker.accept(now, first, kept, FaultRule::none));
    alive[0] = alive[1] = alive[2] = 1;
    mesh.triangles[3] = before;
    ASSERT_TRUE(tracker.may_try(now, second, FaultRule::none));
    for (std::uint32_t v = 4; v < 8; ++v) {
      mesh.points[v].x() -= 3.75;  // through the first
    }
    EXPECT_FALSE(tracker.accept(now, second, second, FaultRule::none));
    for (std::uint32_t v = 4; v < 8; ++v) {
      mesh.points[v].x() += 1.75;
    }
    EXPECT_TRUE(tracker.accept(now, second, second, FaultRule::none)) << "beside it";
  }
}

TEST(FaultTracker, forgets_faces_that_go) {
  Broken broken(1);
  const std::vector<std::uint8_t> all(broken.alive.size(), 1);
  FaultTracker tracker(broken.mesh.points, broken.mesh.triangles, false);
  tracker.find(broken.now(), all, {});
  const std::vector<Fault> before = tracker.faults();
  ASSERT_FALSE(before.empty());
  const std::uint32_t gone = before[0].first;
  tracker.remove(std::vector<std::uint32_t>{gone});
  std::vector<Fault> expected = before;
  std::erase_if(expected, [&](const Fault& f) { return f.first == gone || f.second == gone; });
  EXPECT_TRUE(tracker.faults() == expected);
}

}  // namespace
}  // namespace dupin::rounding
