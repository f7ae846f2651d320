#include "formats/gltf/glb_document.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include "dupin/kernel/error.h"
#include "formats/gltf/glb_layout.h"
#include "text/json_depth.h"
#include "text/little_endian.h"
#include "text/mesh_text.h"

namespace dupin::formats {

GlbDocument::GlbDocument(std::string_view file_bytes, std::string_view file) : file_(file) {
  if (file_bytes.size() < kGlbHeader || text::load<std::uint32_t>(file_bytes, 0) != kGlbMagic) {
    fail("byte 0", "found no header of binary glTF, expected 'glTF' and 8 more bytes");
  }
  if (const auto version = text::load<std::uint32_t>(file_bytes, 4); version != kGlbVersion) {
    fail("byte 4", "found version " + std::to_string(version) + ", expected 2");
  }
  if (const auto length = text::load<std::uint32_t>(file_bytes, 8); length != file_bytes.size()) {
    fail("byte 8", "found a length of " + std::to_string(length) + " in a file of " +
                       std::to_string(file_bytes.size()) + " bytes, expected the same");
  }
  std::string_view json;
  for (std::size_t place = kGlbHeader; place < file_bytes.size();) {
    const std::size_t left = file_bytes.size() - place;
    const std::size_t size =
        left < kGlbChunkHeader ? left : std::size_t{text::load<std::uint32_t>(file_bytes, place)};
    if (left < kGlbChunkHeader || size > left - kGlbChunkHeader) {
      fail("byte " + std::to_string(place), "found a chunk of " + std::to_string(size) +
                                                " bytes, expected at most " + std::to_string(left));
    }
    const auto type = text::load<std::uint32_t>(file_bytes, place + 4);
    const std::string_view content = file_bytes.substr(place + kGlbChunkHeader, size);
    if (type == kGlbJsonChunk && json.empty()) {
      json = content;
    } else if (type == kGlbBytesChunk && bytes_.empty()) {
      bytes_ = content;
    }
    place += kGlbChunkHeader + size;
  }
  if (text::first_too_deep(json)) {
    fail("byte 20", "found JSON with brackets nested too deep");
  }
  json_ = Json::parse(json, nullptr, false);
  if (!json_.is_object()) {
    fail("byte 20", "found faulty JSON, expected an object");
  }
}

void GlbDocument::fail(const std::string& place, const std::string& message) const {
  throw Error(Errc::parse_failed, message, {}, std::string(file_) + ":" + place);
}

const GlbDocument::Json& GlbDocument::member(const Json& json, const std::string& place,
                                             const std::string& key) const {
  if (!json.is_object() || !json.contains(key)) {
    fail(place, "found no '" + key + "', expected one");
  }
  return json[key];
}

std::size_t GlbDocument::unsigned_value(const Json& value, const std::string& place) const {
  // JSON knows one kind of number: 8.0 and 8e0 are integers, too.
  const double number = value.is_number() ? value.get<double>() : -1;
  if (!(number >= 0) || number != std::floor(number) ||
      number > std::numeric_limits<std::uint32_t>::max()) {
    fail(place, "found " +
                    value.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 40) +
                    ", expected an integer from 0 to 4294967295");
  }
  return static_cast<std::size_t>(number);
}

std::size_t GlbDocument::unsigned_member(const Json& json, const std::string& place,
                                         const std::string& key,
                                         std::optional<std::size_t> otherwise) const {
  if (otherwise && json.is_object() && !json.contains(key)) {
    return *otherwise;
  }
  return unsigned_value(member(json, place, key), place + "/" + key);
}

std::pair<const GlbDocument::Json*, std::string> GlbDocument::entry(
    std::size_t index, const std::string& array) const {
  const std::string place = "/" + array + "/" + std::to_string(index);
  const Json& entries = member(json_, "", array);
  if (!entries.is_array() || index >= entries.size()) {
    fail(place, "found nothing there, expected an entry");
  }
  return {&entries[index], place};
}

std::size_t GlbDocument::count(const std::string& array) const {
  if (!json_.contains(array)) {
    return 0;
  }
  if (!json_[array].is_array()) {
    fail("/" + array, "found no array, expected one");
  }
  return json_[array].size();
}

std::string GlbDocument::name(const Json& json, const std::string& key) const {
  return json.is_object() && json.contains(key) && json[key].is_string()
             ? text::clean_line(json[key].get<std::string>())
             : std::string();
}

}  // namespace dupin::formats
