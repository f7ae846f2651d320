#pragma once

#include <string>

#include "dupin/io/report_json.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/solid.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// What --contacts says to do where a result touches itself.
struct ContactChoice {
  enum class Kind {
    standard,  ///< separate for formats whose readers weld, report for others
    report,
    refuse,
    separate,
    bridge
  };
  Kind kind = Kind::standard;
  double length = 0;  ///< to separate or bridge within

  /// What the set operation itself has to do.
  [[nodiscard]] ContactPolicy policy() const {
    return kind == Kind::refuse ? ContactPolicy::refuse : ContactPolicy::report;
  }
};

/// Adds --contacts report|refuse|separate=LENGTH|bridge=LENGTH.
void add_contacts_option(CLI::App& command, std::string& contacts);

/// What was typed, lengths in `unit` (see mesh_length). Throws UsageError.
[[nodiscard]] ContactChoice contact_choice(const std::string& text, const std::string& unit);

/// The solid after what was chosen, told in `report`.
[[nodiscard]] Solid settle(const Solid& solid, const ContactChoice& choice, OutputReport& report);

/// Throws Error{contact} where separating has left none of the whole's triangles.
void require_something_left(const OutputReport& report, std::size_t triangles);

/// The solid rounded, apart where it touches itself by as few spacings of the coordinates as it
/// takes: one, two, four to 64; else, and where only the rounded solid touches itself, by moves of
/// its points. Told in `report`. Where none of that does, as it is.
[[nodiscard]] Rounded rounded_apart(const Solid& solid, Coordinates coordinates,
                                    const RoundingOptions& options, OutputReport& report);

}  // namespace dupin::cli
