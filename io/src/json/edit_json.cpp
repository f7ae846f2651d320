#include "dupin/io/edit_json.h"

#include <charconv>
#include <variant>
#include <vector>

#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"
#include "json/json_document.h"
#include "json/json_span.h"

namespace dupin {
namespace {

using json::Json;
using json::JsonStep;

constexpr std::string_view kParts = "/parts/";

std::string text_of(const PeVector& v) {
  std::string result = "[";
  for (const double x : {v.m.x(), v.m.y(), v.m.z(), v.r}) {
    result += (result.size() > 1 ? ", " : "") + Json(x).dump();
  }
  return result + "]";
}

std::string text_of(const std::vector<PinnedTangent>& tangents) {
  std::string result = "[";
  for (const PinnedTangent& pin : tangents) {
    result += (result.size() > 1 ? ", " : "") + std::string("{\"sphere\": ") +
              std::to_string(pin.sphere) + ", \"tangent\": " + text_of(pin.tangent) + "}";
  }
  return result + "]";
}

const Json& value_at(const Json& document, const std::vector<JsonStep>& steps) {
  const Json* value = &document;
  for (const JsonStep& step : steps) {
    value = std::visit([&](const auto& own) { return &value->at(own); }, step);
  }
  return *value;
}

// Where the part stands; copies stand nowhere of their own.
std::vector<JsonStep> steps_to(const Json& document, const Assembly& assembly, std::uint32_t part) {
  const std::string& pointer = assembly.parts.at(part).pointer;
  std::size_t index = part;
  if (!pointer.empty()) {
    const std::string_view digits = std::string_view(pointer).substr(kParts.size());
    std::from_chars(digits.data(), digits.data() + digits.size(), index);  // the reader's own
  }
  if (document.at("parts").at(index).contains("for")) {
    throw Error(Errc::invalid_argument, "a copy that \"for\" makes cannot be changed alone",
                assembly.parts[part].name, document_place(assembly, part));
  }
  return {std::string("parts"), index};
}

}  // namespace

std::string with_chain(std::string_view text, const std::string& source, std::uint32_t part,
                       const CyclideChainThrough& chain) {
  const Assembly assembly = parse_assembly(text, source);
  const auto& before = std::get<CyclideChainThrough>(assembly.parts.at(part).shape);
  const Json document = Json::parse(text);
  std::vector<JsonStep> place = steps_to(document, assembly, part);
  place.emplace_back(std::string("cyclide_chain"));
  const Json& written = value_at(document, place);
  if (!written.at("spheres").is_array()) {
    throw Error(Errc::invalid_argument, "spheres that an expression stands for cannot be changed",
                assembly.parts[part].name, document_place(assembly, part, "spheres"));
  }
  const auto span = [&](const std::string& current, std::vector<JsonStep> below) {
    below.insert(below.begin(), place.begin(), place.end());
    return json::json_span(current, below);
  };
  std::string result(text);
  const auto put = [&](const json::TextSpan& at, const std::string& value) {
    result.replace(at.begin, at.end - at.begin, value);
  };
  for (std::size_t i = 0; i < chain.spheres.size(); ++i) {
    if (!(chain.spheres[i] == before.spheres.at(i))) {
      put(span(result, {std::string("spheres"), i}), text_of(chain.spheres[i]));
    }
  }
  // An empty list is a key as well.
  if (written.contains("tangents")) {
    put(span(result, {std::string("tangents")}), text_of(chain.tangents));
  } else if (!chain.tangents.empty()) {
    const std::size_t end = span(result, {std::string("spheres")}).end;
    put({end, end}, ", \"tangents\": " + text_of(chain.tangents));
  }
  return result;
}

}  // namespace dupin
