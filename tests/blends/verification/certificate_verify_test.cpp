#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

RingedSurface pipe(const Vec3& from, const Vec3& to) {
  const Vec3 along = (to - from).normalized();
  return {{from, -along, 1}, {to, along, 1}, LineSpine{from, to}, ConstantRadius{1}};
}

CertifiedPart part(const std::string& name, const RingedSurface& surface) {
  Chain chain;
  chain.pieces.emplace_back(surface);
  CertifiedPart result;
  result.name = name;
  result.shape = chain;
  return result;
}

PartClaims straight_claims() {
  const TangencyClaim tangent{0, 0, 1e-300, {}};
  return {RegularClaim{Verdict::proved, .5, {{0, 1}}, {}},
          EmbeddedClaim{Verdict::proved, {{{0, 1}, {0, 1}, {}}}, {}},
          {tangent, tangent},
          MeshClaim{64, 0, {0, 1}, .01}};
}

// The end of the first part and the start of the second.
void join(Certificate& c) {
  c.parts[0].joined[1] = EndIndex{1, End::start};
  c.parts[1].joined[0] = EndIndex{0, End::end};
}

// Two pipes that are joined, and a ball beside the second.
Certificate certificate() {
  Certificate result;
  result.tolerance = .01;
  result.parts = {part("a", pipe({0, 0, 0}, {4, 0, 0})), part("b", pipe({4, 0, 0}, {8, 0, 0})), {}};
  join(result);
  result.parts[2].name = "ball";
  result.parts[2].shape = Sphere{Vec3(7, 5, 0), 1};
  result.claims = {straight_claims(), straight_claims(), {}};
  result.claims[2].mesh = MeshClaim{64, 0, {}, .01};
  const Vec3 up(0, 1, 0);
  result.clearances = {{0, 1, Verdict::proved, 0, {{{0, 1}, {0, 1}, {}}}, {}},
                       {0, 2, Verdict::proved, 2, {{{0, 1}, {0, 1}, up}}, {}},
                       {1, 2, Verdict::proved, 2, {{{0, 1}, {0, 1}, up}}, {}}};
  return result;
}

RingedSurface& surface(Certificate& c, std::size_t i) {
  return std::get<RingedSurface>(std::get<Chain>(c.parts[i].shape).pieces.front());
}

TEST(VerifyCertificate, believes_what_is_true) { EXPECT_NO_THROW(verify(certificate())); }

// Any tolerance may be stated where nobody knows the document.
TEST(VerifyCertificate, believes_of_no_joint_what_only_its_tolerance_says) {
  const auto with_second = [](const Vec3& from, const Vec3& to, double angle, double offset) {
    Certificate c = certificate();
    c.parts.pop_back();
    c.claims.pop_back();
    c.clearances.resize(1);
    c.tolerance = 100;
    surface(c, 1).spine = LineSpine{from, to};
    c.claims[1].tangency = {{4, angle, offset, {}}, {4, angle, offset, {}}};
    return c;
  };
  EXPECT_NO_THROW(verify(with_second({4, 0, 0}, {8, 0, 0}, 0, 1e-300)));
  EXPECT_THROW(verify(with_second({4, 0, 0}, {0, 0, 0}, 3.2, 8)), Error) << "it goes back";
  EXPECT_THROW(verify(with_second({10, 0, 0}, {14, 0, 0}, 0, 6)), Error) << "they do not meet";
  EXPECT_THROW(verify(with_second({2, 0, 0}, {6, 0, 0}, 0, 2)), Error) << "they overlap";
}

// A chain whose second piece begins within the first.
TEST(VerifyCertificate, believes_of_no_chain_that_it_goes_on_where_it_goes_back) {
  for (const double back : {0., .5, 2.}) {
    Certificate c = certificate();
    std::get<Chain>(c.parts[0].shape).pieces.emplace_back(pipe({4, 0, 0}, {8, 0, 0}));
    auto& second = std::get<RingedSurface>(std::get<Chain>(c.parts[0].shape).pieces.back());
    second.spine = LineSpine{Vec3(4 - back, 0, 0), Vec3(8 - back, 0, 0)};
    c.parts.resize(1);
    c.parts[0].joined = {};
    c.claims.resize(1);
    c.clearances.clear();
    c.tolerance = 100;
    PartClaims& claims = c.claims[0];
    claims.regular->leaves = {{0, 1}, {1, 2}};
    claims.mesh.reset();
    claims.tangency.push_back({0, 0, back + 1e-300, {}});
    claims.tangency.push_back({0, 0, back + 1e-300, {}});
    const auto is_believed = [&](std::vector<DiscPairs> leaves) {
      claims.embedded->leaves = std::move(leaves);
      try {
        verify(c);
        return true;
      } catch (const Error&) {
        return false;
      }
    };
    EXPECT_EQ(is_believed({{{0, 2}, {0, 2}, {}}}), false) << "a run needs a direction";
    EXPECT_EQ(is_believed({{{0, 1}, {0, 1}, {}}, {{0, 1}, {1, 2}, {}}, {{1, 2}, {1, 2}, {}}}),
              back < 1)
        << back;
    EXPECT_EQ(is_believed({{{0, 1}, {0, 1}, {}},
                           {{0, .9375}, {1, 2}, {}},
                           {{.9375, 1}, {1, 1.0625}, {}},
                           {{.9375, 1}, {1.0625, 2}, {}},
                           {{1, 2}, {1, 2}, {}}}),
              back == 0)
        << "a leaf that is shorter than what is off";
  }
}

TEST(VerifyCertificate, does_not_ask_about_what_is_undecided) {
  Certificate c = certificate();
  c.claims[0].regular = RegularClaim{};
  c.claims[0].embedded = EmbeddedClaim{};
  c.claims[0].mesh.reset();
  c.clearances[1].verdict = Verdict::undecided;
  c.clearances[1].leaves.clear();
  EXPECT_THROW(verify(c), Error) << "a distance that nothing proves";
  c.clearances[1].distance = 0;
  EXPECT_NO_THROW(verify(c));
}

TEST(VerifyCertificate, of_a_shape_without_proofs_takes_only_undecided_claims) {
  Certificate c;
  c.parts.resize(1);
  c.parts[0].name = "other";
  c.parts[0].shape = Chain{};
  c.claims = {{RegularClaim{}, EmbeddedClaim{}, {}, {}}};
  EXPECT_NO_THROW(verify(c));
  c.claims[0].regular->verdict = Verdict::proved;
  EXPECT_THROW(verify(c), Error);
}

// It has no discs, so that no leaves cover all of them.
TEST(VerifyCertificate, of_a_shape_without_proofs_takes_no_clearance) {
  for (const bool is_first : {true, false}) {
    Certificate c;
    c.parts = {part("pipe", pipe({0, 0, 0}, {4, 0, 0})), part("pipe", pipe({0, 0, 0}, {4, 0, 0}))};
    c.claims = {straight_claims(), straight_claims()};
    c.tolerance = .01;
    const std::size_t other = is_first ? 0 : 1;
    c.parts[other].name = "other";
    c.parts[other].shape = Chain{};
    c.claims[other] = {RegularClaim{}, EmbeddedClaim{}, {}, {}};
    c.clearances = {{0, 1, Verdict::undecided, 0, {}, {}}};
    EXPECT_NO_THROW(verify(c));
    for (const bool joined : {false, true}) {
      if (joined) {
        join(c);
        EXPECT_NO_THROW(verify(c));
      }
      Certificate lie = c;
      lie.clearances = {{0, 1, Verdict::proved, joined ? 0. : 5., {}, {}}};
      EXPECT_THROW(verify(lie), Error) << is_first << joined;
      lie.clearances[0].distance = 5;
      EXPECT_THROW(verify(lie), Error) << is_first << joined;
      lie.clearances[0].leaves = {{{0, 0}, {0, 1}, Vec3(0, 1, 0)}, {{0, 1}, {0, 0}, {}}};
      EXPECT_THROW(verify(lie), Error) << is_first << joined;
    }
  }
}

// Balls in a row, 3 from centre to centre: neighbours are 1 from each other, the next ones 4.
Certificate row_of_balls(std::uint32_t count, double apart) {
  Certificate c;
  c.apart = apart;
  c.claims.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    c.parts.emplace_back();
    c.parts.back().name = std::to_string(i);
    c.parts.back().shape = Sphere{Vec3(3 * i, 0, 0), 1};
    if (i > 0) {
      c.clearances.push_back(
          {i - 1, i, Verdict::proved, .5, {{{0, 1}, {0, 1}, Vec3(1, 0, 0)}}, {}});
    }
  }
  return c;
}

TEST(VerifyCertificate, believes_that_parts_are_apart_whose_boxes_are) {
  EXPECT_NO_THROW(verify(row_of_balls(40, 2)));
  EXPECT_NO_THROW(verify(row_of_balls(40, 4 * (1 - 0x1p-40))));
  EXPECT_NO_THROW(verify(row_of_balls(40, .9))) << "more claims than are needed";
  Certificate c = row_of_balls(40, .9);
  c.clearances.clear();
  EXPECT_NO_THROW(verify(c));
}

// All lies are such where boxes along other axes tell the truth, too.
TEST(VerifyCertificate, believes_boxes_along_other_axes_if_these_are_any) {
  Certificate c = row_of_balls(40, 3.9);
  for (CertifiedPart& part : c.parts) {
    auto& ball = std::get<Sphere>(part.shape);
    ball.center = ball.center[0] * Vec3(.6, .8, 0);
  }
  for (ClearanceClaim& claim : c.clearances) {
    claim.leaves[0].direction = Vec3(3, 4, 0);
  }
  EXPECT_THROW(verify(c), Error) << "along the axes of coordinates they are nearer";
  const Directions axes{Vec3(3, 4, 0), Vec3(-4, 3, 0), Vec3(0, 0, 1)};
  c.axes = axes;
  EXPECT_NO_THROW(verify(c));
  const auto is_refused = [](const Certificate& certificate) {
    try {
      verify(certificate);
    } catch (const Error& error) {
      return error.code() == Errc::invalid_argument;
    }
    return false;
  };
  for (const double number : {std::nan(""), HUGE_VAL, 1e300}) {
    c.axes = axes;
    c.axes->at(1)[2] = number;
    EXPECT_TRUE(is_refused(c)) << number;
  }
  c.axes = {Vec3(4, -3, 0), Vec3(4, -3, 0), Vec3(0, 0, 1)};
  EXPECT_TRUE(is_refused(c)) << "along these they are in one place";
  c.axes = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  EXPECT_TRUE(is_refused(c));
  c.axes = axes;
  c.clearances.pop_back();
  EXPECT_TRUE(is_refused(c)) << "a near pair is missing";
  c = row_of_balls(2, 0);
  EXPECT_NO_THROW(verify(c));
  c.axes = axes;
  EXPECT_TRUE(is_refused(c)) << "where nothing is told by boxes they say nothing";
}

TEST(VerifyCertificate, believes_of_no_two_parts_that_they_are_apart_unless_their_boxes_are) {
  using Tell = std::function<void(Certificate&)>;
  const std::vector<std::pair<std::string, Tell>> lies = {
      {"further than they are", [](Certificate& c) { c.apart = 4 * (1 + 0x1p-40); }},
      {"as if all pairs were there", [](Certificate& c) { c.apart = 0; }},
      {"nowhere near", [](Certificate& c) { c.apart = -1; }},
      {"no number", [](Certificate& c) { c.apart = std::nan(""); }},
      {"beyond all", [](Certificate& c) { c.apart = 1e300; }},
      {"a pair is missing", [](Certificate& c) { c.clearances.erase(c.clearances.begin() + 7); }},
      {"the first is missing", [](Certificate& c) { c.clearances.erase(c.clearances.begin()); }},
      {"the last is missing", [](Certificate& c) { c.clearances.pop_back(); }},
      {"another one in its place",
       [](Certificate& c) {
         c.clearances[7].second = 9;
         c.clearances[7].distance = .5;
       }},
      {"two in another order", [](Certificate& c) { std::swap(c.clearances[3], c.clearances[4]); }},
      {"one twice",
       [](Certificate& c) { c.clearances.insert(c.clearances.begin(), c.clearances[0]); }},
      {"one with itself", [](Certificate& c) { c.clearances.back() = {39, 39, {}, 0, {}, {}}; }},
      {"one with itself, too",
       [](Certificate& c) {
         c.clearances.push_back({39, 39, Verdict::undecided, 0, {}, {}});
       }},
      {"one against the order of parts",
       [](Certificate& c) { std::swap(c.clearances[3].first, c.clearances[3].second); }},
      {"one with what is no part",
       [](Certificate& c) {
         c.clearances.push_back({39, 40, Verdict::undecided, 0, {}, {}});
       }},
      {"a distance that nothing proves", [](Certificate& c) { c.clearances[3].distance = 1.5; }},
      {"a part of which nothing is known", [](Certificate& c) {
         c.parts[20].shape = Chain();
         c.claims[20] = {RegularClaim{}, EmbeddedClaim{}, {}, {}};
         for (const std::size_t i : {19U, 20U}) {
           auto& claim = c.clearances[i];
           claim = {claim.first, claim.second, Verdict::undecided, 0, {}, {}};
         }
       }}};
  for (const auto& [about, tell] : lies) {
    Certificate c = row_of_balls(40, 2);
    tell(c);
    EXPECT_THROW(verify(c), Error) << about;
  }
}

struct Lie {
  std::string about, part, claim;
  std::function<void(Certificate&)> tell;
};

class OneLie : public testing::TestWithParam<Lie> {};

TEST_P(OneLie, is_named_with_its_part) {
  Certificate c = certificate();
  GetParam().tell(c);
  try {
    verify(c);
    ADD_FAILURE() << "believed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    EXPECT_EQ(error.part(), GetParam().part);
    EXPECT_THAT(error.message(), testing::HasSubstr("'" + GetParam().claim + "'"));
    EXPECT_THAT(error.where(), testing::StartsWith("certificate"));
  }
}

INSTANTIATE_TEST_SUITE_P(
    VerifyCertificate, OneLie,
    testing::Values(
        Lie{"claims_of_a_part", "", "parts", [](Certificate& c) { c.claims.pop_back(); }},
        Lie{"no_regular_claim", "a", "regular",
            [](Certificate& c) { c.claims[0].regular.reset(); }},
        Lie{"name_of_two_lines", "", "name", [](Certificate& c) { c.parts[0].name = "a\nb"; }},
        Lie{"name_of_two_parts", "", "name", [](Certificate& c) { c.parts[0].name = "b"; }},
        Lie{"joined_to_none", "a", "joined",
            [](Certificate& c) { c.parts[0].joined[1]->part = 3; }},
        Lie{"joined_to_itself", "a", "joined",
            [](Certificate& c) {
              c.parts[0].joined[0] = EndIndex{0, End::start};
            }},
        Lie{"joined_to_what_knows_nothing", "b", "joined",
            [](Certificate& c) { c.parts[0].joined[1].reset(); }},
        Lie{"joined_at_another_end", "a", "joined",
            [](Certificate& c) { c.parts[1].joined[0]->end = End::start; }},
        Lie{"joined_to_what_is_elsewhere", "a", "joined",
            [](Certificate& c) {
              c.parts[1].shape = pipe({4, 100, 0}, {8, 100, 0});
              c.apart = 1;
              c.clearances.clear();
            }},
        Lie{"negative_tolerance", "", "tolerance", [](Certificate& c) { c.tolerance = -1; }},
        Lie{"document_of_two_lines", "", "document", [](Certificate& c) { c.document = "\n"; }},
        Lie{"margin_of_a_ball", "ball", "regular",
            [](Certificate& c) { c.claims[2].regular = c.claims[0].regular; }},
        Lie{"negative_grid", "ball", "mesh", [](Certificate& c) { c.claims[2].mesh->grid = -1; }},
        Lie{"infinite_bound", "ball", "mesh",
            [](Certificate& c) {
              c.claims[2].mesh->error_bound = std::numeric_limits<double>::infinity();
            }},
        Lie{"knot_that_is_none", "a", "mesh",
            [](Certificate& c) {
              c.claims[0].mesh->knots = {0, std::nan(""), 1};
            }},
        Lie{"undecided_margin", "a", "regular",
            [](Certificate& c) {
              c.claims[0].regular = RegularClaim{Verdict::undecided, 1.5, {}, {}};
              c.claims[0].embedded = EmbeddedClaim{};
            }},
        Lie{"undecided_with_evidence", "a", "embedded",
            [](Certificate& c) { c.claims[0].embedded->verdict = Verdict::undecided; }},
        Lie{"proved_with_a_common_point", "a", "embedded",
            [](Certificate& c) { c.claims[0].embedded->overlap = Overlap{}; }},
        Lie{"distance_without_a_limit", "a", "clearance of ball",
            [](Certificate& c) {
              c.clearances[1].distance = std::numeric_limits<double>::quiet_NaN();
            }},
        Lie{"direction_without_length", "a", "clearance of ball",
            [](Certificate& c) { c.clearances[1].leaves[0].direction = Vec3(0, std::nan(""), 0); }},
        Lie{"parameter_of_many_bits", "a", "clearance of ball",
            [](Certificate& c) {
              c.clearances[1].leaves = {{{0, 0x1p-70}, {0, 1}, Vec3(0, 1, 0)},
                                        {{0x1p-70, 1}, {0, 1}, Vec3(0, 1, 0)}};
            }},
        Lie{"no_embedded_claim", "b", "regular",
            [](Certificate& c) { c.claims[1].embedded.reset(); }},
        Lie{"tangency_of_one_end", "a", "regular",
            [](Certificate& c) { c.claims[0].tangency.pop_back(); }},
        Lie{"margin", "a", "regular", [](Certificate& c) { c.claims[0].regular->margin = 1; }},
        Lie{"margin_leaf", "b", "regular",
            [](Certificate& c) { c.claims[1].regular->leaves[0].to = .5; }},
        Lie{"false_refutation", "b", "regular",
            [](Certificate& c) {
              c.claims[1].regular = RegularClaim{Verdict::refuted, .5, {}, {0, 1}};
              c.claims[1].embedded = EmbeddedClaim{};
            }},
        Lie{"pairs", "b", "embedded", [](Certificate& c) { c.claims[1].embedded->leaves.clear(); }},
        Lie{"axis", "a", "tangency", [](Certificate& c) { surface(c, 0).start.normal.y() = 1e-9; }},
        Lie{"offset", "a", "tangency",
            [](Certificate& c) { surface(c, 0).start.center.y() = 1e-9; }},
        Lie{"curvature", "a", "tangency",
            [](Certificate& c) { c.claims[0].tangency[1].curvature = -1; }},
        Lie{"tolerance", "a", "joints", [](Certificate& c) { c.tolerance = 1e-301; }},
        Lie{"wide_joint", "a", "joints",
            [](Certificate& c) { c.claims[0].tangency[1].offset = .02; }},
        Lie{"mesh", "b", "mesh", [](Certificate& c) { c.claims[1].mesh->error_bound = .001; }},
        Lie{"mesh_of_a_ball", "ball", "mesh",
            [](Certificate& c) { c.claims[2].mesh->error_bound = .001; }},
        Lie{"ball_of_no_radius", "ball", "radius",
            [](Certificate& c) { std::get<Sphere>(c.parts[2].shape).radius = 0; }},
        Lie{"rings_at_the_joint", "a", "joined",
            [](Certificate& c) {
              surface(c, 1).start.slope = 1e-300;
              c.claims[1].tangency[0].deviation = 1e-200;  // what it owns up to
            }},
        Lie{"joint_with_a_ball", "a", "joined",
            [](Certificate& c) {
              c.parts[0].joined[0] = EndIndex{2, End::start};
              c.parts[2].joined[0] = EndIndex{0, End::start};
            }},
        Lie{"joint_that_is_none", "a", "clearance of b",
            [](Certificate& c) { c.parts[0].joined = c.parts[1].joined = {}; }},
        Lie{"distance", "a", "clearance of ball",
            [](Certificate& c) { c.clearances[1].distance = 3.5; }},
        Lie{"direction", "b", "clearance of ball",
            [](Certificate& c) { c.clearances[2].leaves[0].direction = Vec3(1, 0, 0); }},
        Lie{"order_of_clearances", "", "clearance",
            [](Certificate& c) { std::swap(c.clearances[0], c.clearances[1]); }},
        Lie{"clearance_missing", "b", "clearance of ball",
            [](Certificate& c) { c.clearances.pop_back(); }},
        Lie{"clearance_too_many", "", "clearance",
            [](Certificate& c) { c.clearances.push_back(c.clearances.back()); }}),
    [](const auto& row) { return row.param.about; });

// One part whose two pieces meet in a ring.
TEST(VerifyCertificate, of_a_chain_needs_pieces_that_share_their_rings) {
  Certificate c;
  c.tolerance = .01;
  c.parts = {part("chain", pipe({0, 0, 0}, {4, 0, 0}))};
  auto& chain = std::get<Chain>(c.parts[0].shape);
  chain.pieces.emplace_back(pipe({4, 0, 0}, {8, 0, 0}));
  const TangencyClaim tangent{0, 0, 1e-300, {}};
  c.claims = {{RegularClaim{Verdict::proved, .5, {{0, 1}, {1, 2}}, {}},
               EmbeddedClaim{},
               {tangent, tangent, tangent, tangent},
               {}}};
  EXPECT_NO_THROW(verify(c));
  const auto refused_for = [](const Certificate& lie) -> std::string {
    try {
      verify(lie);
      return "nothing";
    } catch (const Error& error) {
      return error.message();
    }
  };
  Certificate closed = c;
  std::get<Chain>(closed.parts[0].shape).closed = true;  // but it ends elsewhere
  EXPECT_THAT(refused_for(closed), testing::HasSubstr("'joints'"));
  Certificate moved = c;
  auto& second = std::get<Chain>(moved.parts[0].shape).pieces[1];
  std::get<RingedSurface>(second) = pipe({4.001, 0, 0}, {8, 0, 0});
  EXPECT_THAT(refused_for(moved), testing::HasSubstr("'joints'"));
}

// Thin tubes may turn at a joint by any angle while their rings are hardly off; what lies further
// along is.
TEST(VerifyCertificate, of_thin_parts_takes_none_that_turns_at_its_joint) {
  const auto thin = [](const Vec3& from, const Vec3& to) {
    RingedSurface tube = pipe(from, to);
    tube.start.radius = tube.end.radius = .001;
    tube.radius = ConstantRadius{.001};
    return tube;
  };
  Certificate c;
  c.tolerance = .01;
  c.parts = {part("a", thin({0, 0, 0}, {4, 0, 0})), part("b", thin({4, 0, 0}, {8, 0, 0}))};
  join(c);
  c.claims = {straight_claims(), straight_claims()};
  c.clearances = {{0, 1, Verdict::proved, 0, {{{0, 1}, {0, 1}, {}}}, {}}};
  EXPECT_NO_THROW(verify(c));
  RingedSurface& back = surface(c, 1);
  back.spine = LineSpine{Vec3(4, 0, 0), Vec3(0, 0, 0)};
  back.end = {Vec3(0, 0, 0), -Vec3::UnitX(), .001};
  c.claims[1].tangency[0] = {3.2, 3.2, 1e-300, {}};
  EXPECT_LT(3.2 * .001, c.tolerance) << "so that the rings are near";
  try {
    verify(c);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.message(), testing::HasSubstr("'joints'"));
  }
}

// With the same slopes across, seen from both sides.
TEST(VerifyCertificate, of_a_chain_of_elliptic_tubes_needs_rings_with_the_same_slopes) {
  EllipticTube before, after;
  before.start = {Vec3(0, 0, 0), -Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 1, -.25}};
  before.end = {Vec3(4, 0, 0), Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 2, .25}};
  after.start = {Vec3(4, 0, 0), -Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 2, -.25}};
  after.end = {Vec3(8, 0, 0), Vec3::UnitX(), 2, 0, Ellipse{Vec3::UnitY(), 3, .25}};
  before.spine = LineSpine{Vec3(0, 0, 0), Vec3(4, 0, 0)};
  after.spine = LineSpine{Vec3(4, 0, 0), Vec3(8, 0, 0)};
  before.first = after.first = ConstantRadius{2};
  before.second = LinearRadius{1, 2};
  after.second = LinearRadius{2, 3};
  before.axis = after.axis = Vec3::UnitY();
  const TangencyClaim near{4, 0, 1e-300, {}};
  Certificate c;
  c.tolerance = .01;
  c.parts.resize(1);
  c.parts[0].name = "chain";
  c.claims = {{RegularClaim{}, EmbeddedClaim{}, {near, near, near, near}, {}}};
  const auto verify_chain = [&] {
    Chain chain;
    chain.pieces = {before, after};
    c.parts[0].shape = chain;
    verify(c);
  };
  EXPECT_NO_THROW(verify_chain());
  for (const double slope : {.25, 0.}) {
    after.start.ellipse->across_slope = slope;
    EXPECT_THROW(verify_chain(), Error) << slope;
  }
}

// The balls are to touch the parts themselves, not some quadrics beside.
TEST(VerifyCertificate, of_fillets_is_about_the_quadrics_of_its_parts) {
  const Part run{"run", PipeBetween{Vec3(-9, 0, 0), Vec3(9, 0, 0), 2}};
  const Part branch{"branch", PipeBetween{Vec3(0, 0, 0), Vec3(0, 9, 0), 1}};
  const Part fillet{"throat", FilletBetween{{"run", "branch"}, 0.3}};
  const Certificate honest = certify({"d.json", Unit::millimetre, 0.05, {}, {run, branch, fillet}});
  EXPECT_EQ(honest.findings(), 0U);
  EXPECT_NO_THROW(verify(honest));
  const std::vector<std::function<void(Ring&)>> changes{
      [](Ring& ring) { ring.radius = std::nextafter(ring.radius, 0); },
      [](Ring& ring) { ring.center.x() = std::nextafter(ring.center.x(), 100); },
      [](Ring& ring) { ring = flipped(ring); }, [](Ring& ring) { ring.slope = 5e-324; },
      [](Ring& ring) {
        ring.ellipse = Ellipse{ring.normal.unitOrthogonal(), 1, 0};
      }};
  for (std::size_t side = 0; side < 2; ++side) {
    for (const auto& change : changes) {
      Certificate c = honest;
      change(c.fillets[0].loops[0].quadrics.at(side));
      try {
        verify(c);
        ADD_FAILURE();
      } catch (const Error& error) {
        EXPECT_THAT(error.message(), testing::HasSubstr("'between'"));
      }
    }
  }
  // Pipes that end before the fillet, and one that is bent.
  for (const std::uint32_t side : {0U, 1U}) {
    Certificate shorter = honest;
    auto& pipe = surface(shorter, side);
    pipe.start.center = .875 * pipe.end.center;
    pipe.spine = LineSpine{pipe.start.center, pipe.end.center};
    try {
      verify(shorter);
      ADD_FAILURE() << side;
    } catch (const Error& error) {
      EXPECT_THAT(error.message(), testing::HasSubstr("'between'"));
    }
  }
  Certificate bent = honest;
  const Vec3 from = surface(bent, 1).start.center, to = surface(bent, 1).end.center;
  surface(bent, 1).spine = BezierSpine{{from, (from + to) / 2, to}, {}};
  EXPECT_THROW(verify(bent), Error);
  Certificate itself = honest;
  itself.fillets[0].between = {0, 0};
  EXPECT_THROW(verify(itself), Error);
  itself = honest;
  itself.fillets[0].between = {0, 2};
  EXPECT_THROW(verify(itself), Error);
  itself = honest;
  itself.fillets[0].loops.clear();
  itself.fillet_claims[0].clear();
  EXPECT_THROW(verify(itself), Error) << "nothing is claimed of it";
  itself = honest;
  itself.fillet_claims[0][0].contact = {0.06, 0.06};
  EXPECT_THROW(verify(itself), Error) << "further than the tolerance";
}

// What is wrong, and where.
TEST(VerifyCertificate, tells_missing_claims_from_others) {
  const auto refusal = [](const std::function<void(Certificate&)>& tell) {
    Certificate c = certificate();
    tell(c);
    try {
      verify(c);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("believed");
  };
  EXPECT_EQ(refusal([](Certificate& c) { c.clearances[1].distance = 9; }),
            "certificate#/clearances/1: 'a': the claim 'clearance of ball' does not follow");
  EXPECT_EQ(refusal([](Certificate& c) { c.clearances.pop_back(); }),
            "certificate#/clearances: 'b': has no claim 'clearance of ball'");
  EXPECT_EQ(refusal([](Certificate& c) { c.clearances.erase(c.clearances.begin() + 1); }),
            "certificate#/clearances/1: 'a': has no claim 'clearance of ball'");
  const std::string one_too_many = "the claim 'clearance' is one too many, or out of order";
  EXPECT_EQ(refusal([](Certificate& c) { c.clearances.push_back(c.clearances.back()); }),
            "certificate#/clearances/3: " + one_too_many);
  EXPECT_EQ(refusal([](Certificate& c) { std::swap(c.clearances[0], c.clearances[1]); }),
            "certificate#/clearances/0: " + one_too_many);
  EXPECT_EQ(refusal([](Certificate& c) { c.claims[1].tangency[1].axis_angle = 1; }),
            "certificate#/claims/1/tangency/1: 'b': the claim 'joints' does not follow");
}

}  // namespace
}  // namespace dupin
