#include "dupin/io/streamed_format.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "io/streams/pieces.h"
#include "support/scratch_directory.h"

namespace dupin::test {
namespace {

using MeshStreams = ScratchDirectory;

TEST_F(MeshStreams, are_of_three_formats) {
  EXPECT_EQ(std::ranges::count_if(mesh_formats(), is_streamed), 2);
  EXPECT_TRUE(is_streamed(kPvtu));
  EXPECT_EQ(std::ranges::count(mesh_formats(), kPvtu), 0);
}

TEST_F(MeshStreams, give_the_bytes_of_their_writers) {
  const MeshHeader header{"mm", "a note", "name", {{"a", "#102030"}}};
  for (const MeshFormat& format : {kStlBinary, kPlyBinary}) {
    for (const std::vector<std::string>& names : kCompanies) {
      const Pieces all(names, format.coordinates);
      const auto stream = mesh_stream(path("out"), format);
      for (std::size_t i = 0; i < names.size(); ++i) {
        stream->append(mesh_piece(all.rounded[i], format, "out"), i);
      }
      EXPECT_FALSE(std::filesystem::exists(path("out")));
      stream->commit(header, {});
      EXPECT_TRUE(read_file(path("out")) == mesh_bytes(all.all(), format, header)) << format.key;
      std::filesystem::remove(path("out"));
    }
  }
}

TEST_F(MeshStreams, take_what_the_format_holds_only) {
  const Pieces fine({"a"}, Coordinates::binary64);
  EXPECT_THROW((void)mesh_piece(fine.rounded[0], kStlBinary, "out.stl"), Error);
  EXPECT_NO_THROW((void)mesh_piece(fine.rounded[0], kPlyBinary, "out.ply"));
}

TEST_F(MeshStreams, begin_where_they_can_be_written) {
  for (const MeshFormat& format : {kStlBinary, kPlyBinary, kPvtu}) {
    EXPECT_THROW((void)mesh_stream(path("no/folder"), format), Error) << format.key;
    { const auto left = mesh_stream(path("out"), format); }
    EXPECT_TRUE(std::filesystem::is_empty(directory()));
  }
}

}  // namespace
}  // namespace dupin::test
