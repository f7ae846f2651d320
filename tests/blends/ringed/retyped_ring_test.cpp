#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/cyclic_blend.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/gap.h"
#include "dupin/kernel/mesh_gap.h"
#include "dupin/kernel/solid.h"
#include "support/paper_surfaces.h"

namespace dupin {
namespace {

constexpr RingSampling kSampling{32};

/// The surface with both end discs, identical points merged.
TriMesh closed(const RingedSurface& surface) {
  TriMesh mesh;
  std::map<std::tuple<double, double, double>, std::uint32_t> index;
  for (const TriMesh& part :
       {tessellate(surface, kSampling).mesh, end_cap_mesh(surface.start, kSampling),
        end_cap_mesh(surface.end, kSampling)}) {
    for (Triangle t : part.triangles) {
      for (std::uint32_t& corner : t) {
        const Vec3& p = part.points[corner];
        const auto [place, added] =
            index.try_emplace({p.x(), p.y(), p.z()}, static_cast<std::uint32_t>(index.size()));
        if (added) {
          mesh.points.push_back(p);
        }
        corner = place->second;
      }
      mesh.triangles.push_back(t);
    }
  }
  return mesh;
}

RingedSurface pipe(const Ring& start, double length) {
  const Vec3 to = start.center - length * start.normal;
  Ring end = flipped(start);
  end.center = to;
  return {start, end, LineSpine{start.center, to}, ConstantRadius{start.radius}};
}

struct Row {
  const char* name;
  Ring typed;  // what the blend's author made of the outlet's start
  GapVerdict verdict;
  std::size_t components;
  bool slit;
};

TEST(RetypedRing, leaves_two_pieces_or_a_slit_and_is_reported) {
  const Vec3 axis = test::skew_axis();
  const Ring inlet{Vec3(0, 0, 0), Vec3(1, 0, 0), 1};
  const Ring outlet{Vec3(10, 4, 0) + axis, -axis, 2};
  const auto typed = [&](const Vec3& center, const Vec3& direction, double radius) {
    return Ring{center, -direction.normalized(), radius};
  };
  const Vec3 rounded_axis(0.0976, 0.1952, 0.9759);
  const std::vector<Row> rows = {
      {"the stored ring", outlet, GapVerdict::welded, 1, false},
      {"centre cut to two digits", typed({10.09, 4.19, 0.97}, axis, 2), GapVerdict::gap, 2, true},
      {"centre rounded to two digits", typed({10.10, 4.20, 0.98}, axis, 2), GapVerdict::overlap, 1,
       false},
      {"direction rounded to four digits", typed(outlet.center, rounded_axis, 2), GapVerdict::kink,
       1, true},
      // Points of oblique rings are rounded, so their discs lie in one plane to some ulps only:
      // that much of a slit there really is between discs that do not share their points.
      {"radius mistaken by a hundredth", typed(outlet.center, axis, 2.01), GapVerdict::step, 1,
       true},
  };
  const TriMesh after = closed(pipe(outlet, 5));
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    const RingedSurface blend = cyclic_blend(inlet, row.typed, {.k = 10, .l = 20});
    const TriMesh before = closed(blend);
    const GapReport ends = measure_gap(blend.end, outlet);
    EXPECT_EQ(name(ends.verdict), name(row.verdict));
    const MeshGapReport meshes = measure_gaps(before, after, {.connect = 0.05});
    EXPECT_EQ(meshes.components, row.components);
    EXPECT_EQ(meshes.slit(), row.slit);
    const std::vector<Solid> solids = {Solid::from(before), Solid::from(after)};
    EXPECT_EQ(unite(solids).components(), row.components);
    if (row.verdict == GapVerdict::gap) {
      ASSERT_EQ(meshes.facing.size(), 1U);
      // Both discs are parallel planes but for the rounding of their points, some ulps of 10.
      EXPECT_NEAR(meshes.facing[0].least.lower, ends.axial.lower, 1e-13);
      EXPECT_NEAR(meshes.facing[0].greatest.upper, ends.axial.upper, 1e-13);
    }
  }
}

}  // namespace
}  // namespace dupin
