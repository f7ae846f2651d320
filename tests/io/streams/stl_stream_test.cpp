#include "dupin/io/stl_stream.h"

#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/stl.h"
#include "dupin/io/streamed_format.h"
#include "dupin/kernel/error.h"
#include "io/streams/pieces.h"
#include "support/scratch_directory.h"
#include "support/shapes.h"

namespace dupin::test {
namespace {

using StlStreams = ScratchDirectory;
using testing::HasSubstr;

TEST_F(StlStreams, gives_the_bytes_of_all_at_once) {
  const MeshHeader header{"mm", "a note"};
  for (const std::vector<std::string>& names : kCompanies) {
    const Pieces all(names, Coordinates::binary32);
    const std::filesystem::path file = path("out.stl");
    StlStream stream(file);
    for (const Rounded& piece : all.rounded) {
      stream.append(mesh_piece(piece, kStlBinary, "out.stl"), 0);
      stream.flush();
    }
    EXPECT_EQ(stream.triangles(), all.all().triangles.size());
    EXPECT_FALSE(std::filesystem::exists(file));
    stream.commit(header, {});
    EXPECT_EQ(read_file(file), stl_binary_bytes(all.all(), header));
    std::filesystem::remove(file);
  }
}

TEST_F(StlStreams, leaves_nothing_behind_without_commit) {
  {
    StlStream stream(path("out.stl"));
    stream.append(
        mesh_piece(Pieces({"a"}, Coordinates::binary32).rounded[0], kStlBinary, "out.stl"), 0);
    EXPECT_FALSE(std::filesystem::is_empty(directory()));
  }
  EXPECT_TRUE(std::filesystem::is_empty(directory()));
}

class StlFiles : public ScratchDirectory {
 public:
  /// What is said of a file with these bytes.
  [[nodiscard]] std::string refusal(const std::string& name, const std::string& bytes, Errc code) {
    write_file(path(name), bytes);
    try {
      StlFile(path(name)).visit([](std::span<const Facet>) {});
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << error.what();
      return error.what();
    }
    ADD_FAILURE() << name;
    return {};
  }
};

std::string with_float(std::string bytes, std::size_t at, float number) {
  const auto raw = std::bit_cast<std::array<char, 4>>(number);
  return bytes.replace(at, 4, raw.data(), 4);
}

TEST_F(StlFiles, are_read_as_often_as_is_asked_for) {
  const TriMesh mesh = tube(3, 0, 1, 20'000);  // more than is read at once
  write_file(path("a.stl"), mesh_bytes(mesh, kStlBinary));
  const StlFile file(path("a.stl"));
  EXPECT_EQ(file.count(), mesh.triangles.size());
  for (int round = 0; round < 2; ++round) {
    std::size_t number = 0;
    file.visit([&](std::span<const Facet> facets) {
      for (const Facet& facet : facets) {
        const Triangle& corners = mesh.triangles[number++];
        for (std::size_t k = 0; k < 9; ++k) {
          EXPECT_EQ(facet[k], static_cast<float>(mesh.points[corners[k / 3]](Eigen::Index(k % 3))));
        }
      }
    });
    EXPECT_EQ(number, mesh.triangles.size());
  }
}

TEST_F(StlFiles, have_the_mesh_that_is_read_at_once) {
  for (const TriMesh& mesh :
       {tube(3, 0, 1, 20'000), labelled(box({0, 0, 0}, {1, 1, 1}), "a"), TriMesh()}) {
    const std::string bytes = mesh_bytes(mesh, kStlBinary, {.unit = "cm"});
    write_file(path("a.stl"), bytes);
    const TriMesh expected = read_stl_binary(bytes, "a.stl"), found = StlFile(path("a.stl")).mesh();
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.triangles, expected.triangles);
    EXPECT_EQ(found.labels, expected.labels);
    EXPECT_EQ(found.names, expected.names);
    EXPECT_EQ(StlFile(path("a.stl")).unit(), "cm");
  }
}

TEST_F(StlFiles, are_told_from_others) {
  const TriMesh mesh = box({0, 0, 0}, {1, 1, 1});
  for (const MeshFormat& format : mesh_formats()) {
    write_file(path("a.stl"), mesh_bytes(mesh, format));
    EXPECT_EQ(is_stl_file(path("a.stl")), format == kStlBinary) << format.key;
  }
  write_file(path("a.stl"), "damaged");
  EXPECT_TRUE(is_stl_file(path("a.stl")));
  EXPECT_FALSE(is_stl_file("/dev/null"));
  EXPECT_THROW((void)is_stl_file(path("missing.stl")), Error);
}

TEST_F(StlFiles, have_no_negative_zero) {
  const std::string bytes = mesh_bytes(box({0, 0, 0}, {1, 1, 1}), kStlBinary);
  write_file(path("a.stl"), with_float(bytes, 84 + 12, -0.0F));
  StlFile(path("a.stl")).visit([](std::span<const Facet> facets) {
    EXPECT_FALSE(std::signbit(facets[0][0]));
  });
}

TEST_F(StlFiles, may_begin_with_any_header_of_their_size) {
  std::string bytes = mesh_bytes(box({0, 0, 0}, {1, 1, 1}), kStlBinary);
  write_file(path("named"), bytes.replace(0, 5, "solid"));
  EXPECT_EQ(StlFile(path("named")).count(), 12);
  write_file(path("empty.stl"), std::string(84, '\0'));
  EXPECT_EQ(StlFile(path("empty.stl")).count(), 0);
}

// With the words of read_mesh().
TEST_F(StlFiles, are_refused_where_they_are_damaged) {
  const std::string bytes = mesh_bytes(box({0, 0, 0}, {1, 1, 1}), kStlBinary);
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const std::string& damaged :
       {bytes.substr(0, 83), bytes.substr(0, 600), bytes + "x", std::string(),
        with_float(bytes, 84 + 3 * 50 + 12 + 8, kNan)}) {
    const std::string message = refusal("a.stl", damaged, Errc::parse_failed);
    try {
      (void)read_mesh(path("a.stl"));
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(message, error.what());
    }
  }
}

TEST_F(StlFiles, are_regular_files_of_the_one_format) {
  const TriMesh mesh = box({0, 0, 0}, {1, 1, 1});
  for (const MeshFormat& format : mesh_formats()) {
    if (!(format == kStlBinary)) {
      EXPECT_THAT(refusal("a.stl", mesh_bytes(mesh, format), Errc::invalid_argument),
                  HasSubstr("is no binary STL"));
    }
  }
  EXPECT_THROW(StlFile("/dev/null"), Error);
  EXPECT_THROW(StlFile{directory()}, Error);
  EXPECT_THROW(StlFile(path("missing.stl")), Error);
}

TEST_F(StlFiles, may_become_shorter) {
  const std::string bytes = mesh_bytes(box({0, 0, 0}, {1, 1, 1}), kStlBinary);
  write_file(path("a.stl"), bytes);
  const StlFile file(path("a.stl"));
  std::filesystem::resize_file(path("a.stl"), 300);
  try {
    file.visit([](std::span<const Facet>) {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::io_failed);
    EXPECT_THAT(error.what(), HasSubstr("shorter"));
  }
}

}  // namespace
}  // namespace dupin::test
