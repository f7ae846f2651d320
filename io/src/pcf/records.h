#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace dupin::pcf {

/// A line of a record, its keyword in upper case and one spelling.
struct Attribute {
  std::string keyword;
  std::size_t line = 0;
  std::size_t position = 0;  ///< in the text, of what follows the keyword
  std::string_view text;     ///< the same, without blanks around it
};

/// A line that stands for itself, and the ones below that belong to it.
struct Record {
  Attribute head;
  std::vector<Attribute> attributes;
};

/// What a keyword at the head of a record says.
enum class HeadKind {
  component,  ///< becomes a solid
  setting,    ///< of the file: units, names
  skipped,    ///< known, and no solid: supports, welds, messages
  unknown,
};

[[nodiscard]] HeadKind head_kind(std::string_view keyword);

/// The records of a text. A line begins one if it is not indented or if its keyword heads records
/// only; lines below messages belong to these, and so do lines with such a keyword that are
/// indented more than the message and have no point of a component below them. Keywords are taken
/// in any case, with "<>" about them or not, in the spellings ENDPOINT, CENTER.
[[nodiscard]] std::vector<Record> records(std::string_view text);

/// What the text begins with; none: no finite number.
[[nodiscard]] std::optional<double> leading_number(std::string_view text);

}  // namespace dupin::pcf
