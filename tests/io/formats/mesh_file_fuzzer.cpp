// A libFuzzer target for all mesh readers:
//
//   cmake --preset fuzz && cmake --build --preset fuzz --target mesh_file_fuzzer
//   mkdir corpus && build/fuzz/tests/io/mesh_file_fuzzer -max_total_time=600 -rss_limit_mb=2048
//   corpus
//
// The first byte of an input chooses the format, in the order of mesh_formats. Start the corpus
// with a small file of each, as `dupin convert` writes them, behind that byte: the containers of
// 3MF and glTF are hard to guess. An input that crashes is written to crash-*; give its name as the
// argument to run it again, and add what it taught to the tables of malformed files.

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/kernel/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  const dupin::MeshFormat& format = dupin::mesh_formats()[data[0] % dupin::mesh_formats().size()];
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    (void)dupin::mesh_bytes(format.read(bytes, "input"), dupin::kOff);
  } catch (const dupin::Error& error) {
    if (error.code() != dupin::Errc::parse_failed && error.code() != dupin::Errc::limit_exceeded) {
      throw;
    }
  }
  return 0;
}
