#include "length.h"

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

double mesh_length(const std::string& text, double otherwise, const std::string& mesh_unit) {
  if (text.empty()) {
    return otherwise;
  }
  return length_in(mesh_unit.empty() ? Unit::millimetre : unit_from(mesh_unit), text, otherwise);
}

void refuse_tolerance(const std::string& command, const CommonOptions& common,
                      const std::string& instead) {
  if (!common.tolerance.empty()) {
    throw UsageError(command + " has no use for --tolerance" +
                     (instead.empty() ? "" : "; did you mean " + instead + "?"));
  }
}

}  // namespace dupin::cli
