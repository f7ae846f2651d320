#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/vtu.h"
#include "dupin/kernel/error.h"
#include "io/streams/pieces.h"
#include "streams/pvtu_stream.h"
#include "support/scratch_directory.h"

namespace dupin::streams {
namespace {

using testing::HasSubstr;
using testing::Not;

class PvtuStreams : public test::ScratchDirectory {
 public:
  /// Pieces of these names, in files of these numbers.
  void write(const std::vector<std::string>& names, const std::vector<std::size_t>& files,
             const MeshHeader& header = {}) {
    const test::Pieces all(names, Coordinates::binary64);
    PvtuStream stream(path("plant.pvtu"));
    for (std::size_t i = 0; i < names.size(); ++i) {
      stream.append(mesh_piece(all.rounded[i], kPvtu, "plant.pvtu"), files[i]);
    }
    stream.commit(header, {});
  }
  [[nodiscard]] std::string bytes(const std::string& name) const { return read_file(path(name)); }
  [[nodiscard]] std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(directory()),
                                                  std::filesystem::directory_iterator()));
  }
};

TEST_F(PvtuStreams, list_their_files_which_number_labels_alike) {
  write({"a", "b.end", "a", ""}, {7, 2, 2, 4}, {"mm", {}, {}, {{"a", "#102030"}}});
  EXPECT_EQ(file_count(), 4);
  const std::string index = bytes("plant.pvtu");
  EXPECT_THAT(index, HasSubstr("<Piece Source=\"plant_0.vtu\"/>\n<Piece Source=\"plant_1.vtu\"/>\n"
                               "<Piece Source=\"plant_2.vtu\"/>\n</PUnstructuredGrid>"));
  for (const std::string array : {"Name=\"label\"", "Name=\"part\"", "Name=\"colour\""}) {
    EXPECT_THAT(index, HasSubstr(array));
    EXPECT_THAT(bytes("plant_1.vtu"), HasSubstr(array));
  }
  const VolumeMesh first = read_vtu(bytes("plant_0.vtu"), "plant_0.vtu");
  EXPECT_EQ(first.surface.triangles.size(), 12 + 4);
  EXPECT_EQ(first.surface.triangles[12][0] >= 8, true) << "behind the points of the box";
  EXPECT_TRUE(first.tetrahedra.empty());
  const test::Pieces all({"a", "b.end", "a", ""}, Coordinates::binary64);
  const TriMesh whole = all.all();
  TriMesh last = all.rounded[0].mesh();
  last.names = whole.names;
  EXPECT_EQ(bytes("plant_2.vtu"), vtu_text({.surface = last}, {"mm", {}, {}, {{"a", "#102030"}}}));
}

TEST_F(PvtuStreams, have_points_of_two_pieces_once_in_each_file) {
  for (const std::size_t second : {0, 1}) {
    PvtuStream stream(path("plant.pvtu"));
    const std::vector<std::string> names{"end"};
    stream.append(
        open_piece(test::bar(0, 1, "a", false), std::vector<std::uint32_t>{10, 11}, names), 0);
    stream.append(open_piece(test::bar(1, 3, "b", true), std::vector<std::uint32_t>{8, 9}, names),
                  second);
    stream.commit({}, {});
    std::size_t points = 0, triangles = 0;
    for (std::size_t i = 0; i <= second; ++i) {
      const std::string name = "plant_" + std::to_string(i) + ".vtu";
      const VolumeMesh read = read_vtu(bytes(name), name);
      points += read.surface.points.size();
      triangles += read.surface.triangles.size();
    }
    EXPECT_EQ(points, second == 0 ? 12 : 16);
    EXPECT_EQ(triangles, 20);
    if (second == 0) {
      EXPECT_EQ(bytes("plant_0.vtu"), vtu_text({.surface = test::two_bars()}, {}));
    }
  }
}

TEST_F(PvtuStreams, have_a_file_even_of_nothing) {
  write({}, {});
  EXPECT_EQ(file_count(), 2);
  EXPECT_THAT(bytes("plant.pvtu"), HasSubstr("plant_0.vtu"));
  EXPECT_THAT(bytes("plant.pvtu"), Not(HasSubstr("CellData")));
}

TEST_F(PvtuStreams, leave_none_where_one_cannot_take_its_place) {
  std::filesystem::create_directory(path("plant_1.vtu"));
  EXPECT_THROW(write({"a", "b", "c"}, {0, 1, 2}), Error);
  EXPECT_EQ(file_count(), 1);
}

}  // namespace
}  // namespace dupin::streams
