#include "dupin/blends/edit_chain.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "support/message_of.h"

namespace dupin {
namespace {

using test::sphere;

Assembly document(std::vector<Part> parts) {
  return {"d.json", Unit::millimetre, 0.01, {}, std::move(parts)};
}

Assembly hook() {
  return document(
      {{"hook",
        CyclideChainThrough{ChainDirection{Vec3(0, -1, 0), 0}, test::crane_hook_spheres(), {}}}});
}

// A chain whose first piece begins at a pipe's end.
Assembly hose() {
  return document({{"pipe", PipeBetween{Vec3(-3, 0, 0), Vec3(0, 0, 0), 1}},
                   {"hose", CyclideChainThrough{PortReference{"pipe", End::end},
                                                {sphere(2, 1, 0, .9), sphere(3, 3, 0, .8),
                                                 sphere(4, 5, 0, .9), sphere(6, 6, 0, 1)},
                                                {}}}});
}

std::vector<PeArc> pieces(Assembly assembly, const CyclideChainThrough& chain) {
  assembly.parts.back().shape = chain;
  return cyclide_pieces(resolve(assembly).parts.back().shape);
}

std::vector<PeArc> pieces(const Assembly& assembly) {
  return pieces(assembly, std::get<CyclideChainThrough>(assembly.parts.back().shape));
}

template <class Work>
std::string refusal(const Work& work) {
  try {
    (void)work();
  } catch (const Error& error) {
    EXPECT_TRUE(error.code() == Errc::invalid_argument || error.code() == Errc::infeasible_blend);
    return error.what();
  }
  return "not refused";
}

TEST(EditChain, finds_the_chain_that_is_meant) {
  const Part pipe{"pipe", PipeBetween{Vec3::Zero(), Vec3::UnitX(), 1}};
  const Part a{"a", CyclideChainThrough()}, b{"b", CyclideChainThrough()};
  EXPECT_EQ(find_chain(document({pipe, a}), {}), 1U);
  EXPECT_EQ(find_chain(document({pipe, a, b}), "b"), 2U);
  const auto fault = [](std::vector<Part> parts, const std::optional<std::string>& name) {
    return refusal([&] { return find_chain(document(std::move(parts)), name); });
  };
  EXPECT_EQ(fault({pipe}, {}), "d.json: the document has no cyclide_chain");
  EXPECT_EQ(fault({pipe}, "pipe"), "d.json: the document has no cyclide_chain");
  EXPECT_EQ(fault({a, pipe, b}, {}), "d.json: name one of the chains 'a', 'b'");
  EXPECT_EQ(fault({a, pipe, b}, "pipe"),
            "d.json: 'pipe' is no cyclide_chain of the document; there is 'a', 'b'");
}

TEST(EditChain, puts_a_junction_exactly_where_it_is_told) {
  const PeVector to = sphere(1.1, 2.5, .2, .8);
  const CyclideChainThrough moved = move_sphere(hook(), 0, 4, to);
  EXPECT_EQ(moved.spheres[4], to);
  const auto before = pieces(hook()), after = pieces(hook(), moved);
  EXPECT_EQ(after[1].end(), to);
  for (const std::size_t same : {0U, 4U, 5U}) {
    EXPECT_EQ(after[same], before[same]) << same;
  }
  // The next one stays as near to its place as two pieces from here to the one after allow.
  const auto moved_by = [&](const PeVector& junction) {
    const PeVector by = junction - before[2].end();
    return std::hypot(by.m.norm(), by.r);
  };
  for (int i = 1; i < 100; ++i) {
    try {
      const DoubleCyclide other = double_cyclide(to, after[1].end_tangent(), before[3].end(),
                                                 before[3].end_tangent(), i / 100.0);
      EXPECT_LT(moved_by(after[2].end()), moved_by(other.first.end()) + 1e-9) << i;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::infeasible_blend) << i;
    }
  }
}

TEST(EditChain, keeps_a_junction_on_its_locus_if_told) {
  const PeVector to = sphere(2.1, .9, .1, .97);
  const CyclideChainThrough moved = move_sphere(hook(), 0, 6, to, true);
  const auto before = pieces(hook()), after = pieces(hook(), moved);
  for (const std::size_t same : {0U, 1U, 4U, 5U}) {
    EXPECT_EQ(after[same], before[same]) << same;
  }
  EXPECT_NE(after[2].end(), to);
  EXPECT_LT((after[2].end().m - to.m).norm(), (before[2].end().m - to.m).norm()) << "but nearer";
}

TEST(EditChain, counts_spheres_from_the_port_it_begins_at) {
  const PeVector to = sphere(6, 6.5, .25, 1);
  const CyclideChainThrough moved = move_sphere(hose(), 1, 3, to);
  EXPECT_EQ(moved.spheres[3], to);
  const auto before = pieces(hose()), after = pieces(hose(), moved);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[1].start(), before[1].start());
  EXPECT_EQ(after[1].end(), to);
}

TEST(EditChain, pins_how_a_free_chain_begins) {
  const Assembly free = document(
      {{"c", CyclideChainThrough{
                 ChainFree(), {sphere(0, 0, 0, 1), sphere(2, 1, 0, 1), sphere(4, 0, 0, 1)}, {}}}});
  const CyclideChainThrough moved = move_sphere(free, 0, 2, sphere(4, .5, 1, 1));
  ASSERT_EQ(moved.tangents.size(), 1U);
  EXPECT_EQ(moved.tangents[0].sphere, 0U);
  EXPECT_EQ(pieces(free, moved)[0].start_tangent(), pieces(free)[0].start_tangent());
  // A bias sphere would decide as well.
  const CyclideChainThrough other = move_sphere(free, 0, 1, sphere(2, 2, 0, 1));
  EXPECT_EQ(pieces(free, other), pieces(free));
}

// A rotation about the axis of the cone at the junction, which all spheres after it follow.
TEST(EditChain, turns_what_follows_a_junction) {
  constexpr double kAngle = 0.5;
  const CyclideChainThrough twisted = twist_chain(hook(), 0, 6, kAngle);
  const auto before = pieces(hook()), after = pieces(hook(), twisted);
  const PeArc& next = before[3];
  const Eigen::AngleAxisd turn(kAngle, next.start_tangent().m.normalized());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Vec3 end = before[i].end().m, center = next.start().m;
    const Vec3 expected = i < 3 ? end : Vec3(center + turn * (end - center));
    EXPECT_LT((after[i].end().m - expected).norm(), 1e-13) << i;
    EXPECT_EQ(after[i].end().r, before[i].end().r);
    EXPECT_EQ(after[i] == before[i], i < 3) << i;
  }
  // Back again.
  Assembly back = hook();
  back.parts[0].shape = twisted;
  const auto again = pieces(back, twist_chain(back, 0, 6, -kAngle));
  EXPECT_LT((again.back().end().m - before.back().end().m).norm(), 1e-13);
}

TEST(EditChain, says_why_an_edit_is_refused) {
  const auto moved = [](const Assembly& assembly, std::size_t at, const PeVector& to) {
    const auto part = static_cast<std::uint32_t>(assembly.parts.size() - 1);
    return refusal([&] { return move_sphere(assembly, part, at, to); });
  };
  const auto twisted = [](const Assembly& assembly, std::size_t at) {
    const auto part = static_cast<std::uint32_t>(assembly.parts.size() - 1);
    return refusal([&] { return twist_chain(assembly, part, at, 1); });
  };
  const PeVector good = sphere(0, 8, 0, 1);
  const std::string spheres = "d.json#/parts/0/cyclide_chain/spheres: 'hook': ";
  EXPECT_EQ(moved(hook(), 13, good), spheres + "there is no sphere 13; the last is 12");
  EXPECT_EQ(moved(hook(), 0, good), spheres + "the chain's first sphere cannot be moved alone");
  EXPECT_EQ(moved(hook(), 4, sphere(0, 8, 0, -1)),
            spheres + "a sphere needs finite coordinates and a positive radius, not -1");
  EXPECT_EQ(twisted(hook(), 5),
            spheres + "sphere 5 is no junction between two pieces; these are 2, 4, 6, 8, 10");
  EXPECT_EQ(twisted(hook(), 12),
            spheres + "sphere 12 is no junction between two pieces; these are 2, 4, 6, 8, 10");
  EXPECT_EQ(twisted(hose(), 2),
            "d.json#/parts/1/cyclide_chain/spheres: 'hose': sphere 2 is no junction between two "
            "pieces; these are 1");
  const std::string far =
      "d.json#/parts/0/cyclide_chain/spheres/4: 'hook': sphere 4 cannot be "
      "moved there: ";
  EXPECT_EQ(moved(hook(), 4, sphere(0, 4, 0, 4)).substr(0, far.size()), far);
}

TEST(EditChain, is_checked_against_a_margin_that_can_be) {
  const Assembly any = document({{"pipe", PipeBetween{Vec3::Zero(), Vec3::UnitX(), 1}}});
  for (const double margin : {1., std::nan("")}) {
    EXPECT_EQ(test::message_of([&] { check_edit(any, 0, margin); }, Errc::invalid_argument),
              "the margin of an edit must be less than 1, not " + decimal(margin));
  }
}

TEST(EditChain, refuses_parts_that_are_no_chain) {
  const Assembly with_pipe = document({{"pipe", PipeBetween{Vec3::Zero(), Vec3::UnitX(), 1}}});
  const std::string no_chain =
      "d.json#/parts/0: 'pipe': the part is no cyclide_chain; other parts have no spheres to move "
      "or to turn about";
  EXPECT_EQ(refusal([&] { return move_sphere(with_pipe, 0, 2, sphere(0, 0, 0, 1)); }), no_chain);
  EXPECT_EQ(refusal([&] { return twist_chain(with_pipe, 0, 2, 1); }), no_chain);
  const std::string no_part = "d.json: there is no part 7; the document has 1";
  EXPECT_EQ(refusal([&] { return move_sphere(with_pipe, 7, 2, sphere(0, 0, 0, 1)); }), no_part);
  EXPECT_EQ(refusal([&] { return twist_chain(with_pipe, 7, 2, 1); }), no_part);
  for (const auto& [part, fault] : {std::pair(0U, no_chain), std::pair(7U, no_part)}) {
    EXPECT_EQ(test::message_of([&] { (void)turned_pieces(with_pipe, part, 0); }), fault);
    EXPECT_EQ(test::message_of([&] { check_edit(with_pipe, part, 0); }), fault);
  }
}

TEST(EditChain, turns_by_finite_angles) {
  for (const double angle : {std::nan(""), double(INFINITY)}) {
    EXPECT_NE(refusal([&] {
                return twist_chain(hook(), 0, 2, angle);
              }).find("a chain is turned by a finite angle"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace dupin
