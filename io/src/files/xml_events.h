#pragma once

// Files: what holds the bytes of a format, on disk and inside each other.
//
// dupin/io/atomic_file.h writes aside and renames, so that whoever looks finds the old file or the
// whole new one. The containers of 3MF are read as they come from strangers: XML as a stream of
// events, without document types, hence without entities that expand (expat; W3C XML 1.0 with
// namespaces), and ZIP packages with a limit on what an entry may expand to (libzip; PKWARE
// APPNOTE 6.3, ECMA-376 part 2). Faults are Error{parse_failed} with file, part and line.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace dupin::files {

/// Namespaces by the prefixes that the root element declares.
using XmlSpaces = std::map<std::string, std::string, std::less<>>;

/// The attributes of an element, valid during its event.
class XmlAttributes {
 public:
  XmlAttributes(const char** raw, const XmlSpaces& spaces) : raw_(raw), spaces_(spaces) {}
  [[nodiscard]] std::optional<std::string_view> find(std::string_view name) const;
  [[nodiscard]] const XmlSpaces& spaces() const { return spaces_; }

 private:
  const char** raw_;
  const XmlSpaces& spaces_;
};

struct XmlEvents {
  /// Names come without their namespace. False ends the reading.
  std::function<bool(std::string_view element, const XmlAttributes& attributes)> begin;
  std::function<void(std::string_view element)> end;
  /// What stands between tags, in as many pieces as it comes. May be empty.
  std::function<void(std::string_view text)> text = {};
  /// Of elements in another namespace than the root's, instead of the first two. May be empty.
  std::function<void(std::string_view element)> begin_of_other_space = {};
};

/// Runs through an XML text. An Error thrown by an event without a place, and every fault of the
/// XML itself, becomes Error{parse_failed} at "place:line". Document type declarations are refused.
void read_xml(std::string_view text, const std::string& place, const XmlEvents& events);

}  // namespace dupin::files
