#include "cli/tool.h"

#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "support/shapes.h"
#include "support/source_folder.h"

namespace dupin::test {

ProcessResult Tool::dupin(std::vector<std::string> arguments, const std::string& input) const {
  arguments.insert(arguments.begin(), tool_path());
  return run_process(arguments, folder_.path(), input);
}

ProcessResult Tool::shell(const std::string& line) const {
  const std::filesystem::path examples = source_folder() / "examples";
  const std::string prelude = "dupin() { " + tool_path() + " \"$@\"; }; [ -e examples ] || ln -s " +
                              examples.string() + " examples; ";
  return run_process({"bash", "-c", prelude + line}, folder_.path());
}

nlohmann::json Tool::json(std::vector<std::string> arguments, int exit_code) const {
  arguments.insert(arguments.begin(), "--json");
  const ProcessResult result = dupin(std::move(arguments));
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_EQ(result.err, "");
  return nlohmann::json::parse(result.out, nullptr, false);
}

void Tool::put(const std::string& name, const TriMesh& mesh) const {
  folder_.write(name, mesh_bytes(mesh, kOff));
}

std::string tool_path() { return DUPIN_TOOL; }

std::string example(const std::string& name) {
  return (source_folder() / "examples" / name).string();
}

TriMesh open_box() {
  TriMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.triangles.erase(mesh.triangles.begin());
  return mesh;
}

}  // namespace dupin::test
