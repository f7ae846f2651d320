#include "dupin/blends/build.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/cyclide_tube.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "support/named_parts.h"
#include "support/single_piece.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

using test::pipe;

constexpr double kPi = std::numbers::pi;

Assembly example(const std::string& name) {
  return read_assembly(test::source_folder() / "examples" / name);
}

PortReference start_of(const std::string& part) { return {part, End::start}; }
PortReference end_of(const std::string& part) { return {part, End::end}; }

Assembly assembly(std::vector<Part> parts, double tolerance = 0.02) {
  return {"", Unit::millimetre, tolerance, {}, std::move(parts)};
}

// Smooth volume of one part and the area of its surface, the discs included, that the error bound
// can move.
double smooth_volume(const ResolvedPart& part) {
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    return 4 * kPi / 3 * std::pow(sphere->radius, 3);
  }
  const auto& chain = std::get<Chain>(part.shape);
  const auto* tube = std::get_if<RingedSurface>(&chain.pieces.front());
  return tube != nullptr ? volume(*tube) : volume(chain);
}

double smooth_area(const ResolvedPart& part) {
  if (const auto* sphere = std::get_if<Sphere>(&part.shape)) {
    return 4 * kPi * sphere->radius * sphere->radius;
  }
  const auto& chain = std::get<Chain>(part.shape);
  const auto* tube = std::get_if<RingedSurface>(&chain.pieces.front());
  return tube != nullptr ? area(*tube) : area(chain);
}

double smooth_volume(const ResolvedAssembly& resolved) {
  double sum = 0;
  for (const auto& part : resolved.parts) {
    sum += smooth_volume(part);
  }
  return sum;
}

// A mesh within e of a surface of area A encloses a volume within e A (1 + e kappa) of the smooth
// one; e kappa is far below 0.1 in the examples, so 1.1 e A is a bound.
double volume_bound(const ResolvedAssembly& resolved, const Built& built) {
  double bound = 0;
  for (std::size_t i = 0; i < resolved.parts.size(); ++i) {
    bound += 1.1 * built.parts[i].error_bound * smooth_area(resolved.parts[i]);
  }
  return bound;
}

struct Expectation {
  std::size_t runs = 1, pieces = 1, components = 1;
  // Places where pieces meet: in a ball, or at a port in a disc, where a closed one meets itself.
  std::size_t meetings = 0;
  double volume = 0;

  // Euler characteristics add up but for what is counted twice, and balls and discs have 1; a
  // boundary has twice the number of its solid.
  [[nodiscard]] std::int64_t euler_number() const {
    return 2 * (static_cast<std::int64_t>(pieces) - static_cast<std::int64_t>(meetings));
  }
};

void expect_solid(const std::string& name, const Assembly& document, const Expectation& expected) {
  const auto resolved = resolve(document);
  const Built built = build(document);
  const Report report = check(to_mesh(built.solid).mesh());
  EXPECT_TRUE(report.is_solid()) << name;
  EXPECT_EQ(report.count(Defect::self_intersection), 0U) << name;
  EXPECT_EQ(report.euler_number, expected.euler_number()) << name;
  EXPECT_EQ(report.components, expected.components) << name;
  EXPECT_EQ(built.runs, expected.runs) << name;
  EXPECT_EQ(built.pieces, expected.pieces) << name;
  EXPECT_NEAR(report.volume, expected.volume, volume_bound(resolved, built)) << name;
  for (const auto& part : built.parts) {
    EXPECT_LE(part.error_bound, document.tolerance) << name << " " << part.name;
    EXPECT_GT(part.triangles, 0U) << name << " " << part.name;
  }
}

TEST(Build, makes_one_solid_of_every_reducer) {
  // Volumes of mathematics A.9 and closed forms.
  struct Row {
    std::string name;
    double volume;
  };
  const Row rows[] = {
      {"reducer.json", 98.7626771261853 + 10 * kPi + 40 * kPi},
      {"straight-reducer.json", 617.726875485855916 + 4 * kPi + 324 * kPi},
      {"straight-reducer-r2.json", 150 * kPi + 4 * kPi + 324 * kPi},
      {"coplanar.json", smooth_volume(resolve(example("coplanar.json")))},
      {"cone-to-pipe.json", smooth_volume(resolve(example("cone-to-pipe.json")))},
      {"u-bend.json", 713.7864803597 + 40 * kPi + 160 * kPi},
  };
  for (const auto& row : rows) {
    expect_solid(row.name, example(row.name), {1, 1, 1, 0, row.volume});
  }
}

TEST(Build, makes_solids_of_chains_and_blends_of_cyclides) {
  // Volumes of mathematics C1 and closed forms; the jet engine's wall is checked in
  // cyclide_tube_test.
  const double hook = 32.431540285655 + 1.5 * kPi * 0.55 * 0.55;
  const double shell = smooth_volume(resolve(example("jet-engine.json")));
  expect_solid("crane-hook.json", example("crane-hook.json"), {1, 1, 1, 0, hook});
  expect_solid("crane-hook-twisted.json", example("crane-hook-twisted.json"), {1, 1, 1, 0, hook});
  expect_solid("jet-engine.json", example("jet-engine.json"), {1, 1, 1, 1, shell});
  for (const std::string name : {"reducing-elbow.json", "skew-pipes.json"}) {
    const Assembly document = example(name);
    expect_solid(name, document, {1, 1, 1, 0, smooth_volume(resolve(document))});
    EXPECT_EQ(build(document).parts[2].construction, "double");
  }
  const Assembly bends = example("u-bend-cyclide.json");
  expect_solid("u-bend-cyclide.json", bends, {2, 2, 2, 0, smooth_volume(resolve(bends))});
  EXPECT_EQ(build(bends).parts[2].construction, "single");
  for (const std::string name :
       {"crane-hook.json", "crane-hook-twisted.json", "jet-engine.json", "reducing-elbow.json",
        "skew-pipes.json", "u-bend-cyclide.json", "ucct-arm.json", "cyclide-blends.json"}) {
    const Solid solid = build(example(name)).solid;
    const Report exact = check(to_mesh(solid).mesh());
    const Report rounded = check(to_mesh(solid, Coordinates::binary32).mesh());
    EXPECT_TRUE(rounded.is_solid()) << name;
    EXPECT_EQ(rounded.count(Defect::self_intersection), 0U) << name;
    EXPECT_EQ(rounded.euler_number, exact.euler_number) << name;
  }
}

TEST(Build, cyclide_blends_say_what_they_are_and_why_not_less) {
  const Assembly document = example("cyclide-blends.json");
  const Built built = build(document);
  const std::string kConstructions[] = {"single", "double", "triple", "ringed"};
  for (std::size_t i = 0; i < 4; ++i) {
    const PartReport& part = built.parts.at(3 * i + 2);
    SCOPED_TRACE(part.name);
    EXPECT_EQ(part.construction, kConstructions[i]);
    // What is not tangent to the ports, or crosses itself, is no blend at all.
    EXPECT_LT(*part.start_tangency, 1e-12);
    EXPECT_LT(*part.end_tangency, 1e-12);
    EXPECT_GT(*part.margin_lower, 0.05);
    ASSERT_EQ(part.rejected.size(), i);
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_THAT(part.rejected[k], testing::StartsWith(kConstructions[k] + ": "));
    }
  }
  EXPECT_THAT(built.parts[5].rejected[0], testing::HasSubstr("off its half angle by 7.66 degrees"));
  EXPECT_THAT(built.parts[8].rejected[1], testing::HasSubstr("no locus of junction spheres"));
  EXPECT_THAT(built.parts[11].rejected[2], testing::HasSubstr("cross themselves"));
  EXPECT_EQ(check(to_mesh(built.solid).mesh()).euler_number, 8);
}

// Where one end's sphere contains, or nearly, the other's no cyclides join them that do not
// cross themselves. If the ports are too near each other for a ringed blend too, all reasons are
// given.
TEST(Build, cyclide_blends_fall_back_to_ringed_ones_or_give_every_reason) {
  struct Row {
    double radius, offset, height;
    const char* reason;
  };
  for (const Row& row : {Row{5, 0, 2, ""}, Row{5, 0.3, 4.5, ""}, Row{2, 0, 0.8, ""},
                         Row{5, 0.3, 2, "ringed: no end speeds"}}) {
    const Assembly document =
        assembly({pipe("a", {0, 0, -1}, {0, 0, 0}, row.radius),
                  pipe("b", {row.offset, 0, row.height}, {row.offset, 0, row.height + 1}, 1),
                  {"blend", CyclideBlendBetween{end_of("a"), start_of("b")}}});
    try {
      const Built built = build(document);
      EXPECT_STREQ(row.reason, "");
      EXPECT_EQ(built.parts[2].construction, "ringed");
      EXPECT_LT(*built.parts[2].start_tangency, 1e-12);
      EXPECT_LT(*built.parts[2].end_tangency, 1e-12);
      EXPECT_THAT(built.parts[2].rejected, testing::ElementsAre(testing::HasSubstr("single: "),
                                                                testing::HasSubstr("double: "),
                                                                testing::HasSubstr("triple: ")));
      EXPECT_EQ(built.solid.euler_number(), 2);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::infeasible_blend);
      EXPECT_EQ(error.part(), "blend");
      for (const std::string reason : {"single: ", "double: ", "triple: ", row.reason}) {
        EXPECT_THAT(error.message(), testing::HasSubstr(reason));
      }
      EXPECT_STRNE(row.reason, "");
    }
  }
}

TEST(Build, cyclide_blends_go_on_from_right_ends_only) {
  const Assembly document =
      assembly({{"oblique", ObliqueBetween{{0, 0, -2}, {1, 0, 0}, Vec3::UnitZ(), 1, 1}},
                pipe("b", {4, 0, 4}, {5, 0, 4}, 1),
                {"blend", CyclideBlendBetween{end_of("oblique"), start_of("b")}}});
  try {
    (void)build(document);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "/parts/2/cyclide_blend/from");
    EXPECT_THAT(error.message(), testing::HasSubstr("only a ringed_blend"));
  }
}

TEST(Build, cyclide_parts_share_their_rings_and_are_tangent_there) {
  const Assembly document = example("skew-pipes.json");
  const Built built = build(document);
  EXPECT_LT(*built.parts[2].start_tangency, 1e-15);
  EXPECT_LT(*built.parts[2].end_tangency, 1e-15);
  EXPECT_EQ(built.gaps.size(), 4U);  // two welded pairs, two open ends
  EXPECT_EQ(
      std::count_if(built.gaps.begin(), built.gaps.end(),
                    [](const GapPair& pair) { return pair.report.verdict == GapVerdict::welded; }),
      2);
}

TEST(Build, a_chain_goes_on_from_a_port) {
  const Assembly document = assembly(
      {pipe("a", {-3, 0, 0}, {0, 0, 0}, 1),
       {"chain",
        CyclideChainThrough{end_of("a"), {{Vec3(2, 1, 0), .9}, {Vec3(3, 3, 1), .8}}, {}, 0}},
       {"c", PipeAlong{end_of("chain"), 2}}});
  const auto resolved = resolve(document);
  EXPECT_EQ(*port_ring(resolved.parts[1].shape, End::start),
            flipped(*port_ring(resolved.parts[0].shape, End::end)));
  expect_solid("chain", document, {1, 1, 1, 0, smooth_volume(resolved)});
}

TEST(Build, warns_of_a_piece_that_turns_away_from_its_bias_sphere) {
  const Assembly document =
      assembly({{"chain", CyclideChainThrough{
                              ChainDirection{Vec3::UnitX(), 0},
                              {{Vec3(0, 0, 0), .5}, {Vec3(-2, 2, 0), .5}, {Vec3(0, 4, 0), .5}},
                              {},
                              0}}});
  const Built built = build(document);
  EXPECT_THAT(built.parts[0].warnings, testing::ElementsAre("piece 0 turns away from sphere 1"));
}

TEST(Build, refuses_chains_with_the_reason_the_value_and_the_sphere) {
  // Mathematics C7.
  struct Row {
    ChainDirection direction;
    std::vector<PeVector> spheres;
    std::string value;
  };
  const PeVector unit{Vec3::Zero(), 1}, bias{Vec3(0, 0, 9), 1};
  const ChainDirection up{Vec3::UnitZ(), 0};
  const Row rows[] = {
      {up, {unit, bias, {Vec3(.3, 0, 0), 1.5}}, "-0.16"},
      {up, {unit, bias, {Vec3(0, 0, -3), 2}}, "-1.06066 must"},
      {up, {unit, bias, {Vec3(.8, 0, .8), 1}}, "-0.32"},
      {{Vec3::UnitZ(), -.7 / std::sqrt(.51)}, {unit, bias, {Vec3(5, 0, 3), .2}}, "-1.79195"},
  };
  for (const Row& row : rows) {
    Assembly document =
        assembly({{"chain", CyclideChainThrough{row.direction, row.spheres, {}, 0}}});
    document.source = "c.json";
    try {
      (void)build(document);
      FAIL() << row.value;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::infeasible_blend);
      EXPECT_EQ(error.part(), "chain");
      EXPECT_EQ(error.where(), "c.json#/parts/0/cyclide_chain/spheres/2");
      EXPECT_THAT(error.message(), testing::HasSubstr(row.value));
    }
  }
}

TEST(Build, refuses_ports_of_hollow_chains) {
  const std::vector<PeVector> spheres{{Vec3(0, 0, 0), 1}, {Vec3(2, 1, 0), .9}, {Vec3(3, 3, 1), .8}};
  const Assembly document = assembly({{"shell", CyclideChainThrough{ChainFree(), spheres, {}, .1}},
                                      {"pipe", PipeAlong{end_of("shell"), 2}}});
  try {
    (void)build(document);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "/parts/1/pipe/from");
    EXPECT_THAT(error.message(), testing::HasSubstr("hollow"));
  }
}

TEST(Build, unites_a_header_with_its_branches) {
  // A branch of radius r from the axis of a pipe of radius 1, at an angle a to it: of every line
  // along the branch, at v across, (sqrt(1 - v^2) - u cos a) / sin a lies inside. The second term
  // cancels over the disc; the trapezoid rule is exact to all digits for the periodic first.
  const auto inside = [](double sine) {
    const double r = 0.5;
    constexpr int kSteps = 64;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const double phi = kPi * i / kSteps;
      sum += std::sqrt(1 - std::pow(r * std::sin(phi), 2)) * 2 * std::pow(r * std::cos(phi), 2);
    }
    return sum * kPi / kSteps / sine;
  };
  const Assembly header = example("header.json");
  const double overlap = 4 * inside(1) + 3 * inside(std::sqrt(0.5)) + 3 * inside(std::sqrt(0.8));
  expect_solid("header.json", header, {11, 11, 1, 10, smooth_volume(resolve(header)) - overlap});
}

// The part of a cylinder of radius r about a diameter of a sphere that lies inside it and further
// than h from the centre, on one side.
double bored(double sphere, double r, double h) {
  return 2 * kPi / 3 * (std::pow(sphere, 3) - std::pow(sphere * sphere - r * r, 1.5)) -
         kPi * r * r * h;
}

TEST(Build, makes_one_solid_of_the_plant_run) {
  const Assembly plant = example("plant-run.json");
  const auto resolved = resolve(plant);
  // Discs and bodies sit on pipes; the pipes' part in them counts once. The two pipes of the angle
  // valve end 15 from its centre and overlap only inside its body.
  double overlap = 0;
  std::size_t components = 0, meetings = 0;
  for (const auto& part : resolved.parts) {
    const auto host = std::find_if(resolved.parts.begin(), resolved.parts.end(), [&](auto& other) {
      return part.name == other.name + "-disc" || part.name == other.name + "-body";
    });
    if (host != resolved.parts.end()) {
      ++meetings;
      const double r = test::single_piece<RingedSurface>(host->shape).end.radius;
      if (const auto* body = std::get_if<Sphere>(&part.shape)) {
        overlap += 2 * bored(body->radius, r, 0);
      } else {
        overlap += kPi * r * r * length(test::single_piece<RingedSurface>(part.shape).spine);
      }
    } else if (const auto* body = std::get_if<Sphere>(&part.shape)) {
      overlap += bored(body->radius, 38.1, 15) + bored(body->radius, 50.8, 15);
      meetings += 2;
      ++components;
    } else {
      ++components;
    }
  }
  EXPECT_GE(components, 20U);
  // Two runs of pipes, six discs, two bodies and the angle valve's.
  expect_solid("plant-run.json", plant, {11, 11, 1, meetings, smooth_volume(resolved) - overlap});
}

TEST(Build, makes_a_solid_of_all_examples_but_the_tight_one) {
  std::size_t built = 0;
  const auto folder = test::source_folder() / "examples";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json" && entry.path().filename() != "tight.json") {
      const Solid solid = build(read_assembly(entry.path())).solid;
      EXPECT_TRUE(check(to_mesh(solid).mesh()).is_solid()) << entry.path();
      ++built;
    }
  }
  EXPECT_GE(built, 7U);
}

TEST(Build, puts_all_points_of_welded_parts_on_the_grid) {
  const Assembly reducer = example("reducer.json");
  const Built built = build(reducer);
  // 1/2048 of the tolerance or less, but more than half of that.
  EXPECT_LE(built.grid, reducer.tolerance / 2048);
  EXPECT_GT(built.grid, reducer.tolerance / 4096);
  for (const Vec3& point : to_mesh(built.solid).mesh().points) {
    EXPECT_EQ(snapped(point, built.grid), point);
  }
}

TEST(Build, refuses_a_tight_blend) {
  try {
    (void)build(example("tight.json"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::irregular_surface);
    EXPECT_EQ(error.part(), "blend");
    EXPECT_THAT(error.where(), testing::HasSubstr("tight.json#/parts/2"));
    EXPECT_THAT(error.message(), testing::HasSubstr(" has enough"));
  }
}

TEST(Build, refuses_sizes_too_small_for_the_coordinates) {
  Assembly far = assembly({pipe("a", Vec3(0, 0, 0), Vec3(0, 0, 1e9), 1),
                           pipe("b", Vec3(0, 0, 0), Vec3(0, 0, 1), 1e-7)});
  for (const bool by_tolerance : {false, true}) {
    far.tolerance = by_tolerance ? 1e-9 : 0.05;
    try {
      (void)build(far);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::invalid_argument);
      EXPECT_EQ(error.part(), by_tolerance ? "" : "b");
      EXPECT_EQ(error.where(), by_tolerance ? "/tolerance" : "/parts/1");
      EXPECT_THAT(error.message(), testing::HasSubstr("(of 'a'); it must be at least 0.0018"));
    }
  }
}

TEST(Build, refuses_more_triangles_than_memory_is_there_for) {
  Assembly vast = assembly(
      {{"vast", ElbowTurning{Place{Vec3::Zero(), Vec3::UnitX(), 1e5}, 1e6, 1, Vec3::UnitY()}}});
  vast.tolerance = 1e-3;
  try {
    (void)build(vast);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
    EXPECT_EQ(error.part(), "vast");
    EXPECT_EQ(error.where(), "/parts/0");
    EXPECT_THAT(error.message(),
                testing::HasSubstr("about 1.43e+09 triangles; the limit is 4 mil"));
  }
}

TEST(Build, refuses_an_elbow_that_is_thicker_than_its_bend) {
  const Assembly fat = assembly(
      {{"fat", ElbowTurning{Place{Vec3::Zero(), Vec3::UnitX(), 2}, 1.5, 1, Vec3::UnitY()}}});
  try {
    (void)build(fat);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::irregular_surface);
    EXPECT_EQ(error.part(), "fat");
    EXPECT_EQ(error.where(), "/parts/0");
  }
}

TEST(Build, refuses_a_blend_that_crosses_itself_far_away) {
  // A plane cubic with a loop: gently bent everywhere, but it comes back to itself.
  Assembly loop = assembly({pipe("a", Vec3(-3, -3, 0), Vec3(0, 0, 0), 0.1),
                            pipe("b", Vec3(2, 0, 0), Vec3(5, -3, 0), 0.1)});
  loop.parts[1].shape = PipeAlong{Place{Vec3(2, 0, 0), Vec3(-1, -1, 0), 0.1}, 4};
  loop.parts[0].shape = PipeAlong{Place{Vec3(-4, 0, 0), Vec3(1, 0, 0), 0.1}, 4};
  loop.parts.push_back(
      {"blend", CyclicBlendBetween{end_of("a"), start_of("b"), {BlendLaw::r1, 30, 30}}});
  try {
    (void)build(loop);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::irregular_surface);
    EXPECT_THAT(error.what(),
                testing::StartsWith("/parts/2: 'blend': the part's mesh is no solid: "));
    EXPECT_THAT(error.message(), testing::ContainsRegex("intersect near .*certify' may tell"));
  }
}

TEST(Build, makes_bends_barely_wider_than_the_pipe) {
  for (const double gap : {1e-2, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-11}) {
    for (const double angle : {0.1, kPi / 2, 6.2}) {
      const Place place{Vec3::Zero(), Vec3::UnitX(), 1};
      Assembly tight = assembly({{"e", ElbowTurning{place, 1 + gap, angle, Vec3::UnitY()}}});
      tight.tolerance = 0.05;
      EXPECT_GT(build(tight).parts[0].margin_lower.value(), 0) << gap << ' ' << angle;
    }
  }
}

TEST(Build, unites_a_run_that_crosses_itself) {
  const Vec3 up(0, 1, 0), left(-1, 0, 0);
  const auto turn = [](const std::string& name, const std::string& from, const Vec3& toward) {
    return Part{name, ElbowTurning{end_of(from), 3, kPi / 2, toward}};
  };
  const Assembly crossing = assembly({pipe("a", Vec3(-10, 0, 0), Vec3(0, 0, 0), 1),
                                      turn("b", "a", up),
                                      {"c", PipeAlong{end_of("b"), 4}},
                                      turn("d", "c", left),
                                      {"e", PipeAlong{end_of("d"), 4}},
                                      turn("f", "e", -up),
                                      {"g", PipeAlong{end_of("f"), 14}}});
  const auto resolved = resolve(crossing);
  // g crosses a at a right angle: two cylinders of radius 1 share 16/3.
  expect_solid("crossing", crossing, {1, 2, 1, 2, smooth_volume(resolved) - 16.0 / 3});
}

TEST(Build, unites_a_run_that_comes_back_over_itself) {
  // Four quarter turns in one plane lead back into the first pipe, which the last one covers.
  std::vector<Part> parts{pipe("pipe-0", Vec3(0, 0, 0), Vec3(4, 0, 0), 1)};
  const Vec3 turns[] = {Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(1, 0, 0)};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string elbow = "elbow-" + std::to_string(i);
    parts.push_back(
        {elbow, ElbowTurning{end_of("pipe-" + std::to_string(i)), 2, kPi / 2, turns[i]}});
    parts.push_back({"pipe-" + std::to_string(i + 1), PipeAlong{end_of(elbow), 4}});
  }
  const Assembly ring = assembly(std::move(parts));
  const auto resolved = resolve(ring);
  expect_solid("ring", ring, {1, 2, 1, 2, smooth_volume(resolved) - 4 * kPi});
}

TEST(Build, welds_a_closed_loop_of_parts) {
  const CyclicBlendOptions automatic;
  const Assembly ring =
      assembly({pipe("a", Vec3(-3, 0, 0), Vec3(3, 0, 0), 1),
                pipe("b", Vec3(3, 9, 0), Vec3(-3, 9, 0), 1.5),
                {"c", CyclicBlendBetween{end_of("a"), start_of("b"), automatic}},
                {"d", CyclicBlendBetween{end_of("b"), start_of("a"), automatic}}});
  expect_solid("ring", ring, {1, 1, 1, 1, smooth_volume(resolve(ring))});
}

TEST(Build, unites_a_closed_loop_that_crosses_itself) {
  const CyclicBlendOptions automatic;
  const Assembly eight =
      assembly({pipe("a", Vec3(-5, 0, 0), Vec3(5, 0, 0), 0.5),
                pipe("b", Vec3(0, 5, 0), Vec3(0, -5, 0), 0.5),
                {"c", CyclicBlendBetween{end_of("a"), start_of("b"), automatic}},
                {"d", CyclicBlendBetween{end_of("b"), start_of("a"), automatic}}});
  const double shared = 16.0 / 3 * 0.125;
  expect_solid("eight", eight, {1, 2, 1, 3, smooth_volume(resolve(eight)) - shared});
}

TEST(Build, keeps_separate_parts_apart) {
  const Assembly apart =
      assembly({pipe("a", Vec3(0, 0, 0), Vec3(3, 0, 0), 1), {"b", SphereAt{Vec3(0, 9, 0), 2}}});
  expect_solid("apart", apart, {2, 2, 2, 0, smooth_volume(resolve(apart))});
}

TEST(Build, labels_parts_ends_and_caps) {
  Assembly reducer = example("reducer.json");
  reducer.parts.push_back({"lid", CapAt{end_of("outlet")}});
  const TriMesh mesh = to_mesh(build(reducer).solid).mesh();
  EXPECT_THAT(mesh.names,
              testing::UnorderedElementsAre("inlet", "outlet", "blend", "inlet.start", "lid"));
  ASSERT_EQ(mesh.labels.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.names[mesh.labels[i]] == "inlet.start") {
      for (const auto corner : mesh.triangles[i]) {
        EXPECT_EQ(mesh.points[corner].x(), -10);
      }
    }
  }
}

TEST(Build, reports_margins_tangency_and_gaps) {
  const Built built = build(example("reducer.json"));
  ASSERT_EQ(built.parts.size(), 3U);
  EXPECT_EQ(built.parts[0].margin_lower, 1);
  EXPECT_FALSE(built.parts[0].start_tangency);
  // The margin of Fig. 6 with R1.
  EXPECT_LE(*built.parts[2].margin_lower, 0.0848584660472 + 1e-12);
  EXPECT_GE(*built.parts[2].margin_upper, 0.0848584660472 - 1e-12);
  EXPECT_NEAR(*built.parts[2].margin_lower, *built.parts[2].margin_upper, 1e-5);
  EXPECT_EQ(built.parts[2].start_tangency, 0);
  EXPECT_EQ(built.parts[2].end_tangency, 0);
  std::vector<std::string> verdicts;
  for (const auto& gap : built.gaps) {
    verdicts.push_back(std::string(name(gap.report.verdict)));
  }
  EXPECT_THAT(verdicts, testing::UnorderedElementsAre("welded", "welded", "open", "open"));
}

TEST(Build, obeys_its_options) {
  const Assembly reducer = example("reducer.json");
  const Built coarse = build(reducer, {.segments = 12}), fine = build(reducer, {.tolerance = 0.01});
  for (const auto& part : coarse.parts) {
    EXPECT_EQ(part.segments, 12U);
  }
  EXPECT_GT(coarse.parts[2].error_bound, 0.05);
  EXPECT_LE(fine.parts[2].error_bound, 0.01);
  EXPECT_GT(fine.solid.triangle_count(), 3 * build(reducer).solid.triangle_count());
  EXPECT_THROW((void)build(reducer, {.tolerance = -1}), Error);
  EXPECT_THROW((void)build(reducer, {.tolerance = 1e-30}), Error);
  const auto stop = [](std::string_view, double) { return false; };
  try {
    (void)build(reducer, {.progress = stop});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::cancelled);
  }
}

TEST(Build, gives_the_same_bytes_twice) {
  const Assembly header = example("header.json");
  const TriMesh once = to_mesh(build(header).solid).mesh(),
                twice = to_mesh(build(header).solid).mesh();
  EXPECT_EQ(once.points, twice.points);
  EXPECT_EQ(once.triangles, twice.triangles);
  EXPECT_EQ(once.labels, twice.labels);
}

}  // namespace
}  // namespace dupin
