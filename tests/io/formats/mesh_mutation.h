#pragma once

#include <cstddef>
#include <ostream>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/kernel/error.h"
#include "io/formats/creased.h"
#include "support/mutation.h"
#include "support/sample_meshes.h"

namespace dupin::test {

/// Reads `count` randomly damaged copies of a small valid file, with normals where the format has
/// any. Each must give a mesh that can be written, or the error that its reader promises.
inline void expect_read_or_refused(const MeshFormat& format, std::size_t count,
                                   bool with_normals = false) {
  MeshHeader header{"mm", "a note"};
  if (with_normals) {
    header.normals = creased_normals();
  }
  const std::string good = mesh_bytes(labelled_tetrahedron(), format, header);
  std::mt19937_64 random(20000);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string bytes = mutated(good, random);
    try {
      (void)mesh_bytes(format.read(bytes, "x"), kOff);
    } catch (const Error& error) {
      ASSERT_TRUE(error.code() == Errc::parse_failed || error.code() == Errc::limit_exceeded)
          << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, count / 10) << format.name;
  EXPECT_LT(refused, count) << format.name;
}

}  // namespace dupin::test

namespace dupin {

/// For GoogleTest.
inline void PrintTo(const MeshFormat& format, std::ostream* out) { *out << format.name; }

}  // namespace dupin

namespace dupin::test {

/// The format's name without blanks, to name a test after it.
inline std::string format_name(const ::testing::TestParamInfo<MeshFormat>& info) {
  std::string text(info.param.name);
  std::erase(text, ' ');
  return text;
}

}  // namespace dupin::test
