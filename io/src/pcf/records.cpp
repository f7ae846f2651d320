#include "pcf/records.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <system_error>
#include <utility>

#include "text/line_counter.h"
#include "text/text_scanner.h"

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

constexpr std::string_view kBlanks = " \t\v\f";

bool is_of(std::span<const std::string_view> families, std::string_view keyword) {
  return std::ranges::any_of(families, [&](std::string_view family) {
    return keyword.starts_with(family) &&
           (keyword.size() == family.size() || keyword[family.size()] == '-' ||
            (keyword[family.size()] >= '0' && keyword[family.size()] <= '9'));
  });
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

// How many blanks there are before the line's first word, which begins there.
std::size_t indentation(std::string_view text, std::size_t begin) {
  const std::size_t last = text.substr(0, begin).find_last_not_of(kBlanks);
  return begin - (last == std::string_view::npos ? 0 : last + 1);
}

// Whether the scanner's next line has a point of a component, which no message has.
bool is_before_point(text::TextScanner scanner) {
  if (scanner.at_end()) {
    return false;
  }
  const std::string keyword = keyword_of(scanner.token());
  return keyword == "END-POINT" || keyword == "CENTRE-POINT" ||
         (keyword.starts_with("BRANCH") && keyword.ends_with("-POINT"));
}

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
  text::TextScanner scanner(text, {});
  text::LineCounter lines(text);
  std::size_t head_indentation = 0;  // of the last record
  while (!scanner.at_end()) {
    const std::size_t begin = scanner.position();
    Attribute own{keyword_of(scanner.token()), lines.at(begin), scanner.position(), {}};
    own.text = scanner.rest_of_line();
    const HeadKind kind = head_kind(own.keyword);
    const std::size_t indented = indentation(text, begin);
    const bool is_below_message = !result.empty() && takes_any_line(result.back());
    // "PIPE TO BE FIELD CUT" is no pipe, where it stands further in than its message.
    const bool is_text =
        is_below_message && indented > head_indentation && !is_before_point(scanner);
    // An indented line begins a record if it cannot be anything else.
    const bool is_head = (std::ranges::count(kPlain, own.keyword) > 0 && !is_text) ||
                         own.keyword.starts_with("UNITS-");
    const bool is_attribute =
        !result.empty() &&
        (indented > 0 ? !is_head : kind == HeadKind::unknown && is_below_message);
    if (is_attribute) {
      result.back().attributes.push_back(std::move(own));
    } else {
      result.push_back({std::move(own), {}});
      head_indentation = indented;
    }
  }
  return result;
}

std::optional<double> leading_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace dupin::pcf
