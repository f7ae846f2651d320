#include "gap_text.h"

#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/shapes.h"

namespace dupin::cli {
namespace {

TEST(GapText, counts_ends_and_tells_those_that_do_not_meet) {
  const Ring end{{0, 0, 0}, {0, 0, 1}, 1, 0};
  Ring start{{0, 0, 0.5}, {0, 0, -1}, 1.25, 0};
  const Ring alone{{9, 9, 9}, {0, 0, 1}, 1, 0};
  GapSummary summary{"a.json",
                     Unit::inch,
                     1,
                     {{"a.end", end, "a"}, {"b.start", start, "b"}, {"c.end", alone, "c"}},
                     {}};
  summary.pairs = pair_ends(summary.ports, summary.connect);
  std::ostringstream out;
  print_gaps(out, summary);
  EXPECT_EQ(out.str(),
            "welded               0\nopen                 1\ngaps                 1\n"
            "  gap: a.end to b.start: axial 0.5 in, radius 0.25 in\n");
}

TEST(GapText, of_one_mesh_lists_its_boundary_alone) {
  TriMesh open = test::box({0, 0, 0}, {1, 1, 1});
  open.triangles.erase(open.triangles.begin());
  std::ostringstream out;
  print_mesh_gaps(out, {"a.off", "", 0, measure_gaps(open, {})});
  EXPECT_THAT(out.str(), testing::StartsWith(
                             "boundary loops       1\n  boundary of a.off: 3 points, length 3.4"));
  EXPECT_EQ(out.str().find("union"), std::string::npos);
}

TEST(GapText, of_two_meshes_tells_slits_and_pieces) {
  std::ostringstream out;
  print_mesh_gaps(out, {"a", "b", 0.5,
                        measure_gaps(test::box({0, 0, 0}, {1, 1, 1}),
                                     test::box({1.25, 0, 0}, {2, 1, 1}), {.connect = 0.5})});
  EXPECT_NE(out.str().find("slits                1\n"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find(" of faces, 0.25 to 0.25 apart, at ("), std::string::npos);
  EXPECT_NE(out.str().find("touching             no\nunion                2 components\n"
                           "  apart: a and b do not touch\n"),
            std::string::npos);
}

TEST(GapText, of_two_meshes_tells_that_they_are_apart) {
  const auto text = [](const TriMesh& a, const TriMesh& b) {
    std::ostringstream out;
    print_mesh_gaps(out, {"a.off", "b.off", 0.5, measure_gaps(a, b, {.connect = 0.5})});
    return out.str();
  };
  const TriMesh box = test::box({0, 0, 0}, {1, 1, 1});
  const TriMesh beside = test::box({1, 0, 0}, {2, 1, 1}), far = test::box({9, 0, 0}, {10, 1, 1});
  const std::string nowhere = ", and no faces look at each other from within 0.5; see --connect\n";
  EXPECT_THAT(text(box, far),
              testing::HasSubstr("  apart: a.off and b.off do not touch" + nowhere));
  EXPECT_THAT(
      text(box, test::joined({beside, far})),
      testing::HasSubstr("  apart: a.off and b.off touch, but are not one piece" + nowhere));
  EXPECT_THAT(text(box, beside), testing::Not(testing::HasSubstr("apart")));
}

}  // namespace
}  // namespace dupin::cli
