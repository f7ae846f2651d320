#include <array>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <regex>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assembly/fillet_part.h"
#include "blends/assembly/filleted_tee.h"
#include "dupin/blends/build.h"
#include "dupin/kernel/error.h"
#include "support/named_parts.h"

namespace dupin {
namespace {

using test::fillet;
using test::pipe;

Assembly assembly(std::vector<Part> parts, double tolerance = 0.02) {
  return {"d.json", Unit::millimetre, tolerance, {}, std::move(parts)};
}

Fillet between(const Part& first, const Part& second, double radius) {
  return resolve(assembly({first, second, fillet("f", first.name, second.name, radius)}))
      .fillets.front()
      .shape;
}

TEST(FilletPart, has_the_loops_that_lie_on_both_pipes) {
  const Part run = pipe("run", {-20, 0, 0}, {20, 0, 0}, 4);
  const std::array<bool, 2> kNone{}, kStart{true, false}, kEnd{false, true};
  const auto buried = [](const Fillet& f, std::size_t pipe) { return f.buried.at(pipe); };
  const Fillet tee = between(run, pipe("b", {0, 0, 0}, {0, 12, 0}, 2), 1);
  EXPECT_EQ(tee.loops.size(), 1U);
  EXPECT_EQ(buried(tee, 0), kNone);
  EXPECT_EQ(buried(tee, 1), kStart);
  EXPECT_GT(tee.regularity, 0.1);
  EXPECT_EQ(buried(between(run, pipe("b", {0, 12, 0}, {0, 0, 0}, 2), 1), 1), kEnd);
  EXPECT_EQ(buried(between(pipe("b", {0, 12, 0}, {0, -1, 0}, 2), run, 1), 0), kEnd);
  const Fillet through = between(run, pipe("b", {0, -12, 1}, {0, 12, 1}, 2), 1);
  EXPECT_EQ(through.loops.size(), 2U);
  EXPECT_EQ(buried(through, 1), kNone);
  const Fillet partly = between(run, pipe("b", {0, -12, 3}, {0, 12, 3}, 2), 1);
  EXPECT_EQ(partly.loops.size(), 1U);
  EXPECT_EQ(buried(partly, 1), kNone);
  // As thick, and touching from inside: the end's disc touches what buries it.
  EXPECT_EQ(buried(between(run, pipe("b", {0, 0, 0}, {0, 12, 0}, 4), 1), 1), kStart);
  EXPECT_EQ(buried(between(run, pipe("b", {0, 0, 2}, {0, 12, 2}, 2), 1), 1), kStart);
}

// A plant's numbers are rounded: pipes that miss a touch by little touch.
TEST(FilletPart, takes_tiny_gaps_for_a_touch) {
  for (const double gap : {0.0, 1e-15, 1e-13, 1e-12, 1e-11, -1e-13, -1e-11}) {
    const Built built = build(
        assembly({pipe("run", {-20, 0, 0}, {20, 0, 0}, 4),
                  pipe("b", {0, 0, 2 + gap}, {0, 12, 2 + gap}, 2), fillet("f", "run", "b", 0.5)}));
    EXPECT_EQ(built.solid.components(), 1U) << gap;
    EXPECT_EQ(built.solid.genus(), 0) << gap;
  }
}

// As it says of what ends in the other pipe as thick.
TEST(FilletPart, is_made_of_pipes_off_the_axis_as_its_refusal_says) {
  const Part run = pipe("run", {-20, 0, 0}, {20, 0, 0}, 4);
  EXPECT_EQ(between(run, pipe("b", {0, 0, 0.1}, {0, 12, 0.1}, 3.9), 0.5).loops.size(), 1U);
  EXPECT_EQ(between(run, pipe("b", {0, -12, 0.1}, {0, 12, 0.1}, 4), 0.5).loops.size(), 1U);
}

// What takes long is left to where a fillet is built, with the same result.
TEST(FilletPart, is_proved_later) {
  const Assembly document = assembly({pipe("run", {-20, 0, 0}, {20, 0, 0}, 4),
                                      pipe("b", {0, 0, 0}, {0, 12, 0}, 2),
                                      pipe("c", {9, 0, 0}, {9, 0, 12}, 3),
                                      fillet("f", "run", "b", 1),
                                      {"g", CopeOfEnd{{"c", End::start}, "run"}}});
  ResolvedAssembly resolved = resolve_unproved(document);
  EXPECT_EQ(resolved.fillets[0].shape.loops.size(), 0U);
  EXPECT_FALSE(resolved.fillets[0].shape.is_cope());
  EXPECT_TRUE(resolved.fillets[0].shape.buried[1][0]);
  find_loops(document, resolved);
  EXPECT_EQ(resolved.fillets[0].shape.loops.size(), 1U);
  EXPECT_EQ(resolved.fillets[0].shape.regularity, std::nullopt);
  prove_fillets(document, resolved);
  const ResolvedAssembly at_once = resolve(document);
  EXPECT_GT(at_once.fillets[0].shape.regularity, 0.1);
  EXPECT_EQ(resolved.fillets[0].shape.regularity, at_once.fillets[0].shape.regularity);
  EXPECT_EQ(resolved.fillets[1].shape.regularity, std::nullopt);
  EXPECT_TRUE(resolved.fillets[1].shape.is_cope());
}

std::string what_is_said(const std::function<void()>& work) {
  try {
    work();
    return "nothing";
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(FilletPart, that_folds_is_refused_alike_wherever_it_is_proved) {
  const Assembly document = test::Tee{1, 0, std::numbers::pi / 6, 0.5}.document(true);
  EXPECT_NO_THROW((void)resolve_unproved(document));
  const std::string said = what_is_said([&] { (void)resolve(document); });
  EXPECT_THAT(said, testing::AllOf(testing::HasSubstr("the fillet folds"),
                                   testing::HasSubstr("the largest ball that fits"),
                                   testing::HasSubstr("d.json#/parts/2")));
  EXPECT_EQ(what_is_said([&] { (void)build(document); }), said);
}

TEST(FilletPart, that_is_nowhere_is_refused_alike_wherever_it_is_looked_for) {
  Assembly document = assembly({pipe("run", {-20, 0, 0}, {20, 0, 0}, 4),
                                pipe("b", {0, 7, 0}, {0, 12, 0}, 2), fillet("f", "run", "b", 1)});
  EXPECT_NO_THROW((void)resolve_unproved(document));
  const std::string said = what_is_said([&] { (void)resolve(document); });
  EXPECT_THAT(said, testing::AllOf(testing::HasSubstr("do not cross within their lengths"),
                                   testing::HasSubstr("d.json#/parts/2")));
  EXPECT_EQ(what_is_said([&] { (void)build(document); }), said);
  // In a district of several, too, whose parts have other numbers.
  document.parts.insert(document.parts.begin(), pipe("far", {0, 0, 900}, {9, 0, 900}, 1));
  EXPECT_THAT(what_is_said([&] { (void)build(document); }),
              testing::AllOf(testing::HasSubstr("do not cross within their lengths"),
                             testing::HasSubstr("d.json#/parts/3")));
  EXPECT_THAT(what_is_said([&] { (void)DistrictBuild(document, {}).build(1, {}); }),
              testing::HasSubstr("d.json#/parts/3"));
}

struct Fault {
  std::vector<Part> parts;
  std::string message;
  Errc code = Errc::infeasible_blend;
};

TEST(FilletPart, says_why_there_is_no_fillet) {
  const Part run = pipe("run", {-20, 0, 0}, {20, 0, 0}, 4);
  const Part branch = pipe("branch", {0, 0, 0}, {0, 12, 0}, 2);
  const auto on = [](const Part& other, double radius = 0.5) {
    return fillet("f", "run", other.name, radius);
  };
  const Part far = pipe("far", {0, 0, 9}, {0, 12, 9}, 2),
             along = pipe("along", {0, 0, 0}, {9, 0, 0}, 2);
  const Part stub = pipe("stub", {0, 0, 0}, {0, 4.4, 0}, 2);
  const Part short_of_it = pipe("short", {0, 7, 0}, {0, 12, 0}, 2);
  const Part out = pipe("out", {0, -4.1, 0}, {0, 12, 0}, 2);
  const Part aside = pipe("aside", {0, 0, 2.001}, {0, 12, 2.001}, 2);
  const Part equal = pipe("equal", {0, 0, 0.1}, {0, 12, 0.1}, 4);
  const Part close = pipe("close", {4.5, 0, 0}, {4.5, 12, 0}, 2);
  const Part elbow{"elbow", ElbowTurning{PortReference{"run", End::end}, 9, 1, {0, 1, 0}}};
  const Fault faults[] = {
      {{run, far, on(far)}, "the axes are 9 apart"},
      {{run, along, on(along)}, "'along' lies inside 'run'"},
      {{run, stub, on(stub)},
       "the fillet runs over the end of 'stub' by 0.1; the largest ball that fits, to 1 %, has a "
       "radius of "
       "0.399"},
      {{run, branch, on(branch, 20)}, "the largest ball that fits, to 1 %, has a radius of"},
      {{run, short_of_it, on(short_of_it)}, "do not cross within their lengths"},
      {{run, out, on(out)}, "the fillet runs over the end of 'out' by"},
      {{run, aside, on(aside)},
       ": 'aside.start' lies inside 'run' only in part, and sticks out by 0.001"},
      {{run, equal, on(equal)},
       "sticks out by 0.1; there it lies inside with a radius of 3.89999 at most; its axis is 0.1 "
       "off that "
       "of "
       "'run', where nothing thicker than a radius of 3.9 ends in it: 'equal' may go on through "
       "'run'"},
      {{run, branch, on(branch), fillet("g", "branch", "run", 0.2)},
       "the crossing of these parts has 'f' already",
       Errc::invalid_argument},
      {{run, branch, close, fillet("g", "run", "branch", 0.5), fillet("f", "run", "close", 0.5)},
       "it overlaps 'g' on 'run'"},
      {{run, elbow, on(elbow)},
       "'elbow' is no straight pipe or cone of circular sections",
       Errc::invalid_argument},
      {{run, branch, {"cap", CapAt{{"branch", End::start}}}, on(branch)},
       "the port 'branch.start' lies inside 'run' and vanishes, but is taken by 'cap'",
       Errc::invalid_argument},
      {{run, branch, fillet("f", "run", "run", 1)}, "two different parts", Errc::invalid_argument},
      {{run, branch, fillet("f", "run", "none", 1)},
       "there is no part named 'none'",
       Errc::invalid_argument},
      {{run, branch, on(branch), fillet("g", "run", "f", 1)},
       "'f' is no pipe or cone",
       Errc::invalid_argument},
      {{run, branch, on(branch, -1)}, "must be a positive number", Errc::invalid_argument},
  };
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.message);
    try {
      (void)build(assembly(fault.parts));
      ADD_FAILURE() << "built";
    } catch (const Error& error) {
      EXPECT_EQ(name(error.code()), name(fault.code)) << error.what();
      EXPECT_THAT(error.what(), testing::HasSubstr(fault.message));
      EXPECT_THAT(error.where(), testing::HasSubstr("d.json#/parts/"));
      EXPECT_FALSE(error.part().empty());
    }
  }
}

// What build says of them, or "".
std::string refusal(const Assembly& document) {
  try {
    (void)build(document);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::infeasible_blend);
    return error.message();
  }
}

// However much too large the ball is.
TEST(FilletPart, names_what_fits_whatever_was_asked_for) {
  const Part run = pipe("run", {-20, 0, 0}, {20, 0, 0}, 4),
             branch = pipe("branch", {0, 0, 0}, {0, 12, 0}, 2);
  for (const double radius : {30., 1e3, 1e6, 1e9}) {
    try {
      (void)between(run, branch, radius);
      FAIL() << radius;
    } catch (const Error& error) {
      const std::string named = "; the largest ball that fits, to 1 %, has a radius of ";
      const std::size_t at = error.message().find(named);
      ASSERT_NE(at, std::string::npos) << error.message();
      const double largest = std::stod(error.message().substr(at + named.size()));
      EXPECT_EQ(between(run, branch, largest).loops.size(), 1U);
      EXPECT_THROW(between(run, branch, 1.011 * largest), Error);
      EXPECT_THAT(error.message(), testing::Not(testing::HasSubstr("do not cross")));
    }
  }
}

// Of an end that is oblique, and beside the axis, less fits than what the axes leave room for.
TEST(FilletPart, names_the_largest_radius_that_ends_inside) {
  const Part run = pipe("run", {-20, 0, 0}, {20, 0, 0}, 4);
  for (const Vec3& from : {Vec3(0, 0, 1), Vec3(0, 0.5, -0.25), Vec3(1, -2, 0.125)}) {
    for (const Vec3& to : {Vec3(0, 15, 1), Vec3(3, 14, 0), Vec3(-6, 16, 2)}) {
      Part branch = pipe("branch", from, to, 3.9375);
      const std::string why = refusal(assembly({run, branch, fillet("f", "run", "branch", 0.01)}));
      const std::string named = "; there it lies inside with a radius of ";
      const std::size_t at = why.find(named);
      ASSERT_NE(at, std::string::npos) << why;
      const double largest = std::stod(why.substr(at + named.size()));
      const auto with = [&](double radius) {
        branch = pipe("branch", from, to, radius);
        return refusal(assembly({run, branch, fillet("f", "run", "branch", 0.01)}));
      };
      EXPECT_EQ(with(largest), "");
      EXPECT_NE(with(1.0001 * largest), "");
    }
  }
}

// Nor are outer radii what a document with inner ones says.
TEST(FilletPart, names_radii_as_the_document_has_them) {
  for (const WallSide side : {WallSide::outwards, WallSide::centred}) {
    const auto with = [&](double radius) {
      Assembly document = assembly({pipe("run", {-20, 0, 0}, {20, 0, 0}, 4),
                                    pipe("branch", {0, 0, 1}, {0, 15, 1}, radius),
                                    fillet("f", "run", "branch", .1)});
      document.wall = 0.5;
      document.wall_side = side;
      return refusal(document);
    };
    const std::string why = with(3.9375), named = "there it lies inside with a radius of ";
    const std::size_t at = why.find(named), room_at = why.find("thicker than a radius of 3 ends");
    ASSERT_NE(at, std::string::npos) << why;
    EXPECT_NE(room_at, std::string::npos) << why;
    EXPECT_EQ(with(std::stod(why.substr(at + named.size()))), "");
  }
}

// The branch ends in the run, whose own end is not meant to lie in the branch: what is missing is
// length.
TEST(FilletPart, says_how_much_longer_pipes_would_do) {
  struct Row {
    double run_radius, branch_radius, ball;
    Vec3 branch_from, branch_way;
    std::optional<double> wall = {};
  };
  const Row rows[]{{40, 27.5, 3.77, {17.57, -5.98, -53.79}, {-30.32, -9.25, 134.8}},
                   {40, 27.5, 3.77, {17.57, -5.98, -53.79}, {-30.32, -9.25, 134.8}, 3.17},
                   {16.72, 27.5, 3.77, {17.57, -5.98, -53.79}, {-30.32, -9.25, 134.8}},
                   {20, 10, 2, {10, 0, 0}, {-40, 0, 30}},
                   {20, 10, 2, {10, 0, 0}, {-20, 0, 15}}};
  int told = 0;
  for (const Row& row : rows) {
    const Vec3 way =
        row.branch_way == Vec3(-30.32, -9.25, 134.8) ? Vec3(40.39, -13.75, -123.6) : Vec3(60, 0, 0);
    std::map<std::string, std::array<double, 2>> more;
    double ball = row.ball;
    const auto refused = [&] {
      const auto longer = [&](const std::string& name, const Vec3& from, const Vec3& by,
                              double radius) {
        const Vec3 along = by.normalized();
        return pipe(name, from - more[name][0] * along, from + by + more[name][1] * along, radius);
      };
      Assembly document = assembly({longer("run", Vec3::Zero(), way, row.run_radius),
                                    longer("b", row.branch_from, row.branch_way, row.branch_radius),
                                    fillet("f", "run", "b", ball)});
      document.wall = row.wall;
      return refusal(document);
    };
    const std::string why = refused();
    EXPECT_THAT(why, testing::Not(testing::HasSubstr("only in part")));
    EXPECT_THAT(why, testing::Not(testing::HasSubstr("e-1")));
    static const std::regex kLonger(R"((?:'(\w+)' longer )?by ([0-9.]+) at its (start|end))");
    std::string name;
    for (std::sregex_iterator it(why.begin(), why.end(), kLonger), last; it != last; ++it) {
      name = (*it)[1].matched ? (*it)[1].str() : name;
      more[name].at((*it)[3] == "start" ? 0 : 1) = std::stod((*it)[2]);
    }
    std::smatch radius;
    if (std::regex_search(why, radius, std::regex("a ball of radius ([0-9.]+) would fit"))) {
      ball = std::stod(radius[1]);
    }
    told += more.empty() ? 0 : 1;
    EXPECT_EQ(more.empty() ? "" : refused(), "") << why;
  }
  EXPECT_GE(told, 3);
}

// What is thicker than the other pipe does not end in it, wherever it is.
TEST(FilletPart, says_which_pipe_is_thicker_where_axes_meet) {
  const std::string why = refusal(
      assembly({pipe("thin", {-90, 0, 0}, {90, 0, 0}, 27.5),
                pipe("thick", {1e-14, 0, 0}, {10, 0, 99}, 40), fillet("f", "thin", "thick", 1)}));
  EXPECT_THAT(why, testing::HasSubstr("it is thicker than 'thin', which may end in it or go on "
                                      "through it"));
  EXPECT_THAT(why, testing::Not(testing::HasSubstr("its axis is")));
}

// Followed, the ball alone led to the next refusal.
TEST(FilletPart, names_the_wall_that_leaves_no_bore_beside_the_ball) {
  const auto with = [](double radius, double wall) {
    Assembly document =
        assembly({pipe("run", {-20, 0, 0}, {20, 0, 0}, 8), pipe("b", {0, 0, 0}, {0, 0, 30}, 1.35),
                  fillet("f", "run", "b", radius)});
    document.wall = wall;
    return refusal(document);
  };
  EXPECT_THAT(with(40, 3.59),
              testing::AllOf(testing::HasSubstr("; the largest ball that fits, to 1 %, has "),
                             testing::EndsWith(
                                 "; 'b' is to be mended, too: a wall of 3.59 leaves no bore where "
                                 "the radius is only 1.35; whether a ball fits inside then is "
                                 "undecided")));
  EXPECT_THAT(with(40, 9), testing::AllOf(testing::HasSubstr("; 'run' is to be mended, too: "),
                                          testing::HasSubstr("; 'b' is to be mended, too: ")));
  EXPECT_THAT(with(40, 0.5), testing::Not(testing::HasSubstr("mended")));
}

// It was said to run over it by -0.
TEST(FilletPart, says_where_it_touches_an_end) {
  const std::string why =
      refusal(assembly({pipe("run", {0, 0, 0}, {12, 0, 0}, 5), pipe("b", {6, 0, 0}, {6, 0, 30}, 4),
                        fillet("f", "run", "b", 2)}));
  EXPECT_THAT(why, testing::HasSubstr("the fillet touches the end of 'run'; the largest ball"));
}

TEST(FilletPart, says_where_walls_leave_no_room_for_any_ball) {
  Assembly document = assembly({pipe("run", {-100, 0, 0}, {100, 0, 0}, 10),
                                pipe("b", {0, 0, 0}, {90, 0, 45}, 10), fillet("f", "run", "b", 9)});
  document.wall = 6;
  const std::string why = refusal(document);
  EXPECT_THAT(why, testing::HasSubstr("the largest ball that fits, to 1 %, has a radius of "));
  EXPECT_THAT(why, testing::HasSubstr("with these walls neither it nor a smaller one fits inside"));
  const auto number_after = [&](const std::string& text) {
    const std::size_t at = why.find(text);
    return at == std::string::npos ? 0 : std::stod(why.substr(at + text.size()));
  };
  std::get<FilletBetween>(document.parts[2].shape).radius =
      number_after("to 1 %, has a radius of ");
  document.insulation = 1;
  EXPECT_EQ(build(document, {.tolerance = 0.5, .region = Region::insulation}).solid.components(),
            1);
  document.wall = number_after(", a wall of ");
  if (why.find("; with one of ") != std::string::npos) {
    std::get<FilletBetween>(document.parts[2].shape).radius = number_after("; with one of ");
  }
  EXPECT_EQ(build(document, {.tolerance = 0.5}).solid.components(), 1);
}

// The named radius builds, with the walls' bore, and 1 % more does not.
TEST(FilletPart, names_the_largest_radius_that_builds) {
  struct Row {
    Vec3 run, from, to;  // the run goes through the origin, half of it is told
    double radius, branch, ball;
    std::optional<double> wall = {};
  };
  const Row rows[]{
      {{128, 0, 0}, {0, -3.13, 0}, {40.9, -3.13, 23.6}, 10.7, 5.04, 2.52},
      {{237, 0, 0}, {-200, -16.5, -90}, {200, -16.5, 90}, 9.73, 8.25, 1.65},
      {{101, 197, -512}, {0, 0, 0}, {-51.4, 82, -136.5}, 27.8896, 27.8896, 13.94, 3},
      {{100, 0, 0}, {0, 0, 0}, {80, 0, 60}, 10, 6, 9, 2},
      {{20, 0, 0}, {0, 0, 0}, {0, 4.4, 0}, 4, 2, 0.5},
  };
  for (const Row& row : rows) {
    const auto with = [&](double ball) {
      Assembly document =
          assembly({pipe("run", -row.run, row.run, row.radius),
                    pipe("b", row.from, row.to, row.branch), fillet("f", "run", "b", ball)},
                   0.05);
      document.wall = row.wall;
      return document;
    };
    const std::string why = refusal(with(row.ball));
    SCOPED_TRACE(why);
    const std::string before = "the largest ball that fits, to 1 %, has a radius of ";
    const auto at = why.find(before);
    ASSERT_NE(at, std::string::npos);
    const double named = std::stod(why.substr(at + before.size()));
    EXPECT_EQ(refusal(with(named)), "") << named;
    EXPECT_NE(refusal(with(1.01 * named)), "") << named;
  }
}

TEST(LargestRadiusBelow, finds_what_fits_beyond_gaps) {
  const auto in_two = [](double r) { return r < 0.2 || (r > 0.3 && r < 0.57); };
  const double found = dupin::assembly::largest_radius_below(1, in_two).value();
  EXPECT_LT(found, 0.57);
  EXPECT_TRUE(in_two(found));
  EXPECT_FALSE(in_two(1.01 * found));
  EXPECT_EQ(dupin::assembly::largest_radius_below(1, [](double) { return false; }), std::nullopt);
  const auto not_the_least = [](double r) { return r > 0.04 && r <= 0.7; };
  EXPECT_NEAR(dupin::assembly::largest_radius_below(1, not_the_least).value(), 0.7, 0.007);
}

}  // namespace
}  // namespace dupin
