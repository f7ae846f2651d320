#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "assembly/parts/cyclide_part.h"
#include "blends/assembly/part_fixture_internal.h"
#include "dupin/blends/cyclide_tube.h"
#include "support/cyclide_cases.h"

namespace dupin::assembly {
namespace {

using test::fault_of;
using test::LonePart;
using test::sphere;

const PartSurface kPipe = RingedSurface{{Vec3(-3, 0, 0), Vec3(-1, 0, 0), 1},
                                        {Vec3::Zero(), Vec3(1, 0, 0), 1},
                                        LineSpine{Vec3(-3, 0, 0), Vec3::Zero()},
                                        ConstantRadius{1}};
const PortReference kPort{"pipe", End::end};

Chain made(const CyclideChainThrough& chain) {
  const LonePart part(chain, {{"pipe", kPipe}});
  return std::get<Chain>(cyclide_chain(part.context(), chain));
}

// The ends of the pieces are the junctions, bitwise.
void expect_through(const Chain& chain, const std::vector<PeVector>& junctions) {
  const std::vector<PeArc> pieces = cyclide_pieces(chain);
  ASSERT_EQ(pieces.size() + 1, junctions.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_EQ(pieces[i].start(), junctions[i]);
    EXPECT_EQ(pieces[i].end(), junctions[i + 1]);
  }
}

// The quarter of a torus of radii 3 and 1 that leaves (3, 0, 0) along y.
TEST(CyclidePart, of_a_circle_of_equal_spheres_is_a_torus) {
  const double part = 3 * std::sqrt(0.5);
  const std::vector<PeVector> spheres = {sphere(3, 0, 0, 1), sphere(part, part, 0, 1),
                                         sphere(0, 3, 0, 1)};
  for (const CyclideChainThrough& chain :
       {CyclideChainThrough{ChainFree(), spheres, {}},
        CyclideChainThrough{ChainDirection{Vec3(0, 5, 0), 0}, spheres, {}},
        CyclideChainThrough{ChainFree(), spheres, {{0, {Vec3::UnitY(), 0}}}}}) {
    const Chain torus = made(chain);
    expect_through(torus, {spheres[0], spheres[2]});
    constexpr double kPi = std::numbers::pi;
    EXPECT_NEAR(volume(torus), kPi * 3 * kPi / 2, 1e-9);
  }
}

TEST(CyclidePart, goes_on_from_a_port) {
  const Chain chain = made({kPort, {sphere(2, 1, 0, .9), sphere(3, 3, 1, .8)}, {}});
  expect_through(chain, {sphere(0, 0, 0, 1), sphere(3, 3, 1, .8)});
  EXPECT_EQ(*port_ring(chain, End::start), (Ring{Vec3::Zero(), Vec3(-1, 0, 0), 1}));
}

TEST(CyclidePart, a_wall_makes_it_hollow) {
  const std::vector<PeVector> spheres = {sphere(0, 0, 0, 1), sphere(2, 0, 0, 1),
                                         sphere(4, 0, 0, 1)};
  const Chain chain = made({ChainFree(), spheres, {}, 0.25});
  EXPECT_EQ(chain.wall, 0.25);
  EXPECT_EQ(port_ring(PartSurface(chain), End::start), nullptr);
  EXPECT_NEAR(volume(chain), std::numbers::pi * (1 - 0.5625) * 4, 1e-9) << "a straight pipe";
}

TEST(CyclidePart, kneecaps_join_pieces_of_three_spheres_each) {
  const std::vector<PeVector> spheres = {sphere(0, 0, 0, 1), sphere(2, 1, 0, .8),
                                         sphere(4, 1, 0, 1), sphere(6, .2, 0, .9),
                                         sphere(8, 1, 0, .7)};
  const Chain chain = made({ChainFree(), spheres, {}, 0, ChainJoints::kneecaps});
  EXPECT_EQ(chain.joints, Joints::spherical);
  expect_through(chain, {spheres[0], spheres[2], spheres[4]});
}

std::string fault(const CyclideChainThrough& chain, Errc code = Errc::invalid_argument) {
  const LonePart part(chain, {{"pipe", kPipe}});
  const std::string prefix = "cyclide_chain/";
  const std::string text = fault_of([&] { return cyclide_chain(part.context(), chain); }, code);
  return text.empty() ? text : text.substr(prefix.size());
}

const std::vector<PeVector> kGood = {sphere(0, 0, 0, 1), sphere(2, 0, 0, 1), sphere(4, 0, 0, 1)};

TEST(CyclidePart, says_which_number_is_wrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [&](std::size_t index, const PeVector& bad) {
    std::vector<PeVector> spheres = kGood;
    spheres[index] = bad;
    return fault({ChainFree(), spheres, {}});
  };
  const std::string positive = ": must be a positive number between 1e-12 and 1e12, not ",
                    finite = ": coordinates must be finite numbers of at most 1e12";
  EXPECT_EQ(with(0, sphere(0, 0, 0, -1)), "spheres/0" + positive + "-1");
  EXPECT_EQ(with(2, sphere(4, 0, 0, 0)), "spheres/2" + positive + "0");
  EXPECT_EQ(with(2, sphere(4, 0, 0, 1e-13)), "spheres/2" + positive + "1e-13");
  EXPECT_EQ(with(2, sphere(4, 0, 0, 2e12)), "spheres/2" + positive + "2e+12");
  EXPECT_EQ(with(1, sphere(nan, 0, 0, 3)), "spheres/1" + finite);
  EXPECT_EQ(with(1, sphere(1e300, 0, 0, 3)), "spheres/1" + finite);
  EXPECT_EQ(fault({ChainFree(), kGood, {}, -0.5}), "wall" + positive + "-0.5");
  EXPECT_EQ(fault({ChainDirection{Vec3::Zero(), 0}, kGood, {}}),
            "direction: the direction must be finite and not zero");
  EXPECT_EQ(fault({ChainDirection{Vec3::UnitX(), nan}, kGood, {}}),
            "direction: the direction must be finite and not zero");
}

TEST(CyclidePart, says_how_many_spheres_it_needs) {
  const std::string turns = ": junctions and bias spheres in turn, not ";
  std::vector<PeVector> spheres;
  for (std::size_t count = 0; count <= 4; ++count) {
    const std::string number = std::to_string(count);
    EXPECT_EQ(fault({ChainFree(), spheres, {}}),
              count == 3 ? ""
                         : "spheres: a chain needs an odd number of spheres, three at least" +
                               turns + number);
    EXPECT_EQ(fault({kPort, spheres, {}}),
              count == 2 || count == 4
                  ? ""
                  : "spheres: a chain from a port needs an even number of spheres, two at least" +
                        turns + number);
    spheres.push_back(sphere(2 + 2 * double(count), 0, 0, 1));
  }
}

TEST(CyclidePart, says_what_does_not_go_together) {
  const PeVector along{Vec3::UnitX(), 0};
  EXPECT_EQ(fault({kPort, {kGood[1], kGood[2]}, {}, 0.5}),
            "wall: a hollow chain has no ports and begins at none");
  EXPECT_EQ(fault({ChainFree(), kGood, {{1, along}}}), "tangents/0/sphere: there is no junction 1");
  EXPECT_EQ(fault({ChainFree(), kGood, {{0, along}, {4, along}}}),
            "tangents/1/sphere: there is no junction 4");
  EXPECT_EQ(fault({kPort, {kGood[1], kGood[2]}, {{0, along}}}),
            "tangents/0/sphere: there is no junction 0")
      << "of the document's spheres the first is a bias sphere";
  const auto knees = ChainJoints::kneecaps;
  EXPECT_EQ(fault({ChainFree(), kGood, {{0, along}}, 0, knees}),
            "tangents: a chain with kneecaps takes no 'tangents'");
  EXPECT_EQ(fault({kPort, {kGood[1], kGood[2]}, {}, 0.5, knees}),
            "wall: a hollow chain has no ports and begins at none");
}

// A last sphere within the junction before it.
TEST(CyclidePart, lays_faults_of_a_piece_at_the_sphere_it_leads_to) {
  const auto place = [](const CyclideChainThrough& chain) {
    const std::string text = fault(chain, Errc::infeasible_blend);
    return text.substr(0, text.find(" is not regular"));
  };
  std::vector<PeVector> spheres = kGood;
  spheres.push_back(sphere(6, 0, 0, 1));
  spheres.push_back(sphere(4.125, 0, 0, 0.5));
  const ChainDirection along{Vec3::UnitX(), 0};
  EXPECT_EQ(place({along, spheres, {}}).substr(0, 18), "spheres/4: piece 1");
  spheres.erase(spheres.begin());
  EXPECT_EQ(place({kPort, spheres, {}}).substr(0, 18), "spheres/3: piece 1");
  EXPECT_EQ(place({ChainFree(), {sphere(0, 0, 0, 2), sphere(0.5, 0, 0, 1), sphere(3, 0, 0, 1)}, {}})
                .substr(0, 8),
            "spheres:")
      << "no piece yet";
}

}  // namespace
}  // namespace dupin::assembly
