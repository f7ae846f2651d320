#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "shading/section_family.h"
#include "support/fillet_loops.h"
#include "support/source_folder.h"

namespace dupin::shading {
namespace {

// The point of a section at an angle, from a direction that changes little along the family.
Vec3 direction_at(const Section& section, const Vec3& start, double angle) {
  const Vec3 first = (start - start.dot(section.normal) * section.normal).normalized();
  return std::cos(angle) * first + std::sin(angle) * section.normal.cross(first);
}

Vec3 point_at(const SectionFamily& family, const Vec3& start, double t, double angle) {
  const Section section = family.section(t);
  const Vec3 direction = direction_at(section, start, angle);
  return section.center + section.radius(direction) * direction;
}

// Normals by the differences of points, which know nothing of closed forms.
void expect_normals_fit(const SectionFamily& family, double bound, const std::string& what) {
  constexpr double kStep = 1e-6;
  for (int i = 1; i < 12; ++i) {
    const double t = i / 12.;
    const Section section = family.section(t);
    EXPECT_NEAR(section.normal.norm(), 1, 1e-12) << what;
    const Vec3 start = section.normal.unitOrthogonal();
    for (int j = 0; j < 12; ++j) {
      const double angle = 0.1 + j * 0.5;
      const Vec3 along = point_at(family, start, t + kStep, angle) -
                         point_at(family, start, t - kStep, angle),
                 around = point_at(family, start, t, angle + kStep) -
                          point_at(family, start, t, angle - kStep);
      const Vec3 normal = family.normal(t, direction_at(section, start, angle));
      EXPECT_NEAR(normal.norm(), 1, 1e-12) << what;
      const Vec3 across = along.cross(around).normalized();
      EXPECT_LT(across.cross(normal).norm(), bound) << what << " " << t << " " << angle;
    }
  }
}

TEST(SectionFamily, has_the_normals_of_its_points) {
  for (const char* name : {"reducer", "skew-pipes", "oblique-nozzle", "oval-duct", "u-bend-cyclide",
                           "cone-to-pipe", "jet-engine", "crane-hook"}) {
    const ResolvedAssembly resolved =
        resolve(read_assembly(test::source_folder() / "examples" / (std::string(name) + ".json")));
    for (const ResolvedPart& part : resolved.parts) {
      for (const Piece& piece : std::get<Chain>(part.shape).pieces) {
        expect_normals_fit(section_family(piece), 1e-7, std::string(name) + " " + part.name);
      }
    }
  }
}

TEST(SectionFamily, begins_and_ends_in_the_stored_rings) {
  for (const char* name : {"skew-pipes", "oval-duct", "u-bend-cyclide", "oblique-nozzle"}) {
    const ResolvedAssembly resolved =
        resolve(read_assembly(test::source_folder() / "examples" / (std::string(name) + ".json")));
    for (const ResolvedPart& part : resolved.parts) {
      for (const Piece& piece : std::get<Chain>(part.shape).pieces) {
        const SectionFamily family = section_family(piece);
        for (const End end : {End::start, End::end}) {
          const Ring& ring = end_ring(piece, end);
          const Section section = family.section(end == End::start ? 0 : 1);
          EXPECT_LT((section.center - ring.center).norm(), 1e-9) << part.name;
          EXPECT_GT((end == End::start ? -1 : 1) * section.normal.dot(ring.normal), 1 - 1e-9);
          const Vec3 axis = reference_axis(ring);
          EXPECT_NEAR(section.radius(axis), ring.radius, 1e-9) << part.name;
          EXPECT_NEAR(section.radius(ring.normal.cross(axis)), across(ring), 1e-9) << part.name;
        }
      }
    }
  }
}

TEST(SectionFamily, of_fillets_is_tangent_to_both_quadrics_along_the_feet) {
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    const std::vector<SectionFamily> families = section_families(loop);
    const std::vector<double> ends = corners(loop);
    ASSERT_EQ(families.size(), std::max(std::size_t(1), ends.size())) << name;
    for (int i = 0; i < 20; ++i) {
      const double angle = std::numbers::pi * (2 * (i + 0.5) / 20 - 1);
      const MovingBall moving = ball(loop, angle);
      const ContactArc arc = contact_arc(loop.quadrics, moving);
      // Between which corners it is.
      const auto stretch = std::size_t(
          std::count_if(ends.begin(), ends.end(), [&](double end) { return end < angle; }));
      const std::size_t at = (stretch + families.size() - 1) % families.size();
      const double from = ends.empty() ? -std::numbers::pi : ends.at(at),
                   to = ends.size() < 2 ? from + 2 * std::numbers::pi
                                        : ends.at((at + 1) % ends.size());
      const double turn = 2 * std::numbers::pi;
      const double t = (angle < from ? angle + turn - from : angle - from) /
                       (to > from ? to - from : to + turn - from);
      const Section section = families[at].section(t);
      for (std::size_t side = 0; side < 2; ++side) {
        const Vec3 direction = (arc.feet.at(side) - section.center).normalized();
        EXPECT_LT(std::abs(direction.dot(section.normal)), 1e-8) << name;
        EXPECT_LT((arc.feet.at(side) - section.center - section.along * direction).norm(), 1e-8);
        // Of the ball outwards, into the quadric.
        EXPECT_LT((families[at].normal(t, direction) + arc.normals.at(side)).norm(), 1e-7) << name;
      }
    }
  }
}

}  // namespace
}  // namespace dupin::shading
