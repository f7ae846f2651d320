#include "dupin/blends/build.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <span>

#include "assembly/cost_limit.h"
#include "assembly/fillet_overlap.h"
#include "assembly/filleted_runs.h"
#include "assembly/joined_hubs.h"
#include "assembly/part_context.h"
#include "assembly/part_margins.h"
#include "assembly/parts/part_kind.h"
#include "assembly/weld.h"
#include "assembly/welded_runs.h"
#include "dupin/blends/resolve.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"

namespace dupin {
namespace {

Assembly with_options(Assembly assembly, const BuildOptions& options) {
  assembly.tolerance = options.tolerance.value_or(assembly.tolerance);
  if (options.segments) {
    assembly.segments = options.segments;
  }
  return assembly;
}

class Builder {
  template <typename Work>
  auto in_part(const ResolvedPart& part, const Work& work) const {
    return assembly::with_part_context(assembly_, part.index, work);
  }

 public:
  Builder(const Assembly& assembly, const BuildOptions& options)
      : assembly_(assembly),
        options_(options),
        resolved_(resolve(assembly)),
        tubes_(resolved_.parts.size()) {
    built_.grid = assembly::lattice_spacing(assembly, resolved_);
  }

  Built run() {
    for (const auto& part : resolved_.parts) {
      built_.parts.push_back(in_part(part, [&] { return certified(part); }));
    }
    built_.ports = ports(resolved_);
    built_.gaps = pair_ends(built_.ports, options_.connect);
    const auto runs = assembly::welded_runs(resolved_);
    assembly::refuse_too_costly(assembly_, resolved_, runs, built_.grid, options_.most_triangles);
    for (const assembly::FilletedRuns& group : assembly::filleted_runs(resolved_, runs)) {
      report("weld", double(group.runs.front()) / double(runs.size()));
      if (group.fillets.empty() && group.junctions.empty()) {
        const std::size_t run = group.runs.front();
        append_solids(runs[run].parts, tessellated(runs[run], run));
      } else {
        append_filleted(runs, group);
      }
    }
    order_reports();
    built_.runs = runs.size();
    built_.pieces = solids_.size();
    built_.solid = solids_.size() == 1 ? solids_.front()
                                       : unite(solids_, {options_.contacts, options_.progress});
    if (options_.cross_check) {
      built_.cross_check = second_opinion(built_.solid, *options_.cross_check, SetOperation::unite,
                                          solids_, options_.progress);
    }
    return std::move(built_);
  }

 private:
  void report(std::string_view stage, double fraction) const {
    if (options_.progress && !options_.progress(stage, fraction)) {
      throw Error(Errc::cancelled, "cancelled by the caller");
    }
  }

  [[nodiscard]] PartReport certified(const ResolvedPart& part) const {
    PartReport result;
    result.name = part.name;
    result.kind = part.kind;
    const assembly::PartMargins proven = assembly::margins(part.shape, part.is_tangent);
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

  RingSampling tessellated(const assembly::WeldedRun& run, std::size_t position) {
    const RingSampling chosen =
        assembly::run_sampling(assembly_, resolved_, run, position, built_.grid);
    for (const auto index : run.parts) {
      Tessellation result = assembly::tessellated(assembly_, resolved_.parts[index], chosen);
      PartReport& entry = built_.parts[index];
      entry.error_bound = result.error_bound;
      entry.segments = chosen.segments;
      entry.bands = result.bands;
      entry.triangles = result.mesh.triangles.size();
      entry.smallest_angle = smallest_angle(result.mesh);
      tubes_[index] = std::move(result.mesh);
    }
    return chosen;
  }

  // The pieces of a chain with kneecaps overlap each other, and so do those of its inner skin.
  [[nodiscard]] std::vector<Solid> solids_of(std::span<const std::uint32_t> parts,
                                             const RingSampling& chosen) const {
    TriMesh mesh = assembly::welded(resolved_, parts, tubes_, chosen);
    const bool overlaps = std::any_of(parts.begin(), parts.end(), [&](std::uint32_t part) {
      const auto* chain = std::get_if<Chain>(&resolved_.parts[part].shape);
      return chain != nullptr && chain->joints == Joints::spherical;
    });
    if (!overlaps) {
      return {Solid::from(mesh)};
    }
    std::vector<Solid> solids, cavities;
    for (TriMesh& shell : assembly::connected_parts(mesh)) {
      const bool is_cavity = check(shell, {.limit = 0, .self_intersections = false}).volume < 0;
      if (is_cavity) {
        std::ranges::for_each(shell.triangles, [](Triangle& t) { std::swap(t[1], t[2]); });
      }
      (is_cavity ? cavities : solids).push_back(Solid::from(shell));
    }
    return cavities.empty() ? solids : std::vector{subtract(unite(solids), cavities)};
  }

  // Parts of a run may cross, touch or cover each other. Such a run is halved, at a ring, until
  // every piece is a solid; the discs of both halves there are the same and vanish in the union.
  void append_solids(std::span<const std::uint32_t> parts, const RingSampling& chosen) {
    try {
      auto solids = solids_of(parts, chosen);
      solids_.insert(solids_.end(), solids.begin(), solids.end());
      return;
    } catch (const Error& error) {
      if (error.code() == Errc::limit_exceeded || error.code() == Errc::cancelled) {
        throw;
      }
      if (parts.size() == 1) {
        const ResolvedPart& part = resolved_.parts[parts.front()];
        in_part(part, [&] { assembly::refuse_mesh(part.shape, error); });
      }
    }
    const auto half = parts.size() / 2;
    append_solids(parts.first(half), chosen);
    append_solids(parts.subspan(half), chosen);
  }

  // Pipes that end in fillets or hubs, with these: one solid, as nothing else closes them.
  void append_filleted(const std::vector<assembly::WeldedRun>& runs,
                       const assembly::FilletedRuns& group) {
    std::map<std::uint32_t, RingSampling> sampling;  // by part
    for (const std::size_t run : group.runs) {
      const RingSampling chosen = tessellated(runs[run], run);
      for (const auto part : runs[run].parts) {
        sampling[part] = chosen;
      }
    }
    std::vector<std::vector<surfaces::FilletMesh>> meshes(resolved_.fillets.size());
    for (const std::size_t f : group.fillets) {
      const ResolvedFillet& fillet = resolved_.fillets[f];
      meshes[f] = assembly::fillet_meshes(
          assembly_, fillet, {sampling.at(fillet.between[0]), sampling.at(fillet.between[1])},
          options_.most_triangles);
      report_fillet(fillet, meshes[f]);
    }
    std::map<std::uint32_t, std::size_t> fillet_on;
    for (const std::size_t f : group.fillets) {
      fillet_on.try_emplace(resolved_.fillets[f].between[0], f);
      fillet_on.try_emplace(resolved_.fillets[f].between[1], f);
    }
    for (const auto& [part, f] : fillet_on) {
      trim(resolved_.fillets[f], part, sampling, meshes);
    }
    std::vector<TriMesh> welded;
    for (const std::size_t run : group.runs) {
      const auto& parts = runs[run].parts;
      welded.push_back(assembly::welded(resolved_, parts, tubes_, sampling.at(parts.front())));
    }
    const TriMesh joined = assembly::joined_with_hubs(
        assembly::joined_by_fillets(resolved_, welded, group.fillets, meshes),
        hubs(group.junctions, sampling));
    try {
      solids_.push_back(Solid::from(joined));
    } catch (const Error& error) {
      const std::string why =
          "with the pipes that it joins, it bounds no solid: " + error.message();
      if (group.fillets.empty()) {
        const ResolvedJunction& first = resolved_.junctions[group.junctions.front()];
        throw Error(Errc::infeasible_blend, why, first.name,
                    document_place(assembly_, first.index));
      }
      throw refusal(resolved_.fillets[group.fillets.front()], why);
    }
  }

  std::vector<assembly::HubPatch> hubs(const std::vector<std::size_t>& junctions,
                                       const std::map<std::uint32_t, RingSampling>& sampling) {
    std::vector<assembly::HubPatch> result;
    for (const std::size_t j : junctions) {
      const ResolvedJunction& junction = resolved_.junctions[j];
      std::vector<RingSampling> samplings;
      std::size_t on_circles = 0;
      for (const auto arm : junction.arms) {
        samplings.push_back(sampling.at(arm));
        on_circles += samplings.back().segments;
      }
      Tessellation hub =
          assembly::hub_tessellation(assembly_, junction, samplings, options_.most_triangles);
      report_hub(junction, hub);
      hub.mesh.names = {junction.name};
      result.push_back({std::move(hub.mesh), on_circles});
    }
    return result;
  }

  void report_hub(const ResolvedJunction& junction, const Tessellation& hub) {
    PartReport entry;
    entry.name = junction.name;
    entry.kind = "junction";
    entry.construction = description(junction.shape);
    entry.error_bound = hub.error_bound;
    entry.triangles = hub.mesh.triangles.size();
    entry.smallest_angle = smallest_angle(hub.mesh);
    fillet_reports_.emplace_back(junction.index, std::move(entry));
  }

  void trim(const ResolvedFillet& fillet, std::uint32_t part,
            const std::map<std::uint32_t, RingSampling>& sampling,
            const std::vector<std::vector<surfaces::FilletMesh>>& meshes) {
    try {
      Tessellation face = assembly::trimmed(resolved_, part, sampling.at(part), meshes);
      PartReport& entry = built_.parts[part];
      entry.error_bound = face.error_bound;
      entry.triangles = face.mesh.triangles.size();
      entry.smallest_angle = smallest_angle(face.mesh);
      tubes_[part] = std::move(face.mesh);
    } catch (const Error& error) {
      if (const auto overlap =
              assembly::fillet_overlap(assembly_, resolved_, part, sampling, meshes)) {
        throw refusal(resolved_.fillets[overlap->fillet], overlap->why);
      }
      throw refusal(fillet, "on '" + resolved_.parts[part].name + "', " + error.message() +
                                "; fillets must be apart from each other and from its ends");
    }
  }

  [[nodiscard]] Error refusal(const ResolvedFillet& fillet, const std::string& why) const {
    return Error(Errc::infeasible_blend, why, fillet.name, document_place(assembly_, fillet.index));
  }

  void report_fillet(const ResolvedFillet& fillet, const std::vector<surfaces::FilletMesh>& loops) {
    PartReport entry;
    entry.name = fillet.name;
    entry.kind = kind(assembly_.parts[fillet.index].shape);
    entry.margin_lower = fillet.shape.regularity;
    entry.smallest_angle = std::numbers::pi;
    for (const auto& loop : loops) {
      entry.error_bound = std::max(entry.error_bound, loop.tessellation.error_bound);
      entry.bands += loop.tessellation.bands;
      entry.segments = std::max(entry.segments, loop.columns);
      entry.triangles += loop.tessellation.mesh.triangles.size();
      entry.smallest_angle = std::min(entry.smallest_angle, smallest_angle(loop.tessellation.mesh));
    }
    fillet_reports_.emplace_back(fillet.index, std::move(entry));
  }

  // Those of fillets and hubs are put where the document has them, hubs before their arms.
  void order_reports() {
    std::vector<std::pair<std::uint32_t, PartReport>> all = std::move(fillet_reports_);
    for (std::size_t i = 0; i < built_.parts.size(); ++i) {
      all.emplace_back(resolved_.parts[i].index, std::move(built_.parts[i]));
    }
    std::ranges::stable_sort(all, {}, [](const auto& entry) { return entry.first; });
    built_.parts.clear();
    for (auto& [index, entry] : all) {
      built_.parts.push_back(std::move(entry));
    }
  }

  const Assembly& assembly_;
  const BuildOptions& options_;
  ResolvedAssembly resolved_;
  std::vector<std::pair<std::uint32_t, PartReport>> fillet_reports_;  // by place in the document
  std::vector<TriMesh> tubes_;                                        // by part
  std::vector<Solid> solids_;
  Built built_;
};

}  // namespace

Built build(const Assembly& assembly, const BuildOptions& options) {
  const Assembly effective = with_options(assembly, options);
  return Builder(effective, options).run();
}

}  // namespace dupin
