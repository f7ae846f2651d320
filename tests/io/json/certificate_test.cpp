#include "dupin/blends/certificate.h"

#include <algorithm>
#include <cctype>
#include <cfenv>
#include <filesystem>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/certify.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/error.h"
#include "support/message_of.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

Assembly example(const std::string& name) {
  return read_assembly(test::source_folder() / "examples" / name);
}

const std::size_t kBlend = 2;  // of the reducer, Fig. 6 of [MS06]

const Certificate& reducer() {
  static const Certificate certificate = certify(example("reducer.json"));
  return certificate;
}

Verdict margin_verdict(double margin) {
  const Certificate certificate = certify(example("reducer.json"), {.margin = margin});
  verify(certificate);
  return certificate.claims[kBlend].regular->verdict;
}

TEST(Certificate, proves_all_of_figure_6) {
  const Certificate& certificate = reducer();
  EXPECT_EQ(certificate.findings(), 0u);
  const PartClaims& blend = certificate.claims[kBlend];
  EXPECT_GT(blend.regular->margin, 0.0840);
  EXPECT_LT(blend.regular->margin, 0.0848584660472);
  for (const TangencyClaim& end : blend.tangency) {
    EXPECT_EQ(end.deviation, 0);
    EXPECT_LT(end.axis_angle, 1e-16);
    EXPECT_LT(end.offset, 1e-100);  // 0, rounded up
  }
  EXPECT_LT(blend.mesh->error_bound, certificate.tolerance);
  ASSERT_EQ(certificate.clearances.size(), 3u);
  EXPECT_GT(certificate.clearances[0].distance, 8);  // inlet and outlet
  for (const std::size_t pipe : {1, 2}) {            // and the blend
    EXPECT_EQ(certificate.clearances[pipe].verdict, Verdict::proved);
    EXPECT_TRUE(certificate.joined(certificate.clearances[pipe]));
    EXPECT_EQ(certificate.clearances[pipe].distance, 0);
  }
  EXPECT_NO_THROW(verify(certificate));
}

TEST(Certificate, finds_figure_6_margin_to_four_digits) {
  EXPECT_EQ(margin_verdict(0.0848), Verdict::proved);
  EXPECT_EQ(margin_verdict(0.0849), Verdict::refuted);
}

// The radius exceeds the bend's, in a direction where every coordinate is rounded.
TEST(Certificate, refutes_an_elbow_that_folds) {
  const std::string text = certificate_json(certify(parse_assembly(
      R"({"units": "mm", "tolerance": 0.2, "parts": [{"name": "fat", "elbow": {
          "from": [-4, 0, -4], "direction": [1, 2, 3], "radius": 1.9, "bend_radius": 1.4,
          "angle": 90, "toward": [0, 1, 0]}}]})",
      "fat.json")));
  const Certificate certificate = parse_certificate(text);
  EXPECT_EQ(certificate.claims.front().regular->verdict, Verdict::refuted);
  EXPECT_NO_THROW(verify(certificate));
  Certificate slim = certificate;
  auto& pieces = std::get<Chain>(slim.parts.front().shape).pieces;
  std::get<RingedSurface>(pieces.front()).radius = ConstantRadius{1.3};
  EXPECT_THROW(verify(slim), Error);
}

// Coarse meshes, whose errors prover and checker bound by different means.
TEST(Certificate, claims_no_less_error_than_the_checker_finds) {
  const char* chains[] = {
      R"([4, 5, -3, 1], [6.143, 5.295, -4.966, 1], [10.867, 4.911, -6.161, 0.857],
         [14.719, 6.612, -4.854, 2], [19.635, 4.902, -6.129, 2])",
      R"([1, -4, -6, 1], [6.535, -2.468, -5.099, 0.5], [9.164, -2.339, -4.261, 1.993],
         [14.715, -0.732, -5.116, 2], [16.95, -1.841, -3.314, 0.5])"};
  for (const char* chain : chains) {
    for (const std::string segments : {"", R"("segments": 3, )"}) {
      const std::string text = R"({"units": "mm", "tolerance": 0.5, )" + segments +
                               R"("parts": [{"name": "c", "cyclide_chain": {"spheres": [)" + chain +
                               "]}}]}";
      const Certificate certificate = certify(parse_assembly(text, "chain.json"));
      EXPECT_TRUE(certificate.claims.front().mesh);
      EXPECT_NO_THROW(verify(certificate)) << text;
    }
  }
}

TEST(Certificate, refuses_a_margin_that_is_none) {
  for (const double margin : {-0.1, 1.0, 2.0}) {
    EXPECT_THROW((void)certify(example("reducer.json"), {.margin = margin}), Error);
  }
}

TEST(Certificate, is_the_same_document_every_time_and_after_reading) {
  const std::string text = certificate_json(reducer());
  EXPECT_EQ(certificate_json(certify(example("reducer.json"))), text);
  EXPECT_EQ(certificate_json(parse_certificate(text)), text);
  EXPECT_EQ(certificate_json(parse_certificate("\xEF\xBB\xBF" + text)), text);
}

TEST(Certificate, of_every_example_is_proved_and_verified) {
  std::size_t count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::source_folder() / "examples")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".json") {
      continue;
    }
    SCOPED_TRACE(name);
    ++count;
    if (name == "tight.json") {
      EXPECT_THROW((void)certify(example(name)), Error);
      continue;
    }
    const Certificate certificate = certify(example(name));
    EXPECT_EQ(certificate.findings(), 0U);
    EXPECT_NO_THROW(verify(parse_certificate(certificate_json(certificate))));
  }
  EXPECT_GE(count, 8u);
}

// One digit of one number, every time another.
TEST(Certificate, with_one_digit_changed_is_rejected) {
  const std::string text = certificate_json(reducer());
  std::mt19937_64 random(5);
  for (int i = 0; i < 100; ++i) {
    std::string changed = text;
    std::size_t place = 0;
    do {
      place = random() % text.size();
    } while (std::isdigit(static_cast<unsigned char>(text[place])) == 0);
    const char old = text[place];
    changed[place] = static_cast<char>('0' + (old - '0' + 1 + random() % 9) % 10);
    EXPECT_THROW((void)parse_certificate(changed), Error) << place << ": " << old;
  }
}

// Sealed again, so that only the checker stands in the way.
struct Lie {
  std::string about;
  std::function<void(Certificate&)> tell;
};

class Liar : public testing::TestWithParam<Lie> {};

TEST_P(Liar, is_caught_by_the_checker) {
  Certificate certificate = reducer();
  GetParam().tell(certificate);
  try {
    verify(parse_certificate(certificate_json(certificate)));
    ADD_FAILURE() << "believed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::invalid_argument);
    EXPECT_THAT(error.what(), testing::AnyOf(testing::HasSubstr("does not follow"),
                                             testing::HasSubstr("has no claim")));
  }
}

PartClaims& blend(Certificate& c) { return c.claims[kBlend]; }

Chain& chain(Certificate& c, std::size_t part) { return std::get<Chain>(c.parts[part].shape); }

RingedSurface& tube(Certificate& c, std::size_t part) {
  return std::get<RingedSurface>(chain(c, part).pieces[0]);
}

HermiteSpine& spine(Certificate& c) { return std::get<HermiteSpine>(tube(c, kBlend).spine); }

INSTANTIATE_TEST_SUITE_P(
    Certificate, Liar,
    testing::Values(
        Lie{"margin", [](auto& c) { blend(c).regular->margin = 0.0849; }},
        Lie{"no_margin_leaves", [](auto& c) { blend(c).regular->leaves.clear(); }},
        Lie{"missing_margin_leaf", [](auto& c) { blend(c).regular->leaves.pop_back(); }},
        Lie{"one_large_margin_leaf",
            [](auto& c) {
              blend(c).regular->leaves = {{0, 1}};
            }},
        Lie{"false_refutation", [](auto& c) { blend(c).regular->verdict = Verdict::refuted; }},
        Lie{"missing_pair", [](auto& c) { blend(c).embedded->leaves.pop_back(); }},
        Lie{"smaller_pair", [](auto& c) { blend(c).embedded->leaves.back().second.to -= 0.01; }},
        Lie{"one_large_pair",
            [](auto& c) {
              blend(c).embedded->leaves = {{{0, 1}, {0, 1}, {}}};
            }},
        Lie{"other_way",
            [](auto& c) {
              for (DiscPairs& leaf : blend(c).embedded->leaves) {
                leaf.direction = leaf.direction ? -*leaf.direction : leaf.direction;
              }
            }},
        Lie{"false_overlap",
            [](auto& c) {
              blend(c).embedded->verdict = Verdict::refuted;
              blend(c).embedded->overlap = Overlap{Vec3(0, 0, 0), {0, .25}, {.5, 1}};
            }},
        Lie{"longer_pipe", [](auto& c) { std::get<LineSpine>(tube(c, 0).spine).from.x() = -60; }},
        Lie{"other_joint", [](auto& c) { tube(c, 0).end.center.y() += 1e-9; }},
        Lie{"moved_start", [](auto& c) { spine(c).from.y() += 1e-13; }},
        Lie{"missing_joint_leaf", [](auto& c) { c.clearances[1].leaves.pop_back(); }},
        Lie{"joint_with_distance", [](auto& c) { c.clearances[1].distance = 1; }},
        Lie{"bent_axis", [](auto& c) { spine(c).start_velocity.y() = 1e-3; }},
        Lie{"tighter_bend", [](auto& c) { spine(c).start_velocity.x() = 18; }},
        Lie{"mesh_bound", [](auto& c) { blend(c).mesh->error_bound *= 0.9; }},
        Lie{"fewer_segments", [](auto& c) { blend(c).mesh->segments -= 2; }},
        Lie{"missing_knot",
            [](auto& c) { blend(c).mesh->knots.erase(blend(c).mesh->knots.begin() + 5); }},
        Lie{"missing_last_knot", [](auto& c) { blend(c).mesh->knots.pop_back(); }},
        Lie{"clearance", [](auto& c) { c.clearances[0].distance += 3; }},
        Lie{"no_clearance_leaves", [](auto& c) { c.clearances[0].leaves.clear(); }},
        Lie{"no_clearance", [](auto& c) { c.clearances.clear(); }},
        Lie{"clearance_overlap",
            [](auto& c) {
              c.clearances[0].overlap = Overlap{Vec3(0, 0, 0), {0, 1}, {0, 1}};
            }},
        Lie{"claims_missing", [](auto& c) { blend(c).regular.reset(); }}),
    [](const auto& row) { return row.param.about; });

TEST(Certificate, of_a_loop_that_comes_back_is_refuted_by_a_common_point) {
  // The spine leaves along x and comes back across its own beginning.
  const auto place = [](const Vec3& point, const Vec3& direction) {
    return PipeAlong{Place{point, direction, 1}, 1};
  };
  const Assembly loop{
      "",
      Unit::millimetre,
      0.1,
      {},
      {{"a", place({0, 0, 0}, {1, 0, 0})},
       {"b", place({4, -4, 0}, {0, -1, 0})},
       {"loop", CyclicBlendBetween{
                    {"a", End::end}, {"b", End::start}, {.k = 60.0, .l = 60.0, .margin = 0}}}}};
  const Certificate certificate = certify(loop);
  const PartClaims& claims = certificate.claims[2];
  EXPECT_EQ(claims.regular->verdict, Verdict::proved);
  EXPECT_EQ(claims.embedded->verdict, Verdict::refuted);
  EXPECT_TRUE(claims.embedded->overlap.has_value());
  EXPECT_GT(certificate.findings(), 0u);
  EXPECT_NO_THROW(verify(certificate));
}

TEST(Certificate, tells_overlap_from_clearance_for_pipes_that_cross) {
  const auto with_height = [](double height) {
    const Assembly assembly{"",
                            Unit::millimetre,
                            0.1,
                            {},
                            {{"a", PipeBetween{{-5, 0, 0}, {5, 0, 0}, 1}},
                             {"b", PipeBetween{{0, -5, height}, {0, 5, height}, 1}},
                             {"ball", SphereAt{{0, 0, 2 * height}, 1}}}};
    const Certificate certificate = certify(assembly);
    verify(certificate);
    return certificate.clearances;
  };
  for (const ClearanceClaim& claim : with_height(1.75)) {
    EXPECT_EQ(claim.verdict, Verdict::proved);
    EXPECT_EQ(claim.overlap.has_value(), claim.first == 0 ? claim.second == 1 : true);
    EXPECT_LE(claim.distance, 1.5);
  }
  const auto apart = with_height(2.5);
  EXPECT_FALSE(apart[0].overlap);
  EXPECT_LE(apart[0].distance, 0.5);
  EXPECT_GE(apart[0].distance, 0.9 * 0.5);
  EXPECT_GE(apart[1].distance, 0.9 * 3);
}

TEST(Certificate, keeps_how_far_parts_without_a_claim_are_apart) {
  const Certificate certificate = certify(example("header.json"), {.apart = .25});
  const std::string text = certificate_json(certificate);
  const Certificate read = parse_certificate(text);
  EXPECT_EQ(read.apart, .25);
  EXPECT_EQ(read.clearances.size(), certificate.clearances.size());
  EXPECT_NO_THROW(verify(read));
  EXPECT_EQ(certificate_json(read), text);
  EXPECT_EQ(text.find("\"axes\""), std::string::npos);
  EXPECT_EQ(certificate_json(reducer()).find("\"apart\""), std::string::npos);
}

std::string resealed(std::string text) {
  text.resize(text.rfind("  \"sha256\""));
  return text + "  \"sha256\": \"" + sha256(text) + "\"\n}\n";
}

// Decimals may say more than the double that they are read as.
TEST(Certificate, has_the_decimals_of_doubles_only) {
  const std::string text = certificate_json(reducer());
  const std::string key = "\"error_bound\":";
  const std::size_t from = text.find(key) + key.size(), to = text.find_first_of(",}", from);
  ASSERT_GT(from, key.size());
  const std::string number = text.substr(from, to - from);
  const double bound = std::stod(number);
  for (const std::string& other : {number + "0", number + "000000000000000000001", "0" + number,
                                   "+" + number, number + "e0"}) {
    const std::string changed = text.substr(0, from) + other + text.substr(to);
    EXPECT_EQ(std::stod(other), bound);
    EXPECT_THROW((void)parse_certificate(resealed(changed)), Error) << other;
  }
  EXPECT_EQ(
      test::message_of([&] {
        (void)parse_certificate(resealed(text.substr(0, from) + number + "01" + text.substr(to)));
      }),
      "the number " + number + "01 is not written as certify writes it, " + number +
          ", of which alone something can be proved");
}

TEST(Certificate, keeps_the_axes_of_boxes) {
  Certificate certificate = certify(example("header.json"), {.apart = .25});
  certificate.axes = {Vec3(0, 0, 2), Vec3(0.1, 0, 0), Vec3(0, -1, 0)};
  const std::string text = certificate_json(certificate);
  const Certificate read = parse_certificate(text);
  EXPECT_EQ(read.axes, certificate.axes);
  EXPECT_EQ(certificate_json(read), text);
  for (const std::string_view other : {"[[0.0,0.0,2.0],[0.1,0.0,0.0]]", "[1,2,3]", "7", "null"}) {
    std::string changed = text;
    const std::string_view axes = "[[0.0,0.0,2.0],[0.1,0.0,0.0],[0.0,-1.0,0.0]]";
    const auto place = changed.find(axes);
    ASSERT_NE(place, std::string::npos);
    changed.replace(place, axes.size(), other);
    EXPECT_NE(test::message_of([&] { (void)parse_certificate(resealed(changed)); }).find("axes"),
              std::string::npos)
        << other;
  }
}

TEST(Certificate, leaves_what_its_limit_forbids_undecided) {
  const Certificate certificate = certify(example("reducer.json"), {.boxes = 2});
  EXPECT_EQ(certificate.claims[kBlend].embedded->verdict, Verdict::undecided);
  EXPECT_GT(certificate.findings(), 0u);
  EXPECT_NO_THROW(verify(certificate));
}

// What no certificate can be about: one clear error each, at its place in the document.
TEST(Certificate, is_refused_for_impossible_parts) {
  struct Row {
    std::string parts, place, words;
  };
  const std::string pipe = R"({"name":"a","pipe":{"from":[0,0,0],"to":[5,0,0],"radius":1}},)";
  const auto blend = [&](const std::string& from, const std::string& more) {
    return pipe + R"({"name":"b","pipe":{)" + from + R"(,"length":4,"radius":1}},)" +
           R"({"name":"c","cyclic_blend":{"from":"a.end","to":"b.start")" + more + "}}";
  };
  const std::string steep =
      R"({"name":"a","cone":{"from":[0,0,0],"direction":[1,0,0],"length":1,"radii":[9,1]}},)"
      R"({"name":"b","pipe":{"from":[9,0,0],"direction":[1,0,0],"length":4,"radius":1}},)"
      R"({"name":"c","cyclic_blend":{"from":"a.end","to":"b.start",)";
  const std::vector<Row> table = {
      {R"({"name":"a","pipe":{"from":[0,0,0],"to":[0,0,0],"radius":1}})", "/parts/0", ""},
      {R"({"name":"a","pipe":{"from":[0,0,0],"to":[5,0,0],"radius":0}})", "/parts/0", "positive"},
      {R"({"name":"a","pipe":{"from":[0,0,0],"direction":[0,0,0],"length":4,"radius":1}})",
       "/parts/0", "direction"},
      {R"({"name":"a","pipe":{"from":[0,0,0],"direction":[1,0,0],"length":-4,"radius":1}})",
       "/parts/0", "positive"},
      {R"({"name":"a","cone":{"from":[0,0,0],"direction":[1,0,0],"length":4,"radii":[1,-2]}})",
       "/parts/0", "positive"},
      {R"({"name":"a","pipe":{"from":[0,0,0],"to":[5,0,0],"semi_axes":[1,0],"axis":[0,0,1]}})",
       "/parts/0", "positive"},
      {R"({"name":"a","pipe":{"from":[0,0,0],"to":[5,0,0],"semi_axes":[2,1],"axis":[1,0,0]}})",
       "/parts/0", "axis"},
      {blend(R"("from":[5,0,0],"direction":[1,0,0])", ""), "/parts/2", ""},
      {blend(R"("from":[9,0,0],"direction":[1,0,0])", R"(,"k":0,"l":5)"), "/parts/2", "k"},
      {blend(R"("from":[9,3,0],"direction":[1,0,0])", R"(,"margin":1.5)"), "/parts/2", "margin"},
      {pipe + R"({"name":"b","ringed_blend":{"from":"a.end","to":{"center":[9,0,0],)"
              R"("direction":[-1,0,0],"radius":1}}})",
       "/parts/1", ""},
      {steep + R"("radius_law":"R2","k":9,"l":9}})", "/parts/2", "cylinders only"},
      {steep + R"("radius_law":"R1","k":9,"l":9}})", "/parts/2", ""}};
  for (const auto& [parts, place, words] : table) {
    try {
      (void)certify(
          parse_assembly(R"({"units":"mm","tolerance":0.05,"parts":[)" + parts + "]}", "bad"));
      ADD_FAILURE() << "certified " << parts;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("bad#" + place)) << parts;
      EXPECT_THAT(error.what(), testing::HasSubstr(words)) << parts;
    }
  }
}

TEST(Certificate, that_is_malformed_is_refused_with_its_place) {
  const std::string text = certificate_json(reducer());
  const std::vector<std::array<std::string, 3>> table = {
      {"\"format\": \"dupin certificate 1\"", "\"format\": \"dupin certificate 2\"", "/format"},
      {"\"units\": \"mm\"", "\"units\": \"ell\"", "unit"},
      {"\"verdict\":\"proved\"", "\"verdict\":\"likely\"", "/claims/0/regular/verdict"},
      {"\"segments\":29", "\"segments\":29.5", "/claims/0/mesh/segments"},
      {"\"joined\":[null", "\"joined\":[[7,\"end\"]", "/parts/0/joined/0/0"},
      {"\"joined\":[null", "\"joined\":[[0,\"start\"]", "/parts/0/joined/0"},
      {"\"joined\":[null", "\"joined\":[[1,\"end\"]", "/parts/0/joined/0"},
      {"\"joined\":[null", "\"joined\":[[1,\"start\"]", "/parts/0/joined/0"},
      {"\"kind\":\"pipe\"", "\"kind\":7", "/parts/0/kind"},
      {"\"closed\":false", "\"closed\":0", "/parts/0/closed"},
      {"\"wall\":0.0", "\"wall\":\"none\"", "/parts/0/wall"},
      {"\"pieces\":[{", "\"pieces\":[],\"was\":[{", "/parts/0/pieces"},
      {"\"ringed_surface\"", "\"surface\"", "/parts/0/pieces/0"},
      {"\"offset\":", "\"off\":", "/claims/0/tangency/0"},
      {"\"curvature\":", "\"curvature\":[],\"was\":", "/claims/0/tangency/0/curvature"},
      {"\"parts\": [", "\"parts\": 3, \"was\": [", "/parts"},
      {"\"claims\": [", "\"claims\": {}, \"was\": [", "/claims"},
      {"\"leaves\":[[0.0,1.0", "\"leaves\":[[0.0,null", "/claims/0/regular/leaves/0/1"},
      {"\"constant\":[", "\"constant\":[3,", "/parts/0/pieces/0/ringed_surface/radius/constant"},
      {"\"from\":[", "\"from\":[0,", "/parts/0/pieces/0/ringed_surface/spine/line/from"},
      {"\"radius\":1.0", "\"radius\":1.5", "/inputs_sha256"},
      {"\"tolerance\"", "\"tolerances\"", "tolerance"}};
  for (const auto& [from, to, place] : table) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    changed.replace(at, from.size(), to);
    try {
      (void)parse_certificate(resealed(changed));
      ADD_FAILURE() << "accepted " << to;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(place));
    }
  }
  for (const std::size_t size : {0ul, 1ul, 100ul, text.size() / 2, text.size() - 70}) {
    EXPECT_THROW((void)parse_certificate(text.substr(0, size)), Error) << size;
  }
}

TEST(Certificate, is_the_same_whatever_way_the_caller_rounds) {
  const auto made = [] {
    const Certificate certificate = certify(example("reducer.json"));
    std::string text = certificate_json(certificate);
    verify(parse_certificate(text, "reducer.cert"));
    return text;
  };
  const std::string usual = made();
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const std::string text = made();
    EXPECT_EQ(std::fegetround(), mode);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(text, usual) << mode;
  }
}

}  // namespace
}  // namespace dupin
