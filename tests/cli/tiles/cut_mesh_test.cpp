#include "tiles/cut_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/solid.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using cli::between_planes;
using cli::PlaneCut;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TriMesh mesh_of(const Solid& solid) {
  return {solid.nearest_points(), solid.triangles(), solid.labels(), solid.names()};
}

using Corner = std::tuple<double, double, double>;
using Corners = std::array<Corner, 3>;

// Of this label, from their least corners on; or the same turned.
std::set<Corners> ends_of(const TriMesh& mesh, const std::string& name, bool are_turned) {
  std::set<Corners> result;
  for (std::size_t face = 0; face < mesh.triangles.size(); ++face) {
    if (mesh.names[mesh.labels[face]] == name) {
      Corners corners;
      std::ranges::transform(mesh.triangles[face], corners.begin(), [&](std::uint32_t corner) {
        const Vec3& p = mesh.points[corner];
        return Corner(p.x(), p.y(), p.z());
      });
      if (are_turned) {
        std::swap(corners[1], corners[2]);
      }
      std::ranges::rotate(corners, std::ranges::min_element(corners));
      EXPECT_TRUE(result.insert(corners).second);
    }
  }
  return result;
}

// A pipe with a bore, along an axis.
TriMesh hollow(int axis, std::uint32_t segments) {
  TriMesh mesh = joined({tube(2, 0, 30, segments), reversed(tube(1, 10, 20, segments))});
  for (Vec3& point : mesh.points) {
    point = axis == 0   ? Vec3(point.z(), point.x(), point.y())
            : axis == 1 ? Vec3(point.y(), point.z(), point.x())
                        : point;
  }
  return mesh;
}

TEST(CutMesh, gives_solids_that_end_in_the_same_triangles) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const std::uint32_t segments : {3U, 8U, 25U}) {
      const TriMesh whole = hollow(axis, segments);
      const std::vector<double> places{5.1, 10.7, 13.3, 19.9, 21.1};
      double volume = 0;
      std::set<Corners> before;
      for (std::size_t i = 0; i <= places.size(); ++i) {
        const auto cut = [&](std::size_t k) {
          return PlaneCut{places[k], "cut " + std::to_string(k)};
        };
        const std::optional<PlaneCut> from = i > 0 ? std::optional(cut(i - 1)) : std::nullopt,
                                      to = i < places.size() ? std::optional(cut(i)) : std::nullopt;
        const TriMesh stretch = between_planes(whole, axis, from, to);
        const Solid solid = Solid::from(stretch);
        volume += solid.volume();
        for (const Vec3& point : stretch.points) {
          EXPECT_GE(point[axis], from ? from->place : -kInfinity);
          EXPECT_LE(point[axis], to ? to->place : kInfinity);
        }
        if (from) {
          EXPECT_EQ(ends_of(stretch, from->name, true), before);
          EXPECT_GE(before.size(), segments - 2);
        }
        before = to ? ends_of(stretch, to->name, false) : std::set<Corners>();
      }
      EXPECT_NEAR(volume, Solid::from(whole).volume(), 1e-12 * volume);
    }
  }
}

// All its long edges run through both planes.
TEST(CutMesh, keeps_what_is_between_planes_through_the_same_edges) {
  const TriMesh whole = tube(1, 0, 100, 12);
  const Solid cut = Solid::from(between_planes(whole, 2, PlaneCut{40, "a"}, PlaneCut{60, "b"}));
  EXPECT_NEAR(cut.volume(), Solid::from(whole).volume() / 5, 1e-12);
  EXPECT_EQ(cut.names(), (std::vector<std::string>{"", "a", "b"}));
  EXPECT_EQ(cut.shells(), 1);
}

TEST(CutMesh, keeps_labels) {
  const TriMesh cut = between_planes(labelled(tube(1, 0, 9, 12), "pipe"), 2, PlaneCut{4, "a"}, {});
  EXPECT_EQ(cut.names, (std::vector<std::string>{"pipe", "a"}));
  const TriMesh whole = labelled(tube(1, 0, 9, 12), "pipe");
  EXPECT_EQ(between_planes(whole, 2, {}, {}).triangles, whole.triangles);
}

// Of many pieces that a union is in one plane.
TEST(CutMesh, closes_any_number_of_polygons) {
  std::vector<Solid> solids;
  for (int i = 0; i < 7; ++i) {
    solids.push_back(Solid::from(moved(hollow(0, 9), Vec3(.5 * i, 1.7 * (i % 4), .3 * i))));
  }
  const TriMesh whole = mesh_of(unite(solids));
  for (const double place : {11.03, 14.99, 18.01}) {
    const Solid before = Solid::from(between_planes(whole, 0, {}, PlaneCut{place, "c"})),
                behind = Solid::from(between_planes(whole, 0, PlaneCut{place, "c"}, {}));
    EXPECT_NEAR(before.volume() + behind.volume(), Solid::from(whole).volume(), 1e-9);
    EXPECT_EQ(ends_of(mesh_of(before), "c", false), ends_of(mesh_of(behind), "c", true));
  }
}

TEST(CutMesh, refuses_what_it_cannot_cut) {
  EXPECT_THROW((void)between_planes(tube(1, 0, 9, 12), 2, PlaneCut{9, "a"}, {}), Error);
  TriMesh open = tube(1, 0, 9, 12);
  open.triangles.pop_back();
  EXPECT_EQ(between_planes(open, 2, PlaneCut{20, "a"}, {}).triangles.size(), 0);
  TriMesh gap = tube(1, 0, 9, 12);
  gap.triangles.erase(gap.triangles.begin());
  EXPECT_THROW((void)between_planes(gap, 2, PlaneCut{4, "a"}, {}), Error);
}

}  // namespace
}  // namespace dupin::test
