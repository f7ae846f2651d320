#include "tiled_build.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/App.hpp>

#include "district_cache.h"
#include "district_result.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/io/sha256.h"
#include "dupin/io/stl.h"
#include "dupin/io/stl_stream.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "exit_code.h"
#include "report_text.h"

namespace dupin::cli {
namespace {

/// So many districts in a tile, where neither tiles nor memory are given.
constexpr std::size_t kAtOnce = 64;

/// What a build needs for a triangle of its result, measured (docs/cli.md).
constexpr double kBytesPerTriangle = 400;

/// Of the standard tolerance of rounding, 1024 spacings of the numbers of a file at the largest
/// coordinate, and half a spacing more.
constexpr double kMostSpacings = 1025;

std::uint64_t bytes_in(const std::string& text) {
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
    throw UsageError("--memory takes a size such as 500MB or 4GB, not '" + text + "'");
  }
  return static_cast<std::uint64_t>(bytes);
}

void append(std::vector<Contact> from, std::vector<Contact>& to) {
  std::ranges::move(from, std::back_inserter(to));
}

/// For districts: the whole's origin and, of its extent, the power of two that decides about
/// rounding, so that a change elsewhere hardly ever is one here.
RoundingOptions rounding_of_districts(RoundingOptions rounding, std::span<const Boxes> boxes) {
  const Eigen::AlignedBox3d all = bounds_of(boxes);
  if (boxes.size() < 2 || !all.min().allFinite() || !all.max().allFinite()) {
    return rounding;
  }
  rounding.whole = all;
  const Vec3 origin = to_mesh(Solid(), Coordinates::binary64, rounding).report().origin;
  rounding.origin = {.choice = Origin::Choice::given, .place = origin};
  const double largest = std::max((all.min() - origin).cwiseAbs().maxCoeff(),
                                  (all.max() - origin).cwiseAbs().maxCoeff());
  const Vec3 half = Vec3::Constant(std::exp2(std::ilogb(largest)));
  rounding.whole = Eigen::AlignedBox3d(origin - half, origin + half);
  return rounding;
}

/// All that decides about a district's facets, besides its document.
std::string text_of(const BuildOptions& options, const ContactChoice& contacts,
                    const RoundingOptions& rounding) {
  std::string text = "dupin " DUPIN_VERSION;
  const auto add = [&text](double number) { text += " " + decimal(number); };
  add(options.region ? static_cast<double>(*options.region) : -1);
  add(static_cast<double>(options.contacts));
  add(static_cast<double>(contacts.kind));
  add(contacts.length);
  add(rounding.tolerance);
  add(rounding.output_grid);
  add(static_cast<double>(rounding.origin.choice));
  const Eigen::AlignedBox3d whole =
      rounding.whole.value_or(Eigen::AlignedBox3d(Vec3(Vec3::Zero()), Vec3(Vec3::Zero())));
  for (const Vec3& place : {rounding.origin.place, Vec3(whole.min()), Vec3(whole.max())}) {
    std::ranges::for_each(place, add);
  }
  return text + "\n";
}

/// Meshes in the way of parts are not in the document, but in files beside it.
void append_meshes(const Assembly& assembly, std::string& text) {
  for (const Part& part : assembly.parts) {
    std::visit(
        [&text](const auto& shape) {
          if constexpr (requires { shape.avoid->obstacles; }) {
            for (const auto& obstacle : shape.avoid.value_or(Avoidance{}).obstacles) {
              if (const auto* given = std::get_if<MeshObstacle>(&obstacle)) {
                text += "\n" + sha256(mesh_bytes(*given->mesh, kOff));
              }
            }
          }
        },
        part.shape);
  }
}

class TiledBuild {
 public:
  TiledBuild(const Document& document, const BuildOptions& options, const BuildArguments& arguments,
             const Ranks& ranks)
      : ranks_(ranks),
        plan_(document.assembly, options),
        boxes_(plan_.boxes()),
        to_(destination(arguments.output)),
        contacts_(contact_choice(arguments.contacts, std::string(symbol(document.assembly.unit)))),
        rounding_(
            rounding_options(arguments.rounding, std::string(symbol(document.assembly.unit)))),
        progress_(options.progress) {
    rounding_ = rounding_of_districts(rounding_, boxes_);
    options_text_ = text_of(options, contacts_, rounding_);
    if (!arguments.tiles.cache.empty()) {
      cache_.emplace(arguments.tiles.cache);
    }
    const TileArguments& tiles = arguments.tiles;
    if (!tiles.memory.empty()) {
      divide_by_memory(bytes_in(tiles.memory), document.assembly);
    } else {
      divide_evenly(tiles.tiles > 0 ? tiles.tiles
                                    : (plan_.size() - 1) / (kAtOnce * ranks.count()) + 1);
    }
  }

  Built run(MeshHeader header, OutputReport& report) {
    StlStream stream(to_.path);
    std::vector<Built> built;
    std::size_t begin = 0;
    report.check.emplace();
    for (const std::size_t end : ends_) {
      tell(progress_, "build", double(begin) / double(plan_.size()));
      std::vector<std::optional<DistrictResult>> tile = own_results(begin, end);
      for (std::size_t i = 0; i < tile.size(); ++i) {
        DistrictResult district = tile[i] ? *std::move(tile[i]) : received(begin + i);
        tile[i].reset();
        stream.append(district.facets);
        take(std::move(district.output), report);
        built.push_back(std::move(district.built));
      }
      begin = end;
    }
    note_origin(report.rounding.origin, header);
    stream.commit(header);
    report.file = to_.path;
    report.format = to_.format.name;
    report.verification = to_.verification;
    return plan_.joined(std::move(built));
  }

  // Of ranks but the first, which writes.
  void run_for_first() const {
    std::size_t begin = 0;
    for (const std::size_t end : ends_) {
      const auto tile = own_results(begin, end);
      for (std::size_t i = 0; i < tile.size(); ++i) {
        if (tile[i]) {
          ranks_.send(bytes_of(*tile[i], plan_.parts(begin + i)));
        }
      }
      begin = end;
    }
  }

 private:
  void divide_evenly(std::size_t tiles) {
    const std::size_t count = plan_.size(), all = std::clamp<std::size_t>(tiles, 1, count);
    for (std::size_t i = 1; i <= all; ++i) {
      ends_.push_back(count * i / all);
    }
  }

  void divide_by_memory(std::uint64_t memory, const Assembly& assembly) {
    const double most = static_cast<double>(memory) / kBytesPerTriangle;
    double tile = 0;
    for (std::size_t i = 0; i < plan_.size(); ++i) {
      const double own = plan_.expected_triangles(i);
      if (own > most) {
        throw Error(Errc::limit_exceeded,
                    "what hangs together at " + decimal(bounds_of({{boxes_[i]}}).center()) +
                        " has about " + decimal(own, 2) + " triangles, which need " +
                        decimal(own * kBytesPerTriangle / 1e9, 2) +
                        " GB; give --memory more, or a coarser tolerance",
                    {}, assembly.source);
      }
      if (tile + own > most) {
        ends_.push_back(i);
        tile = 0;
      }
      tile += own;
    }
    ends_.push_back(plan_.size());
  }

  [[nodiscard]] std::size_t owner(std::size_t district) const { return district % ranks_.count(); }

  // Of the districts of a tile that are this rank's.
  [[nodiscard]] std::vector<std::optional<DistrictResult>> own_results(std::size_t begin,
                                                                       std::size_t end) const {
    std::vector<std::optional<DistrictResult>> tile(end - begin);
    for_each_in_parallel(tile.size(), [&](std::size_t i) {
      if (owner(begin + i) == ranks_.own()) {
        tile[i] = result(begin + i);
      }
    });
    return tile;
  }

  [[nodiscard]] DistrictResult received(std::size_t district) const {
    auto result = result_of(ranks_.receive(owner(district)), plan_.parts(district));
    if (!result) {
      throw Error(Errc::internal,
                  "internal error, please report it: another rank sent what cannot be read");
    }
    return *std::move(result);
  }

  // Made, or as it was kept.
  [[nodiscard]] DistrictResult result(std::size_t district) const {
    if (!cache_) {
      return made(district);
    }
    const Assembly document = plan_.document(district);
    std::string text = options_text_ + document_text(document);
    append_meshes(document, text);
    const std::string key = sha256(text);
    const std::vector<std::uint32_t> parts = plan_.parts(district);
    if (const auto bytes = cache_->find(key)) {
      if (auto kept = result_of(*bytes, parts)) {
        return *std::move(kept);
      }
    }
    DistrictResult result = made(district);
    cache_->keep(key, bytes_of(result, parts));
    return result;
  }

  [[nodiscard]] DistrictResult made(std::size_t district) const {
    DistrictResult result;
    result.built = plan_.build(district);
    const Rounded rounded =
        settled_and_rounded(result.built.solid, to_, rounding_, contacts_, result.output);
    result.built.solid = Solid();
    if (plan_.size() > 1 && !lies_in(rounded, boxes_[district])) {
      throw Error(Errc::internal,
                  "internal error, please report it: a district does not lie in its boxes", {},
                  to_.path);
    }
    result.output.check = check(rounded);
    result.output.rounding = rounded.report();
    result.output.contacts = rounded.contacts();
    result.facets = stl_facets(rounded, to_.path);
    return result;
  }

  static void take(OutputReport&& district, OutputReport& report) {
    add(*district.check, *report.check);
    add(district.rounding, report.rounding);
    append(std::move(district.contacts), report.contacts);
    if (district.settled) {
      add_settled(*std::move(district.settled), report);
    }
  }

  const Ranks& ranks_;
  DistrictBuild plan_;
  std::vector<Boxes> boxes_;
  Destination to_;
  ContactChoice contacts_;
  RoundingOptions rounding_;
  Progress progress_;
  std::optional<DistrictCache> cache_;
  std::string options_text_;
  std::vector<std::size_t> ends_;  // of tiles, behind their last districts
};

}  // namespace

void add_tile_options(CLI::App& command, TileArguments& arguments) {
  auto* const tiles =
      command
          .add_option("--tiles", arguments.tiles,
                      "Build in so many tiles, one after the other, each of parts that have\n"
                      "nothing to do with the others, and append them to a binary STL: the same\n"
                      "bytes in less memory")
          ->type_name("NUMBER")
          ->check(CLI::Range(1, 1000000));
  command
      .add_option("--memory", arguments.memory,
                  "As many tiles as that takes, such as 4GB: for models larger than memory")
      ->type_name("SIZE")
      ->excludes(tiles);
  command
      .add_option("--cache", arguments.cache,
                  "Folder that keeps what tiles are made of: a build that was killed goes on,\n"
                  "and of an edited document only what changed is made again")
      ->type_name("DIR");
}

bool is_tiled(const TileArguments& arguments, const Ranks& ranks) {
  return ranks.count() > 1 || arguments.tiles > 0 || !arguments.memory.empty() ||
         !arguments.cache.empty();
}

void check_tiled(const BuildArguments& arguments) {
  const Destination to = destination(arguments.output);
  if (to.is_stdout() || !(to.format == kStlBinary)) {
    throw UsageError("--tiles, --memory, --cache and mpirun write binary STL files only");
  }
  if (!to.patches.empty() || !arguments.page.empty() || arguments.quality == "cfd") {
    throw UsageError(
        "--patches, --report and --quality cfd look at all of a solid at once, which "
        "--tiles and --memory never have");
  }
  if (to.verification != Verification::compare) {
    throw UsageError(
        "with --tiles, --memory and --cache, files are compared as they are written; --verify "
        "full is what the command check does");
  }
  if (!arguments.cross_check.empty()) {
    throw UsageError("--cross-check is not for --tiles, --memory, --cache and mpirun");
  }
  if (arguments.source.keep_going) {
    throw UsageError(
        "--keep-going builds all of a document again where a part is refused, which "
        "--tiles and --memory do not");
  }
  if (!arguments.tiles.memory.empty()) {
    (void)bytes_in(arguments.tiles.memory);
  }
}

void set_district_margin(BuildOptions& options, const Destination& to,
                         const RoundingOptions& rounding, const ContactChoice& contacts) {
  const double digits = to.format.coordinates == Coordinates::binary32 ? 23 : 52;
  options.relative_margin =
      rounding.tolerance > 0 ? std::exp2(-digits) : kMostSpacings * std::exp2(-digits);
  options.margin = rounding.tolerance + kMostSpacings * rounding.output_grid + contacts.length;
}

OutputReport write_districts(const Built& built, const Destination& to,
                             const RoundingOptions& rounding, MeshHeader header,
                             const ContactChoice& contacts, TriMesh* written,
                             const NormalsOf& normals) {
  OutputReport report;
  const RoundingOptions options = rounding_of_districts(rounding, built.boxes);
  std::vector<std::optional<Rounded>> rounded(built.districts.size());
  std::vector<OutputReport> reports(built.districts.size());
  for_each_in_parallel(rounded.size(), [&](std::size_t i) {
    rounded[i] = settled_and_rounded(built.districts[i], to, options, contacts, reports[i]);
  });
  std::vector<Rounded> all;
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    all.push_back(*std::move(rounded[i]));
    if (reports[i].settled) {
      add_settled(*std::move(reports[i].settled), report);
    }
  }
  return write_rounded(joined(all, built.boxes), to, std::move(header), std::move(report), {},
                       written, normals);
}

Built build_in_tiles(const Document& document, const BuildOptions& options,
                     const BuildArguments& arguments, const MeshHeader& header, const Ranks& ranks,
                     OutputReport& report) {
  TiledBuild build(document, options, arguments, ranks);
  if (ranks.is_first()) {
    return build.run(header, report);
  }
  build.run_for_first();
  return {};
}

}  // namespace dupin::cli
