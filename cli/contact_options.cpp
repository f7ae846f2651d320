#include "contact_options.h"

#include <CLI/App.hpp>

#include "dupin/kernel/contacts.h"
#include "exit_code.h"
#include "length.h"

namespace dupin::cli {

void add_contacts_option(CLI::App& command, std::string& contacts) {
  command
      .add_option("--contacts", contacts,
                  "Where the result touches itself: report it (default), refuse, take\n"
                  "material away (separate=LENGTH) or add some (bridge=LENGTH)")
      ->type_name("POLICY");
}

ContactChoice contact_choice(const std::string& text, const std::string& unit) {
  using Kind = ContactChoice::Kind;
  if (text.empty() || text == "report") {
    return {};
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

}  // namespace dupin::cli
