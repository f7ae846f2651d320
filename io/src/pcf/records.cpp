#include "pcf/records.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "text/line_counter.h"

namespace dupin::pcf {
namespace {

// Families: the keyword itself, or it and "-" and more.
constexpr std::array kComponents = std::to_array<std::string_view>({"PIPE",
                                                                    "ELBOW",
                                                                    "BEND",
                                                                    "TEE",
                                                                    "OLET",
                                                                    "CROSS",
                                                                    "Y-PIECE-FITTING",
                                                                    "REDUCER",
                                                                    "FLANGE",
                                                                    "VALVE",
                                                                    "CAP",
                                                                    "GASKET",
                                                                    "COUPLING",
                                                                    "INSTRUMENT",
                                                                    "UNION",
                                                                    "FILTER",
                                                                    "MISC-COMPONENT",
                                                                    "TRAP",
                                                                    "LAP-JOINT-STUB-END",
                                                                    "PLUG",
                                                                    "SAFETY-DISC",
                                                                    "BLIND-FLANGE",
                                                                    "EXPANSION-BELLOWS",
                                                                    "NIPPLE",
                                                                    "SWAGE",
                                                                    "ORIFICE-PLATE"});
// Which of them are also taken for a record's head where they are indented: attributes begin with
// the same words ("BEND-RADIUS").
constexpr std::array kPlain = std::to_array<std::string_view>({"PIPE",
                                                               "PIPE-FIXED",
                                                               "ELBOW",
                                                               "ELBOW-TEED",
                                                               "BEND",
                                                               "BEND-TEED",
                                                               "TEE",
                                                               "TEE-STUB",
                                                               "TEE-SET-ON",
                                                               "OLET",
                                                               "CROSS",
                                                               "Y-PIECE-FITTING",
                                                               "REDUCER-CONCENTRIC",
                                                               "REDUCER-ECCENTRIC",
                                                               "FLANGE",
                                                               "FLANGE-BLIND",
                                                               "VALVE",
                                                               "VALVE-ANGLE",
                                                               "VALVE-3WAY",
                                                               "VALVE-4WAY",
                                                               "CAP",
                                                               "GASKET",
                                                               "COUPLING",
                                                               "INSTRUMENT",
                                                               "MISC-COMPONENT",
                                                               "SUPPORT",
                                                               "WELD"});
constexpr std::array kSettings = std::to_array<std::string_view>({"UNITS",
                                                                  "ISOGEN-FILES",
                                                                  "PIPELINE-REFERENCE",
                                                                  "PIPELINE-TYPE",
                                                                  "ATTRIBUTE",
                                                                  "PROJECT-IDENTIFIER",
                                                                  "AREA",
                                                                  "PIPING-SPEC",
                                                                  "REVISION",
                                                                  "DATE",
                                                                  "START-CO-ORDS",
                                                                  "SPECIFIC-GRAVITY",
                                                                  "TRACING-SPEC",
                                                                  "INSULATION-SPEC",
                                                                  "PAINTING-SPEC",
                                                                  "JACKET-SPEC",
                                                                  "NOMINAL-CLASS",
                                                                  "PIPELINE-TEMP",
                                                                  "SPOOL-PREFIX",
                                                                  "BEND-RADIUS-RULES",
                                                                  "MISC-SPEC",
                                                                  "LAYER",
                                                                  "BATCH",
                                                                  "FLOW",
                                                                  "ISO-TYPE",
                                                                  "PIPING-BORES"});
constexpr std::array kSkipped = std::to_array<std::string_view>({"SUPPORT",
                                                                 "WELD",
                                                                 "BOLT",
                                                                 "MESSAGE",
                                                                 "MATERIALS",
                                                                 "MATERIAL",
                                                                 "MATERIAL-LIST",
                                                                 "ITEM-CODE",
                                                                 "END-CONNECTION",
                                                                 "END-POSITION",
                                                                 "FLOW-ARROW",
                                                                 "INSULATION-SYMBOL",
                                                                 "FLOOR-SYMBOL",
                                                                 "LOCATION-POINT",
                                                                 "ADDITIONAL-ITEM",
                                                                 "REFERENCE-DIMENSION",
                                                                 "TAP-CONNECTION",
                                                                 "SPLIT-POINT",
                                                                 "ISO-SPLIT-POINT",
                                                                 "FIELD-WELD",
                                                                 "WALL-SYMBOL",
                                                                 "CLAMP",
                                                                 "GUIDE",
                                                                 "INFORMATION",
                                                                 "CONNECTION-REFERENCE",
                                                                 "MISCELLANEOUS-REFERENCE"});

bool is_of(std::span<const std::string_view> families, std::string_view keyword) {
  return std::ranges::any_of(families, [&](std::string_view family) {
    return keyword.starts_with(family) &&
           (keyword.size() == family.size() || keyword[family.size()] == '-' ||
            (keyword[family.size()] >= '0' && keyword[family.size()] <= '9'));
  });
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_blank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

std::string keyword_of(std::string_view token) {
  if (token.starts_with('<') && token.ends_with('>') && token.size() > 2) {
    token = token.substr(1, token.size() - 2);
  }
  std::string keyword(token);
  std::ranges::transform(keyword, keyword.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kSpellings{
      {{"ENDPOINT", "END-POINT"},
       {"CENTREPOINT", "CENTRE-POINT"},
       {"CENTERPOINT", "CENTRE-POINT"},
       {"CENTER-POINT", "CENTRE-POINT"},
       {"COORDS", "CO-ORDS"}}};
  for (const auto& [other, usual] : kSpellings) {
    if (keyword == other) {
      keyword = usual;
    }
  }
  return keyword;
}

// Lines below a message are its text.
bool takes_any_line(const Record& record) { return record.head.keyword.starts_with("MESSAGE"); }

}  // namespace

HeadKind head_kind(std::string_view keyword) {
  if (is_of(kSkipped, keyword)) {
    return HeadKind::skipped;
  }
  if (is_of(kSettings, keyword)) {
    return HeadKind::setting;
  }
  return is_of(kComponents, keyword) ? HeadKind::component : HeadKind::unknown;
}

std::vector<Record> records(std::string_view text) {
  std::vector<Record> result;
  std::size_t position = text.starts_with("\xEF\xBB\xBF") ? 3 : 0, line = 0;
  while (position < text.size()) {
    ++line;
    const std::size_t end = std::min(text.find_first_of("\r\n", position), text.size());
    const std::string_view whole = text.substr(position, end - position);
    const std::string_view content = trimmed(whole);
    if (!content.empty()) {
      const std::string_view token = content.substr(0, content.find_first_of(" \t\v\f"));
      Attribute own{keyword_of(token), line, 0, trimmed(content.substr(token.size()))};
      own.position = static_cast<std::size_t>(token.data() - text.data()) + token.size();
      const HeadKind kind = head_kind(own.keyword);
      const bool is_indented = is_blank(whole.front());
      // An indented line begins a record if it cannot be anything else.
      const bool is_head =
          std::ranges::count(kPlain, own.keyword) > 0 || own.keyword.starts_with("UNITS-");
      const bool is_attribute =
          !result.empty() &&
          (is_indented ? !is_head : kind == HeadKind::unknown && takes_any_line(result.back()));
      if (is_attribute) {
        result.back().attributes.push_back(std::move(own));
      } else {
        result.push_back({std::move(own), {}});
      }
    }
    const bool is_pair = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
    position = end + (is_pair ? 2 : 1);
  }
  return result;
}

}  // namespace dupin::pcf
