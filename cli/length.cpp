#include "length.h"

#include <string_view>

#include "exit_code.h"

namespace dupin::cli {

double length_in(Unit unit, const std::string& text, double otherwise) {
  if (text.empty()) {
    return otherwise;
  }
  try {
    return parse_length(text, unit);
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
}

double document_length(const std::string& option, Unit unit, const std::string& text,
                       double otherwise) {
  constexpr double kLargest = 1e12, kSmallest = 1e-12;  // as documents have them
  const double length = length_in(unit, text, otherwise);
  if (!text.empty() && !(length >= kSmallest && length <= kLargest)) {
    throw UsageError(option + " " + text + " is out of range: in " + std::string(symbol(unit)) +
                     ", lengths are between 1e-12 and 1e12");
  }
  return length;
}

double mesh_length(const std::string& text, double otherwise, const std::string& mesh_unit) {
  constexpr std::string_view kMicron = "um";  // which no document is in
  constexpr double kInMillimetre = 1000;
  if (text.empty()) {
    return otherwise;
  }
  const bool is_of_microns = mesh_unit == kMicron;
  const Unit unit = mesh_unit.empty() || is_of_microns ? Unit::millimetre : unit_from(mesh_unit);
  if (text.ends_with(kMicron)) {
    const std::string thousandfold = text.substr(0, text.size() - kMicron.size()) + "mm";
    return length_in(unit, thousandfold, 0) / (is_of_microns ? 1 : kInMillimetre);
  }
  const bool has_unit = text.back() >= 'a' && text.back() <= 'z';
  return length_in(unit, text, 0) * (is_of_microns && has_unit ? kInMillimetre : 1);
}

void refuse_tolerance(const std::string& command, const CommonOptions& common,
                      const std::string& instead) {
  if (!common.tolerance.empty()) {
    throw UsageError(command + " has no use for --tolerance" +
                     (instead.empty() ? "" : "; did you mean " + instead + "?"));
  }
}

}  // namespace dupin::cli
