#include "dupin/kernel/error.h"

#include <utility>

#include "dupin/kernel/printable.h"
#include "support/shortened.h"

namespace dupin {
namespace {

std::string sentence(const std::string& message, const std::string& part,
                     const std::string& where) {
  std::string text;
  if (!where.empty()) {
    text += support::with_short_keys(where) + ": ";
  }
  if (!part.empty()) {
    text += "'" + support::shortened(part) + "': ";
  }
  return printable(text + support::with_short_quotes(message), "\n\t");
}

}  // namespace

std::string_view name(Errc code) {
  switch (code) {
    case Errc::invalid_argument:
      return "invalid_argument";
    case Errc::not_closed:
      return "not_closed";
    case Errc::not_manifold:
      return "not_manifold";
    case Errc::not_oriented:
      return "not_oriented";
    case Errc::self_intersecting:
      return "self_intersecting";
    case Errc::irregular_surface:
      return "irregular_surface";
    case Errc::infeasible_blend:
      return "infeasible_blend";
    case Errc::boolean_failed:
      return "boolean_failed";
    case Errc::contact:
      return "contact";
    case Errc::unroundable:
      return "unroundable";
    case Errc::limit_exceeded:
      return "limit_exceeded";
    case Errc::cancelled:
      return "cancelled";
    case Errc::parse_failed:
      return "parse_failed";
    case Errc::io_failed:
      return "io_failed";
    case Errc::internal:
      return "internal";
  }
  return "unknown";
}

Error::Error(Errc code, const std::string& message, std::string part, std::string where)
    : std::runtime_error(sentence(message, part, where)),
      code_(code),
      message_(support::with_short_quotes(message)),
      part_(std::move(part)),
      where_(std::move(where)) {}

Error Error::in_part(const std::string& part) const {
  return part_.empty() ? Error(code_, message_, part, where_) : *this;
}

}  // namespace dupin
