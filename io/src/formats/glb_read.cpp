#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "dupin/io/glb.h"
#include "dupin/kernel/error.h"
#include "formats/glb_layout.h"
#include "text/json_depth.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"

namespace dupin {
namespace {

using Json = nlohmann::json;

[[noreturn]] void fail(std::string_view file, const std::string& place,
                       const std::string& message) {
  throw Error(Errc::parse_failed, message, {}, std::string(file) + ":" + place);
}

/// The two chunks of a GLB file.
struct Chunks {
  std::string_view json;
  std::string_view bytes;
};

Chunks split(std::string_view file_bytes, std::string_view file) {
  if (file_bytes.size() < formats::kGlbHeader ||
      text::load<std::uint32_t>(file_bytes, 0) != formats::kGlbMagic) {
    fail(file, "byte 0", "found no header of binary glTF, expected 'glTF' and 8 more bytes");
  }
  if (text::load<std::uint32_t>(file_bytes, 4) != formats::kGlbVersion) {
    fail(file, "byte 4",
         "found version " + std::to_string(text::load<std::uint32_t>(file_bytes, 4)) +
             ", expected 2");
  }
  if (text::load<std::uint32_t>(file_bytes, 8) != file_bytes.size()) {
    fail(file, "byte 8",
         "found a length of " + std::to_string(text::load<std::uint32_t>(file_bytes, 8)) +
             " in a file of " + std::to_string(file_bytes.size()) + " bytes, expected the same");
  }
  Chunks chunks;
  for (std::size_t place = formats::kGlbHeader; place < file_bytes.size();) {
    const std::size_t left = file_bytes.size() - place;
    const std::size_t size = left < formats::kGlbChunkHeader
                                 ? left
                                 : std::size_t{text::load<std::uint32_t>(file_bytes, place)};
    if (left < formats::kGlbChunkHeader || size > left - formats::kGlbChunkHeader) {
      fail(file, "byte " + std::to_string(place),
           "found a chunk of " + std::to_string(size) + " bytes, expected at most " +
               std::to_string(left));
    }
    const auto type = text::load<std::uint32_t>(file_bytes, place + 4);
    const std::string_view content = file_bytes.substr(place + formats::kGlbChunkHeader, size);
    if (type == formats::kGlbJsonChunk && chunks.json.empty()) {
      chunks.json = content;
    } else if (type == formats::kGlbBytesChunk && chunks.bytes.empty()) {
      chunks.bytes = content;
    }
    place += formats::kGlbChunkHeader + size;
  }
  return chunks;
}

/// A stretch of numbers of the buffer, known to lie in it.
struct Accessor {
  std::size_t begin = 0;
  std::size_t stride = 0;
  std::size_t count = 0;
  int component_type = 0;
};

class GlbReader {
 public:
  GlbReader(Json json, std::string_view bytes, std::string_view file)
      : json_(std::move(json)), bytes_(bytes), file_(file) {}

  TriMesh read() && {
    const Json empty = Json::array();
    const Json& meshes = json_.contains("meshes") ? json_["meshes"] : empty;
    if (!meshes.is_array() || meshes.size() > 1) {
      fail(file_, "/meshes", "found " + std::to_string(meshes.size()) + " meshes, expected one");
    }
    if (meshes.size() == 1) {
      const Json& primitives = member(meshes[0], "/meshes/0", "primitives");
      if (!primitives.is_array()) {
        fail(file_, "/meshes/0/primitives", "found no array, expected one");
      }
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        read_primitive(primitives[i], "/meshes/0/primitives/" + std::to_string(i));
      }
    }
    if (named_) {
      std::move(labels_).name_labels(mesh_);
    } else {
      mesh_.labels.clear();
    }
    return std::move(mesh_);
  }

 private:
  const Json& member(const Json& json, const std::string& place, const std::string& key) const {
    if (!json.is_object() || !json.contains(key)) {
      fail(file_, place, "found no '" + key + "', expected one");
    }
    return json[key];
  }

  std::size_t unsigned_member(const Json& json, const std::string& place, const std::string& key,
                              std::optional<std::size_t> otherwise = {}) const {
    if (otherwise && json.is_object() && !json.contains(key)) {
      return *otherwise;
    }
    const Json& value = member(json, place, key);
    if (!value.is_number_unsigned() ||
        value.get<std::uint64_t>() > std::numeric_limits<std::uint32_t>::max()) {
      fail(file_, place + "/" + key,
           "found " + value.dump().substr(0, 40) + ", expected an integer from 0 to 4294967295");
    }
    return value.get<std::size_t>();
  }

  /// The entry that `json[key]` counts in the document's array `array`.
  std::pair<const Json*, std::string> entry(std::size_t index, const std::string& array) const {
    const std::string place = "/" + array + "/" + std::to_string(index);
    const Json& entries = member(json_, "", array);
    if (!entries.is_array() || index >= entries.size()) {
      fail(file_, place, "found nothing there, expected an entry");
    }
    return {&entries[index], place};
  }

  Accessor accessor(std::size_t index, const std::string& type, std::size_t components) const {
    const auto [json, place] = entry(index, "accessors");
    if (json->contains("sparse") || member(*json, place, "type") != type) {
      fail(file_, place, "found another kind of accessor, expected a dense one of " + type);
    }
    Accessor result;
    result.component_type = static_cast<int>(unsigned_member(*json, place, "componentType"));
    const std::size_t size = components * size_of(result.component_type, place);
    result.count = unsigned_member(*json, place, "count");
    const auto [view, view_place] =
        entry(unsigned_member(*json, place, "bufferView"), "bufferViews");
    if (unsigned_member(*view, view_place, "buffer") != 0) {
      fail(file_, view_place + "/buffer", "found another buffer, expected 0, the one inside");
    }
    const std::size_t view_begin = unsigned_member(*view, view_place, "byteOffset", 0);
    const std::size_t view_size = unsigned_member(*view, view_place, "byteLength");
    const std::size_t begin = unsigned_member(*json, place, "byteOffset", 0);
    result.stride = unsigned_member(*view, view_place, "byteStride", size);
    result.begin = view_begin + begin;
    const std::size_t needed =
        result.count == 0 ? 0 : begin + (result.count - 1) * result.stride + size;
    if (result.stride < size || needed > view_size || view_begin + view_size > bytes_.size()) {
      fail(file_, place,
           "found " + std::to_string(result.count) +
               " entries, expected room for them in a buffer of " + std::to_string(bytes_.size()) +
               " bytes");
    }
    return result;
  }

  std::size_t size_of(int component_type, const std::string& place) const {
    switch (component_type) {
      case formats::kGltfUint8:
        return 1;
      case formats::kGltfUint16:
        return 2;
      case formats::kGltfUint32:
      case formats::kGltfFloat:
        return 4;
      default:
        fail(file_, place + "/componentType",
             "found " + std::to_string(component_type) + ", expected 5121, 5123, 5125 or 5126");
    }
  }

  /// Index of the accessor's first point in the mesh; the accessor is read when first met.
  std::uint32_t first_point(std::size_t index, const std::string& place) {
    const auto [known, fresh] =
        first_points_.try_emplace(index, static_cast<std::uint32_t>(mesh_.points.size()));
    if (!fresh) {
      return known->second;
    }
    const Accessor points = accessor(index, "VEC3", 3);
    if (points.component_type != formats::kGltfFloat) {
      fail(file_, place + "/attributes/POSITION", "found integers, expected floats");
    }
    demand_room(12 * (mesh_.points.size() + points.count), place);
    for (std::size_t i = 0; i < points.count; ++i) {
      const auto xyz = text::load<std::array<float, 3>>(bytes_, points.begin + i * points.stride);
      const Vec3 point(xyz[0], xyz[1], xyz[2]);
      if (!point.allFinite()) {
        fail(file_, place + "/attributes/POSITION",
             "found point " + std::to_string(i) + " not finite, expected finite coordinates");
      }
      mesh_.points.emplace_back(point.array() + 0.0);  // -0 becomes 0
    }
    return known->second;
  }

  /// Accessors that overlap could ask for any number of points or triangles.
  void demand_room(std::size_t size, const std::string& place) const {
    if (size > bytes_.size()) {
      fail(file_, place,
           "found more points or triangles than the buffer's " + std::to_string(bytes_.size()) +
               " bytes can hold, expected accessors that do not overlap");
    }
  }

  std::uint32_t index_at(const Accessor& indices, std::size_t i) const {
    const std::size_t place = indices.begin + i * indices.stride;
    switch (indices.component_type) {
      case formats::kGltfUint8:
        return text::load<std::uint8_t>(bytes_, place);
      case formats::kGltfUint16:
        return text::load<std::uint16_t>(bytes_, place);
      default:
        return text::load<std::uint32_t>(bytes_, place);
    }
  }

  void read_primitive(const Json& primitive, const std::string& place) {
    if (unsigned_member(primitive, place, "mode", formats::kGltfTriangles) !=
        formats::kGltfTriangles) {
      fail(file_, place + "/mode", "found another mode, expected 4, triangles");
    }
    const std::size_t points =
        unsigned_member(member(primitive, place, "attributes"), place + "/attributes", "POSITION");
    const std::uint32_t first = first_point(points, place);
    const std::size_t point_count = accessor(points, "VEC3", 3).count;
    const Accessor indices = accessor(unsigned_member(primitive, place, "indices"), "SCALAR", 1);
    if (indices.count % 3 != 0 || indices.component_type == formats::kGltfFloat) {
      fail(file_, place + "/indices",
           "found " + std::to_string(indices.count) +
               " indices, expected integers, three per triangle");
    }
    demand_room(3 * mesh_.triangles.size() + indices.count, place);
    for (std::size_t i = 0; i < indices.count; i += 3) {
      Triangle triangle;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t index = index_at(indices, i + corner);
        if (index >= point_count) {
          fail(file_, place + "/indices",
               "found index " + std::to_string(index) + " at " + std::to_string(i + corner) +
                   ", expected less than " + std::to_string(point_count));
        }
        triangle[corner] = first + index;
      }
      mesh_.triangles.push_back(triangle);
    }
    mesh_.labels.resize(mesh_.triangles.size(), labels_.label(material_name(primitive, place)));
  }

  std::string material_name(const Json& primitive, const std::string& place) {
    if (!primitive.contains("material")) {
      return "default";
    }
    const auto [material, material_place] =
        entry(unsigned_member(primitive, place, "material"), "materials");
    if (!material->is_object() || !material->contains("name") || !(*material)["name"].is_string()) {
      return "default";
    }
    named_ = true;
    return text::clean_line((*material)["name"].get<std::string>());
  }

  Json json_;
  std::string_view bytes_;
  std::string_view file_;
  TriMesh mesh_;
  text::LabelBuilder labels_;
  std::map<std::size_t, std::uint32_t> first_points_;
  bool named_ = false;
};

Json document(const Chunks& chunks, std::string_view file) {
  if (text::first_too_deep(chunks.json)) {
    fail(file, "byte 20", "found JSON with brackets nested too deep");
  }
  Json json = Json::parse(chunks.json, nullptr, false);
  if (!json.is_object()) {
    fail(file, "byte 20", "found faulty JSON, expected an object");
  }
  return json;
}

}  // namespace

TriMesh read_glb(std::string_view bytes, std::string_view file) {
  const Chunks chunks = split(bytes, file);
  return GlbReader(document(chunks, file), chunks.bytes, file).read();
}

std::string unit_of_glb(std::string_view bytes, std::string_view file) {
  const Json json = document(split(bytes, file), file);
  const Json::json_pointer place("/asset/extras/unit");
  return json.contains(place) && json[place].is_string()
             ? text::clean_line(json[place].get<std::string>())
             : std::string();
}

}  // namespace dupin
