#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace dupin {

/// What went wrong, for programs; the message says it to people.
enum class Errc {
  invalid_argument,   ///< a value outside its documented range
  not_closed,         ///< a mesh with boundary edges where a solid is needed
  not_manifold,       ///< an edge or vertex whose faces do not form one fan
  not_oriented,       ///< neighbouring faces that disagree, or an inside-out shell
  self_intersecting,  ///< faces that meet where they should not
  irregular_surface,  ///< a part that folds (1 - kappa R is not positive everywhere) or crosses
                      ///< itself
  infeasible_blend,   ///< no blend of the asked kind exists between these ends
  boolean_failed,     ///< a boolean operation that the engine refuses
  contact,            ///< a result that touches itself, under a policy that forbids it
  unroundable,     ///< no valid mesh with representable coordinates within the allowed displacement
  limit_exceeded,  ///< more data than the stated limits
  cancelled,       ///< the caller's progress callback asked to stop
  parse_failed,    ///< input text or bytes that are not what the format demands
  io_failed,       ///< the operating system refused to read or write
  internal,        ///< a bug of ours
};

/// The enumerator's name, e.g. "not_closed".
[[nodiscard]] std::string_view name(Errc code);

/// The one exception type of the library. `what()` is a complete sentence for people: part, place,
/// fault, remedy. Of names and other texts of more than 60 bytes it quotes the beginning.
class Error : public std::runtime_error {
 public:
  /// `part` names the part or operand at fault, `where` the place in it (file:line, JSON pointer,
  /// parameter); both may be empty.
  explicit Error(Errc code, const std::string& message, std::string part = {},
                 std::string where = {});

  [[nodiscard]] Errc code() const noexcept { return code_; }
  [[nodiscard]] const std::string& part() const noexcept { return part_; }
  [[nodiscard]] const std::string& where() const noexcept { return where_; }
  /// The message without part and place.
  [[nodiscard]] const std::string& message() const noexcept { return message_; }

  /// The same fault, laid at the door of `part` (kept if one is named already).
  [[nodiscard]] Error in_part(const std::string& part) const;

 private:
  Errc code_;
  std::string message_;
  std::string part_;
  std::string where_;
};

}  // namespace dupin
