#include "tiles/tiled_build.h"

#include <algorithm>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/App.hpp>

#include "dupin/blends/drawing.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/off.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/districts.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "exchange_options.h"
#include "exit_code.h"
#include "solver_options.h"
#include "tiles/build_identity.h"
#include "tiles/district_cache.h"
#include "tiles/district_output.h"
#include "tiles/district_result.h"
#include "tiles/seam_check.h"
#include "tiles/shared_tile.h"
#include "tiles/tile_memory.h"

namespace dupin::cli {
namespace {

/// All that decides about a district's facets, besides its document.
std::string text_of(const BuildOptions& options, const ContactChoice& contacts,
                    const RoundingOptions& rounding) {
  std::string text = "dupin " DUPIN_VERSION " " + build_identity();
  const auto add = [&text](double number) { text += " " + decimal(number); };
  // Less than usual is looked at before there are districts.
  add(static_cast<double>(std::max(options.most_triangles, kUsualTriangles)));
  add(options.region ? static_cast<double>(*options.region) : -1);
  add(static_cast<double>(options.contacts));
  add(static_cast<double>(contacts.kind));
  add(contacts.length);
  add(rounding.tolerance);
  add(rounding.output_grid);
  add(static_cast<double>(rounding.origin.choice));
  std::ranges::for_each(rounding.origin.place, add);
  add(rounding.whole ? rounding.whole->largest : 0);
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

/// What a triangle of the result needs, measured (docs/cli.md): of one solid, and where one is
/// taken from another.
constexpr double kBytesPerTriangle = 360, kBytesPerTriangleOfTwo = 1100;

std::uint64_t cache_size(const TileArguments& arguments) {
  return bytes_in(arguments.cache_size.empty() ? "10GB" : arguments.cache_size, "--cache-size");
}

class TiledBuild {
 public:
  TiledBuild(const Document& document, const BuildOptions& options, const BuildArguments& arguments,
             const DistrictCache* cache, const Ranks& ranks)
      : ranks_(ranks),
        assembly_(document.assembly),
        region_(options.region),
        plan_(document.assembly, options),
        boxes_(plan_.boxes()),
        places_(boxes_),
        seams_(plan_.seams()),
        to_(tiled_destination(arguments.output)),
        contacts_(contact_choice(arguments.contacts, std::string(symbol(document.assembly.unit)))),
        rounding_(
            rounding_options(arguments.rounding, std::string(symbol(document.assembly.unit)))),
        progress_(options.progress),
        are_tiles_asked_for_(arguments.tiles.tiles > 0 || !arguments.tiles.memory.empty()),
        cache_(cache),
        cache_size_(cache_size(arguments.tiles)) {
    rounding_ = rounding_of_districts(rounding_, boxes_);
    options_text_ = std::string(to_.format.key) + " " + text_of(options, contacts_, rounding_);
  }

  void refuse_too_costly() const { plan_.refuse_too_costly(); }

  // All ranks do this, and what follows, and come to the same.
  void prepare(const TileArguments& arguments) {
    const bool is_bounded = !arguments.memory.empty();
    if (ranks_.count() > 1 || is_bounded) {
      triangles_ = expected_triangles();
    }
    if (is_bounded) {
      memory_ = TileMemory(bytes_in(arguments.memory, "--memory"), expected_bytes(),
                           assembly_.source, kCoarser);
    }
    divide(arguments);
  }

  // Nothing where pieces do not fit, which misfits() tells.
  std::optional<TiledBuilt> run(const MeshHeader& header, const TileArguments& arguments) {
    return memory_.until_enough([&] { return attempt(header); },
                                [&] {
                                  seams_ = SeamCheck(plan_.seams());
                                  divide(arguments);
                                });
  }

  // Names of seams.
  [[nodiscard]] const std::set<std::string>& misfits() { return seams_.misfits(); }

 private:
  static constexpr const char* kCoarser = ", or a coarser tolerance";

  void divide(const TileArguments& arguments) {
    ends_ = alike(ranks_, [&] {
      return ends_of_tiles(arguments, {.districts = boxes_,
                                       .triangles = triangles_,
                                       .bytes = memory_.bytes(),
                                       .processes = ranks_.count(),
                                       .source = assembly_.source,
                                       .remedy = kCoarser});
    });
    memory_.divide(ends_);
    if (ranks_.count() > 1) {
      owners_ = shared_out(triangles_, ends_, ranks_.count());
    } else {
      owners_.resize(plan_.size(), 0);
    }
  }

  std::optional<TiledBuilt> attempt(const MeshHeader& header) {
    DistrictFile file(to_, places_.by_district(), &ranks_);
    std::vector<Built> built;
    std::size_t begin = 0, tiles = 0, shells = 0;
    for (const std::size_t end : ends_) {
      tell(progress_, "build", double(begin) / double(plan_.size()));
      const auto owners = std::span(owners_).subspan(begin, end - begin);
      const std::size_t tile_file = are_tiles_asked_for_ ? tiles : 0;
      share_tile(owners, ranks_,
                 {.made =
                      [&](std::size_t i) {
                        auto own = result(begin + i);
                        return own ? *std::move(own) : unfit_result(seams_.of(begin + i));
                      },
                  .parts = [&](std::size_t i) { return plan_.parts(begin + i); },
                  .taken =
                      [&](std::size_t i, DistrictResult district) {
                        seams_.add(begin + i, std::move(district.output.sides), shells);
                        shells += district.output.report.check->shells.size();
                        file.append(std::move(district.output),
                                    ranks_.count() > 1 ? owners[i] : tile_file);
                        built.push_back(std::move(district.built));
                      }});
      begin = end;
      ++tiles;
    }
    if (memory_.is_short(ranks_, owners_) || !misfits().empty()) {
      file.abandon();
      return std::nullopt;
    }
    auto flushed = std::async(std::launch::async, [&] { file.flush(); });
    Built all = plan_.joined(std::move(built));
    if (cache_ != nullptr && ranks_.is_first()) {
      cache_->trim(cache_size_);
    }
    flushed.get();
    alike(ranks_, [&] { file.require_something(rounding_); });
    OutputReport report = file.commit(
        header, to_.format.has_normals ? smooth_normals(assembly_, all, file.seen()) : NormalsOf());
    seams_.join(*report.check);
    return TiledBuilt{std::move(all), std::move(report), {}};
  }

  // Resolves every district, which takes its time; ranks share that.
  [[nodiscard]] std::vector<double> expected_triangles() const {
    std::vector<double> triangles(plan_.size());
    for_each_in_parallel(triangles.size(), [&](std::size_t i) {
      if (i % ranks_.count() == ranks_.own()) {
        triangles[i] = plan_.expected_triangles(i);
      }
    });
    take_from_owners(ranks_, triangles, [&](std::size_t i) { return i % ranks_.count(); });
    return triangles;
  }

  [[nodiscard]] std::vector<double> expected_bytes() const {
    std::vector<double> bytes = triangles_;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] *= is_of_two(i) ? kBytesPerTriangleOfTwo : kBytesPerTriangle;
    }
    return bytes;
  }

  // Whether one solid is taken from another: bores, or what is insulated.
  [[nodiscard]] bool is_of_two(std::size_t district) const {
    return region_.value_or(Region::outer) != Region::outer ||
           std::ranges::any_of(plan_.parts(district), [&](std::uint32_t part) {
             return assembly_.parts[part].wall.value_or(assembly_.wall.value_or(0)) > 0;
           });
  }

  // Made, or as it was kept; nothing where there is no memory for it.
  [[nodiscard]] std::optional<DistrictResult> result(std::size_t district) {
    if (cache_ == nullptr) {
      return made(district);
    }
    const Assembly document = plan_.document(district);
    std::string text = options_text_ + document_text(document);
    append_meshes(document, text);
    append_seams(district, text);
    const std::string key = sha256(text);
    const std::vector<std::uint32_t> parts = plan_.parts(district);
    if (auto bytes = cache_->find(key)) {
      auto kept = result_of(*std::move(bytes), parts);
      if (!kept) {
        cache_->distrust(key, "is damaged");
      } else if (are_known(kept->output.voids, district, places_)) {
        return *std::move(kept);
      }
    }
    std::optional<DistrictResult> result = made(district);
    if (result) {
      cache_->keep(key, bytes_of(*result, parts));
    }
    return result;
  }

  void append_seams(std::size_t district, std::string& text) const {
    text += plan_.taken_from_whole(district);
    for (const Seam& seam : seams_.of(district)) {
      text += "\n" + seam.name;
      for (const Vec3& corner : {Vec3(seam.meeting.min()), Vec3(seam.meeting.max())}) {
        std::ranges::for_each(corner, [&](double number) { text += " " + decimal(number); });
      }
    }
  }

  [[nodiscard]] std::optional<DistrictResult> made(std::size_t district) {
    return memory_.within(district, boxes_[district], [&](std::uint64_t limit) {
      DistrictResult result;
      result.built = plan_.build(district, {}, limit);
      result.output = district_output(result.built.solid, boxes_, district, places_, to_, rounding_,
                                      contacts_, seams_.of(district));
      result.built.solid = Solid();
      return result;
    });
  }

  const Ranks& ranks_;
  const Assembly& assembly_;
  std::optional<Region> region_;
  DistrictBuild plan_;
  std::vector<Boxes> boxes_;
  DistrictPlaces places_;
  SeamCheck seams_;
  Destination to_;
  ContactChoice contacts_;
  RoundingOptions rounding_;
  Progress progress_;
  bool are_tiles_asked_for_;
  const DistrictCache* cache_;
  std::uint64_t cache_size_;
  std::string options_text_;
  std::vector<double> triangles_;  // expected of districts, where that is asked for
  TileMemory memory_;
  std::vector<std::size_t> ends_;    // of tiles, behind their last districts
  std::vector<std::size_t> owners_;  // the ranks that make districts
};

}  // namespace

void add_build_tile_options(CLI::App& command, TileArguments& arguments) {
  add_tile_options(command, arguments, tiles_of("parts"));
  auto* const cache =
      command
          .add_option("--cache", arguments.cache,
                      "Folder that keeps what tiles are made of: a build that was killed goes on,\n"
                      "and of an edited document only what changed is made again")
          ->type_name("DIR");
  command.add_option("--piece", arguments.piece)->group("");  // for tests, in no help
  command
      .add_option("--cache-size", arguments.cache_size,
                  "What --cache may hold when the build ends, 10GB if not given: what has not\n"
                  "been used for longest goes")
      ->type_name("SIZE")
      ->needs(cache);
}

void prepare_pieces(const BuildArguments& arguments, BuildOptions& options) {
  const bool is_looked_at = !arguments.page.empty() || arguments.quality == kForSolvers ||
                            !arguments.cross_check.empty() || arguments.source.keep_going;
  if (!is_looked_at && !is_step(arguments.output) && !is_volume(arguments.output) &&
      why_not_tiled(tiled_destination(arguments.output)).empty()) {
    options.most_of_piece = arguments.tiles.most_of_piece();
    options.most_undivided = arguments.tiles.most_undivided();
  }
}

void check_tiled(const BuildArguments& arguments) {
  if (is_step(arguments.output) || is_volume(arguments.output)) {
    throw UsageError(kTiledFormats);
  }
  require_tiled_output(tiled_destination(arguments.output), arguments.tiles);
  (void)cache_size(arguments.tiles);
  if (!arguments.page.empty() || arguments.quality == kForSolvers) {
    throw UsageError(
        "--report and --quality cfd look at all of a solid at once, which --tiles, --memory and "
        ".pvtu never have");
  }
  if (!arguments.cross_check.empty()) {
    throw UsageError("--cross-check is not for --tiles, --memory, --cache, .pvtu and mpirun");
  }
  if (arguments.source.keep_going) {
    throw UsageError(
        "--keep-going builds all of a document again where a part is refused, which "
        "--tiles, --memory and .pvtu do not");
  }
}

TiledBuilt build_in_tiles(const Document& document, const BuildOptions& options,
                          const BuildArguments& arguments, const MeshHeader& header,
                          const Ranks& ranks) {
  std::optional<DistrictCache> cache;
  if (!arguments.tiles.cache.empty()) {
    alike(ranks, [&] { cache.emplace(arguments.tiles.cache); });
  }
  BuildOptions own = options;
  TiledBuilt result = until_pieces_fit(options.most_of_piece, [&](double most_of_piece) {
    own.most_of_piece = most_of_piece;
    const auto build = alike(ranks, [&] {
      auto made =
          std::make_unique<TiledBuild>(document, own, arguments, cache ? &*cache : nullptr, ranks);
      if (arguments.are_triangles_limited) {
        made->refuse_too_costly();
      }
      return made;
    });
    build->prepare(arguments.tiles);
    auto built = build->run(header, arguments.tiles);
    // All ranks, and builds in any number of tiles, find the same ones.
    own.kept_seams.insert(build->misfits().begin(), build->misfits().end());
    return built;
  });
  if (cache) {
    result.warning = cache->warning();
  }
  return result;
}

}  // namespace dupin::cli
