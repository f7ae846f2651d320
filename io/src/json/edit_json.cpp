#include "dupin/io/edit_json.h"

#include <vector>

#include "dupin/io/assembly_json.h"
#include "json/json_document.h"
#include "json/json_span.h"

namespace dupin {
namespace {

using json::Json;
using json::JsonStep;

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

}  // namespace

std::string with_chain(std::string_view text, const std::string& source, std::uint32_t part,
                       const CyclideChainThrough& chain) {
  const Assembly assembly = parse_assembly(text, source);
  const auto& before = std::get<CyclideChainThrough>(assembly.parts.at(part).shape);
  const std::vector<JsonStep> place{std::string("parts"), std::size_t(part),
                                    std::string("cyclide_chain")};
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
  const Json document = Json::parse(text);
  if (document.at("parts").at(part).at("cyclide_chain").contains("tangents")) {
    put(span(result, {std::string("tangents")}), text_of(chain.tangents));
  } else if (!chain.tangents.empty()) {
    const std::size_t end = span(result, {std::string("spheres")}).end;
    put({end, end}, ", \"tangents\": " + text_of(chain.tangents));
  }
  return result;
}

}  // namespace dupin
