#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dupin/io/glb.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "formats/gltf/glb_layout.h"
#include "formats/placed_mesh.h"
#include "formats/split_points.h"
#include "text/json_type.h"
#include "text/known_unit.h"
#include "text/label_colour.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"

// Written with nlohmann_json alone: tinygltf would bring image codecs, leave the bounds of
// accessors for us to check, and hold everything twice, for these few keys.

namespace dupin {
namespace {

using text::Json;

/// Metres per unit.
double metres(std::string_view unit) {
  if (const std::optional<double> length = text::metres_in(unit)) {
    return *length;
  }
  throw Error(Errc::invalid_argument, "glTF cannot scale from the unit '" + std::string(unit) +
                                          "' to metres; known are um, mm, cm, m, in and ft");
}

void pad(std::string& bytes, char filler) { bytes.resize((bytes.size() + 3) / 4 * 4, filler); }

/// glTF wants base colours linear; documents and the palette have sRGB (IEC 61966-2-1). Digits
/// enough to come back to the same channel.
double linear(std::uint8_t channel) {
  const double share = channel / 255.0;
  const double value = share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  return std::round(value * 1e6) / 1e6;
}

/// The parts of the JSON that grow with the mesh, and the bytes they point into.
struct Content {
  std::string bytes;
  std::vector<std::string> names;  // of labels, as they are written
  Json views = Json::array();
  Json accessors = Json::array();
  std::vector<std::pair<std::size_t, Json>> primitives;  // by label
  Json materials = Json::array();
  Json attributes = Json::object();   // of all primitives
  std::optional<std::size_t> copies;  // an accessor

  /// The view of the bytes appended since `begin`, by the GPU if there is a target.
  std::size_t add_view(std::size_t begin, std::optional<int> target) {
    views.push_back({{"buffer", 0}, {"byteOffset", begin}, {"byteLength", bytes.size() - begin}});
    if (target) {
      views.back()["target"] = *target;
    }
    return views.size() - 1;
  }

  /// An accessor of the numbers appended since `begin`.
  std::size_t add_accessor(std::size_t begin, std::optional<int> target, int component,
                           std::size_t count, const char* type) {
    const std::size_t view = add_view(begin, target);
    accessors.push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
    return accessors.size() - 1;
  }
};

void add_points(Content& content, const std::vector<Vec3>& points) {
  Vec3 lowest = points.front();
  Vec3 highest = points.front();
  for (const Vec3& point : points) {
    lowest = lowest.cwiseMin(point);
    highest = highest.cwiseMax(point);
    for (const double coordinate : point) {
      text::store(content.bytes, static_cast<float>(coordinate));
    }
  }
  const std::size_t accessor = content.add_accessor(0, formats::kGltfPointsBuffer,
                                                    formats::kGltfFloat, points.size(), "VEC3");
  content.accessors.back()["min"] = {lowest.x(), lowest.y(), lowest.z()};
  content.accessors.back()["max"] = {highest.x(), highest.y(), highest.z()};
  content.attributes["POSITION"] = accessor;
}

/// Normals of all points, and of which the last ones are copies.
void add_normals(Content& content, const formats::SplitPoints& split) {
  const std::size_t begin = content.bytes.size();
  for (const Direction& normal : split.normals) {
    text::store(content.bytes, normal);
  }
  content.attributes["NORMAL"] = content.add_accessor(
      begin, formats::kGltfPointsBuffer, formats::kGltfFloat, split.normals.size(), "VEC3");
  if (!split.copied.empty()) {
    const std::size_t copies = content.bytes.size();
    for (const std::uint32_t point : split.copied) {
      text::store(content.bytes, point);
    }
    content.copies =
        content.add_accessor(copies, {}, formats::kGltfUint32, split.copied.size(), "SCALAR");
  }
}

void add_primitive(Content& content, const TriMesh& mesh, const std::vector<Triangle>& of_vertices,
                   const std::vector<std::uint32_t>& triangles, std::size_t label,
                   const std::vector<text::Colour>& colours) {
  const std::size_t begin = content.bytes.size();
  for (const std::uint32_t triangle : triangles) {
    text::store(content.bytes, of_vertices[triangle]);
  }
  const std::size_t indices = content.add_accessor(
      begin, formats::kGltfIndicesBuffer, formats::kGltfUint32, 3 * triangles.size(), "SCALAR");
  Json primitive = {
      {"attributes", content.attributes}, {"indices", indices}, {"mode", formats::kGltfTriangles}};
  if (!mesh.labels.empty()) {
    const text::Colour& colour = colours[label];
    primitive["material"] = content.materials.size();
    content.materials.push_back(
        {{"name", content.names[label]},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {linear(colour[0]), linear(colour[1]), linear(colour[2]), 1}},
           {"metallicFactor", 0},
           {"roughnessFactor", 0.6}}}});
  }
  content.primitives.emplace_back(label, std::move(primitive));
}

/// A node for each part with a mesh of its patches, below the one that turns and scales; they share
/// one accessor of points. Meshes without labels are the node's own.
void add_nodes(Json& json, Json root, const TriMesh& mesh, Content& content) {
  Json meshes = Json::array(), nodes = Json::array();
  std::map<std::string, std::size_t> known;
  for (auto& [label, primitive] : content.primitives) {
    const std::string part = mesh.labels.empty()
                                 ? root["name"].get<std::string>()
                                 : text::clean_line(text::part_of_label(content.names[label]));
    const auto [place, is_new] = known.try_emplace(part, meshes.size());
    if (is_new) {
      meshes.push_back({{"name", part}, {"primitives", Json::array()}});
      nodes.push_back({{"name", part}, {"mesh", place->second}});
      root.emplace("children", Json::array());
      root["children"].push_back(nodes.size());
    }
    meshes[place->second]["primitives"].push_back(std::move(primitive));
  }
  if (mesh.labels.empty()) {
    root.erase("children");
    root["mesh"] = 0;
    nodes.clear();
  }
  nodes.insert(nodes.begin(), std::move(root));
  json["nodes"] = std::move(nodes);
  json["meshes"] = std::move(meshes);
}

Json document(Content& content, const TriMesh& mesh, const MeshHeader& header) {
  Json json = {{"asset", {{"version", "2.0"}, {"generator", formats::kGlbGenerator}}},
               {"scene", 0}};
  if (!header.unit.empty() || !header.note.empty()) {
    json["asset"]["extras"] = {{"unit", text::clean_line(header.unit)},
                               {"note", text::clean_line(header.note)}};
  }
  if (content.copies) {
    json["asset"].emplace("extras", Json::object());
    json["asset"]["extras"][formats::kGlbCopies] = *content.copies;
  }
  if (content.primitives.empty()) {
    json["scenes"] = Json::array({Json{{"name", formats::kEmptySet}}});
    return json;
  }
  Json root = {{"name", header.name.empty() ? "solid" : text::clean_line(header.name)},
               {"rotation", {-formats::kGlbHalfTurn, 0, 0, formats::kGlbHalfTurn}}};
  if (!header.unit.empty()) {
    const double scale = metres(header.unit);
    root["scale"] = {scale, scale, scale};
  }
  json["scenes"] = Json::array({Json{{"nodes", Json::array({0})}}});
  add_nodes(json, std::move(root), mesh, content);
  if (!content.materials.empty()) {
    json["materials"] = std::move(content.materials);
  }
  json["accessors"] = std::move(content.accessors);
  json["bufferViews"] = std::move(content.views);
  json["buffers"] = Json::array({Json{{"byteLength", content.bytes.size()}}});
  return json;
}

/// Points, normals and indices.
void add_geometry(Content& content, const TriMesh& mesh, const formats::SplitPoints& split,
                  const MeshHeader& header, const std::vector<Vec3>& points) {
  content.names = text::written_names(mesh.names);
  add_points(content, points);
  if (!split.normals.empty()) {
    add_normals(content, split);
  }
  const std::vector<Triangle>& triangles = split.normals.empty() ? mesh.triangles : split.triangles;
  const auto groups = text::triangles_by_label(mesh);
  const std::vector<text::Colour> colours = text::label_colours(mesh.names, header.colours);
  for (std::size_t label = 0; label < groups.size(); ++label) {
    if (!groups[label].empty()) {
      add_primitive(content, mesh, triangles, groups[label], label, colours);
    }
  }
}

}  // namespace

std::string glb_bytes(const TriMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  std::vector<Vec3> points = text::surface_points(mesh, Coordinates::binary32);
  formats::SplitPoints split;
  if (!header.normals.empty()) {
    split = formats::split_points(mesh, header.normals);
    for (const std::uint32_t point : split.copied) {
      points.push_back(points[point]);
    }
  }
  const std::size_t size =
      (points.size() + split.normals.size() + mesh.triangles.size()) * 12 + split.copied.size() * 4;
  if (size > std::numeric_limits<std::uint32_t>::max() / 2) {
    throw Error(Errc::limit_exceeded, "binary glTF files hold at most 4 GiB");
  }
  Content content;
  content.bytes.reserve(size);
  if (!mesh.triangles.empty()) {
    add_geometry(content, mesh, split, header, points);
  }
  std::string json = document(content, mesh, header).dump();
  pad(json, ' ');
  const bool has_bytes = !content.bytes.empty();
  const std::size_t total = formats::kGlbHeader + formats::kGlbChunkHeader + json.size() +
                            (has_bytes ? formats::kGlbChunkHeader + content.bytes.size() : 0);
  std::string bytes;
  bytes.reserve(total);
  text::store(bytes, formats::kGlbMagic);
  text::store(bytes, formats::kGlbVersion);
  text::store(bytes, static_cast<std::uint32_t>(total));
  text::store(bytes, static_cast<std::uint32_t>(json.size()));
  text::store(bytes, formats::kGlbJsonChunk);
  bytes += json;
  if (has_bytes) {
    text::store(bytes, static_cast<std::uint32_t>(content.bytes.size()));
    text::store(bytes, formats::kGlbBytesChunk);
    bytes += content.bytes;
  }
  return bytes;
}

}  // namespace dupin
