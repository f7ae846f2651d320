// All mesh readers: a file is read, or refused for one of the two reasons that are promised. The
// first byte of an input chooses the format, in the order of mesh_formats; what a finding taught
// goes to the tables of malformed files. See tests/support/fuzz_target.h.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/kernel/error.h"
#include "io/formats/creased.h"
#include "support/fuzz_target.h"
#include "support/sample_meshes.h"

std::vector<std::string> dupin::test::fuzz_seeds() {
  std::vector<std::string> seeds;
  const std::span<const MeshFormat> formats = mesh_formats();
  for (std::size_t i = 0; i < formats.size(); ++i) {
    MeshHeader header{"mm", "a note"};
    const auto add = [&] {
      seeds.push_back(std::string(1, static_cast<char>(i)) +
                      mesh_bytes(labelled_tetrahedron(), formats[i], header));
    };
    add();
    if (formats[i].has_normals) {
      header.normals = creased_normals();
      add();
    }
  }
  return seeds;
}

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
