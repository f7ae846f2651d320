#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "dupin/io/glb.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "formats/gltf/glb_document.h"
#include "formats/gltf/glb_layout.h"
#include "formats/gltf/glb_scene.h"
#include "formats/placed_mesh.h"
#include "formats/split_points.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

using Json = formats::GlbDocument::Json;

/// A stretch of numbers of the buffer, known to lie in it.
struct Accessor {
  std::size_t begin = 0;
  std::size_t stride = 0;
  std::size_t count = 0;
  int component_type = 0;
};

/// A mesh in its own coordinates.
struct Geometry {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::string> materials;  ///< names, one per triangle range
  std::vector<std::size_t> ends;       ///< of the ranges
};

class GlbReader {
 public:
  explicit GlbReader(const formats::GlbDocument& document)
      : document_(document), bytes_(document.bytes()) {}

  TriMesh read() && {
    require_known_extensions();
    const std::vector<formats::MeshInstance> shown = formats::shown_meshes(document_);
    if (shown.size() > 1 && are_of_one_mesh(shown)) {
      append_together(shown);
    } else {
      for (const formats::MeshInstance& instance : shown) {
        append(instance, shown.size() > 1);
      }
    }
    if (mesh_.triangles.empty() && !shown.empty()) {
      fail("/meshes", "found meshes without triangles, expected some");
    }
    if (formats::names_our_writer(document_)) {
      merge_vertices();
    }
    if (named_) {
      std::move(labels_).name_labels(mesh_);
    } else {
      mesh_.labels.clear();
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& place, const std::string& message) const {
    document_.fail(place, message);
  }

  /// What a file cannot be shown without, if it is about more than looks, is about its geometry.
  void require_known_extensions() const {
    const std::size_t count = document_.count("extensionsRequired");
    for (std::size_t i = 0; i < count; ++i) {
      const Json& entry = document_.json()["extensionsRequired"][i];
      const std::string name = entry.is_string() ? entry.get<std::string>() : "";
      if (!name.starts_with("KHR_materials_") && !name.starts_with("KHR_texture_") &&
          !name.starts_with("KHR_lights_")) {
        fail("/extensionsRequired/" + std::to_string(i),
             "found " + text::quoted(name) + ", expected no extension but of materials" +
                 remedy_for(name));
      }
    }
  }

  static std::string remedy_for(const std::string& extension) {
    if (extension.ends_with("_compression")) {
      return "; decode the file, or export it without compression";
    }
    if (extension == "KHR_mesh_quantization") {
      return "; convert its points to floats, or export it without quantization";
    }
    return "";
  }

  /// Of our own files, in which points are there once for each of their normals.
  void merge_vertices() {
    const Json::json_pointer extras("/asset/extras");
    const std::string place = "/asset/extras";
    if (!document_.json().contains(extras) ||
        !document_.json()[extras].contains(formats::kGlbCopies)) {
      return;
    }
    const Accessor copies =
        accessor(document_.unsigned_member(document_.json()[extras], place, formats::kGlbCopies),
                 "SCALAR", 1);
    std::vector<std::uint32_t> copied(std::min(copies.count, mesh_.points.size()));
    for (std::size_t i = 0; i < copied.size(); ++i) {
      copied[i] = index_at(copies, i);
    }
    const bool is_merged = copied.size() == copies.count &&
                           copies.component_type == formats::kGltfUint32 &&
                           formats::merge_copies(copied, mesh_);
    if (!is_merged && formats::is_ours(document_)) {
      fail(place + "/" + formats::kGlbCopies,
           "found other numbers, expected those of points that the last ones are copies of");
    }
  }

  void append(const formats::MeshInstance& instance, bool has_others) {
    append(geometry(instance.mesh), instance.transform, has_others ? instance.name : std::string(),
           "/meshes/" + std::to_string(instance.mesh));
  }

  void append(const Geometry& geometry, const formats::Transform& transform,
              const std::string& other_name, const std::string& place) {
    unfolded_ += geometry.points.size() + geometry.triangles.size();
    if (unfolded_ > formats::kLargestUnfolding) {
      throw Error(Errc::limit_exceeded, "the nodes show more than " +
                                            std::to_string(formats::kLargestUnfolding) +
                                            " points and triangles");
    }
    if (!formats::append_placed(geometry.points, geometry.triangles, transform, mesh_)) {
      fail(place,
           "found a transformation beyond the range of doubles, expected finite coordinates");
    }
    const std::size_t before = mesh_.triangles.size() - geometry.triangles.size();
    for (std::size_t i = 0; i < geometry.ends.size(); ++i) {
      const std::string& name = geometry.materials[i].empty() ? other_name : geometry.materials[i];
      named_ = named_ || !name.empty();
      mesh_.labels.resize(before + geometry.ends[i],
                          labels_.label(name.empty() ? "default" : name));
    }
  }

  /// The meshes of our own parts share their points and their place.
  bool are_of_one_mesh(const std::vector<formats::MeshInstance>& shown) const {
    if (!formats::names_our_writer(document_)) {
      return false;
    }
    const Json* points = nullptr;
    for (const formats::MeshInstance& instance : shown) {
      const Json& primitives = *primitives_of(instance.mesh).first;
      for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Json::json_pointer position("/attributes/POSITION");
        if (!primitives[i].contains("indices") || !primitives[i].contains(position) ||
            (points != nullptr && primitives[i][position] != *points)) {
          return false;
        }
        points = &primitives[i][position];
      }
    }
    return std::ranges::all_of(shown, [&](const formats::MeshInstance& instance) {
      return instance.transform == shown.front().transform;
    });
  }

  /// Patches are in the order in which their indices are stored.
  void append_together(const std::vector<formats::MeshInstance>& shown) {
    std::vector<std::pair<std::size_t, std::pair<const Json*, std::string>>> patches;
    for (const formats::MeshInstance& instance : shown) {
      const auto [primitives, place] = primitives_of(instance.mesh);
      for (std::size_t i = 0; i < primitives->size(); ++i) {
        const std::string at = place + "/" + std::to_string(i);
        patches.emplace_back(document_.unsigned_member((*primitives)[i], at, "indices"),
                             std::pair(&(*primitives)[i], at));
      }
    }
    std::ranges::stable_sort(patches, {}, [](const auto& patch) { return patch.first; });
    Geometry geometry;
    for (const auto& [indices, patch] : patches) {
      read_primitive(*patch.first, patch.second, geometry);
    }
    append(geometry, shown.front().transform, {}, "/meshes");
  }

  /// A mesh is read when it is first met.
  const Geometry& geometry(std::size_t index) {
    const auto [known, fresh] = meshes_.try_emplace(index);
    Geometry& geometry = known->second;
    if (!fresh) {
      return geometry;
    }
    const auto [primitives, place] = primitives_of(index);
    const auto [mesh, mesh_place] = document_.entry(index, "meshes");
    formats::require_no_weights(document_, *mesh, mesh_place);
    first_points_.clear();
    for (std::size_t i = 0; i < primitives->size(); ++i) {
      read_primitive((*primitives)[i], place + "/" + std::to_string(i), geometry);
    }
    points_ += geometry.points.size();
    return geometry;
  }

  std::pair<const Json*, std::string> primitives_of(std::size_t index) const {
    const auto [mesh, place] = document_.entry(index, "meshes");
    const Json& primitives = document_.member(*mesh, place, "primitives");
    if (!primitives.is_array()) {
      fail(place + "/primitives", "found no array, expected one");
    }
    return {&primitives, place + "/primitives"};
  }

  Accessor accessor(std::size_t index, const std::string& type, std::size_t components) const {
    const auto [json, place] = document_.entry(index, "accessors");
    if (json->contains("sparse")) {
      fail(place + "/sparse",
           "found a sparse accessor, expected a dense one: others are not read; export it with all "
           "values");
    }
    if (document_.member(*json, place, "type") != type) {
      fail(place, "found another kind of accessor, expected one of " + type);
    }
    Accessor result;
    result.component_type =
        static_cast<int>(document_.unsigned_member(*json, place, "componentType"));
    if (type == "VEC3" && result.component_type != formats::kGltfFloat) {
      fail(place + "/componentType",
           "found " + std::to_string(result.component_type) +
               ", expected 5126, floats; convert quantized points to these");
    }
    const std::size_t size = components * size_of(result.component_type, place);
    result.count = document_.unsigned_member(*json, place, "count");
    const auto [view, view_place] =
        document_.entry(document_.unsigned_member(*json, place, "bufferView"), "bufferViews");
    if (document_.unsigned_member(*view, view_place, "buffer") != 0) {
      fail(view_place + "/buffer", "found another buffer, expected 0, the one inside");
    }
    if (document_.entry(0, "buffers").first->contains("uri")) {
      fail("/buffers/0/uri", "found a buffer elsewhere, expected the one inside");
    }
    const std::size_t view_begin = document_.unsigned_member(*view, view_place, "byteOffset", 0);
    const std::size_t view_size = document_.unsigned_member(*view, view_place, "byteLength");
    const std::size_t begin = document_.unsigned_member(*json, place, "byteOffset", 0);
    result.stride = document_.unsigned_member(*view, view_place, "byteStride", size);
    result.begin = view_begin + begin;
    const std::size_t needed =
        result.count == 0 ? 0 : begin + (result.count - 1) * result.stride + size;
    if (view_begin + view_size > bytes_.size()) {
      fail(view_place, "found " + std::to_string(view_size) + " bytes from byte " +
                           std::to_string(view_begin) + ", expected room for them in a buffer of " +
                           std::to_string(bytes_.size()) + " bytes");
    }
    if (result.stride < size || needed > view_size) {
      fail(place, "found " + std::to_string(result.count) + " entries of " + std::to_string(size) +
                      " bytes, " + std::to_string(result.stride) +
                      " apart, expected room for them in a view of " + std::to_string(view_size) +
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
        fail(place + "/componentType",
             "found " + std::to_string(component_type) + ", expected 5121, 5123 or 5125");
    }
  }

  /// Index of the accessor's first point in the mesh; the accessor is read when first met.
  std::uint32_t first_point(std::size_t index, const std::string& place, Geometry& geometry) {
    const auto [known, fresh] =
        first_points_.try_emplace(index, static_cast<std::uint32_t>(geometry.points.size()));
    if (!fresh) {
      return known->second;
    }
    const Accessor points = accessor(index, "VEC3", 3);
    demand_room(12 * (points_ + geometry.points.size() + points.count), place);
    for (std::size_t i = 0; i < points.count; ++i) {
      const auto xyz = text::load<std::array<float, 3>>(bytes_, points.begin + i * points.stride);
      const Vec3 point(xyz[0], xyz[1], xyz[2]);
      if (!point.allFinite()) {
        fail(place + "/attributes/POSITION",
             "found point " + std::to_string(i) + " not finite, expected finite coordinates");
      }
      geometry.points.emplace_back(point.array() + 0.0);  // -0 becomes 0
    }
    return known->second;
  }

  /// Accessors that overlap could ask for any number of points or triangles.
  void demand_room(std::size_t size, const std::string& place) const {
    if (size > bytes_.size()) {
      fail(place, "found more points or triangles than the buffer's " +
                      std::to_string(bytes_.size()) +
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

  /// A primitive's indices, or else all of its points.
  std::vector<std::uint32_t> corners(const Json& primitive, const std::string& place,
                                     std::size_t point_count) {
    std::vector<std::uint32_t> corners;
    const bool has_indices = primitive.contains("indices");
    Accessor indices{.count = point_count, .component_type = formats::kGltfUint32};
    if (has_indices) {
      indices = accessor(document_.unsigned_member(primitive, place, "indices"), "SCALAR", 1);
      demand_room(indices_ += indices.count, place);
    }
    if (indices.component_type == formats::kGltfFloat) {
      fail(place + "/indices", "found floats, expected integers");
    }
    for (std::size_t i = 0; i < indices.count; ++i) {
      const auto index = has_indices ? index_at(indices, i) : static_cast<std::uint32_t>(i);
      if (index >= point_count) {
        fail(place + "/indices", "found index " + std::to_string(index) + " at " +
                                     std::to_string(i) + ", expected less than " +
                                     std::to_string(point_count));
      }
      corners.push_back(index);
    }
    return corners;
  }

  void read_primitive(const Json& primitive, const std::string& place, Geometry& geometry) {
    const std::size_t mode =
        document_.unsigned_member(primitive, place, "mode", formats::kGltfTriangles);
    if (mode < formats::kGltfTriangles) {
      return;  // points and lines are no surface
    }
    if (mode > formats::kGltfFan) {
      fail(place + "/mode",
           "found " + std::to_string(mode) +
               ", expected 4, 5 or 6, triangles, strips and fans of them, or less");
    }
    const std::size_t points = document_.unsigned_member(
        document_.member(primitive, place, "attributes"), place + "/attributes", "POSITION");
    const std::uint32_t first = first_point(points, place, geometry);
    const std::size_t point_count = accessor(points, "VEC3", 3).count;
    const std::vector<std::uint32_t> at = corners(primitive, place, point_count);
    if (mode == formats::kGltfTriangles && at.size() % 3 != 0) {
      const bool has_indices = primitive.contains("indices");
      fail(has_indices ? place + "/indices" : place,
           "found " + std::to_string(at.size()) +
               (has_indices ? " indices, expected three per triangle"
                            : " points and no indices, expected three per triangle"));
    }
    append_triangles(at, static_cast<int>(mode), first, geometry);
    geometry.materials.push_back(material_name(primitive, place));
    geometry.ends.push_back(geometry.triangles.size());
  }

  /// As glTF 2.0 (3.7.2.1) orders them. Strips turn by triangles that are none.
  static void append_triangles(const std::vector<std::uint32_t>& at, int mode, std::uint32_t first,
                               Geometry& geometry) {
    const std::size_t step = mode == formats::kGltfTriangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < at.size(); i += step) {
      const std::size_t odd = mode == formats::kGltfStrip ? i % 2 : 0;
      Triangle t{at[i], at[i + 1 + odd], at[i + 2 - odd]};
      if (mode == formats::kGltfFan) {
        t = {at[i + 1], at[i + 2], at[0]};
      }
      if (step == 3 || (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])) {
        geometry.triangles.push_back({first + t[0], first + t[1], first + t[2]});
      }
    }
  }

  /// Empty if it has no name.
  std::string material_name(const Json& primitive, const std::string& place) const {
    if (!primitive.contains("material")) {
      return {};
    }
    return document_.name(
        *document_.entry(document_.unsigned_member(primitive, place, "material"), "materials")
             .first);
  }

  const formats::GlbDocument& document_;
  std::string_view bytes_;
  TriMesh mesh_;
  text::LabelBuilder labels_;
  std::map<std::size_t, Geometry> meshes_;
  std::map<std::size_t, std::uint32_t> first_points_;  ///< in the mesh that is read, by accessor
  std::size_t points_ = 0;                             ///< of the meshes that were
  std::size_t indices_ = 0;                            ///< of all primitives so far
  std::size_t unfolded_ = 0;
  bool named_ = false;
};

}  // namespace

TriMesh read_glb(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  const formats::GlbDocument document(bytes, file);
  return GlbReader(document).read();
}

std::string unit_of_glb(std::string_view bytes, std::string_view file) {
  const formats::GlbDocument document(bytes, file);
  return formats::is_ours(document) ? formats::noted_unit(document) : "m";
}

}  // namespace dupin
