#include "assembly/run_solids.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "assembly/cost_limit.h"
#include "assembly/fillet_overlap.h"
#include "assembly/filleted_runs.h"
#include "assembly/joined_hubs.h"
#include "assembly/part_context.h"
#include "assembly/part_margins.h"
#include "assembly/welded_runs.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"

namespace dupin::assembly {
namespace {

class RunMesher {
 public:
  RunMesher(const Assembly& assembly, const ResolvedAssembly& resolved, double grid,
            const BuildOptions& options, std::span<const RingSampling> given,
            std::span<const RingWithin> within)
      : document_(assembly),
        assembly_(assembly),
        resolved_(resolved),
        grid_(grid),
        options_(options),
        given_(given),
        within_(within),
        buried_(resolved),
        tubes_(resolved.parts.size()) {
    result_.parts.resize(resolved.parts.size());
  }

  // By part.
  std::vector<RingSampling> samplings() {
    const auto runs = welded_runs(resolved_);
    sample(runs);
    std::vector<RingSampling> result(resolved_.parts.size());
    for (std::size_t run = 0; run < runs.size(); ++run) {
      for (const std::uint32_t part : runs[run].parts) {
        result[part] = samplings_[run];
      }
    }
    return result;
  }

  RunSolids run() {
    const auto runs = welded_runs(resolved_);
    refuse_too_costly(assembly_, resolved_, runs, grid_, options_.most_triangles);
    sample(runs);
    for (const FilletedRuns& group : filleted_runs(resolved_, runs)) {
      tell(options_.progress, "mesh", double(group.runs.front()) / double(runs.size()));
      if (group.fillets.empty() && group.junctions.empty()) {
        const std::size_t run = group.runs.front();
        append_solids(runs[run].parts, tessellated(runs[run], run));
      } else if (group.fillets.empty() && !document_.segments) {
        append_hubs(runs, group);
      } else {
        append_filleted(runs, group);
      }
    }
    result_.runs = runs.size();
    return std::move(result_);
  }

 private:
  void sample(const std::vector<WeldedRun>& runs) {
    std::vector<std::size_t> run_of(resolved_.parts.size());
    for (std::size_t run = 0; run < runs.size(); ++run) {
      samplings_.push_back(given_.empty()
                               ? run_sampling(assembly_, resolved_, runs[run], run, grid_)
                               : given_[runs[run].parts.front()]);
      for (const std::uint32_t part : runs[run].parts) {
        run_of[part] = run;
      }
    }
    level_ = LevelEnds(resolved_, std::move(run_of));
    if (given_.empty()) {
      level_.share(samplings_);
    }
    for (const RingWithin& ring : within_) {
      level_.put_within(ring.end, ring.ring);
    }
  }

  RingSampling tessellated(const WeldedRun& run, std::size_t position) {
    const RingSampling chosen = samplings_[position];
    for (const auto index : run.parts) {
      Tessellation result = assembly::tessellated(assembly_, resolved_.parts[index], chosen);
      PartReport& entry = result_.parts[index];
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
    TriMesh mesh = assembly::welded(resolved_, parts, tubes_, chosen, buried_, level_, samplings_);
    const bool overlaps = std::any_of(parts.begin(), parts.end(), [&](std::uint32_t part) {
      const auto* chain = std::get_if<Chain>(&resolved_.parts[part].shape);
      return chain != nullptr && chain->joints == Joints::spherical;
    });
    if (!overlaps) {
      return {Solid::from(mesh)};
    }
    std::vector<Solid> solids, cavities;
    for (TriMesh& shell : connected_parts(mesh)) {
      const bool is_cavity = check(shell, {.limit = 0, .self_intersections = false}).volume < 0;
      if (is_cavity) {
        std::ranges::for_each(shell.triangles, [](Triangle& t) { std::swap(t[1], t[2]); });
      }
      (is_cavity ? cavities : solids).push_back(Solid::from(shell));
    }
    const BooleanOptions limited{.memory_limit = options_.memory_limit};
    return cavities.empty() ? solids
                            : std::vector{subtract(unite(solids, limited), cavities, limited)};
  }

  // Parts of a run may cross, touch or cover each other. Such a run is halved, at a ring, until
  // every piece is a solid; the discs of both halves there are the same and vanish in the union.
  void append_solids(std::span<const std::uint32_t> parts, const RingSampling& chosen) {
    try {
      auto solids = solids_of(parts, chosen);
      result_.solids.insert(result_.solids.end(), solids.begin(), solids.end());
      return;
    } catch (const Error& error) {
      if (error.code() == Errc::limit_exceeded || error.code() == Errc::cancelled) {
        throw;
      }
      if (parts.size() == 1) {
        const ResolvedPart& part = resolved_.parts[parts.front()];
        with_part_context(assembly_, part.index, [&] { refuse_mesh(part.shape, error); });
      }
    }
    const auto half = parts.size() / 2;
    append_solids(parts.first(half), chosen);
    append_solids(parts.subspan(half), chosen);
  }

  // Where a hub is much larger than its pipe, its collar flares within less than the tolerance,
  // nearly in one plane, and coarse rows that are turned against each other cross there.
  void append_hubs(const std::vector<WeldedRun>& runs, const FilletedRuns& group) {
    constexpr int kFiner = 2;
    const std::size_t solids = result_.solids.size(), others = result_.others.size();
    try {
      append_filleted(runs, group);
      return;
    } catch (const Error& error) {
      if (error.code() != Errc::infeasible_blend) {
        throw;
      }
      keep_first(solids, others);
      for (int i = 1; i <= kFiner; ++i) {
        if (append_finer(runs, group, std::pow(0.25, i))) {
          return;
        }
      }
      throw;
    }
  }

  // With a part of the document's tolerance, if that bounds a solid and is not too fine.
  bool append_finer(const std::vector<WeldedRun>& runs, const FilletedRuns& group, double part) {
    const std::size_t solids = result_.solids.size(), others = result_.others.size();
    const std::vector<RingSampling> samplings = samplings_;
    Assembly finer = document_;
    finer.tolerance *= part;
    assembly_ = finer;
    for (const std::size_t run : group.runs) {
      samplings_[run] = run_sampling(finer, resolved_, runs[run], run, grid_);
    }
    bool is_made = true;
    try {
      std::vector<WeldedRun> own;
      for (const std::size_t run : group.runs) {
        own.push_back(runs[run]);
      }
      refuse_too_costly(finer, resolved_, own, grid_, options_.most_triangles);
      append_filleted(runs, group);
    } catch (const Error& error) {
      if (error.code() != Errc::infeasible_blend && error.code() != Errc::limit_exceeded) {
        throw;
      }
      keep_first(solids, others);
      samplings_ = samplings;
      is_made = false;
    }
    assembly_ = document_;
    return is_made;
  }

  void keep_first(std::size_t solids, std::size_t others) {
    result_.solids.erase(result_.solids.begin() + std::ptrdiff_t(solids), result_.solids.end());
    result_.others.erase(result_.others.begin() + std::ptrdiff_t(others), result_.others.end());
  }

  // Pipes that end in fillets or hubs, with these: one solid, as nothing else closes them. Where
  // their runs cross elsewhere, only the parts that fillets and hubs join stay one; the discs
  // between them and the rest vanish in the union.
  void append_filleted(const std::vector<WeldedRun>& runs, const FilletedRuns& group) {
    std::map<std::uint32_t, RingSampling> sampling;  // by part
    for (const std::size_t run : group.runs) {
      const RingSampling chosen = tessellated(runs[run], run);
      for (const auto part : runs[run].parts) {
        sampling[part] = chosen;
      }
    }
    std::vector<std::vector<surfaces::FilletMesh>> meshes(resolved_.fillets.size());
    for_each_in_parallel(group.fillets.size(), [&](std::size_t i) {
      const ResolvedFillet& fillet = resolved_.fillets[group.fillets[i]];
      meshes[group.fillets[i]] = fillet_meshes(
          assembly_, fillet, {sampling.at(fillet.between[0]), sampling.at(fillet.between[1])},
          options_.most_triangles);
    });
    std::set<std::uint32_t> pipes;
    for (const std::size_t f : group.fillets) {
      const ResolvedFillet& fillet = resolved_.fillets[f];
      report_fillet(fillet, meshes[f]);
      pipes.insert(fillet.between.begin(), fillet.between.end());
    }
    trim({pipes.begin(), pipes.end()}, sampling, meshes);
    const JoinedMesher mesher{sampling, meshes, hubs(group.junctions, sampling)};
    try {
      result_.solids.push_back(joined(mesher, runs, group));
    } catch (const Error& error) {
      const bool are_cores_alone = std::ranges::all_of(
          group.runs, [&](std::size_t run) { return runs[run].parts.size() == 1; });
      if (error.code() != Errc::infeasible_blend || are_cores_alone) {
        throw;
      }
      const JoinedCores cores = joined_cores(resolved_, group);
      for (const FilletedRuns& core : cores.groups) {
        result_.solids.push_back(joined(mesher, cores.parts, core));
      }
      append_beside_cores(runs, group, cores, sampling);
    }
  }

  // What joins parts in a group.
  struct JoinedMesher {
    const std::map<std::uint32_t, RingSampling>& sampling;  // by part
    const std::vector<std::vector<surfaces::FilletMesh>>& meshes;
    std::map<std::size_t, HubPatch> hubs;
  };

  [[nodiscard]] Solid joined(const JoinedMesher& mesher, const std::vector<WeldedRun>& runs,
                             const FilletedRuns& group) const {
    std::vector<TriMesh> welded;
    welded.reserve(group.runs.size());
    for (const std::size_t run : group.runs) {
      const auto& parts = runs[run].parts;
      welded.push_back(assembly::welded(resolved_, parts, tubes_, mesher.sampling.at(parts.front()),
                                        buried_, level_, samplings_));
    }
    std::vector<HubPatch> patches;
    patches.reserve(group.junctions.size());
    for (const std::size_t junction : group.junctions) {
      patches.push_back(mesher.hubs.at(junction));
    }
    const TriMesh mesh = joined_with_hubs(
        joined_by_fillets(resolved_, welded, group.fillets, mesher.meshes), patches);
    try {
      return Solid::from(mesh);
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

  // The parts of the group's runs that no fillet or junction joins, run by run from one that is
  // joined to the next.
  void append_beside_cores(const std::vector<WeldedRun>& runs, const FilletedRuns& group,
                           const JoinedCores& cores,
                           const std::map<std::uint32_t, RingSampling>& sampling) {
    std::vector<bool> is_core(resolved_.parts.size(), false);
    for (const WeldedRun& core : cores.parts) {
      is_core[core.parts.front()] = true;
    }
    for (const std::size_t run : group.runs) {
      const std::span<const std::uint32_t> parts = runs[run].parts;
      for (std::size_t begin = 0; begin < parts.size();) {
        std::size_t end = begin;
        while (end < parts.size() && !is_core[parts[end]]) {
          ++end;
        }
        if (end > begin) {
          append_solids(parts.subspan(begin, end - begin), sampling.at(parts[begin]));
        }
        begin = end + 1;
      }
    }
  }

  std::map<std::size_t, HubPatch> hubs(const std::vector<std::size_t>& junctions,
                                       const std::map<std::uint32_t, RingSampling>& sampling) {
    std::map<std::size_t, HubPatch> result;
    for (const std::size_t j : junctions) {
      const ResolvedJunction& junction = resolved_.junctions[j];
      std::vector<RingSampling> samplings;
      std::size_t on_circles = 0;
      for (const auto arm : junction.arms) {
        samplings.push_back(sampling.at(arm));
        on_circles += samplings.back().segments;
      }
      Tessellation hub = hub_tessellation(assembly_, junction, samplings, options_.most_triangles);
      report_hub(junction, hub);
      hub.mesh.names = {junction.name};
      result.emplace(j, HubPatch{std::move(hub.mesh), on_circles});
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
    result_.others.emplace_back(junction.index, std::move(entry));
  }

  // Pipes end where their fillets begin.
  void trim(const std::vector<std::uint32_t>& pipes,
            const std::map<std::uint32_t, RingSampling>& sampling,
            const std::vector<std::vector<surfaces::FilletMesh>>& meshes) {
    struct Face {
      Tessellation face;
      double smallest_angle = 0;
      std::optional<Error> error;
    };
    std::vector<Face> faces(pipes.size());
    for_each_in_parallel(pipes.size(), [&](std::size_t i) {
      try {
        faces[i].face = trimmed(resolved_, pipes[i], sampling.at(pipes[i]), meshes);
        faces[i].smallest_angle = smallest_angle(faces[i].face.mesh);
      } catch (const Error& error) {
        faces[i].error = error;
      }
    });
    for (std::size_t i = 0; i < pipes.size(); ++i) {
      auto& [face, angle, error] = faces[i];
      if (error) {
        throw trim_refusal(assembly_, resolved_, pipes[i], sampling, meshes, *error);
      }
      PartReport& entry = result_.parts[pipes[i]];
      entry.error_bound = face.error_bound;
      entry.triangles = face.mesh.triangles.size();
      entry.smallest_angle = angle;
      tubes_[pipes[i]] = std::move(face.mesh);
    }
  }

  [[nodiscard]] Error refusal(const ResolvedFillet& fillet, const std::string& why) const {
    return Error(Errc::infeasible_blend, why, fillet.name, document_place(assembly_, fillet.index));
  }

  void report_fillet(const ResolvedFillet& fillet, const std::vector<surfaces::FilletMesh>& loops) {
    PartReport entry;
    entry.name = fillet.name;
    entry.kind = kind(document_.parts[fillet.index].shape);
    entry.margin_lower = fillet.shape.regularity;
    entry.smallest_angle = std::numbers::pi;
    for (const auto& loop : loops) {
      entry.error_bound = std::max(entry.error_bound, loop.tessellation.error_bound);
      entry.bands += loop.tessellation.bands;
      entry.segments = std::max(entry.segments, loop.columns);
      entry.triangles += loop.tessellation.mesh.triangles.size();
      entry.smallest_angle = std::min(entry.smallest_angle, smallest_angle(loop.tessellation.mesh));
    }
    result_.others.emplace_back(fillet.index, std::move(entry));
  }

  const Assembly& document_;
  std::reference_wrapper<const Assembly> assembly_;  // the document, or finer for a while
  const ResolvedAssembly& resolved_;
  double grid_;
  const BuildOptions& options_;
  std::span<const RingSampling> given_;  // by part, or none
  std::span<const RingWithin> within_;
  BuriedEnds buried_;
  std::vector<RingSampling> samplings_;  // by run
  LevelEnds level_;
  std::vector<TriMesh> tubes_;  // by part
  RunSolids result_;
};

}  // namespace

RunSolids solids_of_runs(const Assembly& assembly, const ResolvedAssembly& resolved, double grid,
                         const BuildOptions& options, std::span<const RingSampling> given,
                         std::span<const RingWithin> within) {
  return RunMesher(assembly, resolved, grid, options, given, within).run();
}

std::vector<RingSampling> part_samplings(const Assembly& assembly, const ResolvedAssembly& resolved,
                                         double grid) {
  const BuildOptions options;
  return RunMesher(assembly, resolved, grid, options, {}, {}).samplings();
}

}  // namespace dupin::assembly
