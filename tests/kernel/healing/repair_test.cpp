#include "dupin/kernel/repair.h"

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::box;
using test::joined;
using test::reversed;

TriMesh cube(double low, double high) { return box(Vec3::Constant(low), Vec3::Constant(high)); }

// Every triangle with points of its own, as in STL.
TriMesh unwelded(const TriMesh& mesh) {
  TriMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t corner : t) {
      soup.points.push_back(mesh.points[corner]);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TriMesh with_face(TriMesh mesh, const Triangle& face) {
  mesh.triangles.push_back(face);
  return mesh;
}

TriMesh with_turned(TriMesh mesh, std::initializer_list<std::size_t> faces) {
  for (const std::size_t face : faces) {
    std::swap(mesh.triangles[face][1], mesh.triangles[face][2]);
  }
  return mesh;
}

// A cap without area on an edge: its middle is a point that the other face of the edge lacks.
TriMesh with_cap() {
  TriMesh mesh = cube(0, 2);
  const Triangle t = mesh.triangles[0];
  const auto middle = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.emplace_back((mesh.points[t[0]] + mesh.points[t[1]]) / 2);
  mesh.triangles[0] = {t[0], middle, t[2]};
  mesh.triangles.push_back({middle, t[1], t[2]});
  mesh.triangles.push_back({t[0], t[1], middle});
  return mesh;
}

// The same with more points, bridged by a fan of faces without area.
TriMesh with_fan(std::uint32_t pieces) {
  TriMesh mesh = cube(0, 1024);
  const Triangle t = mesh.triangles[0];
  std::uint32_t last = t[0];
  for (std::uint32_t i = 1; i < pieces; ++i) {
    const auto next = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.emplace_back(mesh.points[t[0]] +
                             (mesh.points[t[1]] - mesh.points[t[0]]) * i / pieces);
    mesh.triangles.push_back({last, next, t[2]});
    mesh.triangles.push_back({t[1], next, last});
    last = next;
  }
  mesh.triangles[0] = {last, t[1], t[2]};
  return mesh;
}

// Pyramids of different heights over the same base, whose two copies are both needed.
TriMesh nested_over_one_base() {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {1, 1, 1}, {1, 1, 2}};
  for (const std::uint32_t apex : {3U, 4U}) {
    mesh.triangles.push_back({0, 2, 1});
    mesh.triangles.push_back({0, 1, apex});
    mesh.triangles.push_back({1, 2, apex});
    mesh.triangles.push_back({2, 0, apex});
  }
  return mesh;
}

struct Row {
  const char* name;
  TriMesh mesh;
  mpq_class volume;
  std::size_t components, shells;
  RepairReport report;
};

std::vector<Row> rows() {
  const TriMesh whole = cube(0, 2);
  const Triangle first = whole.triangles[0];
  const Triangle turned = {first[0], first[2], first[1]};
  const TriMesh beside = box({2, 0, 0}, {4, 2, 2});
  return {
      {"a solid", whole, 8, 1, 1, {}},
      {"points of their own", unwelded(whole), 8, 1, 1, {.merged_points = 28}},
      {"an edge twice", with_face(whole, {0, 1, 1}), 8, 1, 1, {.degenerate_faces = 1}},
      {"a cap", with_cap(), 8, 1, 1, {.degenerate_faces = 1}},
      {"a fan", with_fan(1024), 1024 * 1024 * 1024, 1, 1, {.degenerate_faces = 1023}},
      {"copies that are needed", nested_over_one_base(), 12, 1, 1, {.united_overlaps = true}},
      {"a face twice", with_face(whole, first), 8, 1, 1, {.duplicate_faces = 1}},
      {"a face and its back", with_face(whole, turned), 8, 1, 1, {.duplicate_faces = 1}},
      {"a fin of two sheets that run alike",
       with_face(with_face(whole, {0, 1, 7}), {0, 1, 7}),
       8,
       1,
       1,
       {.duplicate_faces = 2}},
      {"a fin of two sheets, back to back",
       with_face(with_face(whole, {0, 1, 7}), {0, 7, 1}),
       8,
       1,
       1,
       {.duplicate_faces = 2}},
      {"all twice", joined({whole, whole}), 8, 1, 1, {.merged_points = 8, .duplicate_faces = 12}},
      {"a wall between",
       joined({whole, beside}),
       16,
       1,
       1,
       {.merged_points = 4, .duplicate_faces = 4}},
      {"some faces turned", with_turned(whole, {0, 5, 7}), 8, 1, 1, {.turned_faces = 3}},
      {"inside out", reversed(whole), 8, 1, 1, {.turned_faces = 12}},
      {"a void", joined({cube(0, 5), reversed(cube(1, 2))}), 124, 1, 2, {}},
      {"a void, all inside out",
       reversed(joined({cube(0, 5), reversed(cube(1, 2))})),
       124,
       1,
       2,
       {.turned_faces = 24, .cavities = 1}},
      {"a block in a void, all inside out",
       reversed(joined({cube(0, 9), reversed(cube(1, 5)), cube(2, 3)})),
       729 - 64 + 1,
       2,
       3,
       {.turned_faces = 36, .cavities = 1}},
      {"a void, its outside inside out",
       joined({reversed(cube(0, 5)), reversed(cube(1, 2))}),
       124,
       1,
       2,
       {.turned_faces = 12, .cavities = 1}},
      {"a void beside one inside out",
       joined({cube(0, 5), reversed(cube(1, 2)), reversed(cube(10, 15)), cube(11, 12)}),
       248,
       2,
       4,
       {.turned_faces = 24, .cavities = 2}},
      {"a block in a block",
       joined({cube(0, 5), cube(1, 2)}),
       125,
       1,
       1,
       {.united_overlaps = true}},
      {"blocks that overlap",
       joined({cube(0, 2), cube(1, 3)}),
       15,
       1,
       1,
       {.united_overlaps = true}},
      {"one of them inside out",
       joined({cube(0, 2), reversed(cube(1, 3))}),
       15,
       1,
       1,
       {.turned_faces = 12, .united_overlaps = true}},
      {"one in the other, both inside out, that touch",
       reversed(joined({cube(0, 5), box({0, 1, 1}, {2, 2, 2})})),
       123,
       1,
       1,
       {.turned_faces = 12, .cavities = 1, .united_overlaps = true}},
  };
}

TEST(Repair, mends_what_can_be_mended_and_says_so) {
  for (const Row& row : rows()) {
    SCOPED_TRACE(row.name);
    const Repaired repaired = repair(row.mesh);
    EXPECT_EQ(repaired.solid.exact_volume(), row.volume);
    EXPECT_EQ(repaired.solid.components(), row.components);
    EXPECT_EQ(repaired.solid.shells(), row.shells);
    EXPECT_EQ(repaired.report, row.report)
        << repaired.report.merged_points << ' ' << repaired.report.degenerate_faces << ' '
        << repaired.report.duplicate_faces << ' ' << repaired.report.turned_faces << ' '
        << repaired.report.united_overlaps;
    TriMesh again;
    again.points = repaired.solid.nearest_points();  // small integers, so exact
    again.triangles = repaired.solid.triangles();
    EXPECT_TRUE(check(again).is_solid());
  }
}

// Comparing all pairs of copies, or of faces about one point, took over a minute.
TEST(Repair, takes_no_longer_for_many_copies_or_many_pieces_of_an_edge) {
  const std::vector<TriMesh> copies(5000, cube(0, 2));
  const Repaired once = repair(joined(copies));
  EXPECT_EQ(once.solid.exact_volume(), 8);
  EXPECT_EQ(once.report.duplicate_faces, 12 * 4999U);
  std::vector<TriMesh> both(1501, cube(0, 2));
  for (std::size_t i = 1; i < both.size(); i += 2) {
    both[i] = reversed(both[i]);
  }
  const Repaired either = repair(joined(both));
  EXPECT_EQ(either.solid.exact_volume(), 8);
  EXPECT_EQ(either.report.duplicate_faces, 12 * 1500U);
  const Repaired divided = repair(with_fan(4096));
  EXPECT_EQ(divided.solid.exact_volume(), 1024 * 1024 * 1024);
  EXPECT_EQ(divided.report.degenerate_faces, 4095U);
}

// What is mended is proved as it is; sources and labels are then those of the faces it is from.
TEST(Repair, keeps_sources_and_labels_of_what_needs_no_arrangement) {
  TriMesh mesh =
      unwelded(joined({test::labelled(cube(0, 2), "a"), test::labelled(cube(4, 6), "b")}));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    mesh.labels.push_back(i < 12 ? 0 : 1);
  }
  mesh.names = {"a", "b"};
  mesh.triangles.insert(mesh.triangles.begin(), Triangle{0, 0, 1});
  mesh.labels.insert(mesh.labels.begin(), 1);
  const Solid solid = repair(mesh).solid;
  ASSERT_EQ(solid.triangle_count(), 24U);
  for (std::size_t i = 0; i < solid.triangle_count(); ++i) {
    const Source source = solid.sources()[i];
    const Vec3 place = solid.nearest_points()[solid.triangles()[i][0]];
    EXPECT_EQ(solid.labels()[i], place.x() <= 2 ? 0U : 1U);
    EXPECT_EQ(source.operand, 0U);
    EXPECT_EQ(mesh.labels[source.triangle], solid.labels()[i]);
  }
}

TEST(Repair, keeps_sources_and_labels) {
  TriMesh mesh = joined({test::labelled(cube(0, 2), "a"), test::labelled(cube(1, 3), "b")});
  mesh.triangles.insert(mesh.triangles.begin(), Triangle{0, 0, 1});
  mesh.labels.insert(mesh.labels.begin(), 0);
  const Solid solid = repair(mesh).solid;
  ASSERT_EQ(solid.labels().size(), solid.triangle_count());
  for (std::size_t i = 0; i < solid.triangle_count(); ++i) {
    const Source source = solid.sources()[i];
    EXPECT_EQ(source.operand, 0U);
    EXPECT_EQ(solid.names()[solid.labels()[i]], mesh.names[mesh.labels[source.triangle]]);
  }
}

// A surface that crosses itself along with what it shares: two tetrahedra through each other that
// have one vertex in common.
TEST(Repair, unites_a_surface_that_crosses_itself_and_shares_points) {
  TriMesh mesh = test::tetrahedron({0, 0, 0});
  const TriMesh other = test::moved(test::tetrahedron({0, 0, 0}), Vec3(0.25, 0.25, 0));
  const Repaired repaired = repair(joined({mesh, other}));
  EXPECT_TRUE(repaired.report.united_overlaps);
  EXPECT_EQ(repaired.solid.components(), 1U);
  EXPECT_GT(repaired.solid.exact_volume(), Solid::from(mesh).exact_volume());
}

// It was told by the number of triangles, which may be the same, or grow where nothing overlaps.
TEST(Repair, says_that_overlaps_are_united_where_they_are) {
  TriMesh inside_one = joined({cube(0, 8), cube(4, 12), cube(1, 2)});
  const Repaired overlapping = repair(inside_one);
  ASSERT_EQ(overlapping.solid.triangle_count(), inside_one.triangles.size());
  EXPECT_EQ(overlapping.report, (RepairReport{.united_overlaps = true}));
  // A corner in the middle of the other's edge: it is divided, and no more.
  const TriMesh beside = joined({cube(0, 2), box({2, 2, 1}, {3, 3, 4})});
  const Repaired touching = repair(joined({beside, beside}));
  EXPECT_EQ(touching.report.duplicate_faces, 24U);
  EXPECT_FALSE(touching.report.united_overlaps);
  EXPECT_TRUE(touching.report.parted_contacts);
  EXPECT_EQ(touching.solid.exact_volume(), 11);
}

// All of them in one arrangement took half a minute.
TEST(Repair, unites_many_shells_in_one_place_in_steps) {
  std::mt19937 random(200);
  std::uniform_real_distribution<double> coordinate(-100, 100);
  std::vector<TriMesh> shells;
  std::vector<Solid> solids;
  while (solids.size() < 100) {
    TriMesh shell = test::tetrahedron({0, 0, 0});
    for (Vec3& point : shell.points) {
      point = {coordinate(random), coordinate(random), coordinate(random)};
    }
    const double volume = check(shell).volume;
    if (std::abs(volume) > 1) {
      shells.push_back(test::labelled(volume > 0 ? shell : test::reversed(shell),
                                      std::to_string(solids.size() % 3)));
      solids.push_back(Solid::from(shells.back()));
    }
  }
  const TriMesh mesh = joined(shells);
  const Repaired repaired = repair(mesh);
  EXPECT_TRUE(repaired.report.united_overlaps);
  EXPECT_EQ(repaired.solid.exact_volume(), unite(solids).exact_volume());
  for (std::size_t i = 0; i < repaired.solid.triangle_count(); ++i) {
    const Source source = repaired.solid.sources()[i];
    ASSERT_EQ(source.operand, 0U);
    ASSERT_EQ(repaired.solid.names()[repaired.solid.labels()[i]],
              mesh.names[mesh.labels[source.triangle]]);
  }
}

struct Refusal {
  const char* name;
  TriMesh mesh;
  Errc code;
};

TEST(Repair, refuses_to_guess) {
  TriMesh open = cube(0, 1), wild = cube(0, 1), mislabelled = cube(0, 1), far = cube(0, 1), fin;
  open.triangles.pop_back();
  wild.triangles[0][0] = 99;
  mislabelled.labels = {0};
  far.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  fin = cube(0, 1);
  fin.points.emplace_back(5, 5, 5);
  fin.triangles.push_back({0, 1, 8});
  TriMesh moebius;
  for (int i = 0; i < 5; ++i) {
    moebius.points.emplace_back(std::cos(1.2566 * i), std::sin(1.2566 * i), 0.1 * i * i);
  }
  for (std::uint32_t i = 0; i < 5; ++i) {
    moebius.triangles.push_back({i, (i + 1) % 5, (i + 2) % 5});
  }
  const Refusal refusals[] = {{"a hole", open, Errc::not_closed},
                              {"a fin", fin, Errc::not_closed},
                              {"a bad index", wild, Errc::invalid_argument},
                              {"a bad label", mislabelled, Errc::invalid_argument},
                              {"a point that is none", far, Errc::invalid_argument},
                              {"one side", moebius, Errc::not_oriented}};
  for (const Refusal& row : refusals) {
    SCOPED_TRACE(row.name);
    try {
      (void)repair(row.mesh);
      ADD_FAILURE() << "should have thrown";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), row.code) << error.what();
    }
  }
}

std::string refusal_of(const TriMesh& mesh) {
  try {
    (void)repair(mesh);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Repair, names_what_is_at_an_edge_that_stays_open) {
  TriMesh open = cube(0, 1), one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}};
  open.triangles.pop_back();
  TriMesh turned = open;
  std::swap(turned.triangles[0][1], turned.triangles[0][2]);
  EXPECT_NE(refusal_of(open).find("3 edges are open"), std::string::npos) << refusal_of(open);
  EXPECT_NE(refusal_of(turned).find("3 edges are open"), std::string::npos) << refusal_of(turned);
  EXPECT_NE(refusal_of(one).find(", which only face 0 has;"), std::string::npos);
  EXPECT_NE(refusal_of(with_face(one, {1, 2, 0}))
                .find(", which only faces 0 and 1 have, copies of each other;"),
            std::string::npos)
      << refusal_of(with_face(one, {1, 2, 0}));
  EXPECT_NE(refusal_of(joined({open, open})).find(", copies of each other;"), std::string::npos);
}

// The sliver 0 1 8 closes a front whose corner is beyond the bottom; there is nothing to be turned.
TEST(Repair, says_what_to_do_with_a_sliver_of_which_a_corner_is_beyond_another_face) {
  TriMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                 {0, 1, 0}, {0, 0, 1}, {1, 0, 1},
                 {1, 1, 1}, {0, 1, 1}, {0.5, 0x1p-10, -0x1p-10}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 8}, {0, 8, 5}, {8, 1, 5}, {0, 5, 4},
                    {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7},
                    {4, 5, 6}, {4, 6, 7}, {1, 2, 6}, {1, 2, 6}};
  EXPECT_NE(refusal_of(mesh).find("what 1 faces bound would be lost"), std::string::npos);
  EXPECT_NE(refusal_of(mesh).find("two of its corners have to be put into one place"),
            std::string::npos)
      << refusal_of(mesh);
  mesh.points[8] = mesh.points[0];
  EXPECT_EQ(repair(mesh).solid.volume(), 1);
}

// A wall across a box: its two halves, and the wall, end along the same edges.
TEST(Repair, names_what_would_have_to_go_where_that_would_do) {
  TriMesh walled = test::tetrahedron({0, 0, 0}, 2);
  walled.points.emplace_back(0, 0, -2);
  std::erase_if(walled.triangles, [](const Triangle& t) { return std::ranges::max(t) == 2; });
  for (const Triangle& t : {Triangle{0, 1, 4}, {1, 2, 4}, {2, 0, 4}, {0, 2, 1}}) {
    walled.triangles.push_back(t);
  }
  EXPECT_NE(refusal_of(walled).find("; without face 6 it would be closed;"), std::string::npos)
      << refusal_of(walled);
  const TriMesh apart =
      joined({cube(0, 1), TriMesh{{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{0, 1, 2}}}});
  EXPECT_NE(refusal_of(apart).find("; without face 12 it would be closed;"), std::string::npos)
      << refusal_of(apart);
  EXPECT_NE(refusal_of(joined({cube(0, 1), with_face(apart, {8, 9, 10})}))
                .find("; without faces 24 and 25 it would be closed;"),
            std::string::npos)
      << refusal_of(joined({cube(0, 1), with_face(apart, {8, 9, 10})}));
}

}  // namespace
}  // namespace dupin
