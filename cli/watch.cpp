#include <algorithm>
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
#include "dupin/io/atomic_file.h"
#include "dupin/io/report_json.h"
#include "dupin/io/sha256.h"

namespace dupin::cli {
namespace {

/// Looked at so often; a change counts when the file has been the same twice.
constexpr std::chrono::milliseconds kPause(50);

/// Times of files are as coarse as two seconds, on FAT. For twice as long behind a change another
/// one may have the same time.
constexpr std::chrono::seconds kCoarsest(4);
/// In between, content is compared once in so many looks.
constexpr int kLooksPerComparison = 10;

/// What the system says of a file.
struct State {
  /// Tells nearly always that it was written anew: but programs can set times back.
  std::tuple<ino_t, off_t, time_t, long> written;
  /// When anything of it was changed, also its name or permissions.
  std::chrono::sys_time<std::chrono::nanoseconds> changed;

  friend bool operator==(const State&, const State&) = default;
};

/// None if there is no such file.
std::optional<State> state_of(const std::string& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) {
    return std::nullopt;
  }
  return State{{status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec},
               std::chrono::sys_time<std::chrono::nanoseconds>(
                   std::chrono::seconds(status.st_ctim.tv_sec) +
                   std::chrono::nanoseconds(status.st_ctim.tv_nsec))};
}

/// None if it cannot be read, which the build will say.
std::optional<std::string> digest_of(const std::string& file) {
  try {
    return sha256(read_file(file));
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// JSON with line breaks, as reports are, on one line.
std::string on_one_line(const std::string& json) {
  std::string line;
  for (std::size_t at = 0; at < json.size();) {
    const std::size_t begin = std::min(json.find_first_not_of(' ', at), json.size()),
                      end = std::min(json.find('\n', begin), json.size());
    line += json.substr(begin, end - begin);
    at = end + 1;
  }
  return line;
}

/// Builds whenever the file is another one than the one that was built last. A change during a
/// build ends it: what it would write is old already.
class Watch {
 public:
  Watch(BatchItem item, std::vector<std::string> build, const CommonOptions& common)
      : item_(std::move(item)),
        build_(std::move(build)),
        quiet_(common.quiet),
        json_(common.json) {}

  /// Until a signal ends the program.
  [[noreturn]] void run() {
    std::optional<State> last = state_of(item_.file);
    if (!last) {
      say("missing", "there is no " + item_.file + " yet; waiting for it");
    }
    for (;; std::this_thread::sleep_for(kPause)) {
      const std::optional<State> now = state_of(item_.file);
      report_ended();
      if (now && now == last && is_changed(*now)) {
        child_.reset();
        built_ = now;
        digest_ = digest_of(item_.file);
        child_ = std::make_unique<ChildProcess>(build_, json_);
      } else if (!now && last) {
        say("gone", item_.file + " is gone; waiting for it");
      }
      last = now;
    }
  }

 private:
  void report_ended() {
    const auto ended = child_ ? child_->poll() : std::nullopt;
    if (!ended) {
      return;
    }
    child_.reset();
    if (json_) {
      std::cout << on_one_line(result_json(item_, *ended)) << std::endl;
    }
    say("waiting", "waiting for changes of " + item_.file);
  }

  /// Where it may be the one that was built, and may not, its content tells.
  [[nodiscard]] bool is_changed(const State& now) {
    if (!built_ || now.written != built_->written) {
      return true;
    }
    const bool is_doubtful = std::chrono::system_clock::now() - now.changed < kCoarsest &&
                             ++looks_ >= kLooksPerComparison;
    if (now.changed == built_->changed && !is_doubtful) {
      return false;
    }
    looks_ = 0;
    built_->changed = now.changed;
    return digest_of(item_.file) != digest_;
  }

  /// With --json, all that is said is an object on a line of its own.
  void say(const std::string& state, const std::string& text) const {
    if (quiet_) {
      return;
    }
    if (json_) {
      std::cout << "{\"file\": " << string_json(item_.file) << ", \"state\": \"" << state << "\"}"
                << std::endl;
    } else {
      std::cerr << "dupin: " << text << std::endl;
    }
  }

  BatchItem item_;
  std::vector<std::string> build_;
  bool quiet_, json_;
  std::optional<State> built_;
  std::optional<std::string> digest_;  ///< of what is built
  int looks_ = 0;                      ///< since it was compared
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
      "one again; a document that is not there is waited for. Takes the options of build; with\n"
      "--json it prints an object a line.\n\n"
      "Examples:\n"
      "  dupin watch plant.json -o plant.stl");
  command->callback([command, arguments, file, &action] {
    action = [command, arguments, file](const CommonOptions& common) -> ExitCode {
      if (*file == "-" || output_path(arguments->output.path) == "-") {
        throw UsageError("watch needs files, not standard input or output");
      }
      (void)destination(arguments->output);
      const BatchItem item{*file, arguments->output.path};
      std::vector<std::string> build = arguments_for(*command, item, common);
      build.front() = "build";
      if (common.quiet) {
        build.insert(build.begin() + 1, "--quiet");
      }
      Watch(item, std::move(build), common).run();
    };
  });
}

}  // namespace dupin::cli
