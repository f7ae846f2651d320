#include "dupin/io/edit_json.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <variant>
#include <vector>

#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
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

const Json& value_at(const Json& document, const std::vector<JsonStep>& steps) {
  const Json* value = &document;
  for (const JsonStep& step : steps) {
    value = std::visit([&](const auto& own) { return &value->at(own); }, step);
  }
  return *value;
}

// The keys and indices of "/parts/0/parts/1", which the reader wrote: keys have no escapes.
std::vector<JsonStep> steps_of(std::string_view pointer) {
  std::vector<JsonStep> steps;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::string_view step = pointer.substr(0, pointer.find('/'));
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
    if (error == std::errc() && end == step.data() + step.size()) {
      steps.emplace_back(index);
    } else {
      steps.emplace_back(std::string(step));
    }
    pointer.remove_prefix(step.size());
  }
  return steps;
}

// Where the part stands, maybe in an entry with parts of its own; copies, also those that an entry
// around makes, stand nowhere of their own.
std::vector<JsonStep> steps_to(const Json& document, const Assembly& assembly, std::uint32_t part) {
  const std::string& pointer = assembly.parts.at(part).pointer;
  const std::vector<JsonStep> steps =
      steps_of(pointer.empty() ? "/parts/" + std::to_string(part) : pointer);
  for (auto end = steps.begin(); end != steps.end();) {
    if (value_at(document, {steps.begin(), ++end}).contains("for")) {
      throw Error(Errc::invalid_argument, "a copy that \"for\" makes cannot be changed alone",
                  assembly.parts[part].name, document_place(assembly, part));
    }
  }
  return steps;
}

// The chain that the part is, whose spheres the new one has.
const CyclideChainThrough& chain_before(const Assembly& assembly, std::uint32_t part,
                                        const CyclideChainThrough& chain) {
  if (part >= assembly.parts.size()) {
    throw Error(Errc::invalid_argument,
                "there is no part " + std::to_string(part) + "; the document has " +
                    std::to_string(assembly.parts.size()),
                {}, assembly.source);
  }
  const auto* const before = std::get_if<CyclideChainThrough>(&assembly.parts[part].shape);
  const auto fail = [&](const std::string& message, std::string_view key) {
    throw Error(Errc::invalid_argument, message, assembly.parts[part].name,
                document_place(assembly, part, key));
  };
  if (before == nullptr) {
    fail("the part is no cyclide_chain, and cannot become one", {});
  } else if (chain.spheres.size() != before->spheres.size()) {
    fail("the chain has to keep its " + std::to_string(before->spheres.size()) +
             " spheres; the new one has " + std::to_string(chain.spheres.size()),
         "spheres");
  }
  const auto require_finite = [&](const PeVector& v, const std::string& key) {
    if (!v.m.allFinite() || !std::isfinite(v.r)) {
      fail("the numbers of spheres and tangents must be finite", key);
    }
  };
  for (std::size_t i = 0; i < chain.spheres.size(); ++i) {
    require_finite(chain.spheres[i], "spheres/" + std::to_string(i));
  }
  for (std::size_t i = 0; i < chain.tangents.size(); ++i) {
    require_finite(chain.tangents[i].tangent, "tangents/" + std::to_string(i));
  }
  return *before;
}

}  // namespace

std::string with_chain(std::string_view text, const std::string& source, std::uint32_t part,
                       const CyclideChainThrough& chain) {
  const UsualArithmetic usual;
  const Assembly assembly = parse_assembly(text, source);
  const CyclideChainThrough& before = chain_before(assembly, part, chain);
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
