#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace dupin::files {

/// The attributes of an element, valid during its event.
class XmlAttributes {
 public:
  explicit XmlAttributes(const char** raw) : raw_(raw) {}
  [[nodiscard]] std::optional<std::string_view> find(std::string_view name) const;

 private:
  const char** raw_;
};

struct XmlEvents {
  /// Names come without their namespace. False ends the reading.
  std::function<bool(std::string_view element, const XmlAttributes& attributes)> begin;
  std::function<void(std::string_view element)> end;
};

/// Runs through an XML text. An Error thrown by an event without a place, and every fault of the
/// XML itself, becomes Error{parse_failed} at "place:line". Document type declarations are refused.
void read_xml(std::string_view text, const std::string& place, const XmlEvents& events);

}  // namespace dupin::files
