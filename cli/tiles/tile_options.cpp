#include "tiles/tile_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>
#include <system_error>
#include <utility>

#include <CLI/App.hpp>

#include "argument_checks.h"
#include "dupin/io/streamed_format.h"
#include "dupin/io/vtp.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "exchange_options.h"
#include "exit_code.h"

namespace dupin::cli {
namespace {

/// So many districts in a tile, where neither tiles nor memory are given.
constexpr std::size_t kAtOnce = 64;

std::vector<std::size_t> even_ends(std::size_t tiles, std::size_t count) {
  const std::size_t all = std::clamp<std::size_t>(tiles, 1, count);
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i <= all; ++i) {
    ends.push_back(count * i / all);
  }
  return ends;
}

std::vector<std::size_t> ends_within(std::uint64_t memory, const Divided& divided) {
  const auto most = static_cast<double>(memory);
  const auto largest = std::ranges::max_element(divided.bytes);
  if (largest != divided.bytes.end() && *largest > most) {
    const auto i = static_cast<std::size_t>(largest - divided.bytes.begin());
    const Vec3 place = bounds_of(divided.districts.subspan(i, 1)).center();
    throw Error(Errc::limit_exceeded,
                "what hangs together at " + decimal(place) + " has about " +
                    decimal(divided.triangles[i], 2) + " triangles, which need at least " +
                    byte_size(*largest) + "; give --memory more" + divided.remedy,
                {}, divided.source);
  }
  std::vector<std::size_t> ends;
  double tile = 0;
  for (std::size_t i = 0; i < divided.districts.size(); ++i) {
    const double own = divided.bytes[i];
    if (tile + own > most) {
      ends.push_back(i);
      tile = 0;
    }
    tile += own;
  }
  ends.push_back(divided.districts.size());
  return ends;
}

}  // namespace

std::string tiles_of(const std::string& what) {
  return "In so many tiles, one after the other, each of " + what +
         " that have\n"
         "nothing to do with the others, and append them to a binary STL or PLY: the\n"
         "same bytes in less memory";
}

void add_tile_options(CLI::App& command, TileArguments& arguments, const std::string& meaning) {
  auto* const tiles = command.add_option("--tiles", arguments.tiles, meaning)
                          ->type_name("NUMBER")
                          ->check(CLI::Range(1, 1000000));
  command
      .add_option("--memory", arguments.memory,
                  "As many tiles as that takes, such as 4GB: for models larger than memory")
      ->type_name("SIZE")
      ->excludes(tiles);
}

std::uint64_t bytes_in(const std::string& text, const std::string& option) {
  constexpr std::array<std::pair<std::string_view, std::uint64_t>, 4> kUnits{
      {{"kB", 1000}, {"MB", 1000'000}, {"GB", 1000'000'000}, {"TB", 1000'000'000'000}}};
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, number);
  const auto* const unit =
      std::ranges::find(kUnits, std::string_view(stop, end), [](const auto& u) { return u.first; });
  constexpr double kMost = 1e15;
  const double bytes = unit == kUnits.end() ? 0 : number * static_cast<double>(unit->second);
  if (fault != std::errc() || !(bytes >= 1 && bytes <= kMost)) {
    throw UsageError(option + " takes a size such as 500MB or 4GB, not '" + text + "'");
  }
  return static_cast<std::uint64_t>(bytes);
}

bool is_in_files(const OutputArguments& output) {
  return output.format.empty() ? lower_extension(output.path) == kPvtu.extension
                               : output.format == kPvtu.key;
}

Destination tiled_destination(const OutputArguments& output) {
  if (!is_in_files(output)) {
    return destination(output);
  }
  OutputArguments one_file = output;
  one_file.format = kVtp.key;
  Destination to = destination(one_file);
  to.format = kPvtu;
  return to;
}

bool is_tiled(const TileArguments& arguments) {
  return arguments.tiles > 0 || !arguments.memory.empty() || !arguments.cache.empty();
}

std::string why_not_tiled(const Destination& to) {
  if (to.is_stdout() || !is_streamed(to.format)) {
    return kTiledFormats;
  }
  if (to.format.key == kPvtu.key && file_at(to.path).empty()) {
    return "there are files beside a .pvtu: it cannot be a device or a pipe";
  }
  if (!to.patches.empty()) {
    return "--patches looks at all of a solid at once, which --tiles, --memory and .pvtu never "
           "have";
  }
  if (to.verification != Verification::compare) {
    return "with --tiles, --memory, --cache and .pvtu, files are compared as they are written; "
           "--verify "
           "full is what the command check does";
  }
  return {};
}

void require_tiled_output(const Destination& to, const TileArguments& arguments) {
  if (const std::string reason = why_not_tiled(to); !reason.empty()) {
    throw UsageError(reason);
  }
  if (!arguments.memory.empty()) {
    (void)bytes_in(arguments.memory, "--memory");
  }
}

std::vector<std::size_t> ends_of_tiles(const TileArguments& arguments, const Divided& divided) {
  if (!arguments.memory.empty()) {
    return ends_within(bytes_in(arguments.memory, "--memory"), divided);
  }
  const std::size_t count = divided.districts.size();
  return even_ends(
      arguments.tiles > 0 ? arguments.tiles : (count - 1) / (kAtOnce * divided.processes) + 1,
      count);
}

}  // namespace dupin::cli
