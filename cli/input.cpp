#include "input.h"

#include <iostream>
#include <iterator>

#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/error.h"

namespace dupin::cli {

bool Input::is_document() const {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string::npos && bytes[first] == '{';
}

Input read_input(const std::string& path) {
  if (path != "-") {
    return {read_file(path), path};
  }
  Input input{{std::istreambuf_iterator<char>(std::cin), {}}, "standard input"};
  if (std::cin.bad()) {
    throw Error(Errc::io_failed, "cannot be read", {}, input.name);
  }
  return input;
}

TriMesh read_mesh_input(const std::string& path) {
  const Input input = read_input(path);
  return read_mesh(input.bytes, input.name);
}

Solid read_solid_input(const std::string& path) {
  const TriMesh mesh = read_mesh_input(path);
  try {
    return Solid::from(mesh);
  } catch (const Error& error) {
    throw error.in_part(path);
  }
}

}  // namespace dupin::cli
