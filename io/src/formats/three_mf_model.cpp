#include "formats/three_mf_model.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "dupin/kernel/error.h"
#include "files/xml_events.h"
#include "text/mesh_text.h"
#include "text/text_scanner.h"

namespace dupin::formats {
namespace {

// Components can repeat components, so that a few lines may ask for any amount of work and depth.
constexpr std::size_t kLargestWeight = 300'000'000;
constexpr std::size_t kLargestDepth = 100;

[[noreturn]] void fail(const std::string& message) { throw Error(Errc::parse_failed, message); }

std::string_view required(const files::XmlAttributes& attributes, std::string_view name) {
  const auto text = attributes.find(name);
  if (!text) {
    fail("found no attribute '" + std::string(name) + "', expected one");
  }
  return *text;
}

template <typename Number>
Number number_in(std::string_view text, std::string_view name) {
  Number number{};
  const std::string_view digits = text.substr(text.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  bool good = error == std::errc() && end == digits.data() + digits.size();
  if constexpr (std::is_floating_point_v<Number>) {
    good = good && std::isfinite(number);
  }
  if (!good) {
    fail("found " + text::quoted(text) + " as '" + std::string(name) + "', expected " +
         (std::is_floating_point_v<Number> ? "a finite number" : "an integer of 32 bits"));
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

/// point -> linear * point + shift
struct Transform {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] Transform after(const Transform& inner) const {
    return {linear * inner.linear, linear * inner.shift + shift};
  }
  [[nodiscard]] bool is_identity() const {
    return linear == Eigen::Matrix3d::Identity() && shift == Vec3::Zero();
  }
};

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

struct Component {
  std::uint32_t object = 0;
  Transform transform;
};

struct Object {
  std::string name;
  std::optional<std::uint32_t> property_group;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> labels;  ///< per triangle, into the names of the model
  std::vector<Component> components;
  std::size_t weight = 1;  ///< objects, points and triangles, with those of the components
  std::size_t depth = 0;   ///< levels of components below
};

/// Collects the resources and the build while the XML runs by.
class ModelReader {
 public:
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
    } else if (element == "model") {
      is_model_ = true;
    }
  }

  void end(std::string_view element) {
    if (element == "object") {
      object_ = nullptr;
    }
  }

  TriMesh build() && {
    if (!is_model_) {
      fail("found no element 'model', expected one");
    }
    TriMesh mesh;
    for (const Component& item : items_) {
      append(item.object, item.transform, mesh);
    }
    if (named_) {
      std::move(labels_).name_labels(mesh);
    } else {
      mesh.labels.clear();
    }
    return mesh;
  }

 private:
  Object& open_object(std::string_view child) {
    if (object_ == nullptr) {
      fail("found the element '" + std::string(child) +
           "' outside of an object, expected it inside");
    }
    return *object_;
  }

  const Object& known_object(std::uint32_t id) const {
    const auto found = objects_.find(id);
    if (found == objects_.end() || &found->second == object_) {
      fail("found object " + std::to_string(id) + ", expected the id of an object before it");
    }
    return found->second;
  }

  void begin_object(const files::XmlAttributes& attributes) {
    const std::uint32_t id = id_of(attributes, "id");
    const auto [place, fresh] = objects_.try_emplace(id);
    if (!fresh) {
      fail("found a second object " + std::to_string(id) + ", expected a new id");
    }
    object_ = &place->second;
    object_->name = text::clean_line(attributes.find("name").value_or(""));
    object_->property_group = optional_id(attributes, "pid");
    const bool other = attributes.find("type").value_or("model") != "model";
    named_ = named_ || (!object_->name.empty() && !other);
    if (object_->name.empty()) {
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

  std::uint32_t label_of(const Object& object, const files::XmlAttributes& attributes) {
    const auto index = optional_id(attributes, "p1");
    const auto own_group = optional_id(attributes, "pid");
    const auto group = own_group ? own_group : object.property_group;
    if (index && group) {
      const auto found = materials_.find(*group);
      if (found != materials_.end()) {
        if (*index >= found->second.size()) {
          fail("found " + std::to_string(*index) + " as 'p1', expected the index of one of the " +
               std::to_string(found->second.size()) + " base materials");
        }
        named_ = true;
        return labels_.label(found->second[*index]);
      }
    }
    return labels_.label(object.name);
  }

  void add_component(const files::XmlAttributes& attributes) {
    Object& object = open_object("component");
    const std::uint32_t id = id_of(attributes, "objectid");
    const Object& child = known_object(id);
    object.weight += child.weight;
    object.depth = std::max(object.depth, child.depth + 1);
    require_size(object.weight, object.depth);
    object.components.push_back({id, transform_of(attributes)});
  }

  void add_item(const files::XmlAttributes& attributes) {
    const std::uint32_t id = id_of(attributes, "objectid");
    weight_ += known_object(id).weight;
    require_size(weight_, 0);
    items_.push_back({id, transform_of(attributes)});
  }

  static void require_size(std::size_t weight, std::size_t depth) {
    if (weight > kLargestWeight || depth > kLargestDepth) {
      throw Error(Errc::limit_exceeded, "the components unfold to more than " +
                                            std::to_string(kLargestWeight) +
                                            " points and triangles, or lie more than " +
                                            std::to_string(kLargestDepth) + " levels deep");
    }
  }

  void append(std::uint32_t id, const Transform& transform, TriMesh& mesh) const {
    const Object& object = objects_.at(id);
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const bool plain = transform.is_identity();
    const bool mirrored = transform.linear.determinant() < 0;
    for (const Vec3& point : object.points) {
      mesh.points.push_back(plain ? point : Vec3(transform.linear * point + transform.shift));
      if (!mesh.points.back().allFinite()) {
        fail("found a transformation of object " + std::to_string(id) +
             " beyond the range of doubles, expected finite coordinates");
      }
    }
    for (const Triangle& t : object.triangles) {
      mesh.triangles.push_back(
          {first + t[0], first + t[mirrored ? 2 : 1], first + t[mirrored ? 1 : 2]});
    }
    mesh.labels.insert(mesh.labels.end(), object.labels.begin(), object.labels.end());
    for (const Component& component : object.components) {
      append(component.object, transform.after(component.transform), mesh);
    }
  }

  std::map<std::uint32_t, std::vector<std::string>> materials_;
  std::map<std::uint32_t, Object> objects_;
  std::vector<Component> items_;
  text::LabelBuilder labels_;
  std::uint32_t group_ = 0;
  Object* object_ = nullptr;
  std::size_t weight_ = 0;
  bool named_ = false;
  bool is_model_ = false;
};

}  // namespace

TriMesh read_3mf_model(std::string_view xml, const std::string& place) {
  ModelReader reader;
  files::read_xml(xml, place,
                  {[&](std::string_view element, const files::XmlAttributes& attributes) {
                     reader.begin(element, attributes);
                     return true;
                   },
                   [&](std::string_view element) { reader.end(element); }});
  try {
    return std::move(reader).build();
  } catch (const Error& error) {
    throw Error(error.code(), error.message(), {}, place);
  }
}

}  // namespace dupin::formats
