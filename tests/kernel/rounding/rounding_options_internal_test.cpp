#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>

#include "boxes/bounds.h"
#include "rounding/rounding_options.h"

namespace dupin::rounding {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(RoundingOptions, are_refused_outside_their_ranges) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-1.0, static_cast<double>(NAN), kInfinity}) {
    EXPECT_THROW(validate({.tolerance = bad}), Error);
    EXPECT_THROW(validate({.output_grid = bad}), Error);
    EXPECT_THROW(validate({.origin = {Origin::Choice::given, Vec3(0, bad == -1 ? NAN : bad, 0)}}),
                 Error);
    Whole whole{{Vec3(0, 0, 0), Vec3(1, 1, 1)}, bad};
    EXPECT_THROW(validate({.whole = whole}), Error);
    whole = {{Vec3(0, 0, 0), Vec3(1, bad == -1 ? NAN : bad, 1)}, 0};
    EXPECT_THROW(validate({.whole = whole}), Error);
  }
  for (const double grid : {0.1, 3.0, 0.75}) {
    EXPECT_THROW(validate({.output_grid = grid}), Error) << "no power of two";
  }
  for (const double grid : {0.0, 0x1p-40, 1.0, 8.0}) {
    EXPECT_NO_THROW(validate({.tolerance = 0.1, .output_grid = grid}));
  }
}

TEST(ChosenOrigin, is_a_round_number_near_the_middle) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1e6, 1e6), size(0.001, 100);
  for (int i = 0; i < 500; ++i) {
    const Vec3 low(place(random), place(random), place(random));
    const Vec3 high = low + Vec3(size(random), size(random), size(random));
    const std::vector<Vec3> points = {low, high};
    const Vec3 origin = chosen_origin({.origin = {Origin::Choice::automatic, {}}}, points);
    const double extent = (high - low).maxCoeff() / 2;
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(std::abs(origin[k] - (low[k] + high[k]) / 2), extent / 8);
      EXPECT_EQ(std::fmod(origin[k], std::exp2(std::floor(std::log2(extent)) - 4)), 0);
    }
  }
}

TEST(ChosenOrigin, is_what_was_asked_for) {
  const std::vector<Vec3> points = {{5, 5, 5}, {7, 7, 7}};
  EXPECT_EQ(chosen_origin({}, points), Vec3(0, 0, 0));
  EXPECT_EQ(chosen_origin({.origin = {Origin::Choice::given, Vec3(1, 2, 3)}}, points),
            Vec3(1, 2, 3));
  EXPECT_EQ(chosen_origin({.origin = {Origin::Choice::automatic, {}}}, {}), Vec3(0, 0, 0));
  EXPECT_EQ(
      chosen_origin({.origin = {Origin::Choice::automatic, {}}}, std::vector{Vec3(0.1, 0.2, 0.3)}),
      Vec3(0.1, 0.2, 0.3))
      << "a single point";
}

TEST(ChosenOrigin, of_a_piece_is_that_of_the_whole) {
  RoundingOptions options{.origin = {Origin::Choice::automatic, {}}};
  options.whole = {.box = {Vec3(0, 0, 0), Vec3(64, 32, 16)}};
  EXPECT_EQ(chosen_origin(options, std::vector{Vec3(1, 2, 3)}), Vec3(32, 16, 8));
  EXPECT_EQ(chosen_origin(options, {}), Vec3(32, 16, 8)) << "nothing of it is here";
  EXPECT_EQ(largest_of(options, Vec3(1, 2, 3)), 63);
  options.whole->largest = 128;
  EXPECT_EQ(largest_of(options, Vec3(1, 2, 3)), 128);
  EXPECT_EQ(largest_of({}, Vec3(1, 2, 3)), 0);
}

TEST(UnroundableError, names_the_place_and_only_what_may_help) {
  const Error near = unroundable_error({.at = {1, 2, 3}, .tolerance = 0.5});
  EXPECT_EQ(near.code(), Errc::unroundable);
  EXPECT_THAT(near.what(), HasSubstr("(1, 2, 3)"));
  EXPECT_THAT(near.what(), HasSubstr("0.5"));
  EXPECT_THAT(near.what(), Not(HasSubstr("recentring")));
  EXPECT_THAT(near.what(), Not(HasSubstr("STL")));
  EXPECT_THAT(near.what(), Not(HasSubstr("lost")));
  EXPECT_THAT(unroundable_error({.tolerance = 0.5, .is_loss = true}).what(),
              HasSubstr("within the tolerance of 0.5, unless what is thinner than their distances "
                        "is lost"));
  Unroundable what{.at = {1234567.25, 2, 3},
                   .tolerance = 0.5,
                   .coordinates = Coordinates::binary32,
                   .is_far = true};
  const Error far = unroundable_error(what);
  EXPECT_EQ(far.where(), "(1234567.25, 2, 3)") << "a hundredth of a millimetre in a plant";
  EXPECT_THAT(far.what(), HasSubstr("recentring"));
  EXPECT_THAT(far.what(), HasSubstr("STL"));
  EXPECT_TRUE(far.message().ends_with("a larger tolerance"));
  what.do_doubles_tell = false;
  EXPECT_THAT(unroundable_error(what).what(), Not(HasSubstr("STL")));
  what.do_doubles_tell = true;
  what.is_on_output_grid = true;
  const Error coarse = unroundable_error(what);
  EXPECT_THAT(coarse.what(), HasSubstr("finer grid"));
  EXPECT_THAT(coarse.what(), Not(HasSubstr("recentring")));
  EXPECT_THAT(coarse.what(), Not(HasSubstr("STL")));
  what.is_nothing = true;
  EXPECT_THAT(unroundable_error(what).what(), HasSubstr("leaves nothing"));
  EXPECT_THAT(unroundable_error(what).what(), Not(HasSubstr("tolerance")));
}

TEST(WithRemediesTried, names_a_tolerance_of_a_few_and_the_usual_one) {
  const Error error = unroundable_error({.at = {1, 2, 3}, .tolerance = 0.5});
  std::vector<double> tried;
  const auto message = [&](double usual, double least, double own = 0.5) {
    tried.clear();
    return with_remedies_tried(error, {.tolerance = own}, usual,
                               [&](const RoundingOptions& options) {
                                 tried.push_back(options.tolerance);
                                 return options.tolerance > least;
                               })
        .message();
  };
  EXPECT_THAT(message(1000, 5), EndsWith("a larger tolerance (8 would do)"));
  EXPECT_EQ(tried, (std::vector<double>{2, 8}));
  EXPECT_THAT(message(1000, 100), EndsWith("a larger tolerance (1000 would do)"));
  EXPECT_EQ(tried, (std::vector<double>{2, 8, 32, 1000}));
  EXPECT_THAT(message(10, 100), EndsWith("the tolerance of 0.5; a tolerance of 32 would not do"));
  EXPECT_EQ(tried, (std::vector<double>{2, 8, 32}));
  EXPECT_THAT(message(1, 1, 1. / 3), EndsWith("a larger tolerance (1.33333 would do)"));
  EXPECT_EQ(tried, (std::vector<double>{1.33333})) << "what is tried is what is said";
  const Error nothing = unroundable_error({.at = {1, 2, 3}, .is_nothing = true});
  EXPECT_EQ(with_remedies_tried(nothing, {}, 10,
                                [](const RoundingOptions&) {
                                  ADD_FAILURE() << "not asked for";
                                  return false;
                                })
                .message(),
            nothing.message());
}

TEST(WithRemediesTried, names_recentring_only_where_it_would_do) {
  Unroundable what{.at = {1, 2, 3},
                   .tolerance = 0.5,
                   .coordinates = Coordinates::binary32,
                   .is_far = true,
                   .is_nothing = true};
  const auto message = [&](bool would_do) {
    return with_remedies_tried(unroundable_error(what), {}, 0.5,
                               [&](const RoundingOptions& options) {
                                 EXPECT_EQ(options.origin.choice, Origin::Choice::automatic);
                                 return would_do;
                               })
        .message();
  };
  EXPECT_EQ(message(true), unroundable_error(what).message());
  EXPECT_THAT(message(false), EndsWith("can tell; what may help: a format that holds doubles (OFF, "
                                       "OBJ, PLY instead of STL)"));
  what.coordinates = Coordinates::binary64;
  EXPECT_THAT(message(false), EndsWith("the numbers of the target format can tell"));
}

TEST(Recentred, is_about_the_middle_of_the_whole) {
  RoundingOptions options{.origin = {Origin::Choice::given, Vec3(9, 9, 9)}};
  options.whole = {.box = {Vec3(0, 0, 0), Vec3(64, 32, 16)}, .largest = 1024};
  const RoundingOptions there = recentred(options);
  const Vec3 origin = chosen_origin(there, std::vector{Vec3(1, 2, 3)});
  EXPECT_EQ(origin, Vec3(32, 16, 8));
  EXPECT_EQ(largest_of(there, origin), 32);
}

}  // namespace
}  // namespace dupin::rounding
