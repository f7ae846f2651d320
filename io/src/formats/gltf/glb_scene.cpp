#include "formats/gltf/glb_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "formats/gltf/glb_layout.h"
#include "text/known_unit.h"

namespace dupin::formats {
namespace {

using Json = GlbDocument::Json;

/// Numbers of a node's member, or these if there is none.
template <std::size_t kCount>
std::array<double, kCount> numbers(const GlbDocument& document, const Json& node,
                                   const std::string& place, const std::string& key,
                                   std::array<double, kCount> values) {
  if (!node.contains(key)) {
    return values;
  }
  const Json& list = node[key];
  bool good = list.is_array() && list.size() == kCount;
  for (std::size_t i = 0; good && i < kCount; ++i) {
    good = list[i].is_number();
    values[i] = good ? list[i].template get<double>() : 0;
    good = good && std::isfinite(values[i]);
  }
  if (!good) {
    document.fail(place + "/" + key,
                  "found something else, expected " + std::to_string(kCount) + " finite numbers");
  }
  return values;
}

/// A quaternion's turn. Quarter turns, whose quaternions no decimal holds, are exact.
Eigen::Matrix3d turn(const std::array<double, 4>& q) {
  const Eigen::Matrix3d matrix =
      Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized().toRotationMatrix();
  constexpr double kNearlyWhole = 0x1p-22;  // as far as those of binary32 are off
  const Eigen::Matrix3d whole = matrix.array().round();
  return (matrix - whole).cwiseAbs().maxCoeff() < kNearlyWhole ? whole : matrix;
}

Transform transform_of(const GlbDocument& document, const Json& node, const std::string& place) {
  Transform transform;
  if (node.contains("matrix")) {
    const auto m = numbers<16>(document, node, place, "matrix", {});
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        const double value =
            m.at(4 * static_cast<std::size_t>(column) + static_cast<std::size_t>(row));
        (column < 3 ? transform.linear(row, column) : transform.shift[row]) = value;
      }
    }
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
      document.fail(place + "/matrix", "found a projection, expected 0, 0, 0, 1 in the last row");
    }
    return transform;
  }
  const auto scale = numbers<3>(document, node, place, "scale", {1, 1, 1});
  const auto rotation = numbers<4>(document, node, place, "rotation", {0, 0, 0, 1});
  if (std::all_of(rotation.begin(), rotation.end(), [](double x) { return x == 0; })) {
    document.fail(place + "/rotation", "found a quaternion of zeros, expected a turn");
  }
  const auto shift = numbers<3>(document, node, place, "translation", {0, 0, 0});
  transform.linear = turn(rotation) * Vec3(scale[0], scale[1], scale[2]).asDiagonal();
  transform.shift = Vec3(shift[0], shift[1], shift[2]);
  return transform;
}

/// Indices of nodes in a list of the document.
std::vector<std::size_t> node_list(const GlbDocument& document, const Json& json,
                                   const std::string& place, const std::string& key) {
  std::vector<std::size_t> nodes;
  if (!json.is_object() || !json.contains(key)) {
    return nodes;
  }
  if (!json[key].is_array()) {
    document.fail(place + "/" + key, "found no array, expected one");
  }
  const std::string list = place + "/" + key + "/";
  for (std::size_t i = 0; i < json[key].size(); ++i) {
    nodes.push_back(document.unsigned_value(json[key][i], list + std::to_string(i)));
  }
  return nodes;
}

/// The nodes at the top, and the place that names them.
std::pair<std::vector<std::size_t>, std::string> roots(const GlbDocument& document) {
  if (document.count("scenes") > 0) {
    const auto [scene, place] =
        document.entry(document.unsigned_member(document.json(), "", "scene", 0), "scenes");
    return {node_list(document, *scene, place, "nodes"), place};
  }
  const std::size_t count = document.count("nodes");
  std::vector<bool> is_child(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [node, place] = document.entry(i, "nodes");
    for (const std::size_t child : node_list(document, *node, place, "children")) {
      if (child < count) {
        is_child[child] = true;
      }
    }
  }
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_child[i]) {
      nodes.push_back(i);
    }
  }
  return {nodes, "/nodes"};
}

/// The scene that our writer makes of a mesh without triangles.
bool is_empty_set(const GlbDocument& document, const std::vector<std::size_t>& roots) {
  return roots.empty() && document.count("scenes") == 1 &&
         document.name(document.json()["scenes"][0]) == kEmptySet;
}

/// Whether node 0 turns and scales as our writer has it for the unit that it notes, and no more.
bool has_our_place(const GlbDocument& document) {
  const Json& node = document.json()["nodes"][0];
  if (!node.is_object() || node.contains("matrix") || node.contains("translation") ||
      !node.contains("rotation") || node["rotation"] != Json({-kGlbHalfTurn, 0, 0, kGlbHalfTurn})) {
    return false;
  }
  const std::string unit = noted_unit(document);
  if (unit.empty()) {
    return !node.contains("scale");
  }
  const std::optional<double> scale = text::metres_in(unit);
  return scale && node.contains("scale") && node["scale"] == Json({*scale, *scale, *scale});
}

/// Walks down from the roots, without recursion: nodes may be as deep as the file is long.
class Walk {
 public:
  explicit Walk(const GlbDocument& document)
      : document_(document), seen_(document.count("nodes"), false) {}

  std::vector<MeshInstance> meshes(const std::vector<std::size_t>& roots) && {
    const bool is_ours = formats::is_ours(document_);
    push(roots, {});
    while (!open_.empty()) {
      const auto [index, parent] = open_.back();
      open_.pop_back();
      visit(index, parent, is_ours);
    }
    return std::move(found_);
  }

 private:
  void push(const std::vector<std::size_t>& nodes, const Transform& parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
      open_.emplace_back(*node, parent);
    }
  }

  /// What is shown would be another shape than the mesh at its place.
  void require_plain(const Json& node, const std::string& place) const {
    if (node.contains("skin")) {
      document_.fail(place + "/skin", "found a skin, whose pose is not read, expected none");
    }
    if (node.contains(Json::json_pointer("/extensions/EXT_mesh_gpu_instancing"))) {
      document_.fail(place + "/extensions",
                     "found instances of a mesh, which are not read, expected a node for each");
    }
    require_no_weights(document_, node, place);
  }

  void visit(std::size_t index, const Transform& parent, bool is_ours) {
    const auto [node, place] = document_.entry(index, "nodes");
    if (!node->is_object()) {
      document_.fail(place, "found no object, expected one");
    }
    if (seen_[index]) {
      document_.fail(place, "found a node that is met twice, expected no circle and one parent");
    }
    seen_[index] = true;
    const Transform own = is_ours ? Transform() : transform_of(document_, *node, place);
    const Transform transform = parent.after(own);
    if (node->contains("mesh")) {
      require_plain(*node, place);
      const std::size_t mesh = document_.unsigned_member(*node, place, "mesh");
      std::string name = document_.name(*node);
      if (name.empty()) {
        name = document_.name(*document_.entry(mesh, "meshes").first);
      }
      found_.push_back({mesh, std::move(name), transform});
    }
    push(node_list(document_, *node, place, "children"), transform);
  }

  const GlbDocument& document_;
  std::vector<bool> seen_;
  std::vector<std::pair<std::size_t, Transform>> open_;
  std::vector<MeshInstance> found_;
};

}  // namespace

void require_no_weights(const GlbDocument& document, const Json& json, const std::string& place) {
  const Json weights = json.is_object() ? json.value("weights", Json::array()) : Json::array();
  if (std::ranges::any_of(weights, [](const Json& weight) { return weight != 0; })) {
    document.fail(place + "/weights",
                  "found weights of other shapes, which are not read, expected none but 0");
  }
}

bool names_our_writer(const GlbDocument& document) {
  return document.json().contains("asset") &&
         document.name(document.json()["asset"], "generator") == kGlbGenerator;
}

std::string noted_unit(const GlbDocument& document) {
  const Json::json_pointer place("/asset/extras");
  return document.json().contains(place) ? document.name(document.json()[place], "unit")
                                         : std::string();
}

bool is_ours(const GlbDocument& document) {
  if (!names_our_writer(document)) {
    return false;
  }
  const auto [top, place] = roots(document);
  const std::size_t count = document.count("nodes");
  if (count == 0) {
    return is_empty_set(document, top);
  }
  if (top != std::vector<std::size_t>{0} || !has_our_place(document)) {
    return false;
  }
  for (std::size_t i = 1; i < count; ++i) {
    for (const char* const key : {"matrix", "rotation", "scale", "translation", "children"}) {
      const Json& node = document.json()["nodes"][i];
      if (node.is_object() && node.contains(key)) {
        return false;
      }
    }
  }
  return true;
}

std::vector<MeshInstance> shown_meshes(const GlbDocument& document) {
  std::vector<MeshInstance> meshes;
  if (document.count("scenes") == 0 && document.count("nodes") == 0) {
    for (std::size_t i = 0; i < document.count("meshes"); ++i) {
      meshes.push_back({i, document.name(*document.entry(i, "meshes").first), {}});
    }
    if (meshes.empty()) {
      document.fail("/meshes", "found no mesh, expected one");
    }
    return meshes;
  }
  const auto [nodes, place] = roots(document);
  meshes = Walk(document).meshes(nodes);
  if (meshes.empty() && !is_empty_set(document, nodes)) {
    document.fail(place, "found no mesh, expected one that a node shows");
  }
  return meshes;
}

}  // namespace dupin::formats
