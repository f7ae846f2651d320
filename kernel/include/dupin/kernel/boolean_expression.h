#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/solid.h"

namespace dupin {

/// A set expression over named operands: `a + b` union, `a - b` difference, `a & b` intersection,
/// parentheses. `&` binds tighter than `+` and `-`, which bind alike and from the left. A name is a
/// run of letters, digits, `_` and `.`, or anything in double quotes.
class Expression {
 public:
  enum class Kind : std::uint8_t { operand, unite, intersect, subtract };
  struct Step {
    Kind kind;
    std::uint32_t operand;  ///< of Kind::operand: an index into names()
    friend bool operator==(const Step&, const Step&) = default;
  };

  /// Throws Error{parse_failed} with the position (from 1) of the fault in `where()`.
  [[nodiscard]] static Expression parse(std::string_view text);

  /// In order of first appearance.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Reverse Polish notation: an operand, or what to do with the last two sets.
  [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
  /// Text that parses to an equal expression, with no more parentheses than needed.
  [[nodiscard]] std::string text() const;
  /// Whether a place is in the set that is inside the operands for which `inside` says so (one
  /// entry per name). Throws Error{invalid_argument} for another number of entries.
  [[nodiscard]] bool contains(const std::vector<bool>& inside) const;

  friend bool operator==(const Expression&, const Expression&) = default;

 private:
  class Parser;

  std::vector<std::string> names_;
  std::vector<Step> steps_;
};

/// The set in one exact arrangement of all operands; in its sources, operands are numbered as in
/// `expression.names()`. Operands that the expression does not name are not used. Throws
/// Error{invalid_argument} if one is missing, and what unite() throws.
[[nodiscard]] Solid evaluate(const Expression& expression,
                             const std::map<std::string, Solid>& operands,
                             const BooleanOptions& options = {});

}  // namespace dupin
