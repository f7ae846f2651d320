#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace dupin::text {

/// That of the library, of another name: types that only we have, whose destructors we may say.
template <class Value, class Condition = void>
struct JsonSerializer : nlohmann::adl_serializer<Value, Condition> {};

/// JSON values as nlohmann::ordered_json and nlohmann::json, whose destructors need no memory: the
/// library's own move all that is in a value to a list, and end the program where there is no room
/// for it, as while std::bad_alloc is on its way. These go down as deep as brackets are nested,
/// which of text is at most kDeepestJson, and in what we write a few.
using Json =
    nlohmann::basic_json<nlohmann::ordered_map, std::vector, std::string, bool, std::int64_t,
                         std::uint64_t, double, std::allocator, JsonSerializer>;
using SortedJson = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                        std::uint64_t, double, std::allocator, JsonSerializer>;

/// Null is what no memory was found for, of a value that became an array or object.
template <class Owned>
void destroy_owned(Owned* owned) {
  if (owned != nullptr) {
    std::destroy_at(owned);
    std::allocator<Owned>().deallocate(owned, 1);
  }
}

/// Ends what a value of this type owns, a union of pointers.
template <class Value>
void destroy_json(nlohmann::detail::value_t type, const Value& value) {
  switch (type) {
    case nlohmann::detail::value_t::object:
      return destroy_owned(value.object);
    case nlohmann::detail::value_t::array:
      return destroy_owned(value.array);
    case nlohmann::detail::value_t::string:
      return destroy_owned(value.string);
    case nlohmann::detail::value_t::binary:
      return destroy_owned(value.binary);
    default:  // is no pointer
      return;
  }
}

}  // namespace dupin::text

template <>
inline void dupin::text::Json::json_value::destroy(value_t type) {
  dupin::text::destroy_json(type, *this);
}

template <>
inline void dupin::text::SortedJson::json_value::destroy(value_t type) {
  dupin::text::destroy_json(type, *this);
}
