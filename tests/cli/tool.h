#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "dupin/kernel/mesh.h"
#include "support/process.h"

namespace dupin::test {

/// Runs the real tool in an empty folder of its own.
class Tool : public testing::Test {
 protected:
  [[nodiscard]] ProcessResult dupin(std::vector<std::string> arguments,
                                    const std::string& input = {}) const;
  /// A line for bash, in which `dupin` is the tool and examples/ is at hand.
  [[nodiscard]] ProcessResult shell(const std::string& line) const;
  /// Runs with --json, expects the exit code, and parses standard output.
  [[nodiscard]] nlohmann::json json(std::vector<std::string> arguments, int exit_code) const;

  /// Puts a mesh into the folder as OFF.
  void put(const std::string& name, const TriMesh& mesh) const;

  TemporaryFolder folder_;
};

/// The path of the tool.
[[nodiscard]] std::string tool_path();

/// The path of a document in examples/.
[[nodiscard]] std::string example(const std::string& name);

/// A box without its first face.
[[nodiscard]] TriMesh open_box();

}  // namespace dupin::test
