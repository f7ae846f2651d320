#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dupin/blends/unit.h"
#include "json/json_document.h"

namespace dupin::json {

/// The named values of a document and, within a "for", its variables (docs/assembly_format.md).
class Values {
 public:
  /// All that stand under "values" of `document`. Throws for names and values of the wrong form,
  /// unknown names and circles.
  Values(const JsonNode& document, Unit unit);

  /// A copy with every expression and, in copies, everything in braces replaced by its value. What
  /// is called "comment" stays as it is; the node's own key `without` is left out.
  [[nodiscard]] Json replaced(const JsonNode& node, std::string_view without = {});

 private:
  friend class Expansion;

  [[nodiscard]] Json each_replaced(const JsonNode& node, std::string_view without);
  [[nodiscard]] Json value(std::string_view name);
  [[nodiscard]] Json defined(const JsonNode& definition);
  [[nodiscard]] Json element(const JsonNode& definition);
  void count(const JsonNode& node, std::size_t amount);

  JsonNode document_;
  Unit unit_;
  struct Known {
    Json value;
    std::size_t chain = 1;  ///< how many values need each other in a row, this one last
  };
  std::map<std::string, Known, std::less<>> known_;
  std::map<std::string, Json, std::less<>> variables_;
  std::vector<std::string> pending_;  ///< that are being evaluated
  std::size_t longest_chain_ = 0;     ///< of those that the last of these has needed so far
  std::size_t work_ = 0;              ///< values and bytes of texts that were made
};

/// A part as it is to be read: `part` has no values, copies or sizes and is no fitting.
struct ExpandedPart {
  Json part;
  std::string pointer;  ///< of the entry in the document that it comes from
  std::string key;      ///< where the document says it there, if it is one of several
  std::string copy;     ///< the name of the copy that it comes from, for faults; none if of no copy
};

/// Some parts, which follow the ones before.
using PartSink = std::function<void(std::span<const ExpandedPart> parts)>;

/// Hands the parts of a document to `sink`, copies one after the other, the last variable of a
/// "for" fastest. Faults in a copy name it. Throws, besides what `sink` throws, for faults of form,
/// and where copies make more parts than kMostParts or more text than any machine needs; what comes
/// before has been handed over then.
void expand(const JsonNode& document, const std::string& source, Unit unit, Values& values,
            const PartSink& sink);

/// Whether a document says something otherwise than part by part in numbers.
[[nodiscard]] bool is_abbreviated(const Json& document);

inline constexpr std::size_t kMostParts = 100'000;

}  // namespace dupin::json
