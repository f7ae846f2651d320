// Certificates of fillets and junctions: what is claimed of them, and that nothing else can be.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gmock/gmock.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

struct Lie {
  std::string about, claim;  // the claim that does not follow
  std::function<void(Certificate&)> tell;
};

void expect_named(const Certificate& honest, const std::vector<Lie>& lies) {
  EXPECT_NO_THROW(verify(honest));
  for (const Lie& lie : lies) {
    Certificate c = honest;
    lie.tell(c);
    try {
      verify(c);
      ADD_FAILURE() << lie.about;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument) << lie.about;
      EXPECT_THAT(error.message(), testing::HasSubstr("'" + lie.claim)) << lie.about;
    }
  }
}

RegularClaim undecided() { return {Verdict::undecided, 0, {}, {}}; }

ClearanceClaim nothing_of(std::uint32_t first, std::uint32_t second) {
  return {first, second, Verdict::undecided, 0, {}, {}};
}

// That nothing is known of parts and how far they are from each other makes these tests quick.
Certificate about_parts_nothing(Certificate c) {
  for (PartClaims& claims : c.claims) {
    if (claims.regular) {
      claims.regular = undecided();
      claims.embedded = EmbeddedClaim{};
      claims.mesh.reset();
    }
  }
  for (ClearanceClaim& claim : c.clearances) {
    claim = nothing_of(claim.first, claim.second);
  }
  return c;
}

// But that loops are regular, for without that their arcs may be anywhere.
Certificate about_fillets_little(Certificate c) {
  for (std::vector<LoopClaims>& loops : c.fillet_claims) {
    for (LoopClaims& loop : loops) {
      loop.embedded = {};
      loop.mesh.reset();
    }
  }
  for (ClearanceClaim& claim : c.fillet_clearances) {
    claim = nothing_of(claim.first, claim.second);
  }
  return c;
}

// Two pipes, a ball beside them, and both loops of the fillet between them.
const Certificate& throat() {
  static const Certificate certificate = [] {
    const Part run{"run", PipeBetween{Vec3(-9, 0, 0), Vec3(9, 0, 0), 2}};
    const Part branch{"branch", PipeBetween{Vec3(0, -9, 0), Vec3(0, 9, 0), 1}};
    const Part ball{"ball", SphereAt{Vec3(0, 0, 9), 1}};
    const Part fillet{"throat", FilletBetween{{"run", "branch"}, 0.3}};
    return about_parts_nothing(
        certify({"d.json", Unit::millimetre, 0.5, {}, {run, branch, ball, fillet}}));
  }();
  return certificate;
}

TEST(VerifyCertificate, of_fillets_takes_no_other_claims_about_loops) {
  ASSERT_EQ(throat().fillet_claims.at(0).size(), 2U);
  const auto loop = [](Certificate& c) -> LoopClaims& { return c.fillet_claims[0][1]; };
  expect_named(
      throat(),
      {{"claims of no fillet", "fillets", [](Certificate& c) { c.fillet_claims.emplace_back(); }},
       {"no claims", "fillets", [](Certificate& c) { c.fillet_claims.clear(); }},
       {"claims of one loop", "loops", [](Certificate& c) { c.fillet_claims[0].pop_back(); }},
       {"a part's name", "name", [](Certificate& c) { c.fillets[0].name = "run"; }},
       {"a name of two lines", "name", [](Certificate& c) { c.fillets[0].name = "a\nb"; }},
       {"no part", "between", [](Certificate& c) { c.fillets[0].between[1] = 3; }},
       {"no part first", "between", [](Certificate& c) { c.fillets[0].between[0] = 3; }},
       {"a part twice", "between", [](Certificate& c) { c.fillets[0].between[1] = 0; }},
       {"a ball", "between", [](Certificate& c) { c.fillets[0].between[1] = 2; }},
       {"contact", "contact", [=](Certificate& c) { loop(c).contact->offset = 0; }},
       {"wide contact", "contact", [=](Certificate& c) { loop(c).contact->offset = .6; }},
       {"margin", "regular", [=](Certificate& c) { loop(c).regular.margin = .99; }},
       {"an undecided margin", "regular",
        [=](Certificate& c) { loop(c).regular.verdict = Verdict::undecided; }},
       {"a margin refuted", "regular",
        [=](Certificate& c) { loop(c).regular.verdict = Verdict::refuted; }},
       {"leaves", "embedded", [=](Certificate& c) { loop(c).embedded.leaves.pop_back(); }},
       {"undecided leaves", "embedded",
        [=](Certificate& c) { loop(c).embedded.verdict = Verdict::undecided; }},
       {"embedded, though not regular", "embedded",
        [=](Certificate& c) {
          loop(c).regular = undecided();
          loop(c).mesh.reset();
        }},
       {"a mesh, though not regular", "mesh",
        [=](Certificate& c) {
          loop(c).regular = undecided();
          loop(c).embedded = {};
        }},
       {"mesh", "mesh", [=](Certificate& c) { loop(c).mesh->error_bound = 1e-9; }}});
  Certificate less = about_fillets_little(throat());
  EXPECT_NO_THROW(verify(less));
  loop(less).regular = undecided();
  EXPECT_NO_THROW(verify(less));
  // Where nothing is said of it, nothing is counted as proved.
  const std::size_t findings = less.findings();
  loop(less).contact.reset();
  EXPECT_NO_THROW(verify(less));
  EXPECT_EQ(less.findings(), findings + 1);
}

RingedSurface& surface_of(Certificate& c, std::size_t part) {
  return std::get<RingedSurface>(std::get<Chain>(c.parts[part].shape).pieces.front());
}

// Its end ring is still that of the cylinder on which the balls roll.
TEST(VerifyCertificate, of_fillets_is_about_pipes_that_are_their_quadrics_all_along) {
  const auto lean = [](double by) {
    return [=](Certificate& c) {
      std::get<LineSpine>(surface_of(c, 1).spine).from.x() += by;
      c.claims[1].tangency[0] = c.claims[1].tangency[1] = {1, by, 2 * by, 0};
    };
  };
  const auto narrow = [](double by) {
    return [=](Certificate& c) {
      surface_of(c, 1).radius = LinearRadius{1 - by, 1};
      surface_of(c, 1).start.radius = 1 - by;
      c.claims[1].tangency[0].deviation = c.claims[1].tangency[1].deviation = 1;
    };
  };
  expect_named(throat(), {{"a cone", "contact", narrow(.5)},
                          {"a cone, but for little", "contact", narrow(0x1p-30)},
                          {"another axis", "contact", lean(.001)},
                          {"another axis, but for little", "contact", lean(0x1p-30)},
                          {"a line that looks back", "joints", [](Certificate& c) {
                             auto& line = std::get<LineSpine>(surface_of(c, 1).spine);
                             std::swap(line.from, line.to);
                             c.tolerance = 1e3;
                             c.claims[1].tangency[0] = c.claims[1].tangency[1] = {4, 4, 20, 0};
                           }}});
  Certificate c = throat();
  narrow(0x1p-30)(c);
  for (LoopClaims& claims : c.fillet_claims[0]) {
    claims.contact->offset += 0x1p-30;
    claims.contact->deviation += 0x1p-30;
  }
  EXPECT_NO_THROW(verify(c)) << "what is claimed is so much";
}

TEST(VerifyCertificate, of_fillets_needs_a_clearance_of_every_loop_and_part_but_its_pipes) {
  // Loops come after the parts: each and the ball, then both.
  ASSERT_EQ(throat().fillet_clearances.size(), 3U);
  expect_named(
      throat(),
      {{"none of the last", "clearance", [](Certificate& c) { c.fillet_clearances.pop_back(); }},
       {"none", "clearance", [](Certificate& c) { c.fillet_clearances.clear(); }},
       {"one more", "clearance",
        [](Certificate& c) { c.fillet_clearances.push_back(c.fillet_clearances.back()); }},
       {"of another part", "clearance", [](Certificate& c) { c.fillet_clearances[0].first = 1; }},
       {"of another loop", "clearance", [](Certificate& c) { c.fillet_clearances[0].second = 4; }},
       {"in another order", "clearance",
        [](Certificate& c) { std::swap(c.fillet_clearances[0], c.fillet_clearances[1]); }},
       {"further", "clearance", [](Certificate& c) { c.fillet_clearances[0].distance = 99; }},
       {"loops further", "clearance", [](Certificate& c) { c.fillet_clearances[2].distance = 99; }},
       {"undecided, but far", "clearance",
        [](Certificate& c) { c.fillet_clearances[0].verdict = Verdict::undecided; }},
       {"loops undecided, but far", "clearance",
        [](Certificate& c) { c.fillet_clearances[2].verdict = Verdict::undecided; }}});
}

// Two branches through a run and a ball beside the first: of ten pairs of a loop with a part it is
// not on or with a loop, those are claimed that are near, and nothing is known of any.
const Certificate& two_throats() {
  static const Certificate certificate = [] {
    const Part run{"run", PipeBetween{Vec3(-9, 0, 0), Vec3(29, 0, 0), 2}};
    const Part left{"left", PipeBetween{Vec3(0, -9, 0), Vec3(0, 9, 0), 1}};
    const Part right{"right", PipeBetween{Vec3(20, -9, 0), Vec3(20, 9, 0), 1}};
    const Part ball{"ball", SphereAt{Vec3(3, 4, 0), 1}};
    const Part first{"first", FilletBetween{{"run", "left"}, 0.3}};
    const Part second{"second", FilletBetween{{"run", "right"}, 0.3}};
    const std::vector<Part> parts{run, left, right, ball, first, second};
    return about_fillets_little(
        about_parts_nothing(certify({"d.json", Unit::millimetre, 0.5, {}, parts}, {.apart = 4})));
  }();
  return certificate;
}

using NumberedPair = std::array<std::uint32_t, 2>;

std::vector<NumberedPair> fillet_pairs(const Certificate& c) {
  std::vector<NumberedPair> result;
  for (const ClearanceClaim& claim : c.fillet_clearances) {
    result.push_back({claim.first, claim.second});
  }
  return result;
}

// Parts are 0 to 3, the loops of `first` 4 and 5, those of `second` 6 and 7.
TEST(VerifyCertificate, of_fillets_needs_clearances_of_near_loops_only) {
  ASSERT_THAT(fillet_pairs(two_throats()),
              testing::ElementsAre(NumberedPair{3, 4}, NumberedPair{4, 5}, NumberedPair{6, 7}));
  const auto claims = [](Certificate& c) -> std::vector<ClearanceClaim>& {
    return c.fillet_clearances;
  };
  const auto one_more = [=](std::size_t place, std::uint32_t first, std::uint32_t second) {
    return [=](Certificate& c) {
      claims(c).insert(claims(c).begin() + std::ptrdiff_t(place), nothing_of(first, second));
    };
  };
  const auto one_less = [=](std::size_t place) {
    return [=](Certificate& c) { claims(c).erase(claims(c).begin() + std::ptrdiff_t(place)); };
  };
  expect_named(two_throats(),
               {{"none of the first", "clearance", one_less(0)},
                {"none of the second", "clearance", one_less(1)},
                {"none of the last", "clearance", one_less(2)},
                {"none", "clearance", [=](Certificate& c) { claims(c).clear(); }},
                {"the first twice", "clearance", one_more(1, 3, 4)},
                {"the last twice", "clearance", one_more(3, 6, 7)},
                {"in another order", "clearance",
                 [=](Certificate& c) { std::swap(claims(c)[0], claims(c)[1]); }},
                {"a loop's own pipe", "clearance", one_more(0, 0, 4)},
                {"a loop's other pipe", "clearance", one_more(0, 1, 4)},
                {"a loop and itself", "clearance", one_more(1, 4, 4)},
                {"the last loop and itself", "clearance", one_more(3, 7, 7)},
                {"an earlier loop", "clearance", one_more(2, 5, 4)},
                {"two parts", "clearance", one_more(0, 2, 3)},
                {"a loop and a part", "clearance", one_more(0, 4, 3)},
                {"others in its stead", "clearance",
                 [=](Certificate& c) { claims(c)[2] = nothing_of(5, 7); }},
                {"no loop", "clearance", one_more(3, 7, 8)},
                {"a part and no loop", "clearance", one_more(3, 3, 8)},
                {"nearer than they are", "clearance", [](Certificate& c) { c.apart = 99; }}});
}

TEST(VerifyCertificate, of_fillets_may_claim_of_loops_that_are_not_near) {
  Certificate c = two_throats();
  c.fillet_clearances = {nothing_of(2, 4), nothing_of(3, 4), nothing_of(4, 5),
                         nothing_of(4, 7), nothing_of(3, 5), nothing_of(5, 6),
                         nothing_of(1, 6), nothing_of(6, 7), nothing_of(3, 7)};
  EXPECT_NO_THROW(verify(c));
  for (ClearanceClaim& claim : c.fillet_clearances) {
    claim.distance = 1;  // undecided, but far
    EXPECT_THROW(verify(c), Error) << claim.first << " and " << claim.second;
    claim.distance = 0;
  }
  c.apart = 1e-3;
  c.fillet_clearances = {};
  EXPECT_NO_THROW(verify(c)) << "boxes of loops are further apart than that";
  c.fillet_claims[1][0].regular = undecided();
  EXPECT_THROW(verify(c), Error) << "arcs that may be anywhere are near to everything";
}

// Three arms, the last two of which are as thin as the prover makes them, and a pipe beside.
const Certificate& junction() {
  static const Certificate certificate = [] {
    const Part a{"a", PipeBetween{Vec3(-12, 0, 0), Vec3(-7, 0, 0), 1}};
    const Part b{"b", ConeBetween{Vec3(12, 1, 0), Vec3(7, .5, 0), 1, 1.3}};
    const Part c{"c", PipeBetween{Vec3(0, 12, 2), Vec3(0, 6, 1), .7}};
    const Part beside{"beside", PipeBetween{Vec3(-9, -9, 0), Vec3(9, -9, 0), 1}};
    const Part hub{"hub", JunctionOfPorts{{{"a", End::end}, {"b", End::end}, {"c", End::end}}}};
    const Certificate all = certify({"d.json", Unit::millimetre, 0.5, {}, {a, b, c, beside, hub}});
    Certificate result = about_parts_nothing(all);
    for (std::size_t i = 0; i < all.clearances.size(); ++i) {
      const auto& claim = all.clearances[i];
      if (claim.first == all.junctions[0].arms[0] && claim.second == all.junctions[0].hub) {
        result.clearances[i] = claim;
      }
    }
    return result;
  }();
  return certificate;
}

ClearanceClaim& clearance_of(Certificate& c, std::uint32_t first, std::uint32_t second) {
  return *std::ranges::find_if(c.clearances, [&](const ClearanceClaim& claim) {
    return claim.first == first && claim.second == second;
  });
}

TEST(VerifyCertificate, of_junctions_is_about_their_hubs_and_arms) {
  ASSERT_EQ(junction().junctions.size(), 1U);
  const std::uint32_t hub = junction().junctions[0].hub;
  const std::vector<std::uint32_t> arms = junction().junctions[0].arms;
  ASSERT_EQ(arms.size(), 3U);
  const auto ball = [=](Certificate& c) -> Sphere& { return std::get<Sphere>(c.parts[hub].shape); };
  expect_named(
      junction(),
      {{"another hub", "arms",
        [=](Certificate& c) { ball(c).radius = std::nextafter(ball(c).radius, 0); }},
       {"one arm", "junction", [](Certificate& c) { c.junctions[0].arms.resize(1); }},
       {"no part", "junctions",
        [=](Certificate& c) {
          c.junctions[0].hub = hub + 1;
          c.claims[hub].mesh.reset();
        }},
       {"a hub twice", "junctions", [](Certificate& c) { c.junctions.push_back(c.junctions[0]); }},
       {"a hub that is none", "junction",
        [=](Certificate& c) {
          c.junctions[0].hub = arms[2];
          c.junctions[0].arms.resize(2);
          c.claims[hub].mesh.reset();
          c.claims[arms[2]].mesh.reset();
        }},
       {"an arm twice", "arms", [=](Certificate& c) { c.junctions[0].arms.push_back(arms[0]); }},
       {"an arm that is none", "arms", [](Certificate& c) { c.junctions[0].arms.push_back(3); }},
       {"an arm that is no part", "arms", [](Certificate& c) { c.junctions[0].arms[0] = 99; }},
       {"itself", "arms", [=](Certificate& c) { c.junctions[0].arms[0] = hub; }},
       {"an arm that goes on", "arms",
        [=](Certificate& c) {
          const auto free = std::ranges::find_if(c.parts, [&](const CertifiedPart& part) {
            return &part != &c.parts[arms[0]] && !part.joined[1];
          });
          c.parts[arms[0]].joined[1] = EndIndex{std::uint32_t(free - c.parts.begin()), End::end};
          free->joined[1] = EndIndex{arms[0], End::end};
        }},
       {"an arm in another's place", "caps",
        [=](Certificate& c) {
          c.parts[arms[1]].shape = c.parts[arms[0]].shape;
          c.claims[arms[1]] = c.claims[arms[0]];
          c.parts[arms[1]].joined = c.parts[1].joined = {};
        }},
       {"a mesh of latitudes", "mesh",
        [=](Certificate& c) { c.claims[hub].mesh->error_bound = 1e-9; }},
       {"a hub's mesh of an arm", "mesh",
        [=](Certificate& c) {
          c.claims[arms[0]].mesh = MeshClaim{64, 0, {}, .5};
        }},
       {"leaves", "clearance",
        [=](Certificate& c) { clearance_of(c, arms[0], hub).leaves.pop_back(); }},
       {"an arm that keeps clear", "clearance",
        [=](Certificate& c) { clearance_of(c, arms[0], hub).distance = 1e-9; }},
       {"undecided leaves", "clearance",
        [=](Certificate& c) { clearance_of(c, arms[0], hub).verdict = Verdict::undecided; }},
       {"no junction", "clearance", [=](Certificate& c) {
          c.junctions.clear();
          c.claims[hub].mesh.reset();
        }}});
  Certificate less = junction();
  clearance_of(less, arms[0], hub) = nothing_of(arms[0], hub);
  less.junctions[0].arms.pop_back();
  clearance_of(less, arms[2], hub) = nothing_of(arms[2], hub);
  EXPECT_NO_THROW(verify(less)) << "two arms are enough";
}

}  // namespace
}  // namespace dupin
