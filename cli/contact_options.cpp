#include "contact_options.h"

#include <utility>

#include <CLI/App.hpp>

#include "dupin/kernel/contacts.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
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

void require_something_left(const OutputReport& report, std::size_t triangles) {
  if (triangles > 0 || !report.settled) {
    return;
  }
  throw Error(Errc::contact, "the solid is so small that separating its contacts within " +
                                 decimal(report.settled->length, kMessageDigits) +
                                 " leaves nothing of it; a smaller length may do");
}

Rounded rounded_apart(const Solid& solid, Coordinates coordinates, const RoundingOptions& options,
                      OutputReport& report) {
  RoundedApart apart = dupin::rounded_apart(solid, coordinates, options);
  if (!apart.contacts.empty()) {
    report.settled = {"separate", apart.length, std::move(apart.contacts)};
  }
  return std::move(apart.rounded);
}

}  // namespace dupin::cli
