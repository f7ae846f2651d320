#include <cstring>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/io/glb.h"
#include "dupin/kernel/error.h"
#include "io/formats/glb_parts.h"
#include "support/malformed.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

using Json = nlohmann::json;

/// The same file with another JSON chunk.
std::string with_json(const std::string& glb, std::string text) {
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string rest = glb.substr(20 + test::number_at(glb, 12));
  std::string bytes = glb.substr(0, 20) + text + rest;
  const auto set = [&](std::size_t place, std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    std::memcpy(bytes.data() + place, &number, 4);
  };
  set(8, bytes.size());
  set(12, text.size());
  return bytes;
}

/// A valid file after one change of its JSON.
std::string changed(const std::string& pointer, const Json& value) {
  const std::string glb = glb_bytes(test::tetrahedron());
  Json json = test::glb_json(glb);
  json[Json::json_pointer(pointer)] = value;
  return with_json(glb, json.dump());
}

TEST(Glb, malformed_files_are_refused_with_their_place) {
  const std::string glb = glb_bytes(test::tetrahedron());
  const std::size_t body = 20 + test::number_at(glb, 12) + 8;
  std::string version = glb;
  version[4] = '\1';
  std::string chunk = glb;
  chunk[15] = '\x7f';
  std::string nan = glb;
  nan.replace(body + 16, 4, "\xff\xff\xff\xff");
  std::string index = glb;
  index[body + 48 + 8] = '\4';
  const std::string size = std::to_string(glb.size());
  test::expect_refused(
      read_glb, "x.glb",
      {
          {"", "x.glb:byte 0: found no header of binary glTF, expected 'glTF' and 8 more bytes"},
          {std::string("glTF\2\0\0", 7),
           "x.glb:byte 0: found no header of binary glTF, expected 'glTF' and 8 more bytes"},
          {version, "x.glb:byte 4: found version 1, expected 2"},
          {glb + "x", "x.glb:byte 8: found a length of " + size + " in a file of " +
                          std::to_string(glb.size() + 1) + " bytes, expected the same"},
          {chunk, "x.glb:byte 12: found a chunk of " + std::to_string(test::number_at(chunk, 12)) +
                      " bytes, expected at most " + std::to_string(glb.size() - 12)},
          {with_json(glb, "{\"asset\":"), "x.glb:byte 20: found faulty JSON, expected an object"},
          {with_json(glb, "[]"), "x.glb:byte 20: found faulty JSON, expected an object"},
          {changed("/meshes", Json::array({1, 2})), "x.glb:/meshes: found 2 meshes, expected one"},
          {changed("/meshes/0", 7), "x.glb:/meshes/0: found no 'primitives', expected one"},
          {changed("/meshes/0/primitives", 7),
           "x.glb:/meshes/0/primitives: found no array, expected one"},
          {changed("/meshes/0/primitives/0", Json::object()),
           "x.glb:/meshes/0/primitives/0: found no 'attributes', expected one"},
          {changed("/meshes/0/primitives/0/mode", 5),
           "x.glb:/meshes/0/primitives/0/mode: found another mode, expected 4, triangles"},
          {changed("/meshes/0/primitives/0/indices", -1),
           "x.glb:/meshes/0/primitives/0/indices: found -1, expected an integer from 0 to "
           "4294967295"},
          {changed("/meshes/0/primitives/0/indices", 2),
           "x.glb:/accessors/2: found nothing there, expected an entry"},
          {changed("/meshes/0/primitives/0/indices", 0),
           "x.glb:/accessors/0: found another kind of accessor, expected a dense one of SCALAR"},
          {changed("/meshes/0/primitives/0/material", 0),
           "x.glb:: found no 'materials', expected one"},
          {changed("/accessors/0/sparse", 1),
           "x.glb:/accessors/0: found another kind of accessor, expected a dense one of VEC3"},
          {changed("/accessors/0/componentType", 5130),
           "x.glb:/accessors/0/componentType: found 5130, expected 5121, 5123, 5125 or 5126"},
          {changed("/accessors/0/componentType", 5125),
           "x.glb:/meshes/0/primitives/0/attributes/POSITION: found integers, expected floats"},
          {changed("/accessors/0/count", 5),
           "x.glb:/accessors/0: found 5 entries, expected room for them in a buffer of 96 bytes"},
          {changed("/accessors/0/count", 4000000000U),
           "x.glb:/accessors/0: found 4000000000 entries, expected room for them in a buffer of 96 "
           "bytes"},
          {changed("/accessors/1/count", 11),
           "x.glb:/meshes/0/primitives/0/indices: found 11 indices, expected integers, three per "
           "triangle"},
          {changed("/accessors/1/byteOffset", 4),
           "x.glb:/accessors/1: found 12 entries, expected room for them in a buffer of 96 bytes"},
          {changed("/bufferViews/0/byteStride", 8),
           "x.glb:/accessors/0: found 4 entries, expected room for them in a buffer of 96 bytes"},
          {changed("/bufferViews/1/buffer", 1),
           "x.glb:/bufferViews/1/buffer: found another buffer, expected 0, the one inside"},
          {nan,
           "x.glb:/meshes/0/primitives/0/attributes/POSITION: found point 1 not finite, expected "
           "finite coordinates"},
          {index, "x.glb:/meshes/0/primitives/0/indices: found index 4 at 2, expected less than 4"},
      });
}

}  // namespace
}  // namespace dupin
