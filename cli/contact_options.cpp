#include "contact_options.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <CLI/App.hpp>

#include "dupin/kernel/contacts.h"
#include "dupin/kernel/error.h"
#include "exit_code.h"
#include "length.h"

namespace dupin::cli {

void add_contacts_option(CLI::App& command, std::string& contacts) {
  command
      .add_option("--contacts", contacts,
                  "Where the result touches itself: report it (default but for STL), refuse,\n"
                  "take material away (separate=LENGTH; for STL one spacing of its\n"
                  "numbers) or add some (bridge=LENGTH)")
      ->type_name("POLICY");
}

ContactChoice contact_choice(const std::string& text, const std::string& unit) {
  using Kind = ContactChoice::Kind;
  if (text.empty()) {
    return {};
  }
  if (text == "report") {
    return {Kind::report};
  }
  if (text == "refuse") {
    return {Kind::refuse};
  }
  const std::size_t equals = text.find('=');
  const std::string verb = text.substr(0, equals);
  if (equals != std::string::npos && equals + 1 < text.size() &&
      (verb == "separate" || verb == "bridge")) {
    return {verb == "bridge" ? Kind::bridge : Kind::separate,
            mesh_length(text.substr(equals + 1), 0, unit)};
  }
  throw UsageError("--contacts takes report, refuse, separate=LENGTH or bridge=LENGTH, not '" +
                   text + "'");
}

Solid settle(const Solid& solid, const ContactChoice& choice, OutputReport& report) {
  const bool is_bridge = choice.kind == ContactChoice::Kind::bridge;
  if ((!is_bridge && choice.kind != ContactChoice::Kind::separate) || solid.contacts().empty()) {
    return solid;
  }
  Settled settled = is_bridge ? bridge(solid, choice.length) : separate(solid, choice.length);
  report.settled = {is_bridge ? "bridge" : "separate", choice.length, std::move(settled.contacts)};
  return settled.solid;
}

namespace {

// By as few spacings of the numbers as it takes; none where none does.
std::optional<Rounded> separated_and_rounded(const Solid& solid, Coordinates coordinates,
                                             const RoundingOptions& options, OutputReport& report) {
  constexpr double kMost = 64;
  double largest = 0;
  for (const Vec3& point : solid.nearest_points()) {
    largest = std::max(largest, point.cwiseAbs().maxCoeff());
  }
  // separate() asks for more than 2^-32 of the largest coordinate.
  const int digits = coordinates == Coordinates::binary32 ? 23 : 31;
  const double spacing = std::ldexp(1.0, std::ilogb(largest) - digits);
  for (double length = spacing; length <= kMost * spacing; length *= 2) {
    try {
      Settled settled = separate(solid, length);
      Rounded rounded = to_mesh(settled.solid, coordinates, options);
      if (rounded.contacts().empty()) {
        report.settled = {"separate", length, std::move(settled.contacts)};
        return rounded;
      }
    } catch (const Error& error) {
      if (error.code() != Errc::contact && error.code() != Errc::unroundable) {
        throw;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Rounded rounded_apart(const Solid& solid, Coordinates coordinates, const RoundingOptions& options,
                      OutputReport& report) {
  if (!solid.contacts().empty()) {
    if (auto rounded = separated_and_rounded(solid, coordinates, options, report)) {
      return *std::move(rounded);
    }
  }
  Rounded rounded = parted(to_mesh(solid, coordinates, options), options);
  if (!rounded.report().parted.empty()) {
    report.settled = {"separate", rounded.report().parted_by, rounded.report().parted};
  }
  return rounded;
}

}  // namespace dupin::cli
