#include "tiles/united_districts.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "dupin/io/mesh_file.h"
#include "dupin/io/stl_stream.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "input.h"
#include "tiles/cut_mesh.h"
#include "tiles/operand_pieces.h"
#include "tiles/seam_check.h"
#include "tiles/shared_tile.h"
#include "tiles/tile_memory.h"

namespace dupin::cli {
namespace {

/// What a triangle of an operand needs, with what crossings add to it where these are few
/// (docs/cli.md).
constexpr double kBytesPerTriangle = 400;

std::vector<Solid> selected(std::span<const Solid> operands,
                            const std::vector<std::size_t>& members) {
  std::vector<Solid> solids;
  solids.reserve(members.size());
  for (const std::size_t i : members) {
    solids.push_back(operands[i]);
  }
  return solids;
}

Eigen::AlignedBox3d box_of(const StlFile& file) {
  Eigen::AlignedBox3d box;
  file.visit([&](std::span<const Facet> facets) {
    for (const Facet& facet : facets) {
      for (std::size_t k = 0; k < facet.size(); k += 3) {
        box.extend(Vec3(facet[k], facet[k + 1], facet[k + 2]));
      }
    }
  });
  return box;
}

TriMesh mesh_of(const Solid& solid) {
  return {solid.nearest_points(), solid.triangles(), solid.labels(), solid.names()};
}

TriMesh mesh_in(const std::string& path) {
  return is_stl_file(path) ? StlFile(path).mesh() : read_mesh_input(path);
}

/// What is known of an operand's file before its tile is made.
struct Survey {
  Eigen::AlignedBox3d box;
  std::size_t triangles = 0;
  std::string unit;
};

Survey surveyed(const std::string& path) {
  if (is_stl_file(path)) {
    const StlFile file(path);
    return {box_of(file), file.count(), file.unit()};
  }
  const Input input = read_input(path);
  const TriMesh mesh = read_mesh(input.bytes, input.name);
  return {cli::box_of(mesh), mesh.triangles.size(), input.unit()};
}

/// The numbers of a survey, which go before its unit.
using Numbers = std::array<double, 7>;

/// Puts what other ranks have read of every so many files in its place.
void exchange(std::vector<Survey>& surveys, const Ranks& ranks) {
  std::string own;
  for (std::size_t i = ranks.own(); i < surveys.size(); i += ranks.count()) {
    const auto& [box, triangles, unit] = surveys[i];
    const Numbers numbers{box.min().x(),
                          box.min().y(),
                          box.min().z(),
                          box.max().x(),
                          box.max().y(),
                          box.max().z(),
                          static_cast<double>(triangles)};
    own.append(reinterpret_cast<const char*>(numbers.data()), sizeof(numbers));
    own.append(unit.c_str(), unit.size() + 1);
  }
  const std::vector<std::string> all = ranks.exchanged(own);
  for (std::size_t rank = 0; rank < ranks.count(); ++rank) {
    const char* at = all[rank].data();
    for (std::size_t i = rank; i < surveys.size(); i += ranks.count()) {
      Numbers numbers{};
      std::memcpy(numbers.data(), at, sizeof(numbers));
      const auto& [ax, ay, az, bx, by, bz, triangles] = numbers;
      surveys[i].box = Eigen::AlignedBox3d(Vec3(ax, ay, az), Vec3(bx, by, bz));
      surveys[i].triangles = static_cast<std::size_t>(triangles);
      surveys[i].unit = at + sizeof(numbers);
      at += sizeof(numbers) + surveys[i].unit.size() + 1;
    }
  }
}

/// Operands that are not cut.
using Uncut = std::set<std::size_t>;

OperandPieces pieces_of(const TiledUnion& task, const OperandFiles& files, double most_of_piece,
                        const Uncut& uncut) {
  return operand_pieces(
      operand_districts(files.boxes, district_margin(task.to, task.rounding, task.contacts)),
      {files.boxes, files.triangles, most_of_piece, uncut});
}

/// A union in the making.
class UnionInTiles {
 public:
  UnionInTiles(const TiledUnion& task, const OperandFiles& files, const Ranks& ranks,
               double most_of_piece, const Uncut& uncut)
      : task_(task),
        files_(files),
        ranks_(ranks),
        districts_(pieces_of(task, files, most_of_piece, uncut)),
        places_(districts_.boxes),
        seams_(districts_.seams),
        rounding_(rounding_of_districts(task.rounding, districts_.boxes)),
        repairs_(task.files.size()),
        first_of_(first_districts()) {
    if (!task.tiles.memory.empty()) {
      memory_ = TileMemory(bytes_in(task.tiles.memory, "--memory"), expected_bytes(), kSource);
    }
    divide();
  }

  // Nothing where pieces do not fit: at cuts of misfits().
  std::optional<OutputReport> run() {
    return memory_.until_enough([&] { return attempt(); },
                                [&] {
                                  seams_ = SeamCheck(districts_.seams);
                                  alike(ranks_, [&] { divide(); });
                                });
  }

  // Operands that were cut where pieces do not fit.
  [[nodiscard]] Uncut misfits() {
    const std::set<std::string>& names = seams_.misfits();
    Uncut result;
    for (const std::vector<OperandStretch>& stretches : districts_.stretches) {
      for (const OperandStretch& stretch : stretches) {
        if (stretch.from && names.contains(stretch.from->name)) {
          result.insert(stretch.operand);
        }
      }
    }
    return result;
  }

 private:
  static constexpr const char* kSource = "operands";

  [[nodiscard]] std::vector<double> expected_bytes() const {
    std::vector<double> bytes = districts_.triangles;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bytes[i] = kBytesPerTriangle * (bytes[i] + largest_that_is_cut(i));
    }
    return bytes;
  }

  void divide() {
    ends_ = ends_of_tiles(task_.tiles, {.districts = districts_.boxes,
                                        .triangles = districts_.triangles,
                                        .bytes = memory_.bytes(),
                                        .processes = ranks_.count(),
                                        .source = kSource});
    memory_.divide(ends_);
    owners_ = shared_out(districts_.triangles, ends_, ranks_.count());
  }

  std::optional<OutputReport> attempt() {
    DistrictFile file(task_.to, places_.by_district(), &ranks_);
    std::size_t begin = 0, shells = 0;
    for (const std::size_t end : ends_) {
      tell(task_.progress, "unite", double(begin) / double(districts_.boxes.size()));
      share_tile(std::span(owners_).subspan(begin, end - begin), ranks_,
                 {.made = [&](std::size_t i) { return made(begin + i); },
                  .parts = [](std::size_t) { return std::vector<std::uint32_t>(); },
                  .taken =
                      [&](std::size_t i, DistrictResult district) {
                        seams_.add(begin + i, std::move(district.output.sides), shells);
                        shells += district.output.report.check->shells.size();
                        file.append(std::move(district.output));
                      }});
      begin = end;
    }
    if (memory_.is_short(ranks_, owners_) || !seams_.misfits().empty()) {
      file.abandon();
      return std::nullopt;
    }
    alike(ranks_, [&] { file.require_something(rounding_); });
    OutputReport report = file.commit({files_.unit, {}});
    seams_.join(*report.check);
    learn_repairs();
    report.repairs = repairs_in(task_.files, repairs_);
    return report;
  }

  // One operand at a time is there as a whole while it is cut.
  [[nodiscard]] double largest_that_is_cut(std::size_t district) const {
    double largest = 0;
    for (const OperandStretch& stretch : districts_.stretches[district]) {
      if (stretch.is_cut()) {
        largest = std::max(largest, static_cast<double>(files_.triangles[stretch.operand]));
      }
    }
    return largest;
  }

  [[nodiscard]] std::vector<std::size_t> first_districts() const {
    std::vector<std::size_t> result(task_.files.size(), districts_.stretches.size());
    for (std::size_t district = 0; district < districts_.stretches.size(); ++district) {
      for (const OperandStretch& stretch : districts_.stretches[district]) {
        result[stretch.operand] = std::min(result[stretch.operand], district);
      }
    }
    return result;
  }

  DistrictResult made(std::size_t district) {
    const std::vector<Seam> seams = seams_.of(district);
    std::vector<Solid> operands;
    for (const OperandStretch& stretch : districts_.stretches[district]) {
      auto own = solid_of(stretch, district);
      if (!own) {
        return unfit_result(seams);
      }
      operands.push_back(*std::move(own));
    }
    // Crossings are counted when they are found, before what they come to is made.
    auto united = memory_.within(district, districts_.boxes[district], [&](std::uint64_t limit) {
      const Solid solid = unite(operands, {task_.contacts.policy(), {}, limit});
      operands.clear();
      DistrictResult result;
      result.output = district_output(solid, districts_.boxes, district, places_, task_.to,
                                      rounding_, task_.contacts, seams);
      return result;
    });
    return united ? *std::move(united) : unfit_result(seams);
  }

  // Of stretches of one operand, the first one's district notes what was mended.
  [[nodiscard]] Solid operand(std::size_t i, std::size_t district) {
    RepairReport repairs;
    Solid solid = operand_of(mesh_in(task_.files[i]), task_.files[i], task_.are_repaired, repairs);
    if (first_of_[i] == district) {
      repairs_[i] = repairs;
    }
    return solid;
  }

  // None where it cannot be cut there. The first district of an operand proves it as a whole,
  // others their stretches only.
  [[nodiscard]] std::optional<Solid> solid_of(const OperandStretch& stretch, std::size_t district) {
    const std::size_t i = stretch.operand;
    if (!stretch.is_cut()) {
      return operand(i, district);
    }
    const bool is_proved = first_of_[i] != district && !task_.are_repaired;
    const TriMesh whole = is_proved ? mesh_in(task_.files[i]) : mesh_of(operand(i, district));
    try {
      return Solid::from(between_planes(whole, stretch.axis, stretch.from, stretch.to));
    } catch (const Error& error) {
      if (error.code() == Errc::limit_exceeded || error.code() == Errc::cancelled) {
        throw;
      }
      return std::nullopt;
    }
  }

  // Of what others have mended.
  void learn_repairs() {
    take_from_owners(ranks_, repairs_, [&](std::size_t i) {
      return first_of_[i] < owners_.size() ? owners_[first_of_[i]] : ranks_.own();
    });
  }

  const TiledUnion& task_;
  const OperandFiles& files_;
  const Ranks& ranks_;
  OperandPieces districts_;
  DistrictPlaces places_;
  SeamCheck seams_;
  RoundingOptions rounding_;
  std::vector<RepairReport> repairs_;  // per operand
  std::vector<std::size_t> first_of_;  // likewise: the first district that has some of it
  TileMemory memory_;
  std::vector<std::size_t> ends_;    // of tiles, behind their last districts
  std::vector<std::size_t> owners_;  // the ranks that make districts
};

}  // namespace

Eigen::AlignedBox3d box_of(const TriMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      box.extend(mesh.points[corner]);
    }
  }
  return box;
}

namespace {

// Of boxes that are not empty.
std::vector<std::size_t> in_order_of_place(const Boxes& boxes) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!boxes[i].isEmpty()) {
      order.push_back(i);
    }
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    const Vec3 &low = boxes[i].min(), &high = boxes[i].max();
    return std::array{low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
  });
  return order;
}

}  // namespace

OperandDistricts operand_districts(std::span<const Eigen::AlignedBox3d> boxes,
                                   const DistrictMargin& margin) {
  Boxes wide(boxes.begin(), boxes.end());
  double largest = 0;
  for (const Eigen::AlignedBox3d& box : wide) {
    largest =
        box.isEmpty()
            ? largest
            : std::max({largest, box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()});
  }
  const double reach = margin.absolute + margin.relative * largest;
  for (Eigen::AlignedBox3d& box : wide) {
    if (!box.isEmpty()) {
      box = Eigen::AlignedBox3d(box.min().array() - reach, box.max().array() + reach);
    }
  }
  OperandDistricts result;
  const std::vector<std::uint32_t> of_box = districts_of(wide);
  std::vector<std::optional<std::size_t>> place(boxes.size());  // by number
  for (const std::size_t i : in_order_of_place(wide)) {
    std::optional<std::size_t>& known = place[of_box[i]];
    if (!known) {
      known = result.operands.size();
      result.operands.emplace_back();
      result.boxes.emplace_back();
    }
    result.operands[*known].push_back(i);
    result.boxes[*known].push_back(wide[i]);
  }
  if (result.operands.empty()) {
    result.operands.emplace_back();
    result.boxes.emplace_back();
  }
  for (std::size_t i = 0; i < wide.size(); ++i) {
    if (wide[i].isEmpty()) {
      result.operands.front().push_back(i);
    }
  }
  return result;
}

std::vector<Solid> united_districts(std::span<const Solid> operands,
                                    const OperandDistricts& districts,
                                    const BooleanOptions& options) {
  if (districts.operands.size() == 1) {
    return {unite(operands, options)};
  }
  tell(options.progress, "unite");
  std::vector<Solid> solids(districts.operands.size());
  for_each_in_parallel(solids.size(), [&](std::size_t i) {
    solids[i] = unite(selected(operands, districts.operands[i]), {options.contacts, {}});
  });
  return solids;
}

OperandFiles survey(const std::vector<std::string>& files, const Progress& progress,
                    const Ranks& ranks) {
  tell(progress, "read");
  std::vector<Survey> surveys(files.size());
  for_each_in_parallel(files.size(), [&](std::size_t i) {
    if (i % ranks.count() == ranks.own()) {
      surveys[i] = surveyed(files[i]);
    }
  });
  exchange(surveys, ranks);
  OperandFiles result;
  std::vector<StatedUnit> units;
  for (std::size_t i = 0; i < files.size(); ++i) {
    result.boxes.push_back(surveys[i].box);
    result.triangles.push_back(surveys[i].triangles);
    units.push_back({files[i], surveys[i].unit});
  }
  result.unit = alike(ranks, [&] { return common_unit(units); });
  return result;
}

OutputReport unite_in_tiles(const TiledUnion& task, const OperandFiles& files, const Ranks& ranks) {
  Uncut uncut;
  return until_pieces_fit(task.tiles.most_undivided(), [&](double most_of_piece) {
    const auto united = alike(ranks, [&] {
      return std::make_unique<UnionInTiles>(task, files, ranks, most_of_piece, uncut);
    });
    auto report = united->run();
    // All ranks, and unions in any number of tiles, find the same ones.
    uncut.merge(united->misfits());
    return report;
  });
}

}  // namespace dupin::cli
