#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "child_process.h"
#include "commands.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's own name
class App;
}

namespace dupin::cli {

/// One document of many, and where its mesh goes.
struct BatchItem {
  std::string file, output;
};

/// Names of outputs are those of inputs with the format's extension. Throws UsageError for two that
/// are one file, for one that is another's input, and for standard input.
[[nodiscard]] std::vector<BatchItem> batch_items(const std::vector<std::string>& files,
                                                 const std::string& folder,
                                                 const std::string& format);

/// The command line that does to one document what `command` was asked to do to many.
[[nodiscard]] std::vector<std::string> arguments_for(const CLI::App& command, const BatchItem& item,
                                                     const CommonOptions& common);

/// What became of one document, as an object in JSON: file, output, exit, and report or failure.
[[nodiscard]] std::string result_json(const BatchItem& item, const ChildResult& result);

/// Builds each document by a process of its own, at most `jobs` at a time, and reports them in
/// their order, failures again at the end. Throws UsageError for options that name one file for
/// all, and OutputError if the folder cannot be made.
[[nodiscard]] ExitCode run_batch(const CLI::App& command, const std::vector<BatchItem>& items,
                                 const std::string& folder, std::size_t jobs,
                                 const CommonOptions& common);

}  // namespace dupin::cli
