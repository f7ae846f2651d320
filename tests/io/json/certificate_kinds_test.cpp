// Certificates of every kind of part: what tampering with them comes to.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/kernel/error.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

const Certificate& certificate_of(const std::string& name) {
  static std::map<std::string, Certificate> known;
  const auto found = known.find(name);
  return found != known.end()
             ? found->second
             : known[name] =
                   certify(read_assembly(test::source_folder() / "examples" / (name + ".json")));
}

std::size_t part(const Certificate& c, const std::string& name) {
  const auto found = std::find_if(c.parts.begin(), c.parts.end(),
                                  [&](const CertifiedPart& p) { return p.name == name; });
  return std::size_t(found - c.parts.begin());
}

Chain& chain(Certificate& c, const std::string& name) {
  return std::get<Chain>(c.parts.at(part(c, name)).shape);
}

template <class Piece>
Piece& piece(Certificate& c, const std::string& name, std::size_t index = 0) {
  return std::get<Piece>(chain(c, name).pieces.at(index));
}

PartClaims& claims(Certificate& c, const std::string& name) { return c.claims.at(part(c, name)); }

ClearanceClaim& pair(Certificate& c, const std::string& a, const std::string& b) {
  return *std::find_if(c.clearances.begin(), c.clearances.end(), [&](const auto& claim) {
    return c.parts[claim.first].name == a && c.parts[claim.second].name == b;
  });
}

class OfAKind : public testing::TestWithParam<std::string> {};

TEST_P(OfAKind, is_rejected_with_one_digit_changed) {
  const std::string text = certificate_json(certificate_of(GetParam()));
  std::mt19937_64 random(12);
  for (int i = 0; i < 10; ++i) {
    std::string changed = text;
    std::size_t place = 0;
    do {
      place = random() % text.size();
    } while (std::isdigit(static_cast<unsigned char>(text[place])) == 0);
    changed[place] = static_cast<char>('0' + (text[place] - '0' + 1 + random() % 9) % 10);
    EXPECT_THROW((void)parse_certificate(changed), Error) << place;
  }
}

INSTANTIATE_TEST_SUITE_P(Certificate, OfAKind,
                         testing::Values("crane-hook", "jet-engine", "ucct-arm", "u-bend-cyclide",
                                         "way-points", "pipe-ring", "oval-duct", "ringed-canal",
                                         "skew-cross", "parallel-cone"),
                         [](const auto& row) {
                           std::string name = row.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// Sealed again, so that only the checker stands in the way.
struct Lie {
  std::string about, example;
  std::function<void(Certificate&)> tell;
};

class LiarOfAKind : public testing::TestWithParam<Lie> {};

TEST_P(LiarOfAKind, is_caught_by_the_checker) {
  Certificate certificate = certificate_of(GetParam().example);
  EXPECT_NO_THROW(verify(certificate));
  GetParam().tell(certificate);
  try {
    verify(parse_certificate(certificate_json(certificate)));
    ADD_FAILURE() << "believed";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("does not follow"));
  }
}

const DiscPairs kAllPairs{{0, 1}, {0, 1}, {}};

INSTANTIATE_TEST_SUITE_P(
    Certificate, LiarOfAKind,
    testing::Values(
        Lie{"cyclide_sphere", "crane-hook",
            [](auto& c) { piece<CyclidePiece>(c, "hook").last.m.x() += 1e-9; }},
        Lie{"cyclide_radius", "crane-hook",
            [](auto& c) { piece<CyclidePiece>(c, "hook", 3).first.r *= 1.2; }},
        Lie{"cyclide_tangent", "crane-hook",
            [](auto& c) { piece<CyclidePiece>(c, "hook", 2).tangent.r += 1e-9; }},
        Lie{"cyclide_margin", "crane-hook",
            [](auto& c) { claims(c, "hook").regular->margin += 0.1; }},
        Lie{"cyclide_refuted", "crane-hook",
            [](auto& c) { claims(c, "hook").regular->verdict = Verdict::refuted; }},
        Lie{"cyclide_pair", "crane-hook",
            [](auto& c) { claims(c, "hook").embedded->leaves.pop_back(); }},
        Lie{"cyclide_mesh", "crane-hook",
            [](auto& c) { claims(c, "hook").mesh->error_bound *= 0.5; }},
        Lie{"cyclide_knot", "crane-hook",
            [](auto& c) {
              auto& knots = claims(c, "hook").mesh->knots;
              knots.erase(std::find(knots.begin(), knots.end(), 1.0));
            }},
        Lie{"cyclide_joint", "crane-hook",
            [](auto& c) { pair(c, "hook", "shank").leaves = {kAllPairs}; }},
        Lie{"missing_piece", "crane-hook", [](auto& c) { chain(c, "hook").pieces.pop_back(); }},
        Lie{"pieces_apart", "crane-hook",
            [](auto& c) { piece<CyclidePiece>(c, "hook", 1).start.radius += 1e-12; }},
        Lie{"curvature", "way-points",
            [](auto& c) { *claims(c, "hose").tangency[0].curvature /= 2; }},
        Lie{"touching", "oblique-nozzle",
            [](auto& c) { pair(c, "plate", "neck").overlap->point.z() += 1e-15; }},
        Lie{"touching_outside", "oblique-nozzle",
            [](auto& c) { pair(c, "plate", "neck").overlap->point.x() = 5; }},
        Lie{"ringed_mesh", "oblique-nozzle",
            [](auto& c) { claims(c, "blend").mesh->error_bound *= 0.5; }},
        Lie{"hollow", "jet-engine", [](auto& c) { chain(c, "shell").wall = 1; }},
        Lie{"hollow_mesh", "jet-engine",
            [](auto& c) {
              claims(c, "shell").mesh = MeshClaim{100, 0, {0, 1, 2, 3}, 1};
            }},
        Lie{"hollow_skin", "jet-engine",
            [](auto& c) { claims(c, "shell").mesh->inner_knots.pop_back(); }},
        Lie{"hollow_bound", "jet-engine",
            [](auto& c) { claims(c, "shell").mesh->error_bound *= 0.5; }},
        Lie{"kneecap", "ucct-arm",
            [](auto& c) { claims(c, "arm").mesh->kneecaps->segments.front() = 3; }},
        Lie{"kneecap_ball", "ucct-arm",
            [](auto& c) { piece<CyclidePiece>(c, "arm").last.r += 1e-12; }},
        Lie{"kneecap_joint", "ucct-arm",
            [](auto& c) {
              pair(c, "arm", "shoulder").leaves = {kAllPairs, {{1, 2}, {0, 1}, {}}};
            }},
        Lie{"turned_back", "u-bend-cyclide",
            [](auto& c) { claims(c, "cyclide").embedded->leaves = {kAllPairs}; }},
        Lie{"spline_piece", "way-points",
            [](auto& c) {
              std::get<HermiteSpine>(piece<RingedSurface>(c, "hose", 2).spine).end_velocity *= 3;
            }},
        Lie{"loose_joint", "way-points",
            [](auto& c) {
              TangencyClaim& joint = claims(c, "hose").tangency[1];
              joint.offset = joint.axis_angle = 1;
            }},
        Lie{"spline_order", "way-points",
            [](auto& c) { std::swap(chain(c, "hose").pieces[0], chain(c, "hose").pieces[1]); }},
        Lie{"open_ring", "pipe-ring", [](auto& c) { chain(c, "ring").closed = false; }},
        Lie{"gap_in_ring", "pipe-ring", [](auto& c) { chain(c, "ring").pieces.pop_back(); }},
        Lie{"half_ring", "pipe-ring",
            [](auto& c) {
              auto& leaves = claims(c, "ring").embedded->leaves;
              leaves.resize(leaves.size() / 2);
            }},
        Lie{"semi_axis", "oval-duct",
            [](auto& c) { piece<EllipticTube>(c, "bend").first = ConstantRadius{2.5}; }},
        Lie{"other_ellipse", "oval-duct",
            [](auto& c) { piece<EllipticTube>(c, "bend").end.ellipse->across *= 1.01; }},
        Lie{"elliptic_margin", "oval-duct",
            [](auto& c) { claims(c, "twist").regular->margin += 0.05; }},
        Lie{"elliptic_refuted", "oval-duct",
            [](auto& c) { claims(c, "bend").embedded->verdict = Verdict::refuted; }},
        Lie{"elliptic_turn", "oval-duct",
            [](auto& c) { piece<EllipticTube>(c, "twist").turn = 0; }},
        Lie{"elliptic_mesh", "oval-duct", [](auto& c) { claims(c, "bend").mesh->axes *= 64; }},
        Lie{"elliptic_tangency", "oval-duct",
            [](auto& c) { claims(c, "twist").tangency[0].axis_angle = -1; }},
        Lie{"ringed_radius", "ringed-canal",
            [](auto& c) { piece<RationalRingedTube>(c, "blend").surface.radius[1] *= 3; }},
        Lie{"ringed_rotation", "ringed-canal",
            [](auto& c) {
              piece<RationalRingedTube>(c, "blend").surface.rotation.front()[2] += 1e-9;
            }},
        Lie{"ringed_deviation", "ringed-canal",
            [](auto& c) { claims(c, "blend").tangency[0].deviation = 0; }},
        Lie{"ringed_margin", "ringed-canal",
            [](auto& c) { claims(c, "blend").regular->margin += 0.1; }},
        Lie{"ringed_clearance", "ringed-canal",
            [](auto& c) { pair(c, "second", "ball").distance *= 1.2; }}),
    [](const auto& row) { return row.param.about; });

Certificate verified(std::vector<Part> parts) {
  const Certificate certificate = certify({"", Unit::millimetre, 0.05, {}, std::move(parts)});
  EXPECT_NO_THROW(verify(parse_certificate(certificate_json(certificate))));
  return certificate;
}

// A pipe, an elbow that turns by so much, and a pipe that may run back into the first.
Certificate turning(double degrees, double length) {
  const PortReference pipe{"a", End::end}, elbow{"turn", End::end};
  const double angle = degrees * std::numbers::pi / 180;
  return verified({{"a", PipeAlong{Place{Vec3::Zero(), Vec3::UnitX(), 1}, 10}},
                   {"turn", ElbowTurning{pipe, 2, angle, Vec3::UnitY()}},
                   {"b", PipeAlong{elbow, length}}});
}

TEST(Certificate, of_bent_joints_is_proved_beyond_the_joint) {
  Certificate certificate = turning(90, 5);
  EXPECT_EQ(certificate.findings(), 0u);
  for (const auto& [a, b] : {std::pair("a", "turn"), std::pair("turn", "b")}) {
    EXPECT_TRUE(certificate.joined(pair(certificate, a, b)));
    EXPECT_EQ(pair(certificate, a, b).distance, 0);
  }
  EXPECT_GT(pair(certificate, "a", "b").distance, 0.9 * std::sqrt(2));
}

// The elbow comes back to within its radius of the pipe that it began at.
TEST(Certificate, refutes_a_joint_whose_parts_meet_again) {
  Certificate certificate = turning(340, 0.5);
  const ClearanceClaim& claim = pair(certificate, "a", "turn");
  EXPECT_EQ(claim.verdict, Verdict::refuted);
  EXPECT_TRUE(claim.overlap.has_value());
  EXPECT_GT(certificate.findings(), 0u);
}

TEST(Certificate, knows_parts_that_only_touch) {
  const auto on_a_plate = [](double height, double radius) {
    return verified({{"plate", PipeBetween{{0, 0, -1}, {0, 0, 0}, 5}},
                     {"post", PipeBetween{{1, 0, height}, {1, 0, height + 3}, radius}}});
  };
  const ClearanceClaim touching = on_a_plate(0, 1).clearances[0];
  EXPECT_EQ(touching.verdict, Verdict::proved);
  EXPECT_TRUE(touching.overlap.has_value());
  const ClearanceClaim above = on_a_plate(0x1p-10, 1).clearances[0];
  EXPECT_EQ(above.verdict, Verdict::proved);
  EXPECT_FALSE(above.overlap.has_value());
}

TEST(Certificate, has_the_curvature_jump_of_blends) {
  const auto blend = [](Continuity continuity) {
    CyclicBlendOptions options;
    options.continuity = continuity;
    const Place start{Vec3::Zero(), Vec3::UnitX(), 1};
    const Place end{Vec3(8, 5, 2), Vec3::UnitY(), 0.8};
    return verified({{"a", PipeAlong{start, 3}},
                     {"b", PipeAlong{end, 3}},
                     {"blend", CyclicBlendBetween{{"a", End::end}, {"b", End::start}, options}}});
  };
  const Certificate g1 = blend(Continuity::g1), g2 = blend(Continuity::g2);
  for (const std::size_t end : {0, 1}) {
    EXPECT_GT(g1.claims[2].tangency[end].curvature, 1e-3);
    EXPECT_LT(g2.claims[2].tangency[end].curvature, 1e-10);
    EXPECT_EQ(g1.claims[0].tangency[end].curvature, 0);
  }
}

}  // namespace
}  // namespace dupin
