#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assembly/districts/common_rings.h"
#include "assembly/districts/divided_districts.h"
#include "assembly/districts/dividing_rings.h"
#include "dupin/blends/build.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "support/named_parts.h"

namespace dupin::assembly {
namespace {

using test::pipe;

constexpr double kMargin = .1;

// One pipe after the other, with a branch on every other one.
Assembly header(int pipes) {
  Assembly result{"plant.json", Unit::millimetre, 0.01, {}, {pipe("h0", {0, 0, 0}, {10, 0, 0}, 1)}};
  for (int i = 1; i < pipes; ++i) {
    const std::string number = std::to_string(i);
    result.parts.push_back(
        {"h" + number, PipeAlong{PortReference{"h" + std::to_string(i - 1), End::end}, 10}});
    if (i % 2 == 0) {
      result.parts.push_back(pipe("b" + number, {10. * i + 5, 0, 0}, {10. * i + 5, 0, 5}, .5));
    }
  }
  return result;
}

DividedDistricts divided_of(const Assembly& assembly, double most,
                            const std::set<std::string>& kept = {}) {
  const ResolvedAssembly resolved = resolve(assembly);
  return divided(assembly, resolved, districts_of_parts(resolved, kMargin),
                 {.most = most, .kept = kept});
}

double triangles_of(const Assembly& assembly, const DistrictParts& members) {
  const ExpectedTriangles all = expected_of(district(assembly, resolve(assembly), members));
  return all.surface + all.crossings;
}

// Of what no ring divides.
double largest_atom(const Assembly& assembly) {
  const ResolvedAssembly resolved = resolve(assembly);
  const DistrictParts members = districts_of_parts(resolved, kMargin).at(0);
  const Divisible whole{resolved, members, common_rings(district(assembly, resolved, members), {})};
  const std::optional<std::vector<double>> distances;
  const Atoms atoms = atoms_of(whole, {{}, distances, {}});
  double largest = 0;
  for (const DistrictParts& piece : pieces_of(whole, atoms.boxes, atoms.rings, atoms.of)) {
    largest = std::max(largest, triangles_of(assembly, piece));
  }
  return largest;
}

TEST(DividedDistricts, have_so_many_triangles_at_most) {
  const Assembly assembly = header(40);
  const double all = triangles_of(assembly, divided_of(assembly, 1e9).districts.at(0));
  const DividedDistricts made = divided_of(assembly, all / 4);
  EXPECT_GE(made.districts.size(), 4);
  EXPECT_LE(made.districts.size(), 8);
  EXPECT_EQ(made.seams.size(), made.districts.size() - 1);
  std::vector<std::uint32_t> parts;
  for (const DistrictParts& piece : made.districts) {
    EXPECT_LE(triangles_of(assembly, piece), all / 4);
    EXPECT_TRUE(std::ranges::is_sorted(piece.parts));
    parts.insert(parts.end(), piece.parts.begin(), piece.parts.end());
    ASSERT_TRUE(piece.piece);
    EXPECT_EQ(piece.piece->samplings.size(), piece.parts.size());
  }
  std::ranges::sort(parts);
  EXPECT_EQ(parts.size(), resolve(assembly).parts.size());
  EXPECT_TRUE(std::ranges::adjacent_find(parts) == parts.end());
  EXPECT_TRUE(std::ranges::is_sorted(
      made.districts, {}, [](const DistrictParts& piece) { return piece.parts.front(); }));
}

TEST(DividedDistricts, touch_at_seams_only) {
  const DividedDistricts made = divided_of(header(40), 100);
  EXPECT_GT(made.seams.size(), 20);
  for (std::uint32_t i = 0; i < made.districts.size(); ++i) {
    for (std::uint32_t j = i + 1; j < made.districts.size(); ++j) {
      for (const Eigen::AlignedBox3d& a : made.districts[i].boxes) {
        for (const Eigen::AlignedBox3d& b : made.districts[j].boxes) {
          const bool is_seam = std::ranges::any_of(made.seams, [&](const Seam& seam) {
            return seam.pieces == std::array{i, j} && seam.meeting.contains(a.intersection(b));
          });
          EXPECT_TRUE(is_seam || !a.intersects(b)) << i << " " << j;
        }
      }
    }
  }
}

TEST(DividedDistricts, of_few_parts_or_triangles_stay_whole) {
  EXPECT_EQ(divided_of(header(40), 1e9).districts.size(), 1);
  EXPECT_TRUE(divided_of(header(40), 1e9).seams.empty());
  EXPECT_EQ(divided_of(header(16), 1).districts.size(), 1);
  EXPECT_FALSE(divided_of(header(16), 1).districts.at(0).piece);
}

// Small pieces are worth while in large models only.
TEST(DividedDistricts, of_as_many_triangles_as_may_be_undivided_stay_whole) {
  const Assembly assembly = header(40);
  const ResolvedAssembly resolved = resolve(assembly);
  const auto pieces = [&](double undivided) {
    return divided(assembly, resolved, districts_of_parts(resolved, kMargin),
                   {.most = 100, .undivided = undivided})
        .districts.size();
  };
  const double all = triangles_of(assembly, divided_of(assembly, 1e9).districts.at(0));
  EXPECT_EQ(pieces(1.01 * all), 1);
  EXPECT_EQ(pieces(.99 * all), pieces(0));
  EXPECT_GT(pieces(0), 20);
}

TEST(DividedDistricts, are_not_divided_where_seams_are_kept) {
  const Assembly assembly = header(40);
  const double most = largest_atom(assembly);
  const DividedDistricts made = divided_of(assembly, most);
  EXPECT_FALSE(made.cut);
  std::set<std::string> names;
  for (const Seam& seam : made.seams) {
    EXPECT_TRUE(names.insert(seam.name).second);
    EXPECT_LT(seam.name.front(), ' ');
  }
  EXPECT_FALSE(divided_of(assembly, most, {*names.begin()}).seams.empty());
  for (const Seam& seam : divided_of(assembly, most, {*names.begin()}).seams) {
    EXPECT_NE(seam.name, *names.begin());
  }
}

// A pipe across a ring is near both of its parts.
TEST(DividedDistricts, are_not_divided_where_others_are_near) {
  Assembly assembly = header(40);
  const auto is_there = [](const Seam& seam) { return seam.meeting.contains(Vec3(90, 0, 1)); };
  EXPECT_TRUE(std::ranges::any_of(divided_of(assembly, largest_atom(assembly)).seams, is_there));
  assembly.parts.push_back(pipe("across", {90, 0, -5}, {90, 0, 5}, .5));
  EXPECT_FALSE(std::ranges::any_of(divided_of(assembly, largest_atom(assembly)).seams, is_there));
}

// A header of one pipe, and pipes across it, some of which go through a second one.
Assembly comb(int teeth) {
  Assembly result{"comb.json",
                  Unit::millimetre,
                  0.01,
                  {},
                  {pipe("h", {-10, 0, 0}, {10. * teeth, 0, 0}, 1),
                   pipe("g", {10. * teeth, 0, 8}, {-10, 0, 8}, 1)}};
  for (int i = 0; i < teeth; ++i) {
    result.parts.push_back(
        pipe("t" + std::to_string(i), {10. * i, 0, -5}, {10. * i, 0, i % 3 == 0 ? 12. : 4.}, .5));
  }
  return result;
}

TEST(DividedDistricts, have_stretches_of_pipes_where_rings_do_not_divide) {
  const Assembly assembly = comb(40);
  const double all = triangles_of(assembly, divided_of(assembly, 1e9).districts.at(0));
  EXPECT_FALSE(divided_of(assembly, all).cut);
  const DividedDistricts made = divided_of(assembly, all / 6);
  ASSERT_TRUE(made.cut);
  EXPECT_GE(made.districts.size(), 6);
  EXPECT_LE(made.districts.size(), 16);
  EXPECT_GE(made.seams.size(), made.districts.size() - 1);
  double together = 0;
  std::set<std::uint32_t> parts;
  for (const DistrictParts& piece : made.districts) {
    const ExpectedTriangles own = expected_of(district(assembly, *made.cut, piece));
    EXPECT_LE(own.surface + own.crossings, all / 6);
    together += own.surface + own.crossings;
    for (const std::uint32_t part : piece.parts) {
      EXPECT_TRUE(parts.insert(part).second);
    }
  }
  EXPECT_GE(together, all) << "all crossings are in one of them";
  EXPECT_LE(together, 1.5 * all);
  EXPECT_EQ(parts.size(), made.cut->parts.size());
  for (const Seam& seam : made.seams) {
    EXPECT_LT(seam.meeting.sizes().minCoeff(), 1);
  }
}

TEST(DividedDistricts, are_cut_no_more_often_than_pieces_need) {
  const Assembly assembly = comb(40);
  const DividedDistricts made = divided_of(assembly, 1000);
  ASSERT_TRUE(made.cut);
  // Each stretch ends where another piece begins, or where the pipe does.
  std::size_t ends = 0;
  for (const DistrictParts& piece : made.districts) {
    ends += piece.piece ? piece.piece->discs.size() : 0;
  }
  EXPECT_EQ(ends, 2 * made.seams.size());
  EXPECT_EQ(made.cut->parts.size(), 42 + made.seams.size());
}

// Where walls change, the narrower bore reaches into the wider one.
TEST(DividedDistricts, of_hollow_parts_are_divided_where_walls_are_the_same) {
  Assembly assembly = header(40);
  BuildOptions options;
  options.margin = kMargin;
  options.most_of_piece = 1;  // at every ring, and between
  const auto seams = [&] { return DistrictBuild(assembly, options).seams(); };
  const auto is_at = [](double x) {
    return [=](const Seam& seam) { return seam.meeting.contains(Vec3(x, 0, 0)); };
  };
  assembly.wall = .1;
  ASSERT_TRUE(std::ranges::any_of(seams(), is_at(20)));
  assembly.parts[3].wall = .2;
  ASSERT_EQ(assembly.parts[3].name, "b2");
  EXPECT_TRUE(std::ranges::any_of(seams(), is_at(20)));
  assembly.parts[3].wall.reset();
  assembly.parts[2].wall = .2;
  ASSERT_EQ(assembly.parts[2].name, "h2");
  EXPECT_FALSE(std::ranges::any_of(seams(), is_at(20)));
  assembly.parts[2].wall.reset();
  options.region = Region::insulation;
  assembly.insulation = .2;
  EXPECT_GT(seams().size(), 10);
}

TEST(DividedDistricts, a_piece_has_a_disc_where_it_ends) {
  const Assembly assembly = header(40);
  const ResolvedAssembly resolved = resolve(assembly);
  BuildOptions options;
  options.margin = kMargin;
  options.most_of_piece = 100;
  const DistrictBuild build(assembly, options);
  ASSERT_FALSE(build.seams().empty());
  const Seam& seam = build.seams().front();
  for (const std::uint32_t piece : seam.pieces) {
    const Built built = build.build(piece);
    const auto label = std::ranges::find(built.solid.names(), seam.name);
    ASSERT_NE(label, built.solid.names().end());
    EXPECT_GT(std::ranges::count(built.solid.labels(), label - built.solid.names().begin()), 5);
    EXPECT_FALSE(build.taken_from_whole(piece).empty());
  }
  EXPECT_THROW((void)build.build_all(), Error);
  EXPECT_TRUE(build.joined({}).solid.triangles().empty());
}

TEST(DividedDistricts, a_hollow_piece_has_an_annulus_where_it_ends) {
  Assembly assembly = header(40);
  assembly.wall = .1;
  assembly.insulation = .2;
  for (const Region region : {Region::metal, Region::fluid, Region::outer, Region::insulation}) {
    BuildOptions options;
    options.region = region;
    options.margin = kMargin;
    options.most_of_piece = 100;
    const DistrictBuild build(assembly, options);
    ASSERT_FALSE(build.seams().empty());
    const Seam& seam = build.seams().front();
    std::vector<SeamSide> sides;
    for (const std::uint32_t piece : seam.pieces) {
      const Rounded rounded = to_mesh(build.build(piece).solid, Coordinates::binary32);
      sides.push_back(
          opened(rounded.mesh(), Vec3::Zero(), check(rounded), {&seam, 1}).sides.front());
    }
    EXPECT_TRUE(fit(sides[0], sides[1])) << name(region);
    const bool has_bore = region == Region::metal || region == Region::insulation;
    EXPECT_EQ(sides[0].borders.size(), has_bore ? 2 : 1) << name(region);
  }
}

}  // namespace
}  // namespace dupin::assembly
