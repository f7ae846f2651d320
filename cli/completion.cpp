#include <iostream>
#include <memory>
#include <string>

#include <CLI/App.hpp>

#include "commands.h"
#include "completion_scripts.h"
#include "length.h"

namespace dupin::cli {

void add_completion(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("completion", "Print a completion script for the shell");
  command->footer(
      "Examples:\n"
      "  source <(dupin completion bash)\n"
      "  dupin completion fish > ~/.config/fish/completions/dupin.fish");
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")
      ->type_name("")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->callback([&app, &action, shell] {
    action = [&app, shell](const CommonOptions& common) {
      refuse_tolerance("completion", common);
      std::cout << (*shell == "bash"  ? bash_completion(app)
                    : *shell == "zsh" ? zsh_completion(app)
                                      : fish_completion(app));
      return ExitCode::ok;
    };
  });
}

}  // namespace dupin::cli
