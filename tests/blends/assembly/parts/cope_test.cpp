#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/kernel/error.h"
#include "support/named_parts.h"

namespace dupin {
namespace {

using test::pipe;

constexpr double kRun = 4;

Part cope(const std::string& name, const std::string& part, End end, const std::string& to) {
  return {name, CopeOfEnd{{part, end}, to}};
}
Assembly assembly(std::vector<Part> parts, double tolerance = 0.02) {
  return {"d.json", Unit::millimetre, tolerance, {}, std::move(parts)};
}

std::string refused(const Assembly& document) {
  try {
    (void)build(document);
    return "built";
  } catch (const Error& error) {
    return error.what();
  }
}

struct Tee {
  double ratio, offset, degrees;

  [[nodiscard]] Assembly document(bool with_cope, double tolerance = 0.02) const {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3 direction(std::cos(angle), std::sin(angle), 0), at(0, 0, offset * kRun);
    std::vector<Part> parts{pipe("run", {-60, 0, 0}, {60, 0, 0}, kRun),
                            pipe("branch", at, at + 30 * direction, ratio * kRun)};
    if (with_cope) {
      parts.push_back(cope("cut", "branch", End::start, "run"));
    }
    return assembly(std::move(parts), tolerance);
  }
};

// Nothing is added to or taken from the union of both pipes, which another engine makes.
TEST(Cope, of_tees_of_all_kinds_is_the_union_of_both_pipes) {
  int count = 0;
  for (const double ratio : {0.25, 0.5, 0.75, 1.0}) {
    for (const double offset : {0.0, 0.25, 0.5, 0.75}) {
      if (ratio + offset > 1) {
        continue;  // its end would not lie in the run
      }
      for (const double degrees : {90, 60, 45, 30}) {
        SCOPED_TRACE(testing::Message() << ratio << ' ' << offset << ' ' << degrees);
        const Tee tee{ratio, offset, double(degrees)};
        const Built built = build(tee.document(true));
        const double united = build(tee.document(false)).solid.exact_volume().get_d();
        EXPECT_NEAR(built.solid.exact_volume().get_d(), united, 2e-3 * united);
        EXPECT_EQ(built.solid.genus(), 0);
        EXPECT_EQ(built.solid.components(), 1U);
        EXPECT_EQ(built.pieces, 1U) << "nothing was united";
        ++count;
      }
    }
  }
  EXPECT_EQ(count, 40);
}

// A branch of radius r on a run of radius R at right angles through its axis covers of it
// the integral of sqrt(R^2 - y^2) over the disc.
TEST(Cope, cuts_off_what_lies_in_the_run_to_second_order) {
  const double r = 0.5 * kRun, R = kRun;
  double inside = 0;
  const int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double y = -r + 2 * r * (i + 0.5) / steps;
    inside += 2 * std::sqrt(r * r - y * y) * std::sqrt(R * R - y * y) * 2 * r / steps;
  }
  const double expected = std::numbers::pi * (R * R * 120 + r * r * 30) - inside;
  const auto fault = [&](double tolerance) {
    return std::abs(build(Tee{0.5, 0, 90}.document(true, tolerance)).solid.exact_volume().get_d() -
                    expected);
  };
  EXPECT_LT(fault(0.001), 5e-4 * expected) << "the sagitta of its circles";
  EXPECT_LT(fault(0.001), fault(0.02) / 10);
}

// All corners but the ends' are on both pipes, and every triangle is on one of them.
TEST(Cope, leaves_patches_of_both_pipes_that_meet_in_corners_of_both) {
  const Built built = build(Tee{0.75, 0.25, 60}.document(true));
  EXPECT_THAT(built.solid.names(),
              testing::UnorderedElementsAre("run", "run.start", "run.end", "branch", "branch.end"));
  ASSERT_EQ(built.parts.size(), 3U);
  EXPECT_EQ(built.parts[2].kind, "cope");
  EXPECT_FALSE(built.parts[2].margin_lower) << "there is no ball";
  EXPECT_EQ(built.parts[2].triangles, 0U);
  for (const PartReport& part : built.parts) {
    EXPECT_GT(part.error_bound, 0) << part.name;
    EXPECT_LE(part.error_bound, 0.02) << part.name;
  }
  const Vec3 direction(0.5, std::sqrt(0.75), 0);
  std::vector<int> of_run(built.solid.nearest_points().size()), of_branch = of_run;
  const auto& triangles = built.solid.triangles();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::string& name = built.solid.names()[built.solid.labels()[i]];
    for (const std::uint32_t v : triangles[i]) {
      of_run[v] += name == "run" ? 1 : 0;
      of_branch[v] += name == "branch" ? 1 : 0;
    }
  }
  int common = 0;
  for (std::size_t v = 0; v < of_run.size(); ++v) {
    if (of_run[v] > 0 && of_branch[v] > 0) {
      const Vec3 p = built.solid.nearest_points()[v];
      const Vec3 q = p - Vec3(0, 0, kRun / 4);
      EXPECT_NEAR(std::hypot(p.y(), p.z()), kRun, 1e-3);
      EXPECT_NEAR((q - q.dot(direction) * direction).norm(), 0.75 * kRun, 1e-3);
      ++common;
    }
  }
  EXPECT_GT(common, 40);
}

TEST(Cope, goes_along_with_fillets_and_other_copes) {
  const Built built = build(assembly({pipe("run", {-60, 0, 0}, {60, 0, 0}, kRun),
                                      pipe("a", {-30, 0, 0}, {-30, 20, 0}, 2),
                                      pipe("b", {0, 0, 0}, {0, 0, 20}, 4),
                                      pipe("c", {30, 0, 0}, {30, 20, 20}, 3),
                                      cope("a-cut", "a", End::start, "run"),
                                      cope("b-cut", "b", End::start, "run"),
                                      {"c-fillet", FilletBetween{{"c", "run"}, 1}}}));
  EXPECT_EQ(built.solid.genus(), 0);
  EXPECT_EQ(built.pieces, 1U);
}

// The pipe that ends inside is the one that is cut, also where both are equally thick.
TEST(Cope, of_equal_pipes_does_not_depend_on_their_order) {
  for (const bool first : {true, false}) {
    std::vector<Part> parts{pipe("run", {-60, 0, 0}, {60, 0, 0}, kRun),
                            pipe("branch", {0, 0, 0}, {0, 0, 30}, kRun)};
    parts.push_back(
        {"throat", FilletBetween{{first ? "branch" : "run", first ? "run" : "branch"}, 0.5}});
    EXPECT_EQ(build(assembly(parts)).solid.genus(), 0) << first;
  }
}

TEST(Cope, has_certified_pipes) {
  const Certificate certificate = certify(Tee{0.5, 0.25, 60}.document(true));
  EXPECT_EQ(certificate.findings(), 0U);
  EXPECT_TRUE(certificate.fillets.empty());
  EXPECT_NO_THROW(verify(certificate));
}

TEST(Cope, says_why_an_end_cannot_be_cut) {
  using testing::HasSubstr;
  const Part run = pipe("run", {-60, 0, 0}, {60, 0, 0}, kRun);
  EXPECT_THAT(refused(assembly(
                  {run, pipe("b", {0, 0, 0}, {0, 30, 0}, 2), cope("cut", "b", End::end, "run")})),
              HasSubstr("'b.end' does not lie inside 'run'"));
  EXPECT_THAT(refused(assembly({run, cope("cut", "run", End::end, "run")})),
              HasSubstr("another part"));
  EXPECT_THAT(refused(assembly(
                  {run, pipe("b", {0, 9, 0}, {0, 30, 0}, 2), cope("cut", "b", End::start, "run")})),
              HasSubstr("do not cross within their lengths"));
  EXPECT_THAT(refused(assembly({run, pipe("b", {50, 0, 0}, {70, 0, 0}, 2),
                                cope("cut", "b", End::start, "run")})),
              HasSubstr("axes are parallel"));
  EXPECT_THAT(refused(assembly({run, pipe("b", {59, 0, 0}, {59, 30, 0}, 2),
                                cope("cut", "b", End::start, "run")})),
              HasSubstr("runs over the end of 'run' by 1"));
  EXPECT_THAT(refused(assembly({run,
                                pipe("b", {0, 0, 0}, {0, 30, 0}, 2),
                                pipe("c", {0, 0, 0}, {0, -30, 0}, 2),
                                {"bend", ElbowTo{PortReference{"b", End::start}, {9, 9, 9}}},
                                cope("cut", "b", End::start, "run")})),
              HasSubstr("b.start"));
}

}  // namespace
}  // namespace dupin
