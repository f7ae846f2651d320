#include "dupin/kernel/tiled_check.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "kernel/same_report.h"
#include "kernel/tiles/facet_scene.h"
#include "support/message_of.h"

namespace dupin {
namespace {

using test::append_facets;
using test::box;
using test::facet_scene;
using test::reversed;

Report in_tiles(const std::vector<Facet>& facets, const TiledCheckOptions& options) {
  test::HeldScratch scratch;
  return check_in_tiles(test::HeldFacets(facets), scratch, options);
}

void expect_same(const Report& found, const Report& expected) {
  test::expect_same_report(found, expected);
  ASSERT_EQ(found.findings.size(), expected.findings.size());
  for (std::size_t i = 0; i < found.findings.size(); ++i) {
    const Finding &own = found.findings[i], &other = expected.findings[i];
    EXPECT_EQ(own.defect, other.defect) << i;
    EXPECT_EQ(own.faces, other.faces) << i;
    EXPECT_EQ(own.points, other.points) << i;
    EXPECT_EQ(own.place, other.place) << i;
  }
}

std::vector<std::size_t> sum(std::vector<std::size_t> counts, const Report& report) {
  counts.resize(report.counts.size());
  std::ranges::transform(counts, report.counts, counts.begin(), std::plus<>());
  return counts;
}

// Planes between tiles go through corners of the grid, and so through faults of all kinds.
TEST(CheckInTiles, has_the_report_of_check_for_all_numbers_of_tiles) {
  std::vector<std::size_t> counts;
  std::size_t solids = 0, nested = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Facet> facets = facet_scene(seed, seed % 3 == 0 ? 0 : 0.002 * seed);
    const std::size_t limit = seed % 4 == 0 ? 3 : 100;
    const Report whole = check(test::welded_mesh(facets), {.limit = limit});
    for (const std::size_t tiles : {1, 3, 8, 64}) {
      SCOPED_TRACE(tiles);
      expect_same(in_tiles(facets, {.tiles = tiles, .limit = limit}), whole);
      if (HasFailure()) {
        return;
      }
    }
    counts = sum(counts, whole);
    solids += whole.is_solid() ? 1 : 0;
    nested += std::ranges::any_of(whole.shells, [](const ShellReport& s) { return s.depth > 0; });
  }
  for (const Defect defect :
       {Defect::degenerate_face, Defect::duplicate_face, Defect::boundary_edge,
        Defect::non_manifold_edge, Defect::non_manifold_vertex, Defect::inconsistent_orientation,
        Defect::self_intersection, Defect::inside_out_component}) {
    EXPECT_GT(counts[static_cast<std::size_t>(defect)], 3) << name(defect);
  }
  EXPECT_GT(solids, 5);
  EXPECT_GT(nested, 3);
}

TEST(CheckInTiles, goes_through_large_facets_that_are_in_all_tiles) {
  std::vector<Facet> facets;
  append_facets(box({0, 0, 0}, {100, 100, 100}), facets);
  for (int i = 0; i < 40; ++i) {
    const Vec3 low(5 + 2 * i, 3 + 7 * i % 80, 10 + 11 * i % 70);
    append_facets(reversed(box(low, low + Vec3(1, 2, 3))), facets);
  }
  const Report whole = check(test::welded_mesh(facets));
  EXPECT_EQ(whole.components, 1);
  for (const std::size_t tiles : {2, 16, 1000}) {
    expect_same(in_tiles(facets, {.tiles = tiles}), whole);
  }
  append_facets(box({-5, 40, 40}, {105, 41, 41}), facets);  // through all of it
  expect_same(in_tiles(facets, {.tiles = 16}), check(test::welded_mesh(facets)));
}

TEST(CheckInTiles, knows_the_empty_mesh) {
  expect_same(in_tiles({}, {.tiles = 5}), check(TriMesh()));
  expect_same(in_tiles({}, {.memory = 1'000'000}), check(TriMesh()));
}

TEST(CheckInTiles, takes_as_many_tiles_as_the_memory_asks_for) {
  std::vector<Facet> facets;
  for (int i = 0; i < 500; ++i) {
    append_facets(box(Vec3(3 * (i % 10), 3 * (i / 10 % 10), 3 * (i / 100)),
                      Vec3(3 * (i % 10) + 2, 3 * (i / 10 % 10) + 2, 3 * (i / 100) + 2)),
                  facets);
  }
  const Report whole = check(test::welded_mesh(facets));
  for (const std::uint64_t memory : {100'000'000, 1'000'000, 300'000}) {
    expect_same(in_tiles(facets, {.memory = memory}), whole);
  }
  for (const std::uint64_t memory : {1, 2500, 5000}) {
    try {
      (void)in_tiles(facets, {.memory = memory});
      ADD_FAILURE() << memory;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::limit_exceeded);
      EXPECT_THAT(error.what(), testing::HasSubstr("--memory"));
    }
  }
}

// A file may become another one while it is looked at.
class ChangingFacets : public test::HeldFacets {
 public:
  ChangingFacets(std::vector<Facet> facets, std::vector<Facet> others, int from_visit)
      : HeldFacets(std::move(facets)), others_(std::move(others)), usual_visits_(from_visit) {}
  void visit(const std::function<void(std::span<const Facet>)>& visit) const override {
    usual_visits_-- > 0 ? HeldFacets::visit(visit) : others_.visit(visit);
  }

 private:
  test::HeldFacets others_;
  mutable int usual_visits_;
};

void expect_refused(const std::vector<Facet>& facets, const std::vector<Facet>& others,
                    int from_visit, std::size_t tiles) {
  SCOPED_TRACE(testing::Message() << others.size() << ' ' << from_visit << ' ' << tiles);
  test::HeldScratch scratch;
  const ChangingFacets source(facets, others, from_visit);
  const auto run = [&] { (void)check_in_tiles(source, scratch, {.tiles = tiles}); };
  EXPECT_THAT(test::message_of(run, Errc::invalid_argument),
              testing::HasSubstr("the same ones every time"));
}

TEST(CheckInTiles, refuses_a_source_that_is_not_the_same_every_time) {
  const std::vector<Facet> facets = facet_scene(3, 0.05);
  for (const int from_visit : {0, 1, 2}) {
    for (const std::size_t tiles : {1, 8}) {
      for (const std::size_t count : {std::size_t(0), std::size_t(1), facets.size() - 1,
                                      facets.size() + 1, 2 * facets.size()}) {
        std::vector<Facet> others = facets;
        others.resize(count, facets[0]);
        expect_refused(facets, others, from_visit, tiles);
      }
    }
  }
  expect_refused(facets, std::vector<Facet>(facets.size(), facets[0]), 2, 8);
}

TEST(CheckInTiles, refuses_facets_that_are_nowhere) {
  for (const float bad : {NAN, INFINITY, -0.0F}) {
    std::vector<Facet> facets = facet_scene(3, 0.05);
    facets[5][3] = bad;
    const auto run = [&] { (void)in_tiles(facets, {.tiles = 3}); };
    EXPECT_EQ(test::message_of(run, Errc::invalid_argument),
              "facet 5 has a coordinate that is not finite, or is -0");
  }
}

TEST(CheckInTiles, does_not_depend_on_the_size_of_numbers) {
  for (const float scale : {1e-44F, 1e37F}) {
    std::vector<Facet> facets = facet_scene(3, 0.05);
    for (Facet& facet : facets) {
      for (float& coordinate : facet) {
        coordinate = std::min(coordinate * scale, 3e38F);
      }
    }
    expect_same(in_tiles(facets, {.tiles = 5}), check(test::welded_mesh(facets)));
  }
}

}  // namespace
}  // namespace dupin
