#include <algorithm>
#include <chrono>
#include <filesystem>
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
#include "dupin/io/avoided_meshes.h"
#include "dupin/io/report_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/error.h"
#include "exit_code.h"

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

/// A file that is looked at again and again, and what was built of it.
class WatchedFile {
 public:
  explicit WatchedFile(std::string file) : file_(std::move(file)), last_(state_of(file_)) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] bool is_there() const { return last_.has_value(); }

  /// Whether it is as it was at the last look.
  bool look() {
    const std::optional<State> now = state_of(file_);
    const bool is_same = now == last_;
    last_ = now;
    return is_same;
  }

  /// Whether it differs from what was built. Where it may be that, and may not, its content tells.
  [[nodiscard]] bool is_changed() {
    if (!is_built_ || last_.has_value() != built_.has_value() ||
        (last_ && last_->written != built_->written)) {
      return true;
    }
    if (!last_) {
      return false;
    }
    const bool is_doubtful = std::chrono::system_clock::now() - last_->changed < kCoarsest &&
                             ++looks_ >= kLooksPerComparison;
    if (last_->changed == built_->changed && !is_doubtful) {
      return false;
    }
    looks_ = 0;
    built_->changed = last_->changed;
    return digest_of(file_) != digest_;
  }

  /// As it was at the last look.
  void set_built() {
    is_built_ = true;
    built_ = last_;
    digest_ = digest_of(file_);
  }

 private:
  std::string file_;
  std::optional<State> last_, built_;
  bool is_built_ = false;
  std::optional<std::string> digest_;  ///< of what is built
  int looks_ = 0;                      ///< since it was compared
};

/// The meshes that a document avoids, where it finds them.
std::vector<WatchedFile> watched_meshes(const std::string& document) {
  std::vector<WatchedFile> meshes;
  const std::filesystem::path folder = std::filesystem::path(document).parent_path();
  try {
    for (const std::string& mesh : avoided_meshes(read_file(document))) {
      meshes.emplace_back((folder / mesh).string());
    }
  } catch (const Error&) {  // it cannot be read, which the build will say
  }
  return meshes;
}

/// Builds whenever the document, or a mesh that it avoids, is another one than the one that was
/// built last. A change during a build ends it: what it would write is old already.
class Watch {
 public:
  Watch(BatchItem item, std::vector<std::string> build, const CommonOptions& common)
      : item_(std::move(item)),
        document_(item_.file),
        build_(std::move(build)),
        quiet_(common.quiet),
        json_(common.json) {}

  /// Until a signal ends the program; or if the first build says that it was called wrongly, which
  /// no change cures.
  ExitCode run() {
    if (!document_.is_there()) {
      say("missing", "there is no " + item_.file + " yet; waiting for it");
    }
    for (;; std::this_thread::sleep_for(kPause)) {
      const bool was_there = document_.is_there();
      const bool is_settled = look();
      if (report_ended() == ExitCode::usage && builds_ == 1) {
        return ExitCode::usage;
      }
      if (document_.is_there() && is_settled && is_changed()) {
        start();
      } else if (!document_.is_there() && was_there) {
        say("gone", item_.file + " is gone; waiting for it");
      }
    }
  }

 private:
  /// Whether all is as it was.
  bool look() {
    bool is_same = document_.look();
    for (WatchedFile& mesh : meshes_) {
      is_same = mesh.look() && is_same;
    }
    return is_same;
  }

  bool is_changed() {
    return document_.is_changed() || std::ranges::any_of(meshes_, &WatchedFile::is_changed);
  }

  void start() {
    child_.reset();
    document_.set_built();
    meshes_ = watched_meshes(item_.file);
    std::ranges::for_each(meshes_, &WatchedFile::set_built);
    child_ = std::make_unique<ChildProcess>(build_, json_);
    ++builds_;
  }

  /// Of a build that has ended, how.
  std::optional<ExitCode> report_ended() {
    const auto ended = child_ ? child_->poll() : std::nullopt;
    if (!ended) {
      return std::nullopt;
    }
    child_.reset();
    if (json_) {
      std::cout << on_one_line(result_json(item_, *ended)) << std::endl;
    }
    const auto code = static_cast<ExitCode>(ended->exit_code);
    if (code != ExitCode::usage || builds_ > 1) {
      say("waiting", "waiting for changes of " + item_.file);
    }
    return code;
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
      std::cerr << "dupin: " + text << std::endl;
    }
  }

  BatchItem item_;
  WatchedFile document_;
  std::vector<WatchedFile> meshes_;  ///< of what is built
  std::vector<std::string> build_;
  bool quiet_, json_;
  std::size_t builds_ = 0;  ///< that were begun
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
      check_destination(*arguments);
      const BatchItem item{*file, arguments->output.path};
      std::vector<std::string> build = arguments_for(*command, item, common);
      build.front() = "build";
      if (common.quiet) {
        build.insert(build.begin() + 1, "--quiet");
      }
      return Watch(item, std::move(build), common).run();
    };
  });
}

}  // namespace dupin::cli
