#include "dupin/io/place_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "dupin/io/assembly_json.h"
#include "dupin/kernel/parallel.h"
#include "json/expansion.h"
#include "json/json_document.h"
#include "text/byte_order_mark.h"

namespace dupin {
namespace {

using json::Json;

/// What the numbers of a key are.
enum class Meaning {
  other,      ///< what a placement does not change
  point,      ///< [x, y, z]
  direction,  ///< [x, y, z]
  length,     ///< a number, or lists of them
  sphere,     ///< [x, y, z, radius], or a list of them
  tangent,    ///< [x, y, z, slope]
};

struct Row {
  std::string_view key;
  Meaning meaning;
};

/// All keys of a document whose numbers change. A key means the same in all parts; a number where a
/// point could be ("sphere" of a tangent) is none.
constexpr std::array<Row, 41> kRows{{
    {"tolerance", Meaning::length},
    {"from", Meaning::point},
    {"to", Meaning::point},
    {"corner", Meaning::point},
    {"center", Meaning::point},
    {"point", Meaning::point},
    {"sphere", Meaning::point},
    {"apex", Meaning::point},
    {"direction", Meaning::direction},
    {"normal", Meaning::direction},
    {"toward", Meaning::direction},
    {"axis", Meaning::direction},
    {"ruling", Meaning::direction},
    {"radius", Meaning::length},
    {"radii", Meaning::length},
    {"semi_axes", Meaning::length},
    {"end_semi_axes", Meaning::length},
    {"end_radius", Meaning::length},
    {"length", Meaning::length},
    {"bend_radius", Meaning::length},
    {"reach", Meaning::length},
    {"k", Meaning::length},
    {"l", Meaning::length},
    {"wall", Meaning::length},
    {"clearance", Meaning::length},
    {"insulation", Meaning::length},
    {"outside_diameter", Meaning::length},
    {"inside_diameter", Meaning::length},
    {"thickness", Meaning::length},
    {"at", Meaning::length},
    {"depth", Meaning::length},
    {"crown", Meaning::length},
    {"knuckle", Meaning::length},
    {"fillet", Meaning::length},
    {"spheres", Meaning::sphere},
    {"tangent", Meaning::tangent},
    {"angle", Meaning::other},
    {"cap_angles", Meaning::other},
    {"smoothness", Meaning::other},
    {"slope", Meaning::other},
    {"segments", Meaning::other},
}};

Meaning meaning_of(std::string_view key) {
  const auto row =
      std::find_if(kRows.begin(), kRows.end(), [&](const Row& r) { return r.key == key; });
  return row == kRows.end() ? Meaning::other : row->meaning;
}

/// Goes once over JSON text that is known to be valid and no deeper than documents are, and copies
/// it but for the numbers that change.
class Rewriter {
 public:
  Rewriter(std::string_view text, const Placement& placement) : text_(text), placement_(placement) {
    result_.is_exact = placement.is_exact();
  }

  PlacedDocument rewritten() && {
    copy_to(text::byte_order_mark(text_));
    copy_space();
    value(Meaning::other);
    copy_space();
    result_.largest_move += placement_.error(radius_);
    return std::move(result_);
  }

 private:
  void value(Meaning meaning) {
    if (text_[at_] == '{') {
      object();
    } else if (text_[at_] == '[') {
      array(meaning);
    } else if (text_[at_] == '"') {
      copy_to(end_of_string());
    } else {
      const std::size_t begin = at_;
      const double number = this->number();
      if (meaning == Meaning::length && std::isfinite(number)) {
        replace(begin, {number}, {nearest(placement_.scaled(number), true)});
      } else {
        at_ = begin;
        copy_to(end_of_literal());
      }
    }
  }

  void object() {
    copy_to(at_ + 1);
    for (copy_space(); text_[at_] != '}'; copy_space()) {
      const std::size_t begin = at_;
      copy_to(end_of_string());
      const auto key = Json::parse(text_.substr(begin, at_ - begin)).get<std::string>();
      copy_space();
      copy_to(at_ + 1);  // the colon
      copy_space();
      value(meaning_of(key));
      copy_comma();
    }
    copy_to(at_ + 1);
  }

  void array(Meaning meaning) {
    const bool has_coordinates = meaning != Meaning::other && meaning != Meaning::length;
    if (has_coordinates && coordinates(meaning)) {
      return;
    }
    copy_to(at_ + 1);
    for (copy_space(); text_[at_] != ']'; copy_space()) {
      value(meaning);
      copy_comma();
    }
    copy_to(at_ + 1);
  }

  /// Takes [x, y, z] or [x, y, z, w]; takes nothing of another array.
  bool coordinates(Meaning meaning) {
    const std::size_t begin = at_++;
    std::vector<double> numbers;
    for (skip_space(); is_number(); skip_space()) {
      numbers.push_back(number());
      skip_space();
      at_ += text_[at_] == ',' ? 1 : 0;
    }
    const bool has_fourth = meaning == Meaning::sphere || meaning == Meaning::tangent;
    if (text_[at_] != ']' || numbers.size() != (has_fourth ? 4U : 3U)) {
      at_ = begin;
      return false;
    }
    ++at_;
    const Vec3 before(numbers[0], numbers[1], numbers[2]);
    const bool is_place = meaning == Meaning::point || meaning == Meaning::sphere;
    radius_ = std::max(radius_, is_place ? before.stableNorm() : 0);
    const Placement::Point exact = is_place ? placement_.place(before) : placement_.turn(before);
    std::vector<double> after;
    for (const mpq_class& coordinate : exact) {
      after.push_back(nearest(coordinate, is_place));
    }
    if (has_fourth) {
      after.push_back(meaning == Meaning::sphere ? nearest(placement_.scaled(numbers[3]), true)
                                                 : numbers[3]);
    }
    replace(begin, numbers, after);
    return true;
  }

  double nearest(const mpq_class& exact, bool is_length) {
    const double held = nearest_point({exact, 0, 0}).x();
    if (!std::isfinite(held)) {
      throw Error(Errc::invalid_argument, "a number is put out of the range of doubles");
    }
    if (const mpq_class move = abs(mpq_class(held) - exact); move != 0) {
      result_.is_exact = false;
      // Of a point at most three coordinates move as far.
      result_.largest_move = std::max(result_.largest_move, is_length ? 2 * move.get_d() : 0);
    }
    return held + 0.0;
  }

  /// Writes the numbers that were read from `begin` to here as they are now.
  void replace(std::size_t begin, const std::vector<double>& before,
               const std::vector<double>& after) {
    const bool is_list = text_[begin] == '[';
    if (before == after) {
      result_.text += text_.substr(begin, at_ - begin);
      return;
    }
    std::string_view separator = is_list ? "[" : "";
    for (std::size_t i = 0; i < after.size(); ++i) {
      result_.text += separator;
      result_.text += Json(after[i]).dump();
      separator = ", ";
    }
    result_.text += is_list ? "]" : "";
  }

  [[nodiscard]] bool is_number() const {
    return text_[at_] == '-' || (text_[at_] >= '0' && text_[at_] <= '9');
  }
  /// Takes the number here; not a number for another literal.
  double number() {
    const std::size_t begin = at_;
    const bool is = is_number();
    at_ = end_of_literal();
    return is ? Json::parse(text_.substr(begin, at_ - begin)).get<double>() : std::nan("");
  }
  [[nodiscard]] std::size_t end_of_literal() const {
    return std::min(text_.find_first_of(" \t\r\n,]}", at_), text_.size());
  }
  [[nodiscard]] std::size_t end_of_string() const {
    std::size_t end = at_ + 1;
    while (text_[end] != '"') {
      end += text_[end] == '\\' ? 2 : 1;
    }
    return end + 1;
  }
  void skip_space() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }
  void copy_to(std::size_t end) {
    result_.text += text_.substr(at_, end - at_);
    at_ = end;
  }
  void copy_space() { copy_to(std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size())); }
  void copy_comma() {
    copy_space();
    if (text_[at_] == ',') {
      copy_to(at_ + 1);
    }
  }

  std::string_view text_;
  const Placement& placement_;
  std::size_t at_ = 0;
  double radius_ = 0;  ///< of a point, from the origin, before
  PlacedDocument result_;
};

const Avoidance* avoidance_of(const auto& shape) {
  if constexpr (requires { shape.avoid; }) {
    return shape.avoid ? &*shape.avoid : nullptr;
  } else {
    return nullptr;
  }
}

// Files stay as they are.
void refuse_meshes(const Part& part) {
  const Avoidance* avoid =
      std::visit([](const auto& shape) { return avoidance_of(shape); }, part.shape);
  if (avoid == nullptr) {
    return;
  }
  for (const auto& obstacle : avoid->obstacles) {
    if (const auto* mesh = std::get_if<MeshObstacle>(&obstacle)) {
      throw Error(Errc::invalid_argument, "part '" + part.name + "' avoids the mesh '" +
                                              mesh->file +
                                              "', which would stay where it is: put the mesh in "
                                              "its place by itself, and name that one");
    }
  }
}

}  // namespace

PlacedDocument placed_document(std::string_view text, const std::string& source,
                               const Placement& placement) {
  const UsualArithmetic usual;
  const Assembly assembly = parse_assembly(text, source);
  std::ranges::for_each(assembly.parts, refuse_meshes);
  if (json::is_abbreviated(Json::parse(text))) {  // an expression cannot say the nearest double
    const std::string in_full =
        std::string(text.substr(0, text::byte_order_mark(text))) + document_text(assembly);
    return Rewriter(in_full, placement).rewritten();
  }
  return Rewriter(text, placement).rewritten();
}

}  // namespace dupin
