#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "dupin/io/msh.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/volume_mesh.h"
#include "text/mesh_text.h"
#include "text/polygon.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

constexpr std::int64_t kLargest = std::numeric_limits<std::int32_t>::max();

// Element types: how many nodes they have, and what becomes of them.
enum class Use { surface, solid, left_out };
struct ElementType {
  std::int64_t type;
  std::size_t nodes;
  Use use;
};
constexpr std::array kTypes = {ElementType{1, 2, Use::left_out}, ElementType{2, 3, Use::surface},
                               ElementType{3, 4, Use::surface},  ElementType{4, 4, Use::solid},
                               ElementType{8, 3, Use::left_out}, ElementType{15, 1, Use::left_out}};

class MshReader {
 public:
  MshReader(std::string_view bytes, std::string_view file) : scanner_(bytes, file) {}

  /// The surface; of a mesh with tetrahedra without the nodes inside.
  TriMesh read() && {
    read_sections();
    return tetrahedra_.empty() ? std::move(mesh_)
                               : volume_mesh_of(std::move(mesh_), std::move(tetrahedra_)).surface;
  }

  VolumeMesh read_volume() && {
    read_sections();
    if (tetrahedra_.empty() && !mesh_.triangles.empty()) {
      scanner_.fail("tetrahedra");
    }
    return volume_mesh_of(std::move(mesh_), std::move(tetrahedra_));
  }

 private:
  void read_sections() {
    read_version();
    bool has_elements = false;
    while (!scanner_.at_end()) {
      const std::string_view section = scanner_.token();
      if (section == "$PhysicalNames") {
        read_names();
      } else if (section == "$Nodes") {
        read_nodes();
      } else if (section == "$Elements") {
        read_elements();
        has_elements = true;
      } else if (section.starts_with('$')) {
        skip(section);
      } else {
        scanner_.move_to(scanner_.position() - section.size());
        scanner_.fail("a section, such as $Nodes");
      }
    }
    if (!has_elements) {
      scanner_.fail("the section $Elements");
    }
    if (mesh_.triangles.empty() && !mesh_.points.empty()) {
      scanner_.fail("triangles or quadrangles of the " + std::to_string(mesh_.points.size()) +
                    " nodes");
    }
    if (has_labels_) {
      std::move(labels_).name_labels(mesh_);
    } else {
      mesh_.labels.clear();
    }
  }

  void expect(std::string_view line) {
    scanner_.skip_space();
    if (scanner_.peek() != line) {
      scanner_.fail(line);
    }
    (void)scanner_.token();
    scanner_.end_line("the end of the line behind " + std::string(line));
  }

  void read_version() {
    scanner_.skip_space();
    while (scanner_.peek() == "$Comments") {
      skip(scanner_.token());
      scanner_.skip_space();
    }
    expect("$MeshFormat");
    scanner_.skip_space();
    if (!scanner_.peek().starts_with("2")) {
      scanner_.fail("MSH of version 2 (in gmsh: -format msh22, or Mesh.MshFileVersion = 2.2)");
    }
    (void)scanner_.token();
    if (scanner_.peek() != "0") {
      scanner_.fail("0, for text (in gmsh: without -bin, or Mesh.Binary = 0)");
    }
    (void)scanner_.rest_of_line();
    expect("$EndMeshFormat");
  }

  void skip(std::string_view section) {
    const std::string end = "$End" + std::string(section.substr(1));
    do {
      (void)scanner_.rest_of_line();
      if (scanner_.at_end()) {
        scanner_.fail(end);
      }
    } while (scanner_.peek() != end);
    (void)scanner_.rest_of_line();
  }

  std::int64_t count(std::string_view what) {
    scanner_.skip_space();
    const std::int64_t result = scanner_.integer(0, kLargest, what);
    scanner_.end_line("the end of the line behind a number of things");
    return result;
  }

  void read_names() {
    for (std::int64_t left = count("the number of physical names, an integer"); left > 0; --left) {
      scanner_.skip_space();
      const std::int64_t dimension = scanner_.integer(0, 3, "a dimension, an integer");
      const std::int64_t tag = scanner_.integer(0, kLargest, "a physical group, an integer");
      std::string_view name = scanner_.rest_of_line();
      if (name.size() < 2 || name.front() != '"' || name.back() != '"') {
        scanner_.fail_at(scanner_.position() - 1,
                         "found " + text::quoted(name) + ", expected a name in quotes");
      }
      if (dimension == 2) {
        names_[tag] = text::clean_line(name.substr(1, name.size() - 2));
      }
    }
    expect("$EndPhysicalNames");
  }

  void read_nodes() {
    for (std::int64_t left = count("the number of nodes, an integer"); left > 0; --left) {
      scanner_.skip_space();
      const std::size_t place = scanner_.position();
      const std::int64_t tag = scanner_.integer(1, kLargest, "a node's number, an integer");
      if (!nodes_.emplace(tag, static_cast<std::uint32_t>(mesh_.points.size())).second) {
        scanner_.fail_at(place, "found node " + std::to_string(tag) + " twice, expected it once");
      }
      mesh_.points.push_back(scanner_.vector("a coordinate"));
      scanner_.end_line("the end of the line behind a node");
    }
    expect("$EndNodes");
  }

  void read_elements() {
    for (std::int64_t left = count("the number of elements, an integer"); left > 0; --left) {
      scanner_.skip_space();
      read_element();
    }
    expect("$EndElements");
  }

  void read_element() {
    (void)scanner_.integer(0, kLargest, "an element's number, an integer");
    const std::size_t place = scanner_.position();
    const std::int64_t number = scanner_.integer(1, kLargest, "an element's type, an integer");
    const auto* const type = std::ranges::find(kTypes, number, &ElementType::type);
    if (type == kTypes.end()) {
      scanner_.fail_at(place,
                       "found an element of type " + std::to_string(number) +
                           ", expected triangles (2), quadrangles (3) and tetrahedra (4) of the "
                           "first order");
    }
    std::int64_t physical = 0;
    const std::int64_t tags = scanner_.integer(0, 100, "the number of tags, an integer");
    for (std::int64_t i = 0; i < tags; ++i) {
      const std::int64_t tag = scanner_.integer(-kLargest, kLargest, "a tag, an integer");
      physical = i == 0 ? tag : physical;
    }
    if (type->use == Use::left_out) {
      (void)scanner_.rest_of_line();
      return;
    }
    corners_.clear();
    for (std::size_t i = 0; i < type->nodes; ++i) {
      corners_.push_back(node());
    }
    scanner_.end_line("the end of the line behind an element");
    if (type->use == Use::solid) {
      tetrahedra_.push_back({corners_[0], corners_[1], corners_[2], corners_[3]});
      return;
    }
    text::triangulate(corners_, mesh_.points, mesh_.triangles,
                      [&] { return scanner_.place(scanner_.position()); });
    mesh_.labels.resize(mesh_.triangles.size(), label(physical));
  }

  std::uint32_t node() {
    const std::size_t place = scanner_.position();
    const auto known =
        nodes_.find(scanner_.integer(1, kLargest, "the number of a node, an integer"));
    if (known == nodes_.end()) {
      scanner_.fail_at(place, "found a node that is not there, expected one of $Nodes");
    }
    return known->second;
  }

  std::uint32_t label(std::int64_t physical) {
    has_labels_ = has_labels_ || physical != 0;
    if (!last_label_ || last_label_->first != physical) {
      const auto name = names_.find(physical);
      last_label_ = {physical,
                     labels_.label(name != names_.end() ? name->second
                                   : physical == 0      ? "default"
                                                        : "surface " + std::to_string(physical))};
    }
    return last_label_->second;
  }

  text::TextScanner scanner_;
  TriMesh mesh_;
  text::LabelBuilder labels_;
  std::map<std::int64_t, std::string> names_;
  std::unordered_map<std::int64_t, std::uint32_t> nodes_;
  std::optional<std::pair<std::int64_t, std::uint32_t>> last_label_;
  std::vector<std::uint32_t> corners_;
  std::vector<Tetrahedron> tetrahedra_;
  bool has_labels_ = false;
};

}  // namespace

TriMesh read_msh(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  return MshReader(bytes, file).read();
}

VolumeMesh read_msh_volume(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  return MshReader(bytes, file).read_volume();
}

}  // namespace dupin
