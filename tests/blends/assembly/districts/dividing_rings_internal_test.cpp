#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/districts/common_rings.h"
#include "assembly/districts/dividing_rings.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::pipe;

// Three pipes one after the other, with a branch on the second.
const Assembly& line() {
  static const Assembly kLine = [] {
    Assembly result{"line.json", Unit::millimetre, 0.1, {}, {pipe("p0", {0, 0, 0}, {10, 0, 0}, 1)}};
    result.parts.push_back({"p1", PipeAlong{PortReference{"p0", End::end}, 10}});
    result.parts.push_back({"p2", PipeAlong{PortReference{"p1", End::end}, 10}});
    result.parts.push_back(pipe("branch", {15, 0, 0}, {15, 0, 9}, .5));
    return result;
  }();
  return kLine;
}

struct Line {
  ResolvedAssembly resolved = resolve(line());
  DistrictParts members = districts_of_parts(resolved, .1).at(0);
  Divisible whole{resolved, members, common_rings(district(line(), resolved, members), {})};
  std::set<std::string> kept;
  std::optional<std::vector<double>> distances;
  DividingRule rule{kept, distances, {}};
};

TEST(DividingRings, are_where_only_two_parts_touch) {
  Line line;
  const Atoms atoms = atoms_of(line.whole, line.rule);
  EXPECT_EQ(atoms.of, (std::vector<std::uint32_t>{0, 1, 2, 1}));
  EXPECT_EQ(atoms.count, 3);
  ASSERT_EQ(atoms.rings.size(), 2);
  EXPECT_EQ(atoms.rings[1].parts, (std::array<std::uint32_t, 2>{1, 2}));
  line.kept.insert(atoms.rings[0].name);
  EXPECT_EQ(atoms_of(line.whole, line.rule).of, (std::vector<std::uint32_t>{0, 0, 1, 0}));
}

TEST(DividingRings, are_discs_of_the_pieces_on_both_sides) {
  const Line line;
  const Atoms atoms = atoms_of(line.whole, line.rule);
  const std::vector<std::uint32_t> group_of{0, 0, 1, 0};
  const auto pieces = pieces_of(line.whole, atoms.boxes, atoms.rings, group_of);
  ASSERT_EQ(pieces.size(), 2);
  EXPECT_EQ(pieces[0].parts, (std::vector<std::uint32_t>{0, 1, 3}));
  EXPECT_EQ(pieces[1].parts, (std::vector<std::uint32_t>{2}));
  for (const DistrictParts& piece : pieces) {
    ASSERT_TRUE(piece.piece);
    EXPECT_EQ(piece.piece->samplings.size(), piece.parts.size());
    ASSERT_EQ(piece.piece->discs.size(), 1);
    EXPECT_EQ(piece.piece->discs.front().name, atoms.rings[1].name);
  }
  EXPECT_EQ(pieces[0].piece->discs.front().end, (EndIndex{1, End::end}));
  EXPECT_EQ(pieces[1].piece->discs.front().end, (EndIndex{2, End::start}));
}

}  // namespace
}  // namespace dupin::assembly
