#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "certification/prove_fillet.h"
#include "support/fillet_loops.h"
#include "verification/fillet_claims.h"

namespace dupin::verification {
namespace {

constexpr double kTolerance = 0.01;

certification::LoopMesh mesh() {
  certification::LoopMesh mesh{{}, 8, 0x1p-20};
  for (int i = 0; i < 128; ++i) {
    mesh.rows.push_back(2 * std::numbers::pi * i / 128);
  }
  return mesh;
}

const CanalFillet& loop_of(const std::string& name) {
  static const auto loops = test::loops_of_all_kinds();
  return std::ranges::find(loops, name, &test::NamedLoop::name)->loop;
}

const LoopClaims& claims_of(const std::string& name) {
  static std::map<std::string, LoopClaims> known;
  const auto found = known.find(name);
  return found != known.end() ? found->second
                              : known[name] = certification::prove_loop(loop_of(name), mesh(),
                                                                        {{}, 1 << 14, kTolerance});
}

bool all_follow(const CanalFillet& loop, const LoopClaims& claims) {
  const auto cells = regular_cells(loop, claims.regular);
  return cells && follows(loop, *cells, claims.embedded) && follows(loop, claims.contact) &&
         claims.mesh && follows(*cells, *claims.mesh);
}

TEST(FilletClaims, of_all_kinds_follow) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    EXPECT_TRUE(all_follow(loop, claims_of(name))) << name;
  }
}

// Each is what it was but for one thing.
TEST(FilletClaims, that_are_regular_do_not_follow_when_changed) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, std::function<void(RegularClaim&)>>> changes{
      {"more than there is",
       [](RegularClaim& c) {
         c.margin = dupin::prove_regular(loop_of("through_0")).regularity / 0.9 + 1e-3;
       }},
      {"no margin", [&](RegularClaim& c) { c.margin = kNaN; }},
      {"a negative margin", [](RegularClaim& c) { c.margin = -1; }},
      {"a gap", [](RegularClaim& c) { c.leaves.erase(c.leaves.begin() + 3); }},
      {"half of it", [](RegularClaim& c) { c.leaves.resize(c.leaves.size() / 2); }},
      {"nothing", [](RegularClaim& c) { c.leaves.clear(); }},
      {"beyond its end",
       [](RegularClaim& c) {
         c.leaves.push_back({2, 2.5});
       }},
      {"a leaf across 1",
       [](RegularClaim& c) {
         const auto at = std::ranges::find(c.leaves, 1.0, &ParameterInterval::to);
         at->to = std::next(at)->to;
         c.leaves.erase(std::next(at));
       }},
      {"a place where it fails",
       [](RegularClaim& c) {
         c.where = {0.5, 0.75};
       }},
      {"refuted", [](RegularClaim& c) { c.verdict = Verdict::refuted; }},
      {"undecided", [](RegularClaim& c) { c.verdict = Verdict::undecided; }}};
  for (const auto& [what, change] : changes) {
    RegularClaim claim = claims_of("through_0").regular;
    change(claim);
    EXPECT_FALSE(regular_cells(loop_of("through_0"), claim)) << what;
  }
}

// A ball so large that the loop folds, or touches itself: no leaves prove otherwise.
TEST(FilletClaims, about_loops_that_fold_do_not_follow) {
  const auto folding = rolling_ball_fillets(test::cylinders(0.5, 0, 30), 1.0).front();
  ASSERT_EQ(dupin::prove_regular(folding).verdict, Verdict::refuted);
  for (int cells = 1; cells <= 1 << 12; cells *= 4) {
    RegularClaim claim{Verdict::proved, 0, {}, {}};
    for (int i = 0; i < 2 * cells; ++i) {
      claim.leaves.push_back({double(i) / cells, double(i + 1) / cells});
    }
    EXPECT_FALSE(regular_cells(folding, claim)) << cells;
  }
}

TEST(FilletClaims, that_are_embedded_do_not_follow_when_changed) {
  const std::vector<std::pair<std::string, std::function<void(EmbeddedClaim&)>>> changes{
      {"a leaf less", [](EmbeddedClaim& c) { c.leaves.pop_back(); }},
      {"a direction turned round",
       [](EmbeddedClaim& c) {
         auto& d = std::ranges::find_if(c.leaves, [](const DiscPairs& p) {
                     return p.direction.has_value();
                   })->direction;
         d = -*d;
       }},
      {"no directions",
       [](EmbeddedClaim& c) {
         for (DiscPairs& leaf : c.leaves) {
           leaf.direction.reset();
         }
       }},
      {"a direction without length",
       [](EmbeddedClaim& c) {
         for (DiscPairs& leaf : c.leaves) {
           leaf.direction = leaf.direction ? std::optional(Vec3(0, 0, 0)) : std::nullopt;
         }
       }},
      {"one leaf for all",
       [](EmbeddedClaim& c) {
         c.leaves = {{{0, 2}, {0, 2}, {}}};
       }},
      {"a leaf of nothing",
       [](EmbeddedClaim& c) {
         c.leaves.push_back({{0, 0}, {1, 1}, {}});
       }},
      {"a point", [](EmbeddedClaim& c) { c.overlap.emplace(); }},
      {"undecided", [](EmbeddedClaim& c) { c.verdict = Verdict::undecided; }}};
  for (const char* name : {"through_0", "equal_0", "parallel_0"}) {
    const auto cells = regular_cells(loop_of(name), claims_of(name).regular);
    for (const auto& [what, change] : changes) {
      EmbeddedClaim claim = claims_of(name).embedded;
      change(claim);
      EXPECT_FALSE(follows(loop_of(name), *cells, claim)) << name << ": " << what;
    }
  }
}

// Across a corner the planes turn at once: only a direction tells both sides apart.
TEST(FilletClaims, across_corners_need_a_direction) {
  const CanalFillet& loop = loop_of("equal_0");
  const auto cells = *regular_cells(loop, claims_of("equal_0").regular);
  const auto& leaves = claims_of("equal_0").embedded.leaves;
  int corners = 0;
  for (DiscPairs leaf : leaves) {
    if ((leaf.first.to == 1 && leaf.second.from == 1) ||
        (leaf.first.from == 0 && leaf.second.to == 2)) {
      ++corners;
      EXPECT_TRUE(holds(loop, cells, leaf));
      const Vec3 d = *leaf.direction;
      leaf.direction.reset();
      EXPECT_FALSE(holds(loop, cells, leaf));
      leaf.direction = -d;
      EXPECT_FALSE(holds(loop, cells, leaf));
      leaf.direction = d.unitOrthogonal();
      EXPECT_FALSE(holds(loop, cells, leaf));
    }
  }
  EXPECT_EQ(corners, 2);
}

// A pipe moved aside by little is not touched any more.
TEST(FilletClaims, of_contact_are_as_tight_as_rounding) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    const ContactClaim claim = claims_of(name).contact;
    EXPECT_LT(claim.offset, 1e-11) << name;
    EXPECT_LT(claim.deviation, 1e-11) << name;
    for (std::size_t side = 0; side < 2; ++side) {
      CanalFillet moved = loop;
      moved.quadrics.at(side).radius += 4 * claim.offset;
      EXPECT_FALSE(follows(moved, claim)) << name;
      EXPECT_TRUE(follows(moved, ContactClaim{6 * claim.offset, claim.deviation})) << name;
      moved = loop;
      moved.quadrics.at(side).center += 1e-6 * moved.quadrics.at(side).normal.unitOrthogonal();
      EXPECT_FALSE(follows(moved, ContactClaim{1, 1e-9})) << name << ": the angle tells, too";
      EXPECT_FALSE(follows(moved, ContactClaim{1e-8, 1})) << name;
    }
  }
  const CanalFillet& loop = loop_of("through_0");
  for (const double bound :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(follows(loop, ContactClaim{bound, 1}));
    EXPECT_FALSE(follows(loop, ContactClaim{1, bound}));
  }
}

// The bound is above what samples of the mesh are off, and no mesh of fewer rows keeps to it.
TEST(FilletClaims, of_meshes_bound_what_samples_say) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    const LoopClaims& claims = claims_of(name);
    double most = 0;
    const auto at = [&](double chi, double u) {
      const ContactArc arc = contact_arc(loop.quadrics, ball(loop, chi));
      return point(arc, u * arc.angle);
    };
    const int segments = 8;
    for (int i = 0; i < 128; ++i) {
      const double a = 2 * std::numbers::pi * i / 128, b = 2 * std::numbers::pi * (i + 1) / 128;
      for (int j = 0; j < segments; ++j) {
        const double u = double(j) / segments, v = double(j + 1) / segments;
        most = std::max(most, ((at(a, u) + at(b, v)) / 2 - at((a + b) / 2, (u + v) / 2)).norm());
      }
    }
    EXPECT_GT(claims.mesh->error_bound, most) << name;
    EXPECT_LT(claims.mesh->error_bound, 6 * most) << name;
    const auto cells = *regular_cells(loop, claims.regular);
    for (const auto& change : std::vector<std::function<void(MeshClaim&)>>{
             [](MeshClaim& c) { c.error_bound = std::nextafter(c.error_bound, 0); },
             [](MeshClaim& c) { c.segments /= 2; }, [](MeshClaim& c) { c.segments = 0; },
             [](MeshClaim& c) { c.segments = 2'000'000; }, [](MeshClaim& c) { c.grid = -1; },
             [](MeshClaim& c) { c.grid = 1; },
             [](MeshClaim& c) {
               c.knots = {0, 1, 2};
             },
             [](MeshClaim& c) { c.knots.pop_back(); },
             [](MeshClaim& c) { c.knots.erase(c.knots.begin()); },
             [](MeshClaim& c) { std::swap(c.knots[3], c.knots[4]); },
             [](MeshClaim& c) { c.error_bound = std::numeric_limits<double>::infinity(); }}) {
      MeshClaim claim = *claims.mesh;
      change(claim);
      EXPECT_FALSE(follows(cells, claim)) << name;
    }
  }
}

}  // namespace
}  // namespace dupin::verification
