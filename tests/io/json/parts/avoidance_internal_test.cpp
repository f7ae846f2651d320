#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "io/json/facing_pipes.h"
#include "support/scratch_directory.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using test::chain;
using test::facing_pipes_and;
using test::refusal;
using testing::HasSubstr;

using AvoidanceOfFiles = test::ScratchDirectory;

TEST_F(AvoidanceOfFiles, meshes_are_found_beside_the_document) {
  const auto place = path("plant.json");
  write_mesh(path("crate.off"), test::box({-3, -4, -4}, {3, 4, 4}));
  const std::string spline =
      R"("spline": {"from": "a.end", "to": "b.start", "avoid": [{"mesh": "crate.off"}], "clearance": 2})";
  const Assembly assembly = parse_assembly(facing_pipes_and(spline), place.string());
  const auto& avoid = *std::get<SplineBetween>(assembly.parts[2].shape).avoid;
  const auto& mesh = std::get<MeshObstacle>(avoid.obstacles[0]);
  EXPECT_EQ(mesh.file, "crate.off");
  EXPECT_EQ(mesh.mesh->triangles.size(), 12);
  EXPECT_GT(chain(resolve(assembly)).pieces.size(), 1);
  EXPECT_THAT(document_text(assembly), HasSubstr(R"({"mesh":"crate.off"})"));
  EXPECT_THAT(refusal(facing_pipes_and(spline), path("sub/d.json").string()),
              HasSubstr("crate.off"));
  write_mesh(path("crate.off"), test::box({-50, -50, -50}, {50, 50, 50}));
  EXPECT_THAT(
      refusal(facing_pipes_and(spline), place.string()),
      HasSubstr("'crate.off' is a closed surface that goes round (-20, 0, 0), where the way "
                "begins"));
  write_mesh(path("crate.off"), test::box({10, -50, -50}, {50, 50, 50}));
  EXPECT_THAT(refusal(facing_pipes_and(spline), place.string()),
              HasSubstr("goes round (20, 0, 0), where the way ends"));
  write_mesh(path("crate.off"), test::box({-3, -4, -4}, {3, 4, 4}), kOff, {.unit = "m"});
  EXPECT_THAT(refusal(facing_pipes_and(spline), place.string()),
              HasSubstr("plant.json#/parts/2/spline/avoid/0/mesh: 'crate.off' is in m, but the "
                        "document in mm; convert it first, with --to-unit"));
  write_mesh(path("crate.off"), test::box({-3, -4, -4}, {3, 4, 4}), kOff, {.unit = "mm"});
  EXPECT_GT(chain(resolve(parse_assembly(facing_pipes_and(spline), place.string()))).pieces.size(),
            1);
  write_mesh(path("crate.off"), {});
  EXPECT_THAT(
      refusal(facing_pipes_and(spline), place.string()),
      HasSubstr("plant.json#/parts/2/spline/avoid/0/mesh: 'c': 'crate.off' has no triangles"));
}

}  // namespace
}  // namespace dupin
