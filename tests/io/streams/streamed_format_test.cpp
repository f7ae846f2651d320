#include "dupin/io/streamed_format.h"

#include <algorithm>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/ply.h"
#include "dupin/io/stl.h"
#include "dupin/kernel/error.h"
#include "io/streams/pieces.h"
#include "support/message_of.h"
#include "support/scratch_directory.h"
#include "support/thread_processes.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;
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

// Each writes the pieces it has, in their places.
TEST_F(MeshStreams, give_the_same_bytes_by_several_processes) {
  const MeshHeader header{"mm", "a note", "name", {{"a", "#102030"}}};
  const MeshStream::Normals normals = [](const TriMesh& mesh) {
    CornerNormals result;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Direction own{0, 0, i % 3 == 0 ? 1.F : -1.F};  // some points are copied
      result.push_back({own, own, own});
    }
    return result;
  };
  for (const MeshFormat& format : {kStlBinary, kPlyBinary, kPvtu}) {
    for (const std::vector<std::string>& names : kCompanies) {
      const Pieces all(names, format.coordinates);
      const auto written = [&](std::size_t count, const MeshStream::Normals& of_piece) {
        ThreadProcesses::run(count, [&](const Processes& processes) {
          const auto stream = mesh_stream(path("out.x"), format, &processes);
          for (std::size_t i = 0; i < names.size(); ++i) {
            MeshPiece piece = mesh_piece(all.rounded[i], format, "out.x");
            piece.is_elsewhere = i % count != processes.own();
            piece.bytes = piece.is_elsewhere ? "" : piece.bytes;
            stream->append(piece, format == kPvtu ? i % count : 0);
          }
          stream->commit(header, of_piece);
        });
        std::map<std::string, std::string> files;
        for (const auto& file : std::filesystem::directory_iterator(directory())) {
          files[file.path().filename().string()] = read_file(file.path());
          std::filesystem::remove(file.path());
        }
        return files;
      };
      const auto alone = written(1, {});
      EXPECT_EQ(alone.size(), format == kPvtu ? 2 : 1);
      for (const std::size_t count : {2, 3}) {
        const auto together = written(count, {});
        if (format == kPvtu) {
          EXPECT_EQ(together.size(), 1 + std::clamp<std::size_t>(names.size(), 1, count));
        } else {
          EXPECT_TRUE(together == alone) << format.key << " " << count;
          EXPECT_TRUE(written(count, normals) == written(1, normals)) << format.key << count;
        }
      }
    }
  }
}

TEST_F(MeshStreams, take_pieces_without_some_of_their_triangles) {
  const Pieces pieces({"a"}, Coordinates::binary32);
  const TriMesh& mesh = pieces.rounded.at(0).mesh();
  const MeshPiece whole = mesh_piece(pieces.rounded[0], kStlBinary, "a.stl");
  ASSERT_EQ(whole.bytes.size(), 4 * 50);
  const std::vector<std::string> names{"b", "c"};
  const MeshPiece left = without(whole, mesh, kStlBinary, std::vector<std::uint32_t>{0, 2}, names);
  EXPECT_EQ(left.triangles, 2);
  EXPECT_EQ(left.labels, 2);
  EXPECT_EQ(left.names, std::vector<std::string>{"a"});
  EXPECT_TRUE(left.bytes == whole.bytes.substr(50, 50) + whole.bytes.substr(150));
  EXPECT_TRUE(without(whole, mesh, kStlBinary, {}, names).bytes == whole.bytes);
  EXPECT_TRUE(without(whole, mesh, kStlBinary, {}, std::vector<std::string>{"a"}).names.empty());
}

TEST_F(MeshStreams, refuse_pieces_that_are_none_of_theirs) {
  const Pieces pieces({"a"}, Coordinates::binary32);
  for (const MeshFormat& format : {kStlBinary, kPlyBinary, kPvtu}) {
    const MeshPiece good = mesh_piece(pieces.rounded[0], format, "out");
    const auto said = [&](const auto& change) {
      MeshPiece bad = good;
      change(bad);
      const auto stream = mesh_stream(path("out"), format);
      return message_of([&] { stream->append(bad, 0); }, Errc::invalid_argument);
    };
    EXPECT_THAT(said([](MeshPiece& bad) { ++bad.triangles; }), HasSubstr("mesh_piece()"));
    EXPECT_THAT(said([](MeshPiece& bad) { bad.bytes.pop_back(); }), HasSubstr("mesh_piece()"));
    if (format == kStlBinary) {
      continue;
    }
    EXPECT_THAT(said([](MeshPiece& bad) { bad.points += 1000000; }), HasSubstr("fit together"));
    EXPECT_THAT(said([](MeshPiece& bad) { bad.labels = 1; }), HasSubstr("fit together"));
    EXPECT_THAT(said([](MeshPiece& bad) { bad.names.clear(); }), HasSubstr("fit together"));
    EXPECT_THAT(said([](MeshPiece& bad) { bad.bytes[bad.points * 24 + 3] = '\x7f'; }),
                HasSubstr("fit together"));  // a corner
    EXPECT_THAT(said([](MeshPiece& bad) {
                  bad.borders = {{"b", {1000}, {}, {}}};
                }),
                HasSubstr("fit together"));
  }
}

TEST_F(MeshStreams, are_committed_once) {
  const Pieces pieces({"a"}, Coordinates::binary32);
  for (const MeshFormat& format : {kStlBinary, kPlyBinary, kPvtu}) {
    const MeshPiece piece = mesh_piece(pieces.rounded[0], format, "out");
    const auto stream = mesh_stream(path("out"), format);
    stream->append(piece, 0);
    stream->commit({}, {});
    EXPECT_THAT(message_of([&] { stream->commit({}, {}); }, Errc::invalid_argument),
                HasSubstr("out: the file is committed"));
    EXPECT_THAT(message_of([&] { stream->append(piece, 0); }, Errc::invalid_argument),
                HasSubstr("out: the file is committed"));
    stream->abandon();
  }
}

TEST_F(MeshStreams, refuse_to_leave_out_what_is_not_there) {
  const TriMesh open = bar(0, 2, "a", true);
  const Rounded solid = to_mesh(Solid::from(open), Coordinates::binary32);
  const std::vector<std::string> names{"end"};
  const auto said = [&](const MeshFormat& format, const std::vector<std::uint32_t>& triangles) {
    const MeshPiece piece = mesh_piece(solid, format, "out");
    return message_of([&] { (void)without(piece, solid.mesh(), format, triangles, names); },
                      Errc::invalid_argument);
  };
  for (const MeshFormat& format : {kStlBinary, kPlyBinary, kPvtu}) {
    EXPECT_EQ(said(format, {9999}), "triangle 9999 cannot be left out: there are 12");
    EXPECT_EQ(said(format, {8, 8}),
              "triangle 8 cannot be left out: the numbers have to ascend, each given once");
  }
  EXPECT_EQ(said(kPlyBinary, {0}), "triangle 0 cannot be left out: its label is none of the names");
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

TEST_F(MeshStreams, names_of_listed_files_are_known) {
  for (const char* const name : {"a_0.vtu", "a_12.vtu"}) {
    EXPECT_TRUE(is_listed_name(name, "folder/a.pvtu")) << name;
  }
  for (const char* const name : {"a_.vtu", "a_1.vtp", "a_x.vtu", "b_1.vtu", "a.vtu", "a_1_2.vtu",
                                 "a_99999999999999999999.vtu", ""}) {
    EXPECT_FALSE(is_listed_name(name, "folder/a.pvtu")) << name;
  }
}

}  // namespace
}  // namespace dupin::test
