#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "commands.h"
#include "length.h"
#include "option_list.h"

namespace dupin::cli {
namespace {

/// Text for roff: nothing in it is a request or an escape.
std::string plain(const std::string& text) {
  std::string result;
  for (const char character : text) {
    if (character == '\\') {
      result += "\\e";
    } else if (character == '-') {
      result += "\\-";
    } else {
      result += character;
    }
  }
  return result.starts_with('.') || result.starts_with('\'') ? "\\&" + result : result;
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }

std::string italic(const std::string& text) { return "\\fI" + plain(text) + "\\fR"; }

std::string upper(std::string text) {
  for (char& character : text) {
    character = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
  }
  return text;
}

std::string names_of(const OptionInfo& option) {
  std::string text;
  for (const std::string& name : option.short_names) {
    text += (text.empty() ? "" : ", ") + bold("-" + name);
  }
  for (const std::string& name : option.long_names) {
    text += (text.empty() ? "" : ", ") + bold("--" + name);
  }
  return text + (option.value.empty() ? "" : " " + italic(option.value));
}

void write_options(std::ostream& out, const std::vector<OptionInfo>& options) {
  for (const OptionInfo& option : options) {
    const bool is_positional = !option.positional.empty();
    out << ".TP\n"
        << (is_positional ? italic(option.positional) : names_of(option)) << '\n'
        << plain(option.text);
    if (!option.choices.empty() && !is_positional) {
      out << "; one of";
      for (const std::string& choice : option.choices) {
        out << ' ' << bold(choice);
      }
    }
    out << (option.required && !is_positional ? " (required)\n" : "\n");
  }
}

/// Paragraphs of a footer: text first, then examples a line each.
void write_footer(std::ostream& out, const std::string& footer) {
  std::istringstream lines(footer);
  std::string line;
  bool examples = false;
  while (std::getline(lines, line)) {
    if (line == "Examples:") {
      out << ".SH EXAMPLES\n.EX\n";
      examples = true;
    } else if (line.empty()) {
      out << (examples ? ".EE\n.PP\n" : ".PP\n");
      examples = false;
    } else {
      out << plain(examples && line.starts_with("  ") ? line.substr(2) : line) << '\n';
    }
  }
  out << (examples ? ".EE\n" : "");
}

void write_head(std::ostream& out, const std::string& title, const std::string& description) {
  out << ".TH " << plain(upper(title)) << " 1 \"\" \"dupin\" \"Dupin\"\n"
      << ".SH NAME\n"
      << plain(title) << " \\- " << plain(description) << "\n.SH SYNOPSIS\n";
}

void write_tool(std::ostream& out, const CLI::App& app) {
  write_head(out, "dupin", app.get_description());
  out << bold("dupin") << " [" << italic("OPTIONS") << "] " << italic("COMMAND") << " ...\n"
      << ".SH OPTIONS\n";
  write_options(out, options_of(app));
  out << ".SH COMMANDS\n";
  for (const CLI::App* command : commands_of(app)) {
    out << ".TP\n"
        << bold("dupin-" + command->get_name()) << "(1)\n"
        << plain(command->get_description()) << '\n';
  }
  out << ".SH DESCRIPTION\n";
  write_footer(out, app.get_footer());
}

void write_command(std::ostream& out, const CLI::App& app, const CLI::App& command) {
  const std::vector<OptionInfo> options = options_of(command);
  write_head(out, "dupin-" + command.get_name(), command.get_description());
  out << bold("dupin " + command.get_name()) << " [" << italic("OPTIONS") << "]";
  for (const OptionInfo& option : options) {
    if (!option.positional.empty()) {
      out << ' ' << italic(option.positional) << (option.repeated ? "..." : "");
    }
  }
  out << "\n.SH OPTIONS\n";
  write_options(out, options);
  out << ".SH \"OPTIONS OF ALL COMMANDS\"\n";
  write_options(out, options_of(app));
  out << ".SH DESCRIPTION\n" << plain(command.get_description()) << ".\n.PP\n";
  write_footer(out, command.get_footer());
  out << ".SH \"SEE ALSO\"\n" << bold("dupin") << "(1)\n";
}

}  // namespace

void add_manual(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("manual", "Print the manual page of the tool or a command");
  const auto name = std::make_shared<std::string>();
  command->add_option("COMMAND", *name, "of which; the tool as a whole if not given")
      ->type_name("");
  command->footer(
      "Examples:\n"
      "  dupin manual build | man -l -");
  command->callback([&app, &action, name] {
    action = [&app, name](const CommonOptions& common) {
      refuse_tolerance("manual", common);
      if (name->empty()) {
        write_tool(std::cout, app);
        return ExitCode::ok;
      }
      for (const CLI::App* one : commands_of(app)) {
        if (one->get_name() == *name) {
          write_command(std::cout, app, *one);
          return ExitCode::ok;
        }
      }
      throw UsageError("'" + *name + "' is no command");
    };
  });
}

}  // namespace dupin::cli
