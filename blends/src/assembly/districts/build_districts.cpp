#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "assembly/bore.h"
#include "assembly/cost_limit.h"
#include "assembly/districts/built_district.h"
#include "assembly/districts/district_plan.h"
#include "assembly/districts/divided_districts.h"
#include "assembly/welded_runs.h"
#include "dupin/blends/build.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

// So many districts, between one look at whether to go on and the next.
constexpr std::size_t kAtOnce = 64;

Assembly with_options(Assembly assembly, const BuildOptions& options) {
  assembly.tolerance = options.tolerance.value_or(assembly.tolerance);
  if (options.segments) {
    assembly.segments = options.segments;
  }
  return assembly;
}

ResolvedAssembly resolved(const Assembly& assembly, const Progress& progress) {
  tell(progress, "resolve");
  return resolve_unproved(assembly);
}

void require_margins(const BuildOptions& options) {
  if (std::isnan(options.most_of_piece) || std::isnan(options.most_undivided)) {
    throw Error(Errc::invalid_argument, "the most triangles of a piece must be a number");
  }
  for (const double margin : {options.margin, options.relative_margin}) {
    if (!(margin >= 0 && std::isfinite(margin))) {
      throw Error(
          Errc::invalid_argument,
          "boxes about parts are wider by a margin that is finite and not negative, not by " +
              decimal(margin, kMessageDigits));
    }
  }
}

// How far what is made of a part may lie outside of a box about its surface.
double margin_of(const Assembly& assembly, const BuildOptions& options) {
  double insulation = 0;
  if (options.region == Region::insulation) {
    for (const double thickness : assembly::insulation_of(assembly)) {
      insulation = std::max(insulation, thickness);
    }
  }
  return 2 * (assembly.tolerance + insulation) + options.margin;
}

[[noreturn]] void refuse_region(const Assembly& assembly, Region region, std::string_view what,
                                std::string_view key) {
  throw Error(Errc::invalid_argument,
              "there is no " + std::string(name(region)) + " region: " +
                  (assembly.is_of_network ? "nothing" : "neither the document nor a part") +
                  " says how thick " + std::string(what) + " is" +
                  (assembly.is_of_network ? "; --" + std::string(key.substr(1)) + " does" : ""),
              {}, document_place(assembly, key));
}

// What the document says of one part holds for the regions of all.
Assembly with_regions(Assembly assembly, const ResolvedAssembly& resolved,
                      std::optional<Region> region) {
  if (region == Region::insulation) {
    if (assembly::insulation_of(assembly).empty()) {
      refuse_region(assembly, *region, "insulation", "/insulation");
    }
    return assembly;
  }
  if (assembly::walls_of(assembly, resolved, region)) {
    assembly.wall = assembly.wall.value_or(0);
  } else if (region.value_or(Region::outer) != Region::outer) {
    refuse_region(assembly, *region, "a wall", "/wall");
  }
  return assembly;
}

// Of any region.
std::set<std::string> known_patches(const ResolvedAssembly& resolved, const Solid& solid) {
  std::set<std::string> result(solid.names().begin(), solid.names().end());
  const auto include = [&](const std::string& name) {
    for (const std::string_view side :
         {std::string_view(), assembly::kBoreSuffix, assembly::kInsulationSuffix}) {
      const std::string own = name + std::string(side);
      result.insert({own, own + ".start", own + ".end"});
    }
  };
  for (const ResolvedPart& part : resolved.parts) {
    include(part.name);
    result.insert(part.end_names.begin(), part.end_names.end());
  }
  std::ranges::for_each(resolved.fillets, [&](const auto& named) { include(named.name); });
  std::ranges::for_each(resolved.junctions, [&](const auto& named) { include(named.name); });
  return result;
}

void refuse_unknown_patches(const Assembly& assembly, const ResolvedAssembly& resolved,
                            const Solid& solid) {
  if (assembly.patches.empty()) {
    return;
  }
  const std::set<std::string> known = known_patches(resolved, solid);
  for (const auto& [name, other] : assembly.patches) {
    if (!known.contains(name)) {
      throw Error(Errc::invalid_argument,
                  "there is no patch named '" + name +
                      "'; patches are called as parts, ends and bores are: part, part.start, "
                      "part.bore",
                  {}, document_place(assembly, "/patches"));
    }
  }
}

double least(double a, double b) { return std::min(a, b); }
std::optional<double> least(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::min(a, b) : std::nullopt;
}

// What became of one more stretch of a pipe, to that of those before.
void add(const PartReport& from, PartReport& to) {
  to.margin_lower = least(to.margin_lower, from.margin_lower);
  to.margin_upper = least(to.margin_upper, from.margin_upper);
  to.least_wall = least(to.least_wall, from.least_wall);
  to.smallest_angle = least(to.smallest_angle, from.smallest_angle);
  to.error_bound = std::max(to.error_bound, from.error_bound);
  to.segments = std::max(to.segments, from.segments);
  to.bands += from.bands;
  to.triangles += from.triangles;
  for (const std::string& warning : from.warnings) {
    if (std::ranges::find(to.warnings, warning) == to.warnings.end()) {
      to.warnings.push_back(warning);
    }
  }
}

// Stretches of a pipe are called like it, and follow one another.
void join_stretches(std::vector<PartReport>& parts) {
  std::vector<PartReport> joined;
  std::map<std::pair<std::uint32_t, std::string>, std::size_t> known;
  for (PartReport& part : parts) {
    const auto [first, is_new] = known.try_emplace({part.index, part.name}, joined.size());
    if (is_new) {
      joined.push_back(std::move(part));
    } else {
      add(part, joined[first->second]);
    }
  }
  parts = std::move(joined);
}

// What became of a district, to that of those before.
void add(Built&& from, Built& to) {
  std::ranges::move(from.parts, std::back_inserter(to.parts));
  to.runs += from.runs;
  to.pieces += from.pieces;
  to.grid = to.grid == 0 ? from.grid : std::min(to.grid, from.grid);
  to.region = from.region;
  const bool is_settled = to.cross_check && to.cross_check->verdict != CrossCheck::Verdict::agrees;
  if (from.cross_check && !is_settled) {
    to.cross_check = std::move(from.cross_check);
  }
  if (from.volumes) {
    to.volumes = to.volumes.value_or(RegionVolumes{});
    to.volumes->outer += from.volumes->outer;
    to.volumes->metal += from.volumes->metal;
    to.volumes->fluid += from.volumes->fluid;
  }
  if (from.insulation) {
    to.insulation = to.insulation.value_or(0) + *from.insulation;
  }
  to.districts.push_back(from.solid);
}

}  // namespace

struct DistrictBuild::Plan {
  Assembly assembly;
  BuildOptions options;
  ResolvedAssembly resolved;
  std::optional<ResolvedAssembly> cut;  // where pipes were cut
  std::vector<assembly::DistrictParts> districts;
  std::vector<Seam> seams;
  assembly::RelatedParts related;
  std::vector<Port> ports;
  std::vector<GapPair> gaps;

  Plan(const Assembly& document, const BuildOptions& chosen)
      : assembly(with_options(document, chosen)),
        options(chosen),
        resolved(dupin::resolved(assembly, chosen.progress)),
        related(assembly) {
    require_margins(options);
    assembly = with_regions(std::move(assembly), resolved, options.region);
    const std::array<void (Plan::*)(), 2> tasks{&Plan::divide, &Plan::measure_gaps};
    for_each_in_parallel(tasks.size(), [&](std::size_t i) { (this->*tasks.at(i))(); });
  }

  /// What the districts have parts of.
  [[nodiscard]] const ResolvedAssembly& of_districts() const { return cut ? *cut : resolved; }
  [[nodiscard]] const assembly::DistrictParts& district(std::size_t number) const {
    if (number >= districts.size()) {
      throw Error(Errc::invalid_argument, "there is no district " + std::to_string(number) +
                                              "; the last is " +
                                              std::to_string(districts.size() - 1));
    }
    return districts[number];
  }

 private:
  void measure_gaps() {
    ports = dupin::ports(resolved);
    gaps = pair_ends(resolved, ports, options.connect);
  }

  void divide() {
    districts = assembly::districts_of_parts(resolved, margin_of(assembly, options),
                                             options.relative_margin);
    if (districts.empty()) {
      districts.emplace_back();
    }
    if (options.most_of_piece > 0) {
      assembly::DividedDistricts made = assembly::divided(
          assembly, resolved, std::move(districts),
          {options.most_of_piece, options.most_undivided, options.kept_seams, options.region});
      districts = std::move(made.districts);
      seams = std::move(made.seams);
      cut = std::move(made.cut);
    }
  }
};

DistrictBuild::DistrictBuild(const Assembly& assembly, const BuildOptions& options) {
  const UsualArithmetic usual;
  plan_ = std::make_shared<const Plan>(assembly, options);
}

std::size_t DistrictBuild::size() const { return plan_->districts.size(); }

std::vector<Boxes> DistrictBuild::boxes() const {
  std::vector<Boxes> result;
  for (const assembly::DistrictParts& district : plan_->districts) {
    result.push_back(district.boxes);
  }
  return result;
}

const std::vector<Seam>& DistrictBuild::seams() const { return plan_->seams; }

std::string DistrictBuild::taken_from_whole(std::size_t district) const {
  const auto& piece = plan_->district(district).piece;
  std::string text;
  if (piece) {
    text = decimal(piece->grid) + " " + decimal(piece->tolerance);
    for (const auto* samplings : {&piece->samplings, &piece->second_samplings}) {
      for (const RingSampling& sampling : *samplings) {
        text += " " + std::to_string(sampling.segments) + " " + decimal(sampling.phase) + " " +
                decimal(sampling.grid);
      }
    }
    for (const assembly::DiscName& disc : piece->discs) {
      text += "\n" + to_string({plan_->of_districts().parts[disc.end.part].name, disc.end.end}) +
              disc.name;
    }
  }
  return text;
}

std::vector<std::uint32_t> DistrictBuild::parts(std::size_t district) const {
  return assembly::document_parts(plan_->of_districts(), plan_->district(district));
}

Assembly DistrictBuild::document(std::size_t district) const {
  std::vector<std::uint32_t> parts = this->parts(district);
  std::set<std::uint32_t> known(parts.begin(), parts.end());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const std::uint32_t other : plan_->related.of(parts[i])) {
      if (known.insert(other).second) {
        parts.push_back(other);
      }
    }
  }
  return assembly::document_of(plan_->assembly, {known.begin(), known.end()});
}

double DistrictBuild::expected_triangles(std::size_t district) const {
  const assembly::District own = assembly::district_with_loops(
      plan_->assembly, plan_->of_districts(), plan_->district(district));
  return assembly::expected_triangles(own, plan_->options.region);
}

Built DistrictBuild::build(std::size_t district, const Progress& progress,
                           std::uint64_t memory_limit) const {
  const UsualArithmetic usual;
  BuildOptions options = plan_->options;
  options.progress = progress;
  options.memory_limit = memory_limit > 0 ? memory_limit : options.memory_limit;
  return assembly::built_district(
      assembly::district(plan_->assembly, plan_->of_districts(), plan_->district(district)),
      options);
}

Built DistrictBuild::joined(std::vector<Built> districts) const {
  const UsualArithmetic usual;
  Built result;
  for (Built& built : districts) {
    add(std::move(built), result);
  }
  std::ranges::stable_sort(result.parts, {}, &PartReport::index);
  if (plan_->cut) {
    join_stretches(result.parts);
  }
  result.boxes = boxes();
  if (!seams().empty()) {
    result.runs = assembly::welded_runs(plan_->resolved).size();
  } else if (result.districts.size() == 1) {
    result.solid = result.districts.front();
  } else if (!std::ranges::all_of(result.districts, &Solid::empty)) {  // which were given away
    result.solid = dupin::joined(result.districts, result.boxes);
  }
  refuse_unknown_patches(plan_->assembly, plan_->resolved, result.solid);
  result.ports = plan_->ports;
  result.gaps = plan_->gaps;
  return result;
}

void DistrictBuild::refuse_too_costly() const {
  ResolvedAssembly resolved = plan_->resolved;
  find_loops(plan_->assembly, resolved);
  assembly::refuse_too_costly(plan_->assembly, resolved, assembly::welded_runs(resolved),
                              assembly::lattice_spacing(plan_->assembly, resolved),
                              plan_->options.most_triangles);
}

Built DistrictBuild::build_all(const Progress& progress) const {
  const UsualArithmetic usual;
  const std::size_t count = size();
  if (!seams().empty()) {
    throw Error(Errc::invalid_argument, "pieces with seams are not built at once");
  }
  if (count == 1) {
    return joined({build(0, progress)});
  }
  refuse_too_costly();
  std::vector<Built> built(count);
  for (std::size_t begin = 0; begin < count; begin += kAtOnce) {
    tell(progress, "build", double(begin) / double(count));
    for_each_in_parallel(std::min(kAtOnce, count - begin),
                         [&](std::size_t i) { built[begin + i] = build(begin + i); });
  }
  return joined(std::move(built));
}

}  // namespace dupin
