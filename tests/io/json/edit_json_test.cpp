#include "dupin/io/edit_json.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/blends/build.h"
#include "dupin/blends/edit_chain.h"
#include "dupin/blends/part_surface.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/kernel/error.h"
#include "support/cyclide_cases.h"
#include "support/message_of.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

using test::sphere;

std::string hook() { return read_file(test::source_folder() / "examples" / "crane-hook.json"); }

CyclideChain pieces(const std::string& text) {
  return {cyclide_pieces(resolve(parse_assembly(text)).parts.at(0).shape)};
}

std::vector<std::size_t> differing(const CyclideChain& a, const CyclideChain& b) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < a.pieces.size(); ++i) {
    if (!(a.pieces[i] == b.pieces[i])) {
      result.push_back(i);
    }
  }
  return result;
}

std::string moved(const std::string& text, std::size_t index, const PeVector& to,
                  bool on_locus = false) {
  return with_chain(text, {}, 0, move_sphere(parse_assembly(text), 0, index, to, on_locus));
}

TEST(EditJson, changes_the_pieces_it_must_and_no_other_bit) {
  struct Row {
    std::size_t sphere;
    PeVector to;
    bool on_locus;
    std::vector<std::size_t> changed;
  };
  const Row rows[] = {
      {4, sphere(1.1, 2.5, .2, .8), false, {1, 2, 3}},
      {6, sphere(2.1, .9, .1, .97), true, {2, 3}},
      {10, sphere(-1.9, 1.6, .1, .6), false, {4, 5}},  // the last junction between pieces
      {12, sphere(-2.1, 2.8, .1, .25), false, {5}},
      {7, sphere(1.4, -.3, 0, 1), false, {}},  // a bias sphere
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.sphere);
    const std::string text = moved(hook(), row.sphere, row.to, row.on_locus);
    EXPECT_EQ(differing(pieces(hook()), pieces(text)), row.changed);
  }
  // Once more, on what was edited before.
  const std::string once = moved(hook(), 4, sphere(1.1, 2.5, .2, .8));
  const std::string twice = moved(once, 6, sphere(2, .9, .1, .97));
  EXPECT_EQ(differing(pieces(once), pieces(twice)), (std::vector<std::size_t>{2, 3, 4}));
}

TEST(EditJson, pieces_still_meet_g1) {
  const auto chain = pieces(moved(hook(), 4, sphere(1.1, 2.5, .2, .8)));
  for (std::size_t i = 0; i + 1 < chain.pieces.size(); ++i) {
    EXPECT_EQ(chain.pieces[i].end(), chain.pieces[i + 1].start());
    const PeVector miss = chain.pieces[i].end_tangent() - chain.pieces[i + 1].start_tangent();
    EXPECT_LT(miss.m.norm() + std::abs(miss.r), 1e-14);
  }
}

TEST(EditJson, the_moved_junction_has_the_values_of_the_oracle) {
  // Mathematics C8: piece 1, and pieces 0, 4 and 5 as they were.
  const auto chain = pieces(moved(hook(), 4, sphere(1.1, 2.5, .2, .8)));
  EXPECT_NEAR(chain.pieces[1].chord(), 2.02672149048654, 1e-12);
  EXPECT_NEAR(chain.pieces[1].w(), 0.836089373485377, 1e-12);
  EXPECT_NEAR(chain.pieces[1].least_power(), 2.57661523067349, 1e-12);
}

TEST(EditJson, keeps_all_other_text) {
  const std::string text = moved(hook(), 12, sphere(-2.125, 2.75, .125, .25));
  std::string expected = hook();
  const std::string before = "[-2, 2.7, 0, 0.25]";
  expected.replace(expected.find(before), before.size(), "[-2.125, 2.75, 0.125, 0.25]");
  EXPECT_EQ(text, expected);
}

TEST(EditJson, finds_values_behind_brackets_in_strings) {
  const std::string text =
      R"({"comment": "]}\\\"[", "units": "mm", "tolerance": 1, "parts": [ {"name": "a", "sphere": {"center": [0,0,9], "radius": 1}},
  {"comment": "{", "cyclide_chain": {"spheres": [[0,0,0,1], [2,0,0,1],[4,0,0,1]]}, "name": "b"}]})";
  const auto chain = move_sphere(parse_assembly(text), 1, 2, sphere(4, 1, 0, 1));
  const std::string edited = with_chain(text, {}, 1, chain);
  EXPECT_THAT(edited, testing::HasSubstr("[[0,0,0,1], [2,0,0,1],[4.0, 1.0, 0.0, 1.0]], "
                                         "\"tangents\": [{\"sphere\": 0, \"tangent\": "));
  EXPECT_THAT(edited, testing::StartsWith(R"({"comment": "]}\\\"[", "units")"));
}

/// A chain in an entry with parts, in another one; `loop` stands in the outer one.
std::string in_groups(const std::string& loop) {
  return R"({"units": "mm", "tolerance": 1, "parts": [
  {"name": "first", "sphere": {"center": [0,0,9], "radius": 1}},
  {"comment": "outer", )" +
         loop + R"("parts": [{"name": "a", "sphere": {"center": [0,0,19], "radius": 1}},
    {"parts": [{"name": "b", "cyclide_chain": {"spheres": [[0,0,0,1], [2,0,0,1],[4,0,0,1]]}}]}]}]})";
}

TEST(EditJson, finds_a_chain_in_an_entry_with_parts) {
  const std::string text = in_groups("");
  const auto chain = move_sphere(parse_assembly(text), 2, 2, sphere(4, 1, 0, 1));
  const std::string edited = with_chain(text, {}, 2, chain);
  const std::size_t at = text.find("[4,0,0,1]");
  EXPECT_EQ(edited.substr(0, at), text.substr(0, at));
  EXPECT_THAT(edited.substr(at), testing::StartsWith("[4.0, 1.0, 0.0, 1.0]], \"tangents\": [{"));
  EXPECT_THAT(edited, testing::EndsWith("}]}}]}]}]}"));
  EXPECT_EQ(std::get<CyclideChainThrough>(parse_assembly(edited).parts.at(2).shape).spheres[2],
            sphere(4, 1, 0, 1));
}

TEST(EditJson, refuses_a_chain_that_an_entry_around_it_copies) {
  const std::string text = in_groups(R"("for": {"i": 1}, )");
  const Assembly assembly = parse_assembly(text, "d.json");
  const auto chain = move_sphere(assembly, 2, 2, sphere(4, 1, 0, 1));
  EXPECT_EQ(
      test::message_of([&] { (void)with_chain(text, "d.json", 2, chain); }, Errc::invalid_argument),
      "d.json#/parts/1/parts/1/parts/0: 'b': a copy that \"for\" makes cannot be changed alone");
}

TEST(EditJson, refuses_what_is_no_edit_of_the_chain) {
  const std::string text = in_groups("");
  const auto chain = std::get<CyclideChainThrough>(parse_assembly(text).parts.at(2).shape);
  const auto said = [&](std::uint32_t part, const CyclideChainThrough& edited) {
    return test::message_of([&] { (void)with_chain(text, "d.json", part, edited); },
                            Errc::invalid_argument);
  };
  EXPECT_EQ(said(3, chain), "d.json: there is no part 3; the document has 3");
  EXPECT_EQ(said(0, chain),
            "d.json#/parts/0: 'first': the part is no cyclide_chain, and cannot become one");
  CyclideChainThrough edited = chain;
  edited.spheres.push_back(sphere(6, 0, 0, 1));
  EXPECT_EQ(said(2, edited),
            "d.json#/parts/1/parts/1/parts/0/cyclide_chain/spheres: 'b': the chain has to keep its "
            "3 spheres; the new one has 4");
  edited = chain;
  edited.spheres[1].r = std::nan("");
  EXPECT_EQ(said(2, edited),
            "d.json#/parts/1/parts/1/parts/0/cyclide_chain/spheres/1: 'b': the numbers of spheres "
            "and tangents must be finite");
  edited = chain;
  edited.tangents = {{1, sphere(std::numeric_limits<double>::infinity(), 0, 0, 0)}};
  EXPECT_EQ(said(2, edited),
            "d.json#/parts/1/parts/1/parts/0/cyclide_chain/tangents/0: 'b': the numbers of spheres "
            "and tangents must be finite");
}

TEST(EditJson, keeps_a_byte_order_mark) {
  const std::string mark = "\xEF\xBB\xBF";
  const PeVector to = sphere(1.1, 2.5, .2, .8);
  EXPECT_EQ(moved(mark + hook(), 4, to), mark + moved(hook(), 4, to));
}

TEST(EditJson, twisting_turns_what_follows) {
  const auto chain = twist_chain(parse_assembly(hook()), 0, 6, 25 * std::numbers::pi / 180);
  const auto turned = pieces(with_chain(hook(), {}, 0, chain));
  const auto expected = test::twisted_crane_hook();
  EXPECT_EQ(differing(pieces(hook()), turned), (std::vector<std::size_t>{3, 4, 5}));
  for (std::size_t i = 0; i < 6; ++i) {
    const PeVector miss = turned.pieces[i].end() - expected.pieces[i].end();
    EXPECT_LT(miss.m.norm(), 1e-13);
    EXPECT_NEAR(turned.pieces[i].w(), expected.pieces[i].w(), 1e-13);
  }
}

TEST(EditJson, a_chain_with_kneecaps_changes_in_the_pieces_through_the_sphere) {
  const std::string text =
      R"({"units": "mm", "tolerance": 0.01, "parts": [{"name": "c", "cyclide_chain": {"joints": "kneecaps",
      "spheres": [[0,0,0,1],[2,1,0,0.8],[4,1,0,1],[6,0.2,0,0.9],[8,1,0,0.7],[10,1.4,0,0.7],[12,1,0,0.7]]}}]})";
  const auto kneecap_pieces = [](const std::string& document) {
    return CyclideChain{cyclide_pieces(resolve(parse_assembly(document)).parts.at(0).shape)};
  };
  const std::vector<std::vector<std::size_t>> changed{{0}, {0}, {0, 1}, {1}, {1, 2}, {2}, {2}};
  const auto spheres =
      std::get<CyclideChainThrough>(parse_assembly(text).parts.at(0).shape).spheres;
  for (std::size_t i = 0; i < changed.size(); ++i) {
    PeVector to = spheres[i];
    to.m.z() += 0.125;
    const std::string edited = moved(text, i, to);
    EXPECT_EQ(differing(kneecap_pieces(text), kneecap_pieces(edited)), changed[i]) << i;
    EXPECT_THAT(edited, testing::Not(testing::HasSubstr("tangents")));
  }
  EXPECT_THROW((void)twist_chain(parse_assembly(text), 0, 2, 1), Error);
}

TEST(EditJson, a_chain_with_kneecaps_at_a_port_keeps_its_beginning) {
  const std::string text =
      R"({"units": "mm", "tolerance": 0.01, "parts": [{"name": "p", "pipe": {"from": [-2,0,0], "to": [0,0,0], "radius": 1}},
      {"name": "c", "cyclide_chain": {"joints": "kneecaps", "from": "p.end",
      "spheres": [[2,1,0,0.8],[4,1,0,1],[6,0.2,0,0.9],[8,1,0,0.7]]}}]})";
  const auto chain = [](const std::string& document) {
    return CyclideChain{cyclide_pieces(resolve(parse_assembly(document)).parts.at(1).shape)};
  };
  const auto edited = [&](std::size_t i, const PeVector& to) {
    const Assembly assembly = parse_assembly(text);
    return with_chain(text, {}, 1, move_sphere(assembly, 1, i, to));
  };
  EXPECT_EQ(differing(chain(text), chain(edited(0, sphere(2, 2, 0, .8)))),
            std::vector<std::size_t>());
  EXPECT_EQ(differing(chain(text), chain(edited(1, sphere(4, 1, .5, 1)))),
            (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(differing(chain(text), chain(edited(3, sphere(8, 1, .5, .7)))),
            std::vector<std::size_t>{1});
}

TEST(EditJson, refuses_what_cannot_be_edited) {
  const Assembly assembly = parse_assembly(hook());
  EXPECT_THROW((void)move_sphere(assembly, 0, 0, sphere(0, 8, 0, 1)), Error);
  EXPECT_THROW((void)move_sphere(assembly, 0, 13, sphere(0, 8, 0, 1)), Error);
  EXPECT_THROW((void)move_sphere(assembly, 0, 4, sphere(0, 4, 0, 4)), Error);
  EXPECT_THROW((void)twist_chain(assembly, 0, 5, 1), Error);
  EXPECT_THROW((void)find_chain(assembly, "shank"), Error);
  EXPECT_EQ(find_chain(assembly, {}), 0U);
}

// parse_assembly refuses keys that occur twice.
TEST(EditJson, writes_a_key_once_that_was_there_empty) {
  for (const std::string tangents : {"", ", \"tangents\": []", ", \"tangents\" : [ ]"}) {
    const std::string text =
        R"({"units": "mm", "tolerance": 0.01, "parts": [{"name": "h", "cyclide_chain": {
           "direction": [0, -1, 0], "spheres": [[0, 8, 0, 0.55], [0, 6, 0, 0.58],
           [0, 4.2, 0, 0.62], [0.3, 3.3, 0, 0.7], [1, 2.6, 0, 0.78], [1.75, 1.95, 0, 0.87],
           [2, 1, 0, 0.95], [1.4, -0.4, 0, 1], [0, -1, 0, 1.05]])" +
        tangents + "}}]}";
    const std::string after = moved(text, 2, sphere(0, 4.3, 0.05, 0.62));
    const Assembly assembly = parse_assembly(after);
    EXPECT_FALSE(std::get<CyclideChainThrough>(assembly.parts[0].shape).tangents.empty());
  }
}

// What is not refused is built from what was written, and keeps to the margin.
TEST(EditJson, random_edits_are_written_sound_or_refused) {
  std::mt19937 random(480);
  std::uniform_real_distribution<double> shift(-1, 1);
  std::string text = hook();
  int written = 0, refused = 0;
  for (int i = 0; i < 480; ++i) {
    const Assembly before = parse_assembly(text);
    const auto& spheres = std::get<CyclideChainThrough>(before.parts[0].shape).spheres;
    const std::size_t at = 1 + random() % (spheres.size() - 1);
    const double size = std::pow(10, 0.8 * shift(random));
    PeVector to = spheres[at];
    to.m += size * Vec3(shift(random), shift(random), shift(random));
    to.r *= std::exp(size * shift(random) / 4);
    std::string after;
    try {
      after = moved(text, at, to, random() % 3 == 0);
      check_edit(parse_assembly(after), 0, kEditMargin);
    } catch (const Error& error) {
      EXPECT_TRUE(error.code() == Errc::infeasible_blend ||
                  error.code() == Errc::irregular_surface ||
                  error.message().find("its smallest radius or length, ") == 0)
          << error.what();
      ++refused;
      continue;
    }
    ++written;
    if (written % 4 == 0) {
      EXPECT_GE(build(parse_assembly(after)).parts[0].margin_lower.value(), kEditMargin);
    }
    if (written % 8 != 0) {
      text = after;  // edits of edits, back to the hook in between
    } else {
      text = hook();
    }
  }
  EXPECT_GT(written, 48);
  EXPECT_GT(refused, 48);
}

}  // namespace
}  // namespace dupin
