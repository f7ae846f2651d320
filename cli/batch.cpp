#include "batch.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <system_error>

#include <CLI/App.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "argument_checks.h"
#include "child_process.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/report_json.h"
#include "option_list.h"
#include "progress_line.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

std::string extension_of(const std::string& key) {
  const MeshFormat* const format = find_mesh_format(key);
  if (format != nullptr && !format->extension.empty()) {
    return std::string(format->extension);
  }
  return "." + key.substr(0, key.find('-'));
}

bool is_of_the_batch(const CLI::Option& option) {
  return option.get_positional() || option.check_lname("out-dir") || option.check_lname("jobs") ||
         option.check_lname("output") || option.check_lname("help");
}

void refuse_files_for_all(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (!is_of_the_batch(*option) && option->count() > 0 && option->get_type_name() == "FILE") {
      throw UsageError(option->get_name() + " names one file, and --out-dir is for many documents");
    }
  }
}

std::string trimmed(std::string text) {
  while (!text.empty() && text.back() == '\n') {
    text.pop_back();
  }
  return text;
}

std::string_view verdict(const ChildResult& result) {
  return result.exit_code == static_cast<int>(ExitCode::ok)         ? "built"
         : result.exit_code == static_cast<int>(ExitCode::findings) ? "findings"
                                                                    : "failed";
}

std::string reason(const BatchItem& item, const ChildResult& result) {
  const std::string said = trimmed(result.err);
  return !said.empty()
             ? said
             : "dupin: " + item.file + ": ended with exit code " + std::to_string(result.exit_code);
}

/// Runs all, and tells of each in its order as soon as those before it are told.
class Batch {
 public:
  Batch(const CLI::App& command, const std::vector<BatchItem>& items, const CommonOptions& common)
      : command_(command), items_(items), common_(common), results_(items.size()) {}

  ExitCode run(std::size_t jobs) {
    std::cout << (common_.json ? "{\n  \"documents\": [" : "");
    ProgressLine line(common_.quiet);
    const Progress progress = line.callback();
    for (std::size_t next = 0; next < items_.size() || !running_.empty();) {
      if (next < items_.size() && running_.size() < jobs) {
        start(next++);
        continue;
      }
      finish_one();
      tell(progress, "documents", double(done_) / double(items_.size()));
    }
    say_all();
    const bool is_misused = std::ranges::all_of(results_, [](const auto& result) {
      return result->exit_code == static_cast<int>(ExitCode::usage);
    });
    return is_misused                          ? ExitCode::usage
           : counts_["built"] == items_.size() ? ExitCode::ok
                                               : ExitCode::findings;
  }

 private:
  void start(std::size_t index) {
    auto child =
        std::make_unique<ChildProcess>(arguments_for(command_, items_[index], common_), true);
    const pid_t id = child->id();
    running_[id] = {index, std::move(child)};
  }

  void finish_one() {
    int status = 0;
    const pid_t id = ::waitpid(-1, &status, 0);
    const auto found = running_.find(id);
    if (found == running_.end()) {
      return;
    }
    const std::size_t index = found->second.first;
    results_[index] = found->second.second->finished(status);
    running_.erase(found);
    ++done_;
    for (; told_ < items_.size() && results_[told_]; ++told_) {
      say(told_);
    }
  }

  void say(std::size_t index) {
    const ChildResult& result = *results_[index];
    const BatchItem& item = items_[index];
    const std::string_view what = verdict(result);
    ++counts_[std::string(what)];
    if (common_.json) {
      std::cout << (index == 0 ? "\n" : ",\n") << result_json(item, result);
    } else if (!common_.quiet) {
      std::cout << what << std::string(10 - what.size(), ' ') << item.file
                << (what == "failed" ? "" : " -> " + item.output) << std::endl;
    }
  }

  void say_all() {
    if (common_.json) {
      std::cout << "\n  ],\n  \"built\": " << counts_["built"]
                << ",\n  \"findings\": " << counts_["findings"]
                << ",\n  \"failed\": " << counts_["failed"] << "\n}\n";
      return;
    }
    std::ostream& out = common_.quiet ? std::cerr : std::cout;
    if (!common_.quiet) {
      out << counted(items_.size(), "document") << ": " << counts_["built"] << " built, "
          << counts_["findings"] << " with findings, " << counts_["failed"] << " failed\n";
    }
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (verdict(*results_[i]) == "failed") {
        out << reason(items_[i], *results_[i]) << '\n';
      }
    }
  }

  const CLI::App& command_;
  const std::vector<BatchItem>& items_;
  const CommonOptions& common_;
  std::vector<std::optional<ChildResult>> results_;
  std::map<pid_t, std::pair<std::size_t, std::unique_ptr<ChildProcess>>> running_;
  std::map<std::string, std::size_t> counts_;
  std::size_t done_ = 0, told_ = 0;
};

[[noreturn]] void refuse_both(const std::string& first, const std::string& second,
                              const std::string& output) {
  throw UsageError("'" + first + "' and '" + second + "' would both become '" + output + "'");
}

[[noreturn]] void refuse_in_place(const std::string& other, const std::string& file,
                                  const std::string& output) {
  throw UsageError("'" + output + "' of '" + file + "' would take the place of '" + other + "'");
}

}  // namespace

std::vector<BatchItem> batch_items(const std::vector<std::string>& files, const std::string& folder,
                                   const std::string& format) {
  const std::string extension = extension_of(format.empty() ? "stl" : format);
  std::map<std::filesystem::path, std::string> inputs, owners;  // by the files that they are
  for (const std::string& file : files) {
    inputs.emplace(file_at(file), file);
  }
  std::vector<BatchItem> items;
  for (const std::string& file : files) {
    if (file == "-") {
      throw UsageError("--out-dir names outputs like inputs, and standard input has no name");
    }
    const std::filesystem::path name = std::filesystem::path(file).stem().string() + extension;
    const std::string output = (std::filesystem::path(folder) / name).string();
    items.push_back({file, output});
    const std::filesystem::path place = file_at(output);
    if (place.empty()) {
      continue;
    }
    const auto [owner, is_new] = owners.emplace(place, file);
    if (!is_new) {
      refuse_both(owner->second, file, output);
    }
    if (const auto other = inputs.find(place); other != inputs.end()) {
      refuse_in_place(other->second, file, output);
    }
  }
  return items;
}

std::vector<std::string> arguments_for(const CLI::App& command, const BatchItem& item,
                                       const CommonOptions& common) {
  std::vector<std::string> words{command.get_name()};
  const auto add = [&](const CLI::Option& option) {
    const std::string name = option.get_lnames().empty() ? "-" + option.get_snames().front()
                                                         : "--" + option.get_lnames().front();
    const bool is_flag = option.get_items_expected_max() == 0;
    for (const std::string& value : option.results()) {
      words.push_back(name);
      if (!is_flag) {
        words.push_back(value);
      }
    }
  };
  for (const CLI::Option* option : command.get_options()) {
    if (!is_of_the_batch(*option)) {
      add(*option);
    }
  }
  if (!common.tolerance.empty()) {
    words.insert(words.end(), {"--tolerance", common.tolerance});
  }
  if (common.json) {
    words.emplace_back("--json");
  }
  words.insert(words.end(), {"-o", item.output, "--", item.file});
  return words;
}

std::string result_json(const BatchItem& item, const ChildResult& result) {
  const bool has_report = verdict(result) != "failed";
  const std::string text = trimmed(has_report ? result.out : result.err);
  return "{\"file\": " + string_json(item.file) +
         ", \"output\": " + (has_report ? string_json(item.output) : "null") +
         ", \"exit\": " + std::to_string(result.exit_code) +
         (has_report ? ", \"report\": " : ", \"failure\": ") +
         (text.starts_with('{') ? text : "null") + "}";
}

ExitCode run_batch(const CLI::App& command, const std::vector<BatchItem>& items,
                   const std::string& folder, std::size_t jobs, const CommonOptions& common) {
  refuse_files_for_all(command);
  std::error_code failure;
  std::filesystem::create_directories(end_of_links(folder), failure);
  if (failure) {
    throw OutputError(
        Error(Errc::io_failed, "cannot make the folder: " + failure.message(), {}, folder));
  }
  return Batch(command, items, common).run(std::max<std::size_t>(jobs, 1));
}

}  // namespace dupin::cli
