#include "assembly/districts/built_district.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "assembly/bore.h"
#include "assembly/cost_limit.h"
#include "assembly/districts/common_rings.h"
#include "assembly/outward_shape.h"
#include "assembly/part_context.h"
#include "assembly/part_margins.h"
#include "assembly/parts/part_kind.h"
#include "assembly/run_solids.h"
#include "assembly/welded_runs.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/renamed.h"
#include "surfaces/least_wall.h"

namespace dupin::assembly {
namespace {

// Of its area: an end of a bore of which less is closed is open.
constexpr double kBlindShare = 0.5;

class Builder {
 public:
  Builder(District district, const BuildOptions& options)
      : assembly_(std::move(district.assembly)),
        numbers_(std::move(district.parts)),
        options_(options),
        resolved_(std::move(district.resolved)),
        piece_(std::move(district.piece)) {}

  Built run() {
    prove_fillets(assembly_, resolved_);
    const auto count = static_cast<double>(resolved_.parts.size());
    for (const auto& part : resolved_.parts) {
      tell(options_.progress, "certify", double(built_.parts.size()) / count);
      built_.parts.push_back(
          assembly::with_part_context(assembly_, part.index, [&] { return certified(part); }));
    }
    if (options_.region == Region::insulation) {
      build_insulation();
    } else if (const auto walls = assembly::walls_of(assembly_, resolved_, options_.region)) {
      build_hollow(*walls);
    } else {
      built_.grid = piece_ ? piece_->grid : assembly::lattice_spacing(assembly_, resolved_);
      built_.solid = outer(resolved_);
    }
    built_.solid = renamed_patches(built_.solid);
    return std::move(built_);
  }

 private:
  [[nodiscard]] Solid renamed_patches(const Solid& solid) const {
    return assembly_.patches.empty() ? solid : renamed(solid, assembly_.patches);
  }

  void build_insulation() {
    const std::vector<double> thickness = assembly::insulation_of(assembly_);
    resolved_ = assembly::filled(std::move(resolved_));
    built_.region = Region::insulation;
    built_.insulation = 0;
    if (thickness.empty()) {
      built_.grid = assembly::lattice_spacing(assembly_, resolved_);
      (void)outer(resolved_);
      return;
    }
    assembly::SelectedParts around = assembly::insulated(assembly_, resolved_, thickness);
    name_seams(around);
    built_.grid =
        piece_ ? piece_->grid : assembly::lattice_of_both(assembly_, resolved_, around.resolved);
    // Far enough that no rounding of both ends lets them cross.
    constexpr double kClear = 8;
    const ResolvedAssembly inside =
        assembly::reaching_out(resolved_, assembly_, kClear * built_.grid, seam_names());
    std::vector<assembly::RingWithin> rings;
    for (const DiscName& disc : discs()) {
      if (const auto place = around.position[disc.end.part]) {
        rings.push_back({{*place, disc.end.end},
                         {*port_ring(resolved_.parts[disc.end.part].shape, disc.end.end),
                          piece_->samplings[disc.end.part], disc.name}});
      }
    }
    const Solid whole = outer(inside), covered = united(around.resolved, second(around), rings);
    built_.solid = subtract(covered, {&whole, 1}, of_booleans());
    built_.insulation = built_.solid.volume();
    cross_check(built_.solid, SetOperation::subtract, std::array{covered, whole});
  }

  // Of all parts, before they are filled.
  void prove_walls(const std::vector<double>& walls) {
    for (std::size_t i = 0; i < resolved_.parts.size(); ++i) {
      const ResolvedPart& part = resolved_.parts[i];
      const double wall = walls[part.index];
      built_.parts[i].is_hollow = wall > 0;
      if (wall > 0) {
        const PartShape& shape = assembly_.parts[part.index].shape;
        const assembly::PartKind& kind = assembly::part_kind(shape);
        built_.parts[i].least_wall =
            kind.least_wall != nullptr
                ? std::optional(kind.least_wall(assembly::outer_shape(assembly_, part.index),
                                                part.shape, wall))
                : surfaces::least_wall(part.shape, wall);
      }
    }
  }

  [[nodiscard]] PartReport certified(const ResolvedPart& part) const {
    PartReport result;
    result.name = part.name;
    result.kind = part.kind;
    const assembly::PartMargins proven = assembly::margins(part.shape, part.is_tangent, part.kind);
    result.margin_lower = proven.margin_lower;
    result.margin_upper = proven.margin_upper;
    result.start_tangency = proven.start_tangency;
    result.end_tangency = proven.end_tangency;
    const PartShape& shape = assembly_.parts[part.index].shape;
    assembly::PartNotes notes = assembly::part_kind(shape).notes(shape, part.shape);
    result.construction = std::move(notes.construction);
    result.rejected = std::move(notes.rejected);
    result.warnings = std::move(notes.warnings);
    return result;
  }

  [[nodiscard]] BooleanOptions of_booleans() const {
    return {options_.contacts, options_.progress, options_.memory_limit};
  }

  [[nodiscard]] Solid united(std::span<const Solid> solids) const {
    return solids.size() == 1 ? solids.front() : unite(solids, of_booleans());
  }

  void cross_check(const Solid& result, SetOperation operation, std::span<const Solid> operands) {
    const bool is_settled =
        built_.cross_check && built_.cross_check->verdict != CrossCheck::Verdict::agrees;
    if (options_.cross_check && !is_settled) {
      built_.cross_check =
          second_opinion(result, *options_.cross_check, operation, operands, options_.progress);
    }
  }

  // Ends where another piece goes on.
  [[nodiscard]] std::vector<DiscName> discs() const {
    return piece_ ? piece_->discs : std::vector<DiscName>();
  }

  [[nodiscard]] std::set<std::string> seam_names() const {
    std::set<std::string> names;
    for (const DiscName& disc : discs()) {
      names.insert(disc.name);
    }
    return names;
  }

  // Both surfaces are closed there by what has one name.
  void name_seams(assembly::SelectedParts& second) const {
    for (const DiscName& disc : discs()) {
      if (const auto place = second.position[disc.end.part]) {
        second.resolved.parts[*place].end_names.at(at(disc.end.end)) = disc.name;
      }
    }
  }

  // The samplings of these parts in the whole; none where they are the whole.
  [[nodiscard]] std::vector<RingSampling> second(const assembly::SelectedParts& parts) const {
    std::vector<RingSampling> result;
    for (std::size_t i = 0; piece_ && i < parts.position.size(); ++i) {
      if (parts.position[i]) {
        result.push_back(piece_->second_samplings[i]);
      }
    }
    return piece_ ? assembly::with_what_goes_on(std::move(result), parts.resolved) : result;
  }

  // Of all parts, which other pieces of them may follow.
  Solid outer(const ResolvedAssembly& parts, std::span<const assembly::RingWithin> rings = {}) {
    const std::vector<RingSampling> given =
        piece_ ? assembly::with_what_goes_on(piece_->samplings, parts)
               : std::vector<RingSampling>();
    assembly::RunSolids made =
        assembly::solids_of_runs(assembly_, parts, built_.grid, options_, given, rings);
    for (std::size_t i = 0; i < built_.parts.size(); ++i) {
      PartReport &entry = built_.parts[i], &of_mesh = made.parts[i];
      entry.error_bound = of_mesh.error_bound;
      entry.segments = of_mesh.segments;
      entry.bands = of_mesh.bands;
      entry.triangles = of_mesh.triangles;
      entry.smallest_angle = of_mesh.smallest_angle;
    }
    built_.runs = made.runs;
    built_.pieces = made.solids.size();
    Solid result = united(made.solids);
    cross_check(result, SetOperation::unite, made.solids);
    order_reports(std::move(made.others));
    return result;
  }

  // Those of fillets and hubs are put where the document has them, hubs before their arms.
  void order_reports(std::vector<std::pair<std::uint32_t, PartReport>> all) {
    for (std::size_t i = 0; i < built_.parts.size(); ++i) {
      all.emplace_back(resolved_.parts[i].index, std::move(built_.parts[i]));
    }
    std::ranges::stable_sort(all, {}, [](const auto& entry) { return entry.first; });
    built_.parts.clear();
    for (auto& [index, entry] : all) {
      entry.index = numbers_[index];
      built_.parts.push_back(std::move(entry));
    }
  }

  void build_hollow(const std::vector<double>& walls) {
    const double tolerance = assembly::tolerance_within_walls(assembly_.tolerance, walls);
    const bool is_finer = tolerance < assembly_.tolerance;
    assembly_.tolerance = tolerance;
    try {
      build_regions(walls);
    } catch (const Error& error) {
      const bool is_about_tolerance = error.code() == Errc::limit_exceeded ||
                                      (error.code() == Errc::invalid_argument &&
                                       error.where() == document_place(assembly_, "/tolerance"));
      if (!is_about_tolerance || !is_finer) {
        throw;
      }
      throw Error(error.code(),
                  error.message() + "; here it is a quarter of the thinnest wall, which is " +
                      decimal(4 * tolerance, kMessageDigits),
                  error.part(), error.where());
    }
  }

  void build_regions(const std::vector<double>& walls) {
    resolved_ = assembly::filled(std::move(resolved_));
    prove_walls(walls);
    assembly::SelectedParts bore = assembly::bore_of(assembly_, resolved_, walls);
    name_seams(bore);
    const ResolvedAssembly solid_parts =
        assembly::kept_out_of_solids(bore, assembly_, resolved_, walls);
    built_.grid = piece_ ? piece_->grid
                         : assembly::lattice_of_bores(assembly_, resolved_, bore.resolved, walls);
    refuse_too_costly(bore, solid_parts, walls);
    const Solid whole = outer(resolved_, bore_rings(bore));
    std::set<std::string> open = exposed_names(whole);
    std::erase_if(open, [names = seam_names()](const auto& end) { return names.contains(end); });
    assembly::lengthen_out_of(bore, assembly_, resolved_, walls, open);
    const Solid filling = subtract(united(bore.resolved, second(bore)), {{united(solid_parts)}},
                                   {.memory_limit = options_.memory_limit});
    const std::array<Solid, 2> both{whole, filling};
    const BooleanOptions options = of_booleans();
    const Solid metal = subtract(whole, {&filling, 1}, options), fluid = intersect(both, options);
    refuse_broken_walls(fluid);
    warn_of_blind_ends(fluid);
    built_.volumes = {whole.volume(), metal.volume(), fluid.volume()};
    built_.region = options_.region.value_or(Region::metal);
    built_.solid = built_.region == Region::outer   ? whole
                   : built_.region == Region::metal ? metal
                                                    : fluid;
    if (built_.region != Region::outer) {
      cross_check(built_.solid,
                  built_.region == Region::metal ? SetOperation::subtract : SetOperation::intersect,
                  both);
    }
  }

  // Each alone is asked again when it is made; only here is it known what would do for all, with
  // bores that may become longer.
  void refuse_too_costly(const assembly::SelectedParts& bore, const ResolvedAssembly& solid_parts,
                         const std::vector<double>& walls) const {
    if (piece_) {
      return;
    }
    assembly::SelectedParts longest = bore;
    assembly::refuse_too_costly(
        assembly_, {&resolved_, &bore.resolved, &solid_parts}, built_.grid, options_.most_triangles,
        assembly::tolerance_within_walls(std::numeric_limits<double>::infinity(), walls), [&] {
          lengthen_everywhere(longest, walls);
          return &longest.resolved;
        });
  }

  // Ends that stay closed need no room for that.
  void lengthen_everywhere(assembly::SelectedParts& bore, const std::vector<double>& walls) const {
    std::set<std::string> ends;
    for (const ResolvedPart& part : resolved_.parts) {
      ends.insert(part.end_names.begin(), part.end_names.end());
    }
    try {
      assembly::lengthen_out_of(bore, assembly_, resolved_, walls, ends);
    } catch (const Error&) {
    }
  }

  // Where another piece goes on, with its bore.
  [[nodiscard]] std::vector<assembly::RingWithin> bore_rings(
      const assembly::SelectedParts& bore) const {
    std::vector<assembly::RingWithin> result;
    for (const DiscName& disc : discs()) {
      if (const auto place = bore.position[disc.end.part]) {
        result.push_back({disc.end,
                          {*port_ring(bore.resolved.parts[*place].shape, disc.end.end),
                           piece_->second_samplings[disc.end.part], disc.name}});
      }
    }
    return result;
  }

  [[nodiscard]] Solid united(const ResolvedAssembly& parts,
                             const std::vector<RingSampling>& given = {},
                             std::span<const assembly::RingWithin> rings = {}) const {
    return parts.parts.empty() ? Solid()
                               : united(assembly::solids_of_runs(assembly_, parts, built_.grid,
                                                                 options_, given, rings)
                                            .solids);
  }

  [[nodiscard]] static std::set<std::string> exposed_names(const Solid& solid) {
    std::set<std::string> result;
    for (const std::uint32_t label : std::set(solid.labels().begin(), solid.labels().end())) {
      result.insert(solid.names()[label]);
    }
    return result;
  }

  // Of each label's triangles.
  [[nodiscard]] static std::map<std::string, double> exposed_areas(const Solid& solid) {
    std::vector<double> of_label(solid.names().size(), 0);
    const auto& points = solid.nearest_points();
    for (std::size_t i = 0; i < solid.triangle_count(); ++i) {
      const auto& [a, b, c] = solid.triangles()[i];
      of_label[solid.labels()[i]] +=
          (points[b] - points[a]).cross(points[c] - points[a]).norm() / 2;
    }
    std::map<std::string, double> result;
    for (std::size_t label = 0; label < of_label.size(); ++label) {
      if (of_label[label] > 0) {
        result[solid.names()[label]] += of_label[label];
      }
    }
    return result;
  }

  // What bounds the fluid is a bore, an open end or a solid part; else a bore reaches out: of its
  // own part where meshes are too coarse for the wall between them, and of another one where it
  // leaves its own by an open end, which it goes through.
  void refuse_broken_walls(const Solid& fluid) const {
    std::map<std::string_view, std::uint32_t> outside;
    const auto include = [&](const auto& named) {
      if (!assembly_.parts[named.index].solid) {
        outside.emplace(named.name, named.index);
      }
    };
    std::ranges::for_each(resolved_.parts, include);
    std::ranges::for_each(resolved_.fillets, include);
    std::ranges::for_each(resolved_.junctions, include);
    for (std::size_t i = 0; i < fluid.triangle_count(); ++i) {
      const auto part = outside.find(fluid.names()[fluid.labels()[i]]);
      if (part != outside.end()) {
        const std::string bore = bore_beside(fluid, fluid.labels()[i]);
        const Vec3& at = fluid.nearest_points()[fluid.triangles()[i][0]];
        throw Error(Errc::infeasible_blend,
                    "its surface lies inside of '" + bore + "' at " + decimal(at) + ": " +
                        wall_advice(part->first, bore, at),
                    std::string(part->first), document_place(assembly_, part->second));
      }
    }
  }

  [[nodiscard]] std::string wall_advice(std::string_view part, std::string_view bore,
                                        const Vec3& at) const {
    const std::string_view bored = bore.substr(0, bore.rfind(assembly::kBoreSuffix));
    const bool is_made = std::ranges::any_of(assembly_.parts, [&](const Part& one) {
      return one.name == bored && !one.component.name.empty();
    });
    if (const auto end = end_called_as_part(bored); end && part == bored) {
      return is_made ? "its end '" + *end +
                           "' is to lie inside of what it branches off, and reaches out of that, "
                           "where no bore opens and no wall closes it"
                     : "the patch '" + *end + "' is called '" + assembly_.patches.at(*end) +
                           "' as its part is, so that no bore opens there, and no wall closes it; "
                           "give it another name";
    }
    if (part == bored || are_of_a_fillet(part, bored) ||
        (are_neighbours(part, bored) && !is_at_open_end(bored, at))) {
      return "meshes are too coarse there for the wall; choose a smaller tolerance, or a thicker "
             "wall";
    }
    return "there is no wall where an open end of '" + std::string(bored) +
           "' is cut; that end must be elsewhere, or " +
           (assembly_.is_of_network ? "no walls be given"
                                    : "'" + std::string(bored) + "' without a bore (\"wall\": 0)");
  }

  [[nodiscard]] std::optional<std::string> end_called_as_part(std::string_view part) const {
    for (const End end : {End::start, End::end}) {
      const std::string name = to_string({std::string(part), end});
      const auto patch = assembly_.patches.find(name);
      if (patch != assembly_.patches.end() && patch->second == part) {
        return name;
      }
    }
    return std::nullopt;
  }

  // Whether the place is where the part's bore goes out of it by an end that nothing is joined to.
  [[nodiscard]] bool is_at_open_end(std::string_view name, const Vec3& at) const {
    const auto part = std::ranges::find(resolved_.parts, name, &ResolvedPart::name);
    return part != resolved_.parts.end() &&
           std::ranges::any_of(std::array{End::start, End::end}, [&](End end) {
             const Ring* ring = port_ring(part->shape, end);
             const double reach = wall_of(*part);
             return ring != nullptr && !part->joined.at(dupin::at(end)) &&
                    std::abs((at - ring->center).dot(ring->normal)) <= reach &&
                    (at - ring->center).norm() <= ring->radius + reach;
           });
  }

  // Whether one of them is the fillet of the other.
  [[nodiscard]] bool are_of_a_fillet(std::string_view a, std::string_view b) const {
    return std::ranges::any_of(resolved_.fillets, [&](const ResolvedFillet& fillet) {
      const auto is_at = [&](std::string_view name) {
        return std::ranges::any_of(
            fillet.between, [&](std::uint32_t pipe) { return resolved_.parts[pipe].name == name; });
      };
      return (fillet.name == a && is_at(b)) || (fillet.name == b && is_at(a));
    });
  }

  [[nodiscard]] bool are_neighbours(std::string_view a, std::string_view b) const {
    const auto part = std::ranges::find(resolved_.parts, a, &ResolvedPart::name);
    return part != resolved_.parts.end() && std::ranges::any_of(part->joined, [&](const auto& end) {
             return end && resolved_.parts[end->part].name == b;
           });
  }

  // An end of a bore that bounds the fluid, though no part goes on from it, lies inside of a wall.
  // Of an end in a bore as wide as its own, a sliver does, too.
  void warn_of_blind_ends(const Solid& fluid) {
    const std::map<std::string, double> areas = exposed_areas(fluid);
    for (const ResolvedPart& part : resolved_.parts) {
      for (const End end : {End::start, End::end}) {
        const std::string bore = part.name + std::string(assembly::kBoreSuffix);
        const auto exposed = areas.find(to_string({bore, end}));
        if (!part.joined.at(at(end)) && exposed != areas.end() &&
            exposed->second > kBlindShare * bore_area(part, end)) {
          std::ranges::find(built_.parts, part.name, &PartReport::name)
              ->warnings.push_back("its bore ends blind at its " + std::string(name(end)) +
                                   ", which lies inside of a wall");
        }
      }
    }
  }

  [[nodiscard]] double wall_of(const ResolvedPart& part) const {
    return assembly_.parts[part.index].wall.value_or(assembly_.wall.value_or(0));
  }

  [[nodiscard]] double bore_area(const ResolvedPart& part, End end) const {
    const Ring* ring = port_ring(part.shape, end);
    const double wall = wall_of(part);
    return ring == nullptr ? 0 : std::numbers::pi * (ring->radius - wall) * (across(*ring) - wall);
  }

  [[nodiscard]] static std::string bore_beside(const Solid& fluid, std::uint32_t label) {
    std::vector<bool> is_corner(fluid.point_count(), false);
    const auto& triangles = fluid.triangles();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (const std::uint32_t corner : triangles[i]) {
        is_corner[corner] = is_corner[corner] || fluid.labels()[i] == label;
      }
    }
    std::string own = fluid.names()[label] + std::string(assembly::kBoreSuffix);
    std::optional<std::string> other;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const std::string& name = fluid.names()[fluid.labels()[i]];
      if (name.ends_with(assembly::kBoreSuffix) &&
          std::ranges::any_of(triangles[i], [&](auto corner) { return is_corner[corner]; })) {
        if (name == own) {
          return own;
        }
        other = other.value_or(name);
      }
    }
    return other.value_or("a bore");
  }

  Assembly assembly_;
  std::vector<std::uint32_t> numbers_;  // of its parts, in the whole document
  const BuildOptions& options_;
  ResolvedAssembly resolved_;
  std::optional<PieceOf> piece_;
  Built built_;
};

}  // namespace

Built built_district(District district, const BuildOptions& options) {
  return Builder(std::move(district), options).run();
}

}  // namespace dupin::assembly
