#include "dupin/blends/build.h"

#include <algorithm>
#include <span>

#include "assembly/cost_limit.h"
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
    for (std::size_t i = 0; i < runs.size(); ++i) {
      report("weld", double(i) / double(runs.size()));
      append_solids(runs[i].parts, tessellated(runs[i], i));
    }
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

  const Assembly& assembly_;
  const BuildOptions& options_;
  ResolvedAssembly resolved_;
  std::vector<TriMesh> tubes_;  // by part
  std::vector<Solid> solids_;
  Built built_;
};

}  // namespace

Built build(const Assembly& assembly, const BuildOptions& options) {
  const Assembly effective = with_options(assembly, options);
  return Builder(effective, options).run();
}

}  // namespace dupin
