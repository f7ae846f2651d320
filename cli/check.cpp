#include "dupin/kernel/check.h"

#include <cstdint>
#include <iostream>
#include <memory>
#include <span>

#include <CLI/App.hpp>

#include "commands.h"
#include "dupin/io/scratch_file.h"
#include "dupin/io/stl_stream.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/tiled_check.h"
#include "exit_code.h"
#include "input.h"
#include "length.h"
#include "progress_line.h"
#include "report_text.h"
#include "tiles/tile_options.h"

namespace dupin::cli {
namespace {

/// What the system refuses of a temporary file is an error of writing.
class TemporaryFile : public ScratchFile {
 public:
  void write(std::uint64_t at, std::span<const char> bytes) override {
    writing([&] { ScratchFile::write(at, bytes); });
  }
};

Report checked_in_tiles(const std::string& file, const TileArguments& tiles) {
  require_read_again(file, "--tiles and --memory read it more than once");
  TiledCheckOptions options;
  if (tiles.memory.empty()) {
    options.tiles = tiles.tiles;
  } else {
    options.memory = bytes_in(tiles.memory, "--memory");
  }
  const StlFile facets(file);
  const auto scratch = writing([] { return std::make_unique<TemporaryFile>(); });
  try {
    return check_in_tiles(facets, *scratch, options);
  } catch (const Error& error) {
    if (error.code() == Errc::limit_exceeded) {
      throw error.in_part(file);
    }
    throw;
  }
}

Report checked(const std::string& file, const TileArguments& tiles, const CommonOptions& common) {
  ProgressLine line(common.quiet);
  const Progress progress = line.callback();
  if (is_tiled(tiles)) {
    tell(progress, "check");
    return checked_in_tiles(file, tiles);
  }
  tell(progress, "read");
  const TriMesh mesh = read_mesh_input(file);
  tell(progress, "check");
  return check(mesh);
}

ExitCode run_check(const std::string& file, const TileArguments& tiles,
                   const CommonOptions& common) {
  refuse_tolerance("check", common);
  const Report report = checked(file, tiles, common);
  if (common.json) {
    std::cout << to_json(report) << '\n';
  } else if (!common.quiet) {
    print_report(std::cout, report);
  }
  return report.is_solid() ? ExitCode::ok : ExitCode::findings;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("check", "Say whether a mesh is a solid, and if not, why");
  const auto file = std::make_shared<std::string>();
  command->add_option("FILE", *file, "mesh file; - for standard input")->type_name("")->required();
  const auto tiles = std::make_shared<TileArguments>();
  add_tile_options(*command, *tiles,
                   "In so many tiles of space, one after the other, of a binary STL: the same\n"
                   "report in less memory");
  command->footer(
      "Exit code 1 means that the mesh is no solid.\n\n"
      "Examples:\n"
      "  dupin check part.stl\n"
      "  dupin check part.stl --json | jq .counts\n"
      "  dupin check plant.stl --memory 4GB");
  command->callback([file, tiles, &action] {
    action = [file, tiles](const CommonOptions& common) {
      return run_check(*file, *tiles, common);
    };
  });
}

}  // namespace dupin::cli
