#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/ply.h"
#include "io/streams/pieces.h"
#include "streams/ply_stream.h"
#include "support/scratch_directory.h"

namespace dupin::streams {
namespace {

using PlyStreams = test::ScratchDirectory;

/// Each triangle's own, and for all of one point the same where it is even: some points are copied.
CornerNormals normals_of(const TriMesh& mesh) {
  CornerNormals normals;
  for (const Triangle& triangle : mesh.triangles) {
    auto& corners = normals.emplace_back();
    const Vec3 a = mesh.points[triangle[0]], b = mesh.points[triangle[1]],
               c = mesh.points[triangle[2]];
    const Vec3 own = (b - a).cross(c - a).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 normal = triangle[k] % 2 == 0 ? Vec3::UnitX() : own;
      corners[k] = {float(normal.x()), float(normal.y()), float(normal.z())};
    }
  }
  return normals;
}

CornerNormals same_for_all(const TriMesh& mesh) {
  const Direction up{0, 0, 1};
  return CornerNormals(mesh.triangles.size(), {up, up, up});
}

TEST_F(PlyStreams, have_the_normals_and_copies_of_all_at_once) {
  for (const auto& normals : {normals_of, same_for_all}) {
    for (const std::vector<std::string>& names : test::kCompanies) {
      const test::Pieces all(names, Coordinates::binary64);
      PlyStream stream(path("out.ply"));
      MeshHeader header{"mm", "a note", {}, {{"a", "#102030"}}};
      for (const Rounded& piece : all.rounded) {
        stream.append(mesh_piece(piece, kPlyBinary, "out.ply"), 0);
      }
      stream.commit(header, normals);
      header.normals.clear();
      for (const Rounded& piece : all.rounded) {  // points of pieces are numbered by themselves
        const CornerNormals own = normals(piece.mesh());
        header.normals.insert(header.normals.end(), own.begin(), own.end());
      }
      EXPECT_TRUE(read_file(path("out.ply")) == ply_binary_bytes(all.all(), header));
      if (!names.empty()) {
        EXPECT_EQ(read_ply(read_file(path("out.ply")), "out.ply").points, all.all().points);
      }
    }
  }
}

// The second of two bars that share a ring has the points of the first one there.
TEST_F(PlyStreams, have_points_of_two_pieces_once) {
  const TriMesh one = test::bar(0, 1, "a", false), other = test::bar(1, 3, "b", true);
  const auto written = [&](const MeshStream::Normals& normals) {
    PlyStream stream(path("out.ply"));
    const std::vector<std::string> names{"end"};
    stream.append(open_piece(one, std::vector<std::uint32_t>{10, 11}, names), 0);
    stream.append(open_piece(other, std::vector<std::uint32_t>{8, 9}, names), 0);
    stream.commit({}, normals);
    return read_file(path("out.ply"));
  };
  const TriMesh whole = test::two_bars();
  EXPECT_TRUE(written({}) == ply_binary_bytes(whole, {}));
  MeshHeader header;
  header.normals = same_for_all(whole);
  EXPECT_TRUE(written(same_for_all) == ply_binary_bytes(whole, header));
  const TriMesh read = read_ply(written(normals_of), "out.ply");
  EXPECT_EQ(read.points, whole.points) << "copies are told from points";
  EXPECT_EQ(read.triangles, whole.triangles);
}

// What the triangles of both pieces say together, as of a point where both are tangent.
TEST_F(PlyStreams, have_normals_at_rings_that_both_pieces_see) {
  const auto of_corners = [](const TriMesh& mesh) {  // how many triangles are at each
    std::vector<float> count(mesh.points.size(), 0);
    for (const Triangle& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        ++count[corner];
      }
    }
    CornerNormals normals;
    for (const auto& [a, b, c] : mesh.triangles) {
      normals.push_back({Direction{count[a], 0, 1}, {count[b], 0, 1}, {count[c], 0, 1}});
    }
    return normals;
  };
  PlyStream stream(path("out.ply"));
  const std::vector<std::string> names{"end"};
  stream.append(open_piece(test::bar(0, 1, "a", false), std::vector<std::uint32_t>{10, 11}, names),
                0);
  stream.append(open_piece(test::bar(1, 3, "b", true), std::vector<std::uint32_t>{8, 9}, names), 0);
  stream.commit({}, of_corners);
  const std::string bytes = read_file(path("out.ply"));
  EXPECT_NE(bytes.find("element vertex 12\n"), std::string::npos) << "none are copied";
}

}  // namespace
}  // namespace dupin::streams
