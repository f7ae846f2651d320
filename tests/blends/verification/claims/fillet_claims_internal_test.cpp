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
#include "verification/claims/fillet_claims.h"
#include "verification/work.h"

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
  return cells && follows(loop, *cells, claims.embedded) && claims.contact &&
         follows(loop, *claims.contact) && claims.mesh && follows(*cells, *claims.mesh);
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
    const ContactClaim claim = claims_of(name).contact.value();
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

TEST(FilletClaims, that_are_undecided_have_a_margin_below_one) {
  EXPECT_TRUE(has_form(RegularClaim{Verdict::undecided, .5, {}, {}}));
  EXPECT_FALSE(has_form(RegularClaim{Verdict::undecided, 1, {}, {}}));
}

// A pipe moved aside: by how much the angle is off varies along the loop, as the ball's speed does.
TEST(FilletClaims, of_contact_are_about_the_worst_angle) {
  CanalFillet loop = loop_of("through_0");
  loop.quadrics[0].center.y() += 1e-3;
  double lean = 0;
  for (int i = 0; i < 2000; ++i) {
    const double t = i * 1e-3;
    const auto balls = std::visit(BallReader<2>(*turn_stretch({t, t})), loop.motion);
    const Jet<2> off = seen_from(loop.quadrics[0], balls.center).distance - balls.radius;
    lean = std::max(lean,
                    std::abs(numbers::middle(off[1])) / numbers::norm(part(balls.center, 1)).lower);
  }
  EXPECT_TRUE(follows(loop, ContactClaim{1, 1.01 * lean}));
  EXPECT_FALSE(follows(loop, ContactClaim{1, .99 * lean}));
}

TEST(FilletClaims, of_contact_do_not_follow_of_a_ball_that_stands) {
  CanalFillet loop = loop_of("through_0");
  std::get<RollingThrough>(loop.motion).distance = 0;
  EXPECT_FALSE(follows(loop, ContactClaim{1e9, 1e9}));
}

TEST(FilletClaims, of_contact_take_the_last_derivative_from_all_of_a_stretch) {
  const double h = .125;
  const TaylorRange found = taylor_range(Jet<3>{{1, 2, 4}}, Jet<3>{{99, 99, Interval(-8, 16)}}, h);
  EXPECT_NEAR(found.value.upper, 1 + 2 * h + 16 * h * h / 2, 1e-12);
  EXPECT_NEAR(found.value.lower, 1 - 2 * h - 16 * h * h / 2, 1e-12);
  EXPECT_NEAR(found.slope.upper, 2 + 16 * h, 1e-12);
  EXPECT_NEAR(found.slope.lower, 2 - 16 * h, 1e-12);
  EXPECT_GE(found.value.upper, 1 + 2 * h + 16 * h * h / 2);
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

// Arcs about the x axis that go along it by 1, over a stretch.
ArcCell hand_made(double from, double to) {
  ArcCell cell{{from, to}, {}};
  ContactArcs& arcs = cell.arcs;
  arcs.length = .125;
  arcs.tangent = numbers::interval_vec(Vec3::UnitX());
  arcs.turning = numbers::interval_vec(Vec3(0, .5, 0));
  arcs.radius = 1;
  arcs.toward = {numbers::interval_vec(Vec3::UnitY()), numbers::interval_vec(Vec3::UnitZ())};
  arcs.inverse_cosine = {1, 1.5};
  arcs.passing = 1;
  return cell;
}

std::vector<ArcCell> hand_made_loop() {
  std::vector<ArcCell> cells;
  for (int i = 0; i < 8; ++i) {
    cells.push_back(hand_made(i / 4., (i + 1) / 4.));
  }
  return cells;
}

TEST(FilletClaims, are_about_the_cells_that_a_stretch_meets) {
  const auto cells = hand_made_loop();
  const auto met = [&](double from, double to) {
    const auto way = cells_of(cells, {from, to});
    return std::pair(way.data() - cells.data(), way.size());
  };
  EXPECT_EQ(met(0, 2), std::pair(std::ptrdiff_t(0), std::size_t(8)));
  EXPECT_EQ(met(.25, .5), std::pair(std::ptrdiff_t(1), std::size_t(1)));
  EXPECT_EQ(met(.375, .625), std::pair(std::ptrdiff_t(1), std::size_t(2)));
  EXPECT_EQ(met(1.75, 2), std::pair(std::ptrdiff_t(7), std::size_t(1)));
}

TEST(FilletClaims, cost_work_for_every_cell_that_is_met) {
  const std::vector<ArcCell> cells(4000, hand_made(0, 1));
  const WorkLimit limit(10'000);
  static_cast<void>(cells_of(cells, {0, 1}));
  EXPECT_EQ(limit.left(), 9'000U - 1);
}

struct Spoiled {
  const char* what;
  std::function<void(ContactArcs&)> change;
};

// What may be wrong with some arcs of a stretch is wrong with all of it.
TEST(FilletClaims, that_arcs_move_along_a_direction_are_about_the_worst_of_them) {
  const IntervalVec x = numbers::interval_vec(Vec3::UnitX()),
                    slanted = numbers::interval_vec(Vec3(1, 1, 0));
  std::vector<ArcCell> cells = hand_made_loop();
  EXPECT_TRUE(moves_along(cells, x));
  EXPECT_FALSE(moves_along(cells, Interval(-1) * x));
  cells[3].arcs.passing = {-.125, 1};
  EXPECT_FALSE(moves_along(cells, x));
  for (const auto& [what, change] :
       std::vector<Spoiled>{{"what lags",
                             [](ContactArcs& a) {
                               a.lag = {0, 3};
                             }},
                            {"what grows",
                             [](ContactArcs& a) {
                               a.growth = {-3, 0};
                             }},
                            {"what turns about T",
                             [](ContactArcs& a) {
                               a.spin[0] = {-3, 3};
                             }},
                            {"what turns about T at the other foot", [](ContactArcs& a) {
                               a.spin[1] = {-3, 3};
                             }}}) {
    std::vector<ArcCell> spoiled = hand_made_loop();
    EXPECT_TRUE(moves_along(spoiled, slanted)) << what;
    change(spoiled[5].arcs);
    EXPECT_FALSE(moves_along(spoiled, slanted)) << what;
  }
}

TEST(FilletClaims, of_short_ways_are_about_the_worst_arcs_on_them) {
  const CanalFillet& loop = loop_of("through_0");
  const DiscPairs leaf{{0, .25}, {.25, .5}, {}};
  EXPECT_TRUE(holds(loop, hand_made_loop(), leaf));
  for (const auto& [what, change] : std::vector<Spoiled>{{"turns too much",
                                                          [](ContactArcs& a) {
                                                            a.turning[1] = {.5, 8};
                                                          }},
                                                         {"may go back",
                                                          [](ContactArcs& a) {
                                                            a.passing = {-.5, 1};
                                                          }},
                                                         {"lags",
                                                          [](ContactArcs& a) {
                                                            a.lag = {0, 64};
                                                          }},
                                                         {"lags as it turns",
                                                          [](ContactArcs& a) {
                                                            a.lag = 4;
                                                            a.turning[1] = {0, 3};
                                                          }},
                                                         {"grows",
                                                          [](ContactArcs& a) {
                                                            a.growth = {0, 16};
                                                          }},
                                                         {"falls",
                                                          [](ContactArcs& a) {
                                                            a.growth = {-16, 0};
                                                          }},
                                                         {"turns about T",
                                                          [](ContactArcs& a) {
                                                            a.spin[0] = {-16, 0};
                                                          }},
                                                         {"turns about T at the other foot",
                                                          [](ContactArcs& a) {
                                                            a.spin[1] = {0, 16};
                                                          }},
                                                         {"is wide", [](ContactArcs& a) {
                                                            a.spin[0] = 1;
                                                            a.radius = {0, 16};
                                                          }}}) {
    for (const std::size_t place : {0U, 1U}) {
      std::vector<ArcCell> cells = hand_made_loop();
      change(cells[place].arcs);
      EXPECT_FALSE(holds(loop, cells, leaf)) << what;
      change(cells[7].arcs);  // nor is there a way around
    }
  }
}

// Where the way on is spoiled, that around the loop's beginning may be short, and the other way.
TEST(FilletClaims, of_short_ways_go_around_or_not_but_across_no_corner) {
  const CanalFillet &smooth = loop_of("through_0"), &both = loop_of("equal_0");
  ASSERT_TRUE(has_corner(both, 0) && has_corner(both, 1));
  const auto spoiled = [](std::size_t cell) {
    std::vector<ArcCell> cells = hand_made_loop();
    cells[cell].arcs.passing = -1;
    return cells;
  };
  const DiscPairs across_one{{.75, 1}, {1, 1.25}, {}}, around{{0, .25}, {1.75, 2}, {}},
      beyond{{.5, .75}, {1.75, 2}, {}}, from_one{{1, 1.25}, {1.25, 1.5}, {}},
      to_one{{.5, .75}, {.75, 1}, {}};
  EXPECT_TRUE(holds(smooth, spoiled(0), across_one));
  EXPECT_FALSE(holds(both, spoiled(0), across_one));
  EXPECT_TRUE(holds(both, spoiled(0), from_one));
  EXPECT_TRUE(holds(both, spoiled(0), to_one));
  EXPECT_TRUE(holds(smooth, spoiled(4), around));
  EXPECT_FALSE(holds(smooth, spoiled(0), around));
  EXPECT_FALSE(holds(smooth, spoiled(7), around));
  EXPECT_FALSE(holds(both, spoiled(4), around));
  EXPECT_TRUE(holds(smooth, spoiled(4), beyond));
  EXPECT_FALSE(holds(smooth, spoiled(4), {beyond.second, beyond.first, {}}));
  EXPECT_FALSE(holds(smooth, spoiled(0), {{1, 1.25}, {.75, 1}, {}})) << "not in their order";
  // Corners at one place only.
  for (const char* name : {"touching_0", "touching_1"}) {
    const CanalFillet& loop = loop_of(name);
    const bool at_one = has_corner(loop, 1);
    ASSERT_NE(at_one, has_corner(loop, 0));
    EXPECT_EQ(holds(loop, spoiled(0), across_one), !at_one) << name;
    EXPECT_EQ(holds(loop, spoiled(4), around), at_one) << name;
    EXPECT_FALSE(holds(loop, spoiled(2), {{.25, .5}, {.75, 1}, {}})) << name << ": around all";
  }
}

TEST(FilletClaims, across_corners_are_of_stretches_that_end_there) {
  const auto cells = hand_made_loop();
  const Vec3 x = Vec3::UnitX();
  const CanalFillet &smooth = loop_of("through_0"), &both = loop_of("equal_0");
  EXPECT_TRUE(holds(both, cells, {{.75, 1}, {1, 1.25}, x}));
  EXPECT_TRUE(holds(both, cells, {{0, .25}, {1.75, 2}, x}));
  EXPECT_FALSE(holds(smooth, cells, {{.75, 1}, {1, 1.25}, x}));
  EXPECT_FALSE(holds(smooth, cells, {{0, .25}, {1.75, 2}, x}));
  EXPECT_FALSE(holds(both, cells, {{.5, .75}, {1, 1.25}, x}));
  EXPECT_FALSE(holds(both, cells, {{.75, 1}, {1.25, 1.5}, x}));
  EXPECT_FALSE(holds(both, cells, {{.25, .5}, {1.75, 2}, x}));
  EXPECT_FALSE(holds(both, cells, {{0, .25}, {1.5, 1.75}, x}));
  for (const std::size_t backwards : {3U, 4U}) {
    auto turned = cells;
    turned[backwards].arcs.passing = -1;
    EXPECT_FALSE(holds(both, turned, {{.75, 1}, {1, 1.25}, x})) << backwards;
  }
}

TEST(FilletClaims, have_leaves_within_one_half_of_the_loop) {
  const CanalFillet& loop = loop_of("through_0");
  for (const ParameterInterval& leaf :
       {ParameterInterval{.9375, 1}, {1, 1.0625}, {0, .0625}, {1.9375, 2}}) {
    EXPECT_TRUE(regular_cell(loop, leaf, 0)) << leaf.from;
  }
  for (const ParameterInterval& leaf : {ParameterInterval{.96875, 1.03125},
                                        {.25, .25},
                                        {.25, .125},
                                        {-.0625, 0},
                                        {2, 2.0625},
                                        {1.96875, 2.03125}}) {
    EXPECT_FALSE(regular_cell(loop, leaf, 0)) << leaf.from;
  }
  const auto cells = hand_made_loop();
  EXPECT_TRUE(holds(loop, cells, {{.25, .5}, {.5, .75}, {}}));
  EXPECT_FALSE(holds(loop, cells, {{.25, .25}, {.5, .75}, {}}));
  EXPECT_FALSE(holds(loop, cells, {{.25, .5}, {.75, .75}, {}}));
  EXPECT_FALSE(holds(loop, cells, {{.25, .5}, {.75, 1.25}, {}}));
}

// So wide a stretch that all arcs are known, but not how fast they pass.
TEST(FilletClaims, that_are_regular_are_about_the_slowest_arcs_and_the_fastest_balls) {
  const CanalFillet& loop = loop_of("through_0");
  const ParameterInterval leaf{.25, .28125};
  const auto arcs = contact_arcs(loop, leaf);
  ASSERT_TRUE(arcs);
  const double least = arcs->passing.lower / arcs->speed.upper;
  ASSERT_LT(1.001 * least, arcs->passing.lower / arcs->speed.lower);
  ASSERT_LT(1.001 * least, arcs->passing.upper / arcs->speed.upper);
  EXPECT_TRUE(regular_cell(loop, leaf, .9999 * least));
  EXPECT_FALSE(regular_cell(loop, leaf, 1.0001 * least));
}

TEST(FilletClaims, have_cells_that_bound_how_their_arcs_bend) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    for (const ParameterInterval& leaf :
         {ParameterInterval{.25, .2509765625}, {1.5, 1.5009765625}}) {
      const auto cell = regular_cell(loop, leaf, 0);
      ASSERT_TRUE(cell) << name;
      const auto at = [&](double chi, double u) {
        const ContactArc arc = contact_arc(loop.quadrics, ball(loop, chi));
        return point(arc, u * arc.angle);
      };
      double along = 0, mixed = 0, around = 0, size = 0;
      for (const double t : {leaf.from, (leaf.from + leaf.to) / 2, leaf.to}) {
        for (const double u : {.01, .3, .5, .7, .99}) {
          const double chi = test::angle_at(t), h = 1e-3;
          const auto part = [&](double i, double k) { return at(chi + i * h, u + k * h); };
          along = std::max(along, (part(1, 0) - 2 * part(0, 0) + part(-1, 0)).norm() / (h * h));
          around = std::max(around, (part(0, 1) - 2 * part(0, 0) + part(0, -1)).norm() / (h * h));
          mixed = std::max(
              mixed, (part(1, 1) - part(1, -1) - part(-1, 1) + part(-1, -1)).norm() / (4 * h * h));
          size = std::max(size, part(0, 0).norm());
        }
      }
      EXPECT_GE(cell->along * (1 + 1e-4), along) << name;
      EXPECT_GE(cell->mixed * (1 + 1e-4), mixed) << name;
      EXPECT_GE(cell->around * (1 + 1e-4), around) << name;
      EXPECT_GE(cell->size, size) << name;
      EXPECT_LE(cell->along, 1.5 * along) << name;
      EXPECT_LE(cell->mixed, 2.5 * mixed) << name;
      EXPECT_LE(cell->around, 1.02 * around) << name;
      EXPECT_LE(cell->size, 1.01 * size) << name;
    }
  }
}

// Two bands, of which one has the largest bounds of each kind.
TEST(FilletClaims, of_meshes_are_made_of_the_largest_bounds_in_each_band) {
  std::vector<ArcCell> cells = hand_made_loop();
  cells[4].along = 2;
  cells[5].mixed = 3;
  cells[7].around = 5;
  cells[1].along = cells[1].mixed = cells[1].around = .5;
  cells[2].size = 7;
  cells[6].size = 6;
  const double dt = 4, du = .25;  // dt: of pi, that bound
  const double error = (dt * dt * 2 + 2 * dt * du * 3 + du * du * 5) / 8;
  const double rounding = std::sqrt(3.) / 2 * .125 + std::ldexp(7, -47);
  MeshClaim claim{4, .125, {0, 1, 2}, 0};
  EXPECT_NEAR(mesh_error(cells, claim), error + rounding, 1e-12);
  EXPECT_GE(mesh_error(cells, claim), (error + rounding) * (1 - 1e-15));
  std::reverse(cells.begin(), cells.end());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i].t = {double(i) / 4, double(i + 1) / 4};
  }
  EXPECT_NEAR(mesh_error(cells, claim), error + rounding, 1e-12);
  for (const std::vector<double>& knots : std::vector<std::vector<double>>{
           {}, {0}, {0, 2}, {.25, 1, 2}, {0, 1, 1.75}, {0, .5, 1.5, 2}, {0, 1, 1, 2}}) {
    EXPECT_EQ(mesh_error(cells, {4, .125, knots, 0}), std::numeric_limits<double>::infinity());
  }
}

TEST(FilletClaims, of_meshes_have_one_segment_at_least_and_no_more_than_the_limit) {
  const auto cells = hand_made_loop();
  EXPECT_TRUE(follows(cells, MeshClaim{1, 0, {0, 1, 2}, 1}));
  EXPECT_FALSE(follows(cells, MeshClaim{0, 0, {0, 1, 2}, 1}));
  EXPECT_TRUE(follows(cells, MeshClaim{CertificateLimits::kSegments, 0, {0, 1, 2}, 1}));
  EXPECT_FALSE(follows(cells, MeshClaim{CertificateLimits::kSegments + 1, 0, {0, 1, 2}, 1}));
}

// Pipes that end, at either end, a little before or behind where the balls touch them last.
TEST(FilletClaims, hold_of_balls_between_the_ends_of_their_pipes_only) {
  const CanalFillet loop = test::loops_of_all_kinds().front().loop;
  const auto furthest = [&](const Ring& pipe, const Vec3& direction) {
    double most = -1e9;
    for (int i = 0; i < 4096; ++i) {
      const Vec3 at = ball(loop, 2 * std::numbers::pi * i / 4096).center;
      most = std::max(most, (at - pipe.center).dot(direction));
    }
    return most;
  };
  for (std::size_t side = 0; side < 2; ++side) {
    for (const bool is_start : {false, true}) {
      const auto holds_with = [&](double beyond) {
        CanalFillet cut = loop;
        std::array<Ring, 2> starts = loop.quadrics;
        for (std::size_t k = 0; k < 2; ++k) {
          const Ring pipe = loop.quadrics.at(k);
          const Vec3 axis = pipe.normal;
          const bool is_cut = k == side;
          const double up = furthest(pipe, axis) + (is_cut && !is_start ? -beyond : 1);
          const double down = furthest(pipe, -axis) + (is_cut && is_start ? -beyond : 1);
          cut.quadrics.at(k).center = pipe.center + up * axis;
          starts.at(k).center = pipe.center - down * axis;
          starts.at(k).normal = -axis;
        }
        return touches_between(cut, starts, kTolerance);
      };
      EXPECT_TRUE(holds_with(-1)) << side << is_start;
      EXPECT_TRUE(holds_with(.9 * kTolerance)) << side << is_start;
      EXPECT_FALSE(holds_with(1.1 * kTolerance)) << side << is_start;
      EXPECT_FALSE(holds_with(1)) << side << is_start;
    }
  }
}

}  // namespace
}  // namespace dupin::verification
