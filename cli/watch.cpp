#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>
#include <tuple>

#include <CLI/App.hpp>
#include <sys/stat.h>

#include "batch.h"
#include "build_arguments.h"
#include "child_process.h"
#include "commands.h"

namespace dupin::cli {
namespace {

/// Looked at so often; a change counts when the file has been the same twice.
constexpr std::chrono::milliseconds kPause(50);

/// What tells that a file was written anew; empty if there is none.
using State = std::optional<std::tuple<ino_t, off_t, time_t, long>>;

State state_of(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) {
    return std::nullopt;
  }
  return State{{status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec}};
}

/// Builds whenever the file is another one than the one that was built last. A change during a
/// build ends it: what it would write is old already.
class Watch {
 public:
  Watch(std::string file, std::vector<std::string> build, bool quiet)
      : file_(std::move(file)), build_(std::move(build)), quiet_(quiet) {}

  /// Until a signal ends the program.
  [[noreturn]] void run() {
    for (State last = state_of(file_);; std::this_thread::sleep_for(kPause)) {
      const State now = state_of(file_);
      if (child_) {
        if (const auto ended = child_->poll()) {
          child_.reset();
          say("waiting for changes of " + file_);
        }
      }
      if (now == last && now && (!is_built_ || now != built_)) {
        child_.reset();
        built_ = now;
        is_built_ = true;
        child_ = std::make_unique<ChildProcess>(build_, false);
      } else if (!now && last) {
        say(file_ + " is gone; waiting for it");
      }
      last = now;
    }
  }

 private:
  void say(const std::string& text) const {
    if (!quiet_) {
      std::cerr << "dupin: " << text << std::endl;
    }
  }

  std::string file_;
  std::vector<std::string> build_;
  bool quiet_;
  State built_;
  bool is_built_ = false;
  std::unique_ptr<ChildProcess> child_;
};

}  // namespace

void add_watch(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("watch", "Build a document whenever it changes");
  const auto arguments = std::make_shared<BuildArguments>();
  const auto file = std::make_shared<std::string>();
  command->add_option("FILE", *file, "assembly document, piping file (.pcf) or graph")
      ->type_name("")
      ->required();
  command->add_option("-o,--output", arguments->output.path, "mesh file")
      ->type_name("OUT")
      ->required();
  add_build_options(*command, *arguments);
  command->footer(
      "Ctrl-C ends it. An error is shown, and the file written before stays until the document is\n"
      "one again. Takes the options of build.\n\n"
      "Examples:\n"
      "  dupin watch plant.json -o plant.stl");
  command->callback([command, arguments, file, &action] {
    action = [command, arguments, file](const CommonOptions& common) -> ExitCode {
      if (*file == "-" || output_path(arguments->output.path) == "-") {
        throw UsageError("watch needs files, not standard input or output");
      }
      if (!state_of(*file)) {
        throw Error(Errc::io_failed, "cannot read the file: No such file or directory", {}, *file);
      }
      (void)destination(arguments->output);
      std::vector<std::string> build =
          arguments_for(*command, {*file, arguments->output.path}, common);
      build.front() = "build";
      if (common.quiet) {
        build.insert(build.begin() + 1, "--quiet");
      }
      Watch(*file, std::move(build), common.quiet).run();
    };
  });
}

}  // namespace dupin::cli
