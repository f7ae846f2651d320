#include "formats/three_mf_model.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include "dupin/kernel/error.h"
#include "files/xml_events.h"
#include "formats/placed_mesh.h"
#include "text/mesh_text.h"
#include "text/text_scanner.h"

namespace dupin::formats {
namespace {

constexpr std::size_t kLargestDepth = 100;  // of components in components, and of parts in parts
constexpr std::string_view kPath =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06|path";
constexpr std::string_view kResolution =
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07|meshresolution";

/// Extensions that a model may require: without them its triangles are its shape all the same, or
/// their elements say that they are not.
constexpr std::array<std::string_view, 6> kExtensions = {
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07",
    "http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07"};

constexpr std::array<std::string_view, 6> kUnits = {"micron", "millimeter", "centimeter",
                                                    "inch",   "foot",       "meter"};

/// Elements of extensions in whose place or beside which an object's triangles are not its shape.
constexpr std::array<std::string_view, 4> kOtherShapes = {"beamlattice", "booleanshape",
                                                          "displacementmesh", "levelset"};

[[noreturn]] void fail(const std::string& message) { throw Error(Errc::parse_failed, message); }

std::string_view required(const files::XmlAttributes& attributes, std::string_view name) {
  const auto text = attributes.find(name);
  if (!text) {
    fail("found no attribute '" + std::string(name) + "', expected one");
  }
  return *text;
}

/// Without the white space around it, of which XML Schema's numbers may have some.
std::string_view collapsed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kSpace);
  return first == std::string_view::npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

template <typename Number>
Number number_in(std::string_view text, std::string_view name) {
  Number number{};
  const std::string_view bare = collapsed(text);
  const std::string_view digits = bare.substr(bare.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  bool good = error == std::errc() && end == digits.data() + digits.size();
  std::string_view expected = "an integer of 32 bits";
  if constexpr (std::is_floating_point_v<Number>) {
    good = good && std::isfinite(number);
    expected = error == std::errc::result_out_of_range ? "a number in the range of doubles"
                                                       : "a finite number";
  }
  if (!good) {
    fail("found " + text::quoted(text) + " as '" + std::string(name) + "', expected " +
         std::string(expected));
  }
  return number;
}

std::uint32_t id_of(const files::XmlAttributes& attributes, std::string_view name) {
  return number_in<std::uint32_t>(required(attributes, name), name);
}

std::optional<std::uint32_t> optional_id(const files::XmlAttributes& attributes,
                                         std::string_view name) {
  const auto text = attributes.find(name);
  return text ? std::optional(number_in<std::uint32_t>(*text, name)) : std::nullopt;
}

/// Twelve numbers: the rows of a matrix that row vectors are multiplied with, the shift last.
Transform transform_of(const files::XmlAttributes& attributes) {
  Transform transform;
  const auto text = attributes.find("transform");
  if (!text) {
    return transform;
  }
  std::string_view rest = *text;
  for (int i = 0; i < 12; ++i) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
    const std::string_view token = rest.substr(0, rest.find_first_of(" \t\r\n"));
    rest.remove_prefix(token.size());
    const auto value = number_in<double>(token, "transform");
    (i < 9 ? transform.linear(i % 3, i / 3) : transform.shift[i - 9]) = value;
  }
  if (rest.find_first_not_of(" \t\r\n") != std::string_view::npos) {
    fail("found " + text::quoted(*text) + " as 'transform', expected 12 numbers");
  }
  return transform;
}

struct Object;

struct Component {
  const Object* object = nullptr;
  Transform transform;
};

struct Object {
  std::uint32_t id = 0;
  std::string name;
  bool has_name = true;
  std::optional<std::uint32_t> property_group, property_index;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> labels;  ///< per triangle, into the names of the model
  std::vector<Component> components;
  std::size_t weight = 1;  ///< objects, points and triangles, with those of the components
  std::size_t depth = 0;   ///< levels of components below

  [[nodiscard]] bool says_that_it_is_empty() const { return name == kEmptySet && weight == 1; }
};

/// What one part of the package holds.
struct ModelPart {
  bool is_model = false;
  bool is_read = false;
  std::string unit;
  std::map<std::uint32_t, Object> objects;
  std::vector<Component> items;
};

/// The labels of all parts.
struct Labels {
  text::LabelBuilder builder;
  bool named = false;
};

/// A part by its p:path.
using OtherPart = std::function<const ModelPart&(std::string_view path)>;

/// Collects the resources and the build of one part while the XML runs by.
class ModelReader {
 public:
  ModelReader(ModelPart& part, Labels& labels, OtherPart other)
      : part_(part), labels_(labels), other_(std::move(other)) {}

  void begin(std::string_view element, const files::XmlAttributes& attributes) {
    if (element == "vertex") {
      add_vertex(attributes);
    } else if (element == "triangle") {
      add_triangle(attributes);
    } else if (element == "base") {
      if (!materials_.empty()) {
        materials_[group_].push_back(text::clean_line(required(attributes, "name")));
      }
    } else if (element == "basematerials") {
      group_ = id_of(attributes, "id");
      materials_[group_].clear();
    } else if (element == "object") {
      begin_object(attributes);
    } else if (element == "component") {
      add_component(attributes);
    } else if (element == "item") {
      add_item(attributes);
    } else if (element == "build") {
      require_first(std::exchange(has_build_, true), element);
    } else if (element == "model") {
      begin_model(attributes);
    } else {
      refuse_other_shape(element);
    }
  }

  /// An element whose shape is that of no triangles, of whatever namespace.
  static void refuse_other_shape(std::string_view element) {
    if (std::ranges::find(kOtherShapes, element) != kOtherShapes.end()) {
      fail("found the element '" + std::string(element) +
           "', whose shape is not read, expected triangles and components");
    }
  }

  void end(std::string_view element) {
    if (element == "object") {
      object_ = nullptr;
    } else if (element == "build" && part_.items.empty()) {
      fail("found a build without items, expected what it is to show");
    }
  }

 private:
  Object& open_object(std::string_view child) {
    if (object_ == nullptr) {
      fail("found the element '" + std::string(child) +
           "' outside of an object, expected it inside");
    }
    return *object_;
  }

  static void require_first(bool has_one, std::string_view element) {
    if (has_one) {
      fail("found a second element '" + std::string(element) + "', expected one");
    }
  }

  void begin_model(const files::XmlAttributes& attributes) {
    require_first(std::exchange(part_.is_model, true), "model");
    part_.unit = attributes.find("unit").value_or("millimeter");
    if (std::ranges::find(kUnits, part_.unit) == kUnits.end()) {
      fail("found the unit " + text::quoted(part_.unit) +
           ", expected micron, millimeter, centimeter, inch, foot or meter");
    }
    std::istringstream prefixes{std::string(attributes.find("requiredextensions").value_or(""))};
    for (std::string prefix; prefixes >> prefix;) {
      const auto space = attributes.spaces().find(prefix);
      const std::string name = space == attributes.spaces().end() ? prefix : space->second;
      if (std::ranges::find(kExtensions, name) == kExtensions.end()) {
        fail("found " + text::quoted(name) +
             " among the required extensions, expected those of production, materials, slices, "
             "beam lattices and sets of triangles only");
      }
    }
  }

  /// The object that an item or a component names, in this part or in another.
  const Object& known_object(const files::XmlAttributes& attributes) const {
    const std::uint32_t id = id_of(attributes, "objectid");
    const auto path = attributes.find(kPath);
    const ModelPart& part = path ? other_(*path) : part_;
    const auto found = part.objects.find(id);
    if (found == part.objects.end() || &found->second == object_) {
      fail("found object " + std::to_string(id) + ", expected the id of an object " +
           (&part == &part_ ? "before it" : "of the part " + text::quoted(*path)));
    }
    return found->second;
  }

  void begin_object(const files::XmlAttributes& attributes) {
    if (object_ != nullptr) {
      fail("found an object inside of an object, expected it beside that");
    }
    const std::uint32_t id = id_of(attributes, "id");
    const auto [place, fresh] = part_.objects.try_emplace(id);
    if (!fresh) {
      fail("found a second object " + std::to_string(id) + ", expected a new id");
    }
    object_ = &place->second;
    object_->id = id;
    object_->name = text::clean_line(attributes.find("name").value_or(""));
    object_->property_group = optional_id(attributes, "pid");
    object_->property_index = optional_id(attributes, "pindex");
    if (attributes.find(kResolution) == "lowres") {
      fail(
          "found a mesh of low resolution beside slices, which are not read, expected one of full "
          "resolution");
    }
    const bool other = attributes.find("type").value_or("model") != "model";
    labels_.named = labels_.named || (!object_->name.empty() && !other);
    object_->has_name = !object_->name.empty();
    if (!object_->has_name) {
      object_->name = "object " + std::to_string(id);
    }
  }

  void add_vertex(const files::XmlAttributes& attributes) {
    const auto coordinate = [&](std::string_view axis) {
      return number_in<double>(required(attributes, axis), axis) + 0.0;  // -0 becomes 0
    };
    const double x = coordinate("x");
    const double y = coordinate("y");
    const double z = coordinate("z");
    Object& object = open_object("vertex");
    object.points.emplace_back(x, y, z);
    ++object.weight;
  }

  void add_triangle(const files::XmlAttributes& attributes) {
    Object& object = open_object("triangle");
    Triangle triangle;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      constexpr std::array<std::string_view, 3> kNames = {"v1", "v2", "v3"};
      triangle[corner] = id_of(attributes, kNames[corner]);
      if (triangle[corner] >= object.points.size()) {
        fail("found " + std::to_string(triangle[corner]) + " as '" + std::string(kNames[corner]) +
             "', expected the index of one of the " + std::to_string(object.points.size()) +
             " vertices");
      }
    }
    object.triangles.push_back(triangle);
    object.labels.push_back(label_of(object, attributes));
    ++object.weight;
  }

  /// The material of the triangle's own, or of an object without a name; else that name.
  std::uint32_t label_of(const Object& object, const files::XmlAttributes& attributes) {
    const auto own_index = optional_id(attributes, "p1");
    const auto own_group = optional_id(attributes, "pid");
    const auto group = own_group ? own_group : object.property_group;
    const auto index =
        own_index || own_group || object.has_name ? own_index : object.property_index;
    if (index && group) {
      const auto found = materials_.find(*group);
      if (found != materials_.end()) {
        if (*index >= found->second.size()) {
          fail("found " + std::to_string(*index) + " as '" + (own_index ? "p1" : "pindex") +
               "', expected the index of one of the " + std::to_string(found->second.size()) +
               " base materials");
        }
        labels_.named = true;
        return labels_.builder.label(found->second[*index]);
      }
    }
    return labels_.builder.label(object.name);
  }

  void add_component(const files::XmlAttributes& attributes) {
    Object& object = open_object("component");
    const Object& child = known_object(attributes);
    object.weight += child.weight;
    object.depth = std::max(object.depth, child.depth + 1);
    require_size(object.weight, object.depth);
    object.components.push_back({&child, transform_of(attributes)});
  }

  void add_item(const files::XmlAttributes& attributes) {
    const Object& object = known_object(attributes);
    weight_ += object.weight;
    require_size(weight_, 0);
    part_.items.push_back({&object, transform_of(attributes)});
  }

  static void require_size(std::size_t weight, std::size_t depth) {
    if (weight > kLargestUnfolding || depth > kLargestDepth) {
      throw Error(Errc::limit_exceeded, "the components unfold to more than " +
                                            std::to_string(kLargestUnfolding) +
                                            " points and triangles, or lie more than " +
                                            std::to_string(kLargestDepth) + " levels deep");
    }
  }

  ModelPart& part_;
  Labels& labels_;
  OtherPart other_;
  std::map<std::uint32_t, std::vector<std::string>> materials_;
  std::uint32_t group_ = 0;
  Object* object_ = nullptr;
  std::size_t weight_ = 0;
  bool has_build_ = false;
};

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

/// The parts of a package, each read when it is first named.
class Model {
 public:
  explicit Model(const ModelSource& source) : source_(source) {}

  const ModelPart& read(const std::string& name) {
    // The names of parts are equal in any case (ECMA-376 part 2).
    const auto [place, fresh] = parts_.try_emplace(lower_case(name));
    ModelPart& part = place->second;
    if (!fresh) {
      return part;
    }
    if (++depth_ > kLargestDepth) {
      throw Error(Errc::limit_exceeded,
                  "parts name parts more than " + std::to_string(kLargestDepth) + " levels deep");
    }
    const ModelText text = source_(name);
    root_place_ = depth_ == 1 ? text.place : root_place_;
    ModelReader reader(part, labels_, [&](std::string_view path) -> const ModelPart& {
      return other(path, part);
    });
    files::read_xml(text.xml, text.place,
                    {[&](std::string_view element, const files::XmlAttributes& attributes) {
                       // Builds are those of the root.
                       if (depth_ == 1 || element != "item") {
                         reader.begin(element, attributes);
                       }
                       if (element == "model") {
                         require_unit(part);
                       }
                       return true;
                     },
                     [&](std::string_view element) {
                       if (depth_ == 1 || element != "build") {
                         reader.end(element);
                       }
                     },
                     {},
                     ModelReader::refuse_other_shape});
    if (!part.is_model) {
      throw Error(Errc::parse_failed, "found no element 'model', expected one", {}, text.place);
    }
    --depth_;
    part.is_read = true;
    return part;
  }

  /// What the root shows.
  TriMesh build(const ModelPart& root) && {
    TriMesh mesh;
    bool says_that_it_is_empty = true;
    for (const Component& item : root.items) {
      append(*item.object, item.transform, mesh);
      says_that_it_is_empty = says_that_it_is_empty && item.object->says_that_it_is_empty();
    }
    if (root.items.empty()) {
      fail_in_root("found no build, expected one with items");
    }
    if (mesh.triangles.empty() && !says_that_it_is_empty) {
      fail_in_root("found a build of objects without triangles, expected some");
    }
    if (labels_.named) {
      std::move(labels_.builder).name_labels(mesh);
    } else {
      mesh.labels.clear();
    }
    return mesh;
  }

 private:
  const ModelPart& other(std::string_view path, const ModelPart& from) {
    if (!path.starts_with('/')) {
      fail("found " + text::quoted(path) + " as path, expected a part, such as '/3D/part.model'");
    }
    const ModelPart& part = read(std::string(path.substr(1)));
    if (!part.is_read && &part != &from) {
      fail("found the part " + text::quoted(path) + " inside of itself, expected no circle");
    }
    return part;
  }

  /// Lengths of another unit would be taken for what they are not.
  void require_unit(const ModelPart& part) {
    if (depth_ == 1) {
      unit_ = part.unit;
    } else if (part.unit != unit_) {
      fail("found the unit " + text::quoted(part.unit) + ", expected that of the root, " +
           text::quoted(unit_));
    }
  }

  [[noreturn]] void fail_in_root(const std::string& message) const {
    throw Error(Errc::parse_failed, message, {}, root_place_);
  }

  void append(const Object& object, const Transform& transform, TriMesh& mesh) const {
    if (!append_placed(object.points, object.triangles, transform, mesh)) {
      fail_in_root("found a transformation of object " + std::to_string(object.id) +
                   " beyond the range of doubles, expected finite coordinates");
    }
    mesh.labels.insert(mesh.labels.end(), object.labels.begin(), object.labels.end());
    for (const Component& component : object.components) {
      append(*component.object, transform.after(component.transform), mesh);
    }
  }

  const ModelSource& source_;
  std::map<std::string, ModelPart> parts_;
  Labels labels_;
  std::string unit_, root_place_;
  std::size_t depth_ = 0;
};

}  // namespace

TriMesh read_3mf_model(const std::string& root, const ModelSource& source) {
  Model model(source);
  const ModelPart& part = model.read(root);
  return std::move(model).build(part);
}

}  // namespace dupin::formats
