#include <BRep_Tool.hxx>
#include <gtest/gtest.h>

#include "io/occt/body_shapes_internal.h"
#include "occt/nurbs_geometry.h"
#include "occt/tube_surface.h"

namespace dupin::occt {
namespace {

TEST(TubeSurface, passes_through_both_rings) {
  const exchange::Body body = bent_pipe();
  for (const exchange::TubeFace& tube : body.tubes) {
    const exchange::RingCurve &start = body.rings[tube.start], &end = body.rings[tube.end];
    const TubeSurface made = tube_surface(tube, start, end, 0.7);
    for (int i = 0; i < 16; ++i) {
      const double around = made.seam + (made.seam_again - made.seam) * i / 16;
      EXPECT_NEAR((vec(made.at(around, made.start)) - start.center).norm(), start.first, 1e-12);
      EXPECT_NEAR((vec(made.at(around, made.end)) - end.center).norm(), end.first, 1e-12);
    }
    EXPECT_EQ(has_free_seam(tube), !std::holds_alternative<exchange::TorusArc>(tube.surface));
    if (has_free_seam(tube)) {
      EXPECT_NEAR(angle_on(start, vec(made.at(made.seam, made.start))), 0.7, 1e-12);
    }
  }
}

TEST(TubeSurface, faces_have_rings_and_seam) {
  const exchange::Body body = bent_pipe();
  const exchange::TubeFace& tube = body.tubes.front();
  RingEdges start(body.rings[0]), end(body.rings[1]);
  const TubeSurface made = tube_surface(tube, body.rings[0], body.rings[1], 0);
  start.add_seam(angle_on(start.ring(), vec(made.at(made.seam, made.start))));
  end.add_seam(angle_on(end.ring(), vec(made.at(made.seam, made.end))));
  end.add_seam(2.5);  // a neighbour's
  start.make();
  end.make();
  const TopoDS_Face face = tube_face(tube, made, start, end);
  EXPECT_TRUE(is_valid(face));
  GProp_GProps area;
  BRepGProp::SurfaceProperties(face, area);
  EXPECT_NEAR(area.Mass(), 10 * std::numbers::pi, 1e-9);
}

}  // namespace
}  // namespace dupin::occt
