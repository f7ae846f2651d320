#include "assembly/filleted_runs.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

#include "assembly/groups.h"
#include "assembly/part_context.h"
#include "numbers/point_order.h"
#include "tessellation/trimmed_face.h"

namespace dupin::assembly {
namespace {

using surfaces::FilletMesh;

// Meshes side by side, in which points at feet are the same.
class Joiner {
 public:
  void open_at(const std::vector<Vec3>& feet) {
    for (const Vec3& foot : feet) {
      vertex_at_.try_emplace(foot, kNone);
    }
  }

  void append(const TriMesh& mesh) {
    std::vector<std::uint32_t> vertices, labels;
    for (const Vec3& point : mesh.points) {
      vertices.push_back(vertex(point));
    }
    for (const std::string& name : mesh.names) {
      labels.push_back(std::uint32_t(result_.names.size()));
      result_.names.push_back(name);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle& t = mesh.triangles[i];
      result_.triangles.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
      result_.labels.push_back(labels.at(mesh.labels[i]));
    }
  }

  TriMesh take() { return std::move(result_); }

 private:
  static constexpr auto kNone = std::uint32_t(-1);

  std::uint32_t vertex(const Vec3& point) {
    const auto foot = vertex_at_.find(point);
    if (foot != vertex_at_.end() && foot->second != kNone) {
      return foot->second;
    }
    const auto index = std::uint32_t(result_.points.size());
    result_.points.push_back(point);
    if (foot != vertex_at_.end()) {
      foot->second = index;
    }
    return index;
  }

  std::map<Vec3, std::uint32_t, numbers::PointOrder> vertex_at_;
  TriMesh result_;
};

// All loops of a fillet under its name.
TriMesh labelled(const std::string& name, const std::vector<FilletMesh>& loops) {
  TriMesh result;
  result.names = {name};
  for (const FilletMesh& loop : loops) {
    const TriMesh& mesh = loop.tessellation.mesh;
    const auto offset = std::uint32_t(result.points.size());
    result.points.insert(result.points.end(), mesh.points.begin(), mesh.points.end());
    for (const auto& [a, b, c] : mesh.triangles) {
      result.triangles.push_back({offset + a, offset + b, offset + c});
    }
  }
  result.labels.assign(result.triangles.size(), 0);
  return result;
}

// What `among` names, sorted into groups by what joins runs.
std::vector<FilletedRuns> grouped(const ResolvedAssembly& assembly, std::span<const WeldedRun> runs,
                                  const FilletedRuns& among) {
  std::vector<std::uint32_t> run_of(assembly.parts.size());
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (const std::uint32_t part : runs[r].parts) {
      run_of[part] = std::uint32_t(r);
    }
  }
  Groups groups(runs.size());
  const auto join = [&](std::uint32_t part, std::uint32_t other) {
    groups.unite(run_of[part], run_of[other]);
  };
  for (const std::size_t f : among.fillets) {
    join(assembly.fillets[f].between[0], assembly.fillets[f].between[1]);
  }
  for (const std::size_t j : among.junctions) {
    for (const std::uint32_t arm : assembly.junctions[j].arms) {
      join(assembly.junctions[j].arms.front(), arm);
    }
  }
  std::vector<FilletedRuns> by_first(runs.size());
  for (const std::size_t r : among.runs) {
    by_first[groups.of(std::uint32_t(r))].runs.push_back(r);
  }
  for (const std::size_t f : among.fillets) {
    by_first[groups.of(run_of[assembly.fillets[f].between[0]])].fillets.push_back(f);
  }
  for (const std::size_t j : among.junctions) {
    by_first[groups.of(run_of[assembly.junctions[j].arms.front()])].junctions.push_back(j);
  }
  std::erase_if(by_first, [](const FilletedRuns& group) { return group.runs.empty(); });
  return by_first;
}

}  // namespace

std::vector<FilletedRuns> filleted_runs(const ResolvedAssembly& assembly,
                                        std::span<const WeldedRun> runs) {
  FilletedRuns all;
  all.runs.resize(runs.size());
  all.fillets.resize(assembly.fillets.size());
  all.junctions.resize(assembly.junctions.size());
  for (auto* positions : {&all.runs, &all.fillets, &all.junctions}) {
    std::iota(positions->begin(), positions->end(), std::size_t{0});
  }
  return grouped(assembly, runs, all);
}

JoinedCores joined_cores(const ResolvedAssembly& assembly, const FilletedRuns& group) {
  std::set<std::uint32_t> parts;
  for (const std::size_t f : group.fillets) {
    parts.insert(assembly.fillets[f].between.begin(), assembly.fillets[f].between.end());
  }
  for (const std::size_t j : group.junctions) {
    parts.insert(assembly.junctions[j].arms.begin(), assembly.junctions[j].arms.end());
  }
  JoinedCores result;
  result.parts.reserve(parts.size());
  for (const std::uint32_t part : parts) {
    result.parts.push_back({{part}});
  }
  FilletedRuns cores = group;
  cores.runs.resize(parts.size());
  std::iota(cores.runs.begin(), cores.runs.end(), std::size_t{0});
  result.groups = grouped(assembly, result.parts, cores);
  return result;
}

std::vector<FilletMesh> fillet_meshes(const Assembly& assembly, const ResolvedFillet& fillet,
                                      const std::array<RingSampling, 2>& samplings,
                                      std::size_t most_triangles) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return with_part_context(assembly, fillet.index, [&] {
    std::vector<FilletMesh> result;
    for (const CanalFillet& loop : fillet.shape.loops) {
      result.push_back(surfaces::fillet_mesh(
          loop, {assembly.tolerance,
                 {kTurn / samplings[0].segments, kTurn / samplings[1].segments},
                 samplings[0].grid,
                 most_triangles}));
    }
    return result;
  });
}

Tessellation trimmed(const ResolvedAssembly& assembly, std::uint32_t part,
                     const RingSampling& sampling,
                     const std::vector<std::vector<FilletMesh>>& meshes) {
  const Chain& chain = std::get<Chain>(assembly.parts[part].shape);
  tessellation::TrimmedFace face{end_ring(chain, End::start), end_ring(chain, End::end), {}};
  for (std::size_t f = 0; f < assembly.fillets.size(); ++f) {
    const ResolvedFillet& fillet = assembly.fillets[f];
    for (std::size_t side = 0; side < 2; ++side) {
      if (fillet.between.at(side) != part) {
        continue;
      }
      for (const FilletMesh& loop : meshes[f]) {
        face.curves.push_back(loop.feet.at(side));
      }
      face.keeps_start = face.keeps_start && !fillet.shape.buried.at(side)[0];
      face.keeps_end = face.keeps_end && !fillet.shape.buried.at(side)[1];
    }
  }
  return tessellation::trimmed_face(face, sampling);
}

TriMesh joined_by_fillets(const ResolvedAssembly& assembly, const std::vector<TriMesh>& runs,
                          std::span<const std::size_t> fillets,
                          const std::vector<std::vector<FilletMesh>>& meshes) {
  Joiner joiner;
  for (const std::size_t f : fillets) {
    for (const FilletMesh& loop : meshes[f]) {
      joiner.open_at(loop.feet[0]);
      joiner.open_at(loop.feet[1]);
    }
  }
  std::ranges::for_each(runs, [&](const TriMesh& run) { joiner.append(run); });
  for (const std::size_t f : fillets) {
    if (!assembly.fillets[f].shape.is_cope()) {
      joiner.append(labelled(assembly.fillets[f].name, meshes[f]));
    }
  }
  return joiner.take();
}

}  // namespace dupin::assembly
