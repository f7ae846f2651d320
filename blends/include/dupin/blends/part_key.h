#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

namespace dupin {

/// The name of a key in a document, as an argument of templates.
struct KeyName {
  template <std::size_t size>
  consteval KeyName(const char (&name)[size]) {
    static_assert(size <= 32, "a key's name has at most 31 characters");
    for (std::size_t i = 0; i < size; ++i) {
      text[i] = name[i];
    }
  }
  [[nodiscard]] constexpr std::string_view view() const { return text.data(); }
  friend constexpr bool operator==(const KeyName&, const KeyName&) = default;

  std::array<char, 32> text{};
};

/// A key and the shapes that it stands for.
template <KeyName key, class... Shapes>
struct PartKey {
  static constexpr KeyName kName = key;
  using ShapeTuple = std::tuple<Shapes...>;
  template <class Shape>
  static constexpr int kCount = (int(std::is_same_v<Shape, Shapes>) + ...);
};

/// Keys with different names, none of whose shapes is another's.
template <class... Keys>
class PartKeyTable {
  template <class... Shapes>
  static std::variant<Shapes...> variant_of(std::tuple<Shapes...>);

  template <class Shape>
  static consteval std::size_t position() {
    static_assert((Keys::template kCount<Shape> + ...) == 1, "a shape belongs to exactly one key");
    std::size_t result = 0;
    (void)((Keys::template kCount<Shape> == 1 || (++result, false)) || ...);
    return result;
  }

 public:
  static constexpr std::array kNames{Keys::kName...};

  using Shape = decltype(variant_of(std::tuple_cat(std::declval<typename Keys::ShapeTuple>()...)));

  template <KeyName name>
  static constexpr bool kHas = ((Keys::kName == name) || ...);

  /// The name of the key that stands for a shape.
  template <class OneShape>
  static constexpr KeyName kNameOf = kNames[position<OneShape>()];
};

}  // namespace dupin
