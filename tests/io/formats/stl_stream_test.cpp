#include "dupin/io/stl_stream.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/stl.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/solid.h"
#include "support/process.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

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

TEST(StlStream, gives_the_bytes_of_all_at_once) {
  const TemporaryFolder folder;
  const MeshHeader header{"mm", "a note"};
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"a", "b", "c"}, {"a"}, {"a", "a"}, {}}) {
    const Pieces all = pieces(names);
    const std::filesystem::path path = folder.path() / "out.stl";
    StlStream stream(path);
    for (const Rounded& piece : all.rounded) {
      stream.append(piece);
    }
    EXPECT_EQ(stream.triangles(), 4 * names.size());
    EXPECT_FALSE(std::filesystem::exists(path));
    stream.commit(header);
    EXPECT_EQ(read_file(path), stl_binary_bytes(joined(all.rounded, all.boxes).mesh(), header));
    std::filesystem::remove(path);
  }
}

TEST(StlStream, leaves_nothing_behind_without_commit) {
  const TemporaryFolder folder;
  {
    StlStream stream(folder.path() / "out.stl");
    stream.append(pieces({"a"}).rounded[0]);
    EXPECT_FALSE(std::filesystem::is_empty(folder.path()));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace dupin::test
