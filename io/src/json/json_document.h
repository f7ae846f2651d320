#pragma once

#include <string>
#include <string_view>

#include "dupin/kernel/error.h"
#include "text/json_type.h"

// This folder: documents, edits, reports and certificates as JSON. A value is read through a
// JsonNode, which knows its place ("file#/parts/3/pipe"), so that every fault names it;
// allow_only() refuses keys that nobody reads, and numbers are finite or refused. What a key of a
// part means is not known here: parts/KEY.cpp gives the numbers as they are typed
// (dupin/blends/part_shape.h). Reports are written with their keys in a fixed order and the
// shortest decimals: same input, same bytes.

namespace dupin::json {

using text::Json;

/// JSON text as a value. Throws Error{parse_failed} with "source:line:column" for text that is not
/// JSON or is nested too deep, and with "source#/json/pointer" for an object that repeats a key or
/// has more of them than any document.
[[nodiscard]] Json parse_json(std::string_view text, const std::string& source);

/// A value in a document that knows its place, so that faults do.
class JsonNode {
 public:
  JsonNode(const Json& value, const std::string& source, std::string pointer)
      : JsonNode(value, source, std::move(pointer), {}) {}

  [[noreturn]] void fail(const std::string& message) const;

  [[nodiscard]] const Json& value() const { return *value_; }
  /// The name of the document.
  [[nodiscard]] const std::string& source() const { return *source_; }
  [[nodiscard]] bool has(std::string_view key) const;

  /// What the document's lengths are in, as it says; empty where nobody told.
  [[nodiscard]] std::string_view unit() const { return unit_; }
  /// The same of a document that says so; `unit` has to outlive it.
  [[nodiscard]] JsonNode in(std::string_view unit) const {
    return {*value_, *source_, pointer_, unit};
  }

  /// The value of a key. Throws if this is not an object or has no such key.
  [[nodiscard]] JsonNode at(std::string_view key) const;
  [[nodiscard]] JsonNode at(std::size_t index) const;

  /// Another value in the place of a key's.
  [[nodiscard]] JsonNode with(const Json& value, std::string_view key) const;

  /// Each throws if this is something else.
  void require_object() const;
  [[nodiscard]] std::size_t require_array() const;  ///< its size
  [[nodiscard]] double number() const;
  [[nodiscard]] std::string text() const;

 private:
  JsonNode(const Json& value, const std::string& source, std::string pointer, std::string_view unit)
      : value_(&value), source_(&source), pointer_(std::move(pointer)), unit_(unit) {}

  const Json* value_;
  const std::string* source_;
  std::string pointer_;
  std::string_view unit_;
};

}  // namespace dupin::json
