#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "text/json_type.h"

namespace dupin::formats {

/// The two chunks of a binary glTF file. Every member of the JSON is asked for by functions that
/// fail with its place.
class GlbDocument {
 public:
  using Json = text::SortedJson;

  /// Throws Error{parse_failed} with "file:byte N". The bytes have to outlive this.
  GlbDocument(std::string_view file_bytes, std::string_view file);

  [[nodiscard]] const Json& json() const { return json_; }
  [[nodiscard]] std::string_view bytes() const { return bytes_; }

  /// Throws Error{parse_failed} at the JSON pointer `place`.
  [[noreturn]] void fail(const std::string& place, const std::string& message) const;
  [[nodiscard]] const Json& member(const Json& json, const std::string& place,
                                   const std::string& key) const;
  [[nodiscard]] std::size_t unsigned_value(const Json& value, const std::string& place) const;
  [[nodiscard]] std::size_t unsigned_member(const Json& json, const std::string& place,
                                            const std::string& key,
                                            std::optional<std::size_t> otherwise = {}) const;
  /// An entry of the document's array `array`, and its place.
  [[nodiscard]] std::pair<const Json*, std::string> entry(std::size_t index,
                                                          const std::string& array) const;
  /// How many entries the document's array `array` has; none if it is not there.
  [[nodiscard]] std::size_t count(const std::string& array) const;
  /// The text of a member, fit for a line; empty if there is none.
  [[nodiscard]] std::string name(const Json& json, const std::string& key = "name") const;

 private:
  std::string_view bytes_;
  std::string_view file_;
  Json json_;
};

}  // namespace dupin::formats
