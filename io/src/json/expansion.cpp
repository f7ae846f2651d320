#include "json/expansion.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "json/expression.h"
#include "json/fittings.h"
#include "json/nominal_size.h"
#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

constexpr std::size_t kLongestChain = 64;      // of names that need each other
constexpr std::size_t kMostWork = 50'000'000;  // values and bytes of all copies
constexpr std::size_t kAtOnce = 1024;          // parts that are handed over
// What an entry with parts says of all of them.
constexpr std::array<std::string_view, 3> kOfRuns{"wall", "wall_side", "insulation"};
// What only readers of documents know, as it stands for something else.
constexpr std::array<std::string_view, 7> kShort{
    "values", "for", "size", "schedule", "class", "outside_diameter", "inside_diameter"};

/// How much Values::replaced counts for a value in which nothing is to be replaced where there are
/// no variables; none for one with an expression.
std::optional<std::size_t> plain_work(const Json& value) {
  std::size_t work = 1;
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    return is_expression(text) ? std::nullopt : std::optional(work + text.size());
  }
  if (!value.is_structured()) {
    return work;
  }
  const bool is_object = value.is_object();
  for (auto below = value.begin(); below != value.end(); ++below) {
    const bool is_comment = is_object && below.key() == "comment";
    const auto own = is_comment ? std::optional(std::size_t{0}) : plain_work(*below);
    if (!own) {
      return std::nullopt;
    }
    work += *own + (is_object ? below.key().size() : 0);
  }
  return work;
}

}  // namespace

Values::Values(const JsonNode& document, Unit unit) : document_(document), unit_(unit) {
  if (!document.has("values")) {
    return;
  }
  const JsonNode values = document.at("values");
  values.require_object();
  for (const auto& [name, definition] : values.value().items()) {
    if (!is_value_name(name)) {
      values.at(name).fail(
          "a value's name has letters, digits and _, begins with no digit and is no unit");
    }
  }
  for (const auto& [name, definition] : values.value().items()) {
    try {
      (void)value(name);
    } catch (const LookupFault& fault) {
      values.at(name).fail(fault.message);
    }
  }
}

Json Values::value(std::string_view name) {
  if (const auto variable = variables_.find(name); variable != variables_.end()) {
    return variable->second;
  }
  if (const auto known = known_.find(name); known != known_.end()) {
    longest_chain_ = std::max(longest_chain_, known->second.chain);
    return known->second.value;
  }
  if (!document_.has("values") || !document_.at("values").has(name)) {
    throw LookupFault{"there is no value named '" + std::string(name) + "'"};
  }
  const JsonNode definition = document_.at("values").at(name);
  pending_.emplace_back(name);
  const auto first = std::ranges::find(pending_, name);
  if (first + 1 != pending_.end()) {
    std::string circle;
    for (auto at = first; at != pending_.end(); ++at) {
      circle.append(circle.empty() ? "'" : " -> '").append(*at).append("'");
    }
    throw LookupFault{"values must not need each other in a circle: " + circle};
  }
  const auto bound = [&](std::size_t values) {
    if (values > kLongestChain) {
      throw LookupFault{"more than " + std::to_string(kLongestChain) +
                        " values need each other in a row"};
    }
  };
  bound(pending_.size());  // and the recursion
  const std::size_t of_user = std::exchange(longest_chain_, 0);
  Json result = defined(definition);
  const std::size_t chain = longest_chain_ + 1;
  bound(chain);  // in whatever order they are written
  pending_.pop_back();
  longest_chain_ = std::max(of_user, chain);
  return known_.emplace(name, Known{std::move(result), chain}).first->second.value;
}

Json Values::defined(const JsonNode& definition) {
  if (!definition.value().is_array()) {
    return element(definition);
  }
  Json list = Json::array();
  const std::size_t size = definition.require_array();
  for (std::size_t i = 0; i < size; ++i) {
    list.push_back(element(definition.at(i)));
    if (list.back().is_array()) {
      definition.at(i).fail("a list holds numbers and texts, not lists");
    }
  }
  return list;
}

Json Values::element(const JsonNode& definition) {
  if (definition.value().is_number()) {
    return definition.value();
  }
  if (!definition.value().is_string()) {
    definition.fail(std::string("must be a number, a text or a list of these, not ") +
                    definition.value().type_name());
  }
  const std::string text = definition.text();
  if (is_expression(text)) {
    return evaluated(definition, unit_, [&](std::string_view name) { return value(name); });
  }
  const auto length = quantity(text, unit_);
  return length ? number_value(*length) : definition.value();
}

void Values::count(const JsonNode& node, std::size_t amount) {
  work_ += amount;
  if (work_ > kMostWork) {
    node.fail("the copies of this document become too large");
  }
}

Json Values::replaced(const JsonNode& node, std::string_view without) {
  const Json& value = node.value();
  if (variables_.empty() && !node.has(without)) {
    if (const auto work = plain_work(value)) {
      count(node, *work);
      return value;
    }
  }
  return each_replaced(node, without);
}

Json Values::each_replaced(const JsonNode& node, std::string_view without) {
  const Json& value = node.value();
  count(node, 1);
  if (value.is_array()) {
    Json list = Json::array();
    for (std::size_t i = 0; i < value.size(); ++i) {
      list.push_back(each_replaced(node.at(i), {}));
    }
    return list;
  }
  if (value.is_object()) {
    Json object = Json::object();
    for (const auto& [key, below] : value.items()) {
      if (key == without) {
        continue;
      }
      count(node, key.size());
      // Keys of an object differ: they need not be looked for.
      object.get_ref<Json::object_t&>().Container::emplace_back(
          key, key == "comment" ? below : each_replaced(node.at(key), {}));
    }
    return object;
  }
  if (!value.is_string()) {
    return value;
  }
  const std::string text = node.text();
  count(node, text.size());
  const auto lookup = [&](std::string_view name) { return this->value(name); };
  if (is_expression(text)) {
    Json result = evaluated(node, unit_, lookup);
    count(node, result.is_array() ? result.size() : 1);
    return result;
  }
  return variables_.empty() ? value : Json(with_braces_replaced(node, unit_, lookup));
}

/// Goes over the entries of "parts".
class Expansion {
 public:
  Expansion(const std::string& source, Unit unit, Values& values, const PartSink& sink)
      : source_(source), unit_(unit), values_(values), sink_(sink) {}

  void all(const JsonNode& parts) {
    try {
      entries(parts, "/parts");
    } catch (const Error&) {
      hand_over();  // which may throw for what comes first
      throw;
    }
    hand_over();
  }

 private:
  void entries(const JsonNode& parts, const std::string& pointer) {
    const std::size_t count = parts.require_array();
    for (std::size_t i = 0; i < count; ++i) {
      entry(parts.at(i), pointer + "/" + std::to_string(i));
    }
  }

  void entry(const JsonNode& node, const std::string& pointer) {
    if (node.has("parts")) {
      Keys keys{"for", "comment", "parts"};
      keys.insert(keys.end(), kOfRuns.begin(), kOfRuns.end());
      allow_only(node, keys);
      if (node.has("comment")) {
        (void)node.at("comment").text();
      }
      const Json outside = usual_;
      for (const std::string_view key : kOfRuns) {
        if (node.has(key)) {
          usual_[std::string(key)] = values_.replaced(node.at(key));
        }
      }
      node.has("for") ? looped(node, pointer) : entries(node.at("parts"), pointer + "/parts");
      usual_ = outside;
    } else if (node.has("for")) {
      looped(node, pointer);
    } else {
      part(node, pointer);
    }
  }

  void looped(const JsonNode& node, const std::string& pointer) {
    const JsonNode loops = node.at("for");
    loops.require_object();
    if (loops.value().empty()) {
      loops.fail(R"(must name a variable and say how often, like {"i": 40})");
    }
    std::vector<std::string> names;
    for (const auto& [name, range] : loops.value().items()) {
      const JsonNode loop = loops.at(name);
      if (!is_value_name(name)) {
        loop.fail(
            "a variable's name has letters, digits and _, begins with no digit and is no unit");
      }
      if (values_.known_.contains(name) || values_.variables_.contains(name)) {
        loop.fail("there is a value named '" + name + "' already");
      }
      names.push_back(name);
    }
    copies(node, pointer, names, 0);
  }

  void copies(const JsonNode& node, const std::string& pointer,
              const std::vector<std::string>& names, std::size_t depth) {
    if (depth == names.size()) {
      node.has("parts") ? entries(node.at("parts"), pointer + "/parts") : part(node, pointer);
      return;
    }
    const JsonNode loop = node.at("for").at(names[depth]);
    const Json range = values_.replaced(loop);
    const bool is_count = range.is_number();
    const bool is_right = range.is_array() || (is_count && range.is_number_unsigned());
    const std::size_t size = !is_right ? 0 : is_count ? range.get<std::size_t>() : range.size();
    if (size == 0 || size > kMostParts) {
      loop.fail("must be a whole number from 1 to " + std::to_string(kMostParts) +
                " or a list of as many values");
    }
    if (depth + 1 == names.size() && !has_loops(node)) {
      count_copies(node, size);
    }
    for (std::size_t i = 0; i < size; ++i) {
      const Json& value = is_count ? range : range[i];
      if (!is_count && !value.is_number() && !value.is_string()) {
        loop.at(i).fail("must be a number or a text");
      }
      values_.count(loop, 1);
      values_.variables_[names[depth]] = is_count ? Json(std::uint64_t(i)) : value;
      copies(node, pointer, names, depth + 1);
    }
    values_.variables_.erase(names[depth]);
  }

  // Whether there are copies within its copies, which are counted then.
  static bool has_loops(const JsonNode& node) {
    if (!node.has("parts")) {
      return false;
    }
    const JsonNode parts = node.at("parts");
    const std::size_t count = parts.require_array();
    for (std::size_t i = 0; i < count; ++i) {
      const JsonNode entry = parts.at(i);
      if (entry.value().is_object() && (entry.has("for") || has_loops(entry))) {
        return true;
      }
    }
    return false;
  }

  // Before they are made: copies of nothing take time, too.
  void count_copies(const JsonNode& node, std::size_t amount) {
    copied_ += amount;
    if (copied_ > kMostParts) {
      refuse_copies(node);
    }
  }

  [[noreturn]] static void refuse_copies(const JsonNode& node) {
    node.fail("copies make more than " + std::to_string(kMostParts) + " parts");
  }

  void part(const JsonNode& node, const std::string& pointer) {
    node.require_object();
    if (!values_.variables_.empty() && ++made_ > kMostParts) {
      refuse_copies(node);
    }
    std::string name;
    try {
      if (!values_.variables_.empty()) {
        const Json own = values_.replaced(node.at("name"));
        name = own.is_string() ? own.get<std::string>() : "";
      }
      Json expanded = values_.replaced(node, "for");
      give_section(expanded, JsonNode(expanded, source_, pointer), unit_);
      if (has_wall(expanded)) {
        for (const auto& [key, usual] : usual_.items()) {
          if (!expanded.contains(key)) {
            expanded[key] = usual;
          }
        }
      }
      for (Member& member : members(std::move(expanded), source_, pointer)) {
        expanded_.push_back({std::move(member.part), pointer, std::move(member.key), name});
      }
    } catch (const Error& error) {
      if (name.empty()) {
        throw;
      }
      throw error.in_part(name);
    }
    if (expanded_.size() >= kAtOnce) {
      hand_over();
    }
  }

  void hand_over() {
    const std::vector<ExpandedPart> some = std::exchange(expanded_, {});
    sink_(some);
  }

  // Not what has the wall of others, or none.
  static bool has_wall(const Json& part) {
    return !(part.contains("solid") && part["solid"] == Json(true)) &&
           std::ranges::none_of(std::array{"fillet", "cope", "cap", "flange"},
                                [&](const char* key) { return part.contains(key); });
  }

  const std::string& source_;
  Unit unit_;
  Values& values_;
  const PartSink& sink_;
  Json usual_ = Json::object();  ///< what entries around say of the walls of their parts
  std::vector<ExpandedPart> expanded_;
  std::size_t made_ = 0;
  std::size_t copied_ = 0;  ///< of loops that have none within
};

void expand(const JsonNode& document, const std::string& source, Unit unit, Values& values,
            const PartSink& sink) {
  Expansion(source, unit, values, sink).all(document.at("parts"));
}

bool is_abbreviated(const Json& document) {
  if (document.is_string()) {
    return is_expression(document.get_ref<const std::string&>());
  }
  if (!document.is_structured()) {
    return false;
  }
  for (const auto& [key, value] : document.items()) {
    const bool is_own_key =
        document.is_object() && (std::ranges::find(kShort, key) != kShort.end() ||
                                 std::ranges::find(fitting_keys(), key) != fitting_keys().end() ||
                                 (key == "parts" && !document.contains("units")));
    if (is_own_key || (key != "comment" && is_abbreviated(value))) {
      return true;
    }
  }
  return false;
}

}  // namespace dupin::json
