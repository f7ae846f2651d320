#include <gtest/gtest.h>

#include "dupin/blends/cyclide_form.h"
#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "exchange/part_faces.h"

namespace dupin::exchange {
namespace {

std::string example(const std::string& name) {
  return DUPIN_SOURCE_DIR "/examples/" + name + ".json";
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
    const PieceSurface surface = piece_surface(piece, 0.01, count);
    ++(std::holds_alternative<NurbsSurface>(surface) ? nurbs : analytic);
  }
  EXPECT_EQ(nurbs, 1U);  // the blend
  EXPECT_EQ(count.lofted, 1U);
  EXPECT_EQ(count.exact, analytic);
  EXPECT_LE(count.error, 0.01);
  EXPECT_GT(count.error, 0);
}

TEST(PartFaces, cyclides_are_one_surface_on_which_all_their_points_lie) {
  std::size_t seen = 0;
  SurfaceCount count;
  for (const Piece& piece : pieces_of("reducing-elbow")) {
    const PieceSurface made = piece_surface(piece, 0.01, count);
    const auto* surface = std::get_if<NurbsSurface>(&made);
    if (surface == nullptr) {
      continue;
    }
    ++seen;
    const PeArc arc = arc_of(std::get<CyclidePiece>(piece));
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; j <= 40; ++j) {
        EXPECT_NEAR(signed_distance(arc, evaluate(*surface, i / 20., j / 40.)), 0, 1e-12);
      }
      EXPECT_EQ(evaluate(*surface, i / 20., 0), evaluate(*surface, i / 20., 1));
    }
  }
  EXPECT_EQ(seen, 2U);
  EXPECT_EQ(count.lofted, 0U);
}

}  // namespace
}  // namespace dupin::exchange
