#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/io/stl.h"
#include "dupin/io/three_mf.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/error.h"
#include "support/scratch_directory.h"
#include "support/shapes.h"

namespace dupin {
namespace {

using WriteVerified = test::ScratchDirectory;

TriMesh tetrahedron() { return test::tetrahedron(Vec3(0, 0, 0), 1); }

/// A tetrahedron that is a solid in doubles, whose apex falls into its base plane in floats.
TriMesh too_flat_for_floats() {
  TriMesh mesh = tetrahedron();
  mesh.points[0] = Vec3(0, 0, 1);
  mesh.points[1] = Vec3(4, 0, 1);
  mesh.points[2] = Vec3(0, 4, 1);
  mesh.points[3] = Vec3(1, 1, 1 + 0x1p-30);
  return mesh;
}

TEST_F(WriteVerified, writes_a_solid_and_returns_its_report) {
  for (const MeshFormat& format : mesh_formats()) {
    const Report report = write_verified(path("x"), tetrahedron(), format);
    EXPECT_TRUE(report.is_solid());
    EXPECT_EQ(report.triangles, 4U);
    EXPECT_EQ(read_file(path("x")), mesh_bytes(tetrahedron(), format));
  }
  EXPECT_NO_THROW(write_verified(path("flat"), too_flat_for_floats(), kOff));
}

TEST_F(WriteVerified, tells_its_stages_and_keeps_the_old_file_when_cancelled_in_any) {
  write_file(path("x.off"), "old");
  std::vector<std::string> told;
  for (const std::string last : {"write", "verify"}) {
    told.clear();
    const Progress progress = [&](std::string_view stage, double) {
      told.emplace_back(stage);
      return stage != last;
    };
    try {
      write_verified(path("x.off"), tetrahedron(), kOff, {}, progress);
      ADD_FAILURE() << last;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::cancelled);
    }
    EXPECT_EQ(read_file(path("x.off")), "old");
  }
  EXPECT_EQ(told, (std::vector<std::string>{"write", "verify"}));
}

TEST_F(WriteVerified, of_what_was_rounded_keeps_the_old_file_when_cancelled_in_any_stage) {
  write_file(path("x.off"), "old");
  const Rounded rounded = to_mesh(Solid::from(tetrahedron()));
  for (const std::string last : {"write", "verify"}) {
    const Progress progress = [&](std::string_view stage, double) { return stage != last; };
    for (const bool is_file : {true, false}) {
      try {
        if (is_file) {
          write_verified(path("x.off"), rounded, kOff, {}, progress);
        } else {
          static_cast<void>(verified_bytes("x.off", rounded, kOff, {}, progress));
        }
        ADD_FAILURE() << last;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), Errc::cancelled);
      }
    }
    EXPECT_EQ(read_file(path("x.off")), "old");
  }
}

TEST_F(WriteVerified, keeps_the_old_file_when_rounding_breaks_the_solid) {
  write_file(path("x.stl"), "old");
  for (const MeshFormat& format : mesh_formats()) {
    if (format.coordinates != Coordinates::binary32) {
      continue;
    }
    try {
      write_verified(path("x.stl"), too_flat_for_floats(), format);
      ADD_FAILURE() << format.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::unroundable);
      EXPECT_NE(
          error.message().find("this mesh is no longer a solid: self_intersection at (2.000000, "
                               "0.500000, 1.000000), "),
          std::string::npos)
          << error.what();
    }
  }
  EXPECT_EQ(read_file(path("x.stl")), "old");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory()),
                          std::filesystem::directory_iterator()),
            1);
}

TEST_F(WriteVerified, compares_the_file_with_the_mesh_that_rounding_proved) {
  const std::vector<Solid> pipes = {Solid::from(test::tube(1, 0.5, 4, 16)),
                                    Solid::from(test::tube(1, 0.5, 4, 15))};
  const Solid solid = unite(pipes);
  for (const MeshFormat& format : mesh_formats()) {
    const Rounded rounded = to_mesh(solid, format.coordinates);
    EXPECT_NO_THROW(write_verified(path("x"), rounded, format)) << format.name;
    EXPECT_EQ(read_file(path("x")), mesh_bytes(rounded.mesh(), format));
    EXPECT_EQ(verified_bytes("x", rounded, format), read_file(path("x")));
  }
}

TEST_F(WriteVerified, keeps_the_old_file_when_the_format_is_coarser_than_the_rounding) {
  const Rounded rounded = to_mesh(Solid::from(too_flat_for_floats()));
  write_file(path("x"), "old");
  for (const MeshFormat& format : mesh_formats()) {
    if (format.coordinates == Coordinates::binary64) {
      continue;
    }
    try {
      write_verified(path("x"), rounded, format);
      ADD_FAILURE() << format.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::unroundable);
      EXPECT_NE(error.message().find("triangle 1 at (0.000000, 0.000000, 1.000000) does not come"),
                std::string::npos)
          << error.what();
    }
    EXPECT_EQ(read_file(path("x")), "old");
    EXPECT_THROW(static_cast<void>(verified_bytes("x", rounded, format)), Error);
  }
}

TEST_F(WriteVerified, refuses_a_contact_that_readers_would_weld) {
  const std::vector<Solid> boxes = {Solid::from(test::box(Vec3(0, 0, 0), Vec3(1, 1, 1))),
                                    Solid::from(test::box(Vec3(1, 1, 0), Vec3(2, 2, 1)))};
  const Rounded rounded = to_mesh(unite(boxes), Coordinates::binary32);
  ASSERT_EQ(rounded.contacts().size(), 1);
  EXPECT_NO_THROW(write_verified(path("x"), rounded, kThreeMf));
  for (const MeshFormat& format : {kStlBinary, kStlAscii}) {
    try {
      write_verified(path("y"), rounded, format);
      ADD_FAILURE() << format.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::contact) << error.what();
      EXPECT_NE(error.message().find("first at (1.000000, 1.000000, "), std::string::npos)
          << error.what();
    }
    EXPECT_FALSE(std::filesystem::exists(path("y")));
  }
}

TEST_F(WriteVerified, can_be_left_out) {
  EXPECT_NO_THROW(write_mesh(path("x.stl"), too_flat_for_floats()));
  EXPECT_EQ(read_mesh(path("x.stl")).triangles.size(), 4U);
}

}  // namespace
}  // namespace dupin
