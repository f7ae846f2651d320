#include "dupin/io/stl.h"

#include "formats/stl_binary.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

bool begins_with_solid(std::string_view bytes) {
  text::TextScanner scanner(bytes, {});
  scanner.skip_space();
  return scanner.take("solid");
}

Evidence recognise_ascii(std::string_view bytes) {
  return begins_with_solid(bytes) && !is_binary_stl(bytes) ? Evidence::first_word : Evidence::none;
}

/// Some writers begin the header of their binary files with "solid".
Evidence recognise_binary(std::string_view bytes) {
  if (has_size_of_binary_stl(bytes)) {
    return Evidence::size;
  }
  return begins_with_solid(bytes) && is_binary_stl(bytes) ? Evidence::first_word : Evidence::none;
}

std::string write_ascii(const TriMesh& mesh, const MeshHeader&) { return stl_ascii_text(mesh); }

/// There is no place for one.
std::string unit_of_ascii(std::string_view /*bytes*/, std::string_view /*file*/) { return {}; }

std::string unit_of_binary(std::string_view bytes, std::string_view /*file*/) {
  return formats::stl_unit(bytes);
}

}  // namespace

constinit const MeshFormat kStlAscii = {.key = "stl-ascii",
                                        .name = "ASCII STL",
                                        .extension = {},
                                        .coordinates = Coordinates::binary32,
                                        .merges_points = true,
                                        .read = read_stl_ascii,
                                        .write = write_ascii,
                                        .recognises = recognise_ascii,
                                        .unit = unit_of_ascii};

constinit const MeshFormat kStlBinary = {.key = "stl",
                                         .name = "binary STL",
                                         .extension = ".stl",
                                         .coordinates = Coordinates::binary32,
                                         .merges_points = true,
                                         .read = read_stl_binary,
                                         .write = stl_binary_bytes,
                                         .recognises = recognise_binary,
                                         .unit = unit_of_binary};

}  // namespace dupin
