#include <gtest/gtest.h>

#include "io/streams/pieces.h"
#include "streams/spilled_meshes.h"

namespace dupin::streams {
namespace {

TEST(SpilledMeshes, give_back_what_they_were_given_with_the_labels_of_the_whole) {
  for (const std::vector<std::string>& names : test::kCompanies) {
    const test::Pieces all(names, Coordinates::binary64);
    SpilledMeshes spilled;
    for (const Rounded& piece : all.rounded) {
      spilled.append(spilled_piece(piece.mesh()));
    }
    spilled.number_labels();
    const TriMesh whole = all.all();
    EXPECT_EQ(spilled.names(), whole.names);
    EXPECT_EQ(spilled.have_labels(), !whole.labels.empty());
    EXPECT_EQ(spilled.points(), whole.points.size());
    EXPECT_EQ(spilled.triangles(), whole.triangles.size());
    std::size_t face = 0;
    for (std::size_t i = 0; i < spilled.size(); ++i) {
      const TriMesh mesh = spilled.mesh(i);
      EXPECT_EQ(mesh.points, all.rounded[i].mesh().points);
      EXPECT_EQ(mesh.triangles, all.rounded[i].mesh().triangles);
      for (const std::uint32_t label : mesh.labels) {
        EXPECT_EQ(mesh.names[label], whole.names[whole.labels[face]]);
        EXPECT_EQ(spilled.numbers(i)[label], whole.labels[face++]);
      }
    }
    EXPECT_EQ(face, whole.labels.size());
  }
}

}  // namespace
}  // namespace dupin::streams
