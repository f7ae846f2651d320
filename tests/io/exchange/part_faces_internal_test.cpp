#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "exchange/part_faces.h"
#include "support/source_folder.h"

namespace dupin::exchange {
namespace {

std::string example(const std::string& name) {
  return test::source_folder() / "examples" / (name + ".json");
}

std::vector<Piece> pieces_of(const std::string& name) {
  std::vector<Piece> result;
  for (const ResolvedPart& part : resolve(read_assembly(example(name))).parts) {
    if (const auto* chain = std::get_if<Chain>(&part.shape)) {
      result.insert(result.end(), chain->pieces.begin(), chain->pieces.end());
    }
  }
  return result;
}

TEST(PartFaces, pipes_cones_and_elbows_are_analytic) {
  std::size_t analytic = 0, nurbs = 0;
  SurfaceCount count;
  for (const Piece& piece : pieces_of("plant-run")) {
    const auto surfaces = piece_surfaces(piece, 0.01, count);
    ASSERT_EQ(surfaces.size(), 1U);
    const PieceSurface& surface = surfaces.front();
    ++(std::holds_alternative<NurbsSurface>(surface) ? nurbs : analytic);
  }
  EXPECT_EQ(nurbs, 1U);  // the blend
  EXPECT_EQ(count.lofted, 1U);
  EXPECT_EQ(count.exact, analytic);
  EXPECT_LE(count.error, 0.01);
  EXPECT_GT(count.error, 0);
}

TEST(PartFaces, cyclides_are_surfaces_on_which_all_their_points_lie) {
  std::size_t seen = 0;
  SurfaceCount count;
  for (const char* name : {"reducing-elbow", "crane-hook"}) {
    for (const Piece& piece : pieces_of(name)) {
      const auto* cyclide = std::get_if<CyclidePiece>(&piece);
      for (const PieceSurface& made : piece_surfaces(piece, 0.01, count)) {
        const auto* surface = std::get_if<NurbsSurface>(&made);
        if (surface == nullptr || cyclide == nullptr) {
          continue;
        }
        ++seen;
        const PeArc arc = arc_of(*cyclide);
        const RingCurve circle = end_circle(*surface);
        for (int j = 0; j <= 20; ++j) {
          for (int i = 0; i <= 10; ++i) {
            EXPECT_NEAR(signed_distance(arc, evaluate(*surface, i / 10., j / 20.)), 0, 1e-11);
          }
          const Vec3 at = evaluate(*surface, 1, j / 20.) - circle.center;
          EXPECT_NEAR(at.norm(), circle.first, 1e-11);
          EXPECT_NEAR(at.dot(circle.normal), 0, 1e-11);
        }
      }
    }
  }
  EXPECT_GE(seen, 7U);
  EXPECT_EQ(count.lofted, 0U);
}

}  // namespace
}  // namespace dupin::exchange
