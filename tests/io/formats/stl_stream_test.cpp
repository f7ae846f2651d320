#include "dupin/io/stl_stream.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/solid.h"
#include "support/scratch_directory.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using StlStreams = ScratchDirectory;

struct Pieces {
  std::vector<Rounded> rounded;
  std::vector<Boxes> boxes;
};

Pieces pieces(const std::vector<std::string>& names) {
  Pieces result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Vec3 place(10.0 * static_cast<double>(i), .1, .2);
    result.rounded.push_back(
        to_mesh(Solid::from(labelled(tetrahedron(place, 1), names[i])), Coordinates::binary32));
    result.boxes.push_back({{place - Vec3::Ones(), place + Vec3::Constant(2)}});
  }
  return result;
}

TEST_F(StlStreams, gives_the_bytes_of_all_at_once) {
  const MeshHeader header{"mm", "a note"};
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"a", "b", "c"}, {"a"}, {"a", "a"}, {}}) {
    const Pieces all = pieces(names);
    const std::filesystem::path file = path("out.stl");
    StlStream stream(file);
    for (const Rounded& piece : all.rounded) {
      stream.append(stl_facets(piece, "out.stl"));
    }
    EXPECT_EQ(stream.triangles(), 4 * names.size());
    EXPECT_FALSE(std::filesystem::exists(file));
    stream.commit(header);
    EXPECT_EQ(read_file(file), stl_binary_bytes(joined(all.rounded, all.boxes).mesh(), header));
    std::filesystem::remove(file);
  }
}

TEST_F(StlStreams, leaves_nothing_behind_without_commit) {
  {
    StlStream stream(path("out.stl"));
    stream.append(stl_facets(pieces({"a"}).rounded[0], "out.stl"));
    EXPECT_FALSE(std::filesystem::is_empty(directory()));
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory()));
}

}  // namespace
}  // namespace dupin::test
