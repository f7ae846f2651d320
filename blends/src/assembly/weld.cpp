#include "assembly/weld.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "assembly/groups.h"
#include "dupin/blends/tessellate.h"
#include "dupin/kernel/connected_components.h"
#include "numbers/point_order.h"

namespace dupin::assembly {
namespace {

// The vertices of one ring, by their coordinates, which all parts at the ring agree upon bitwise.
using RingVertices = std::map<Vec3, std::uint32_t, numbers::PointOrder>;

class Welder {
 public:
  Welder(const ResolvedAssembly& assembly, std::span<const std::uint32_t> parts,
         const RingSampling& sampling, const BuriedEnds& buried, const LevelEnds& level,
         std::span<const RingSampling> of_runs)
      : assembly_(assembly),
        sampling_(sampling),
        buried_(buried),
        level_(level),
        of_runs_(of_runs),
        is_member_(assembly.parts.size(), false) {
    for (const auto part : parts) {
      is_member_[part] = true;
    }
  }

  void append(std::uint32_t index, const TriMesh& tube) {
    const ResolvedPart& part = assembly_.parts[index];
    const std::uint32_t label = new_label(part.name);
    const Ring* start_ring = port_ring(part.shape, End::start);
    if (start_ring == nullptr) {
      append_closed(part, tube, label);
      return;
    }
    const std::size_t first = row_size({index, End::start}), last = row_size({index, End::end});
    const std::span points(tube.points);
    std::vector<std::uint32_t> vertices = on_ring(ring({index, End::start}), points.first(first));
    const auto inner = appended(points.subspan(first, points.size() - first - last));
    vertices.insert(vertices.end(), inner.begin(), inner.end());
    const auto at_end = on_ring(ring({index, End::end}), points.last(last));
    vertices.insert(vertices.end(), at_end.begin(), at_end.end());
    append_triangles(tube, vertices, label);
    close(index, End::start, *start_ring, label);
    close(index, End::end, *port_ring(part.shape, End::end), label);
  }

  [[nodiscard]] TriMesh take() { return std::move(mesh_); }

 private:
  [[nodiscard]] bool is_welded(const EndIndex& end) const {
    const auto& joined = assembly_.parts[end.part].joined.at(at(end.end));
    return joined && is_member_[joined->part];
  }

  // How many points a tube has at an end: those of the ring, or none.
  [[nodiscard]] std::size_t row_size(const EndIndex& end) const {
    return buried_.contains(end) ? 0 : sampling_.segments;
  }

  // Both ends at a welded ring have the same vertices; the end that comes first owns them.
  RingVertices& ring(const EndIndex& end) {
    const auto key = [](const EndIndex& e) { return std::pair(e.part, at(e.end)); };
    const auto own = key(end);
    return rings_[is_welded(end)
                      ? std::min(own, key(*assembly_.parts[end.part].joined.at(at(end.end))))
                      : own];
  }

  std::vector<std::uint32_t> appended(std::span<const Vec3> points) {
    std::vector<std::uint32_t> vertices;
    vertices.reserve(points.size());
    for (const Vec3& point : points) {
      vertices.push_back(std::uint32_t(mesh_.points.size()));
      mesh_.points.push_back(point);
    }
    return vertices;
  }

  std::vector<std::uint32_t> on_ring(RingVertices& ring, std::span<const Vec3> points) {
    std::vector<std::uint32_t> vertices;
    vertices.reserve(points.size());
    for (const Vec3& point : points) {
      const auto [entry, is_new] = ring.try_emplace(point, std::uint32_t(mesh_.points.size()));
      if (is_new) {
        mesh_.points.push_back(point);
      }
      vertices.push_back(entry->second);
    }
    return vertices;
  }

  // The labels of a closed part tell its ends apart, if it has any.
  void append_closed(const ResolvedPart& part, const TriMesh& mesh, std::uint32_t label) {
    append_triangles(mesh, appended(mesh.points), label);
    if (mesh.labels.empty()) {
      return;
    }
    const std::array<std::uint32_t, 3> labels{label, new_label(part.end_names[0]),
                                              new_label(part.end_names[1])};
    std::transform(mesh.labels.begin(), mesh.labels.end(),
                   mesh_.labels.end() - std::ptrdiff_t(mesh.labels.size()),
                   [&](std::uint32_t own) { return labels.at(own); });
  }

  void append_triangles(const TriMesh& part, const std::vector<std::uint32_t>& vertices,
                        std::uint32_t label) {
    for (const auto& [a, b, c] : part.triangles) {
      mesh_.triangles.push_back({vertices[a], vertices[b], vertices[c]});
      mesh_.labels.push_back(label);
    }
  }

  // Ends that are joined to a part outside the piece vanish in the union and need no name.
  void close(std::uint32_t index, End end, const Ring& at_ring, std::uint32_t part_label) {
    if (is_welded({index, end}) || buried_.contains({index, end})) {
      return;
    }
    const ResolvedPart& part = assembly_.parts[index];
    const auto label = part.joined.at(at(end)) ? part_label : new_label(part.end_names.at(at(end)));
    const std::vector<tessellation::SampledRing> rings =
        tessellation::nested_rings({at_ring, sampling_}, level_.within({index, end}, of_runs_));
    const auto append_flat = [&](const TriMesh& flat, const std::string& inside) {
      append_triangles(flat, on_ring(ring({index, end}), flat.points),
                       inside.empty() ? label : new_label(inside));
    };
    append_flat(end_cap_mesh(rings.back().ring, rings.back().sampling), rings.back().name);
    for (std::size_t i = rings.size(); --i > 0;) {
      TriMesh annulus;
      tessellation::append_annulus(annulus, rings[i], rings[i - 1]);
      append_flat(annulus, rings[i - 1].name);
    }
  }

  std::uint32_t new_label(const std::string& name) {
    mesh_.names.push_back(name);
    return std::uint32_t(mesh_.names.size() - 1);
  }

  const ResolvedAssembly& assembly_;
  const RingSampling& sampling_;
  const BuriedEnds& buried_;
  const LevelEnds& level_;
  std::span<const RingSampling> of_runs_;
  std::vector<bool> is_member_;
  std::map<std::pair<std::uint32_t, std::size_t>, RingVertices> rings_;
  TriMesh mesh_;
};

// A ring whose disc may lie level with another one.
const Ring* ring_of_disc(const ResolvedAssembly& assembly, const BuriedEnds& buried,
                         const EndIndex& end) {
  const ResolvedPart& part = assembly.parts[end.part];
  const Ring* ring = port_ring(part.shape, end.end);
  const bool is_flange = part.is_closed[0] && part.is_closed[1];
  return ring == nullptr || ring->ellipse || part.joined.at(at(end.end)) ||
                 (part.is_closed.at(at(end.end)) && !is_flange) || buried.contains(end)
             ? nullptr
             : ring;
}

}  // namespace

LevelEnds::LevelEnds(const ResolvedAssembly& assembly, std::vector<std::size_t> run_of) {
  const BuriedEnds buried(assembly);
  std::map<Vec3, std::vector<Member>, numbers::PointOrder> by_center;
  for (std::uint32_t i = 0; i < assembly.parts.size(); ++i) {
    const auto& is_closed = assembly.parts[i].is_closed;
    for (const End end : {End::start, End::end}) {
      if (const Ring* ring = ring_of_disc(assembly, buried, {i, end})) {
        by_center[ring->center].push_back({{i, end},
                                           *ring,
                                           run_of[i],
                                           is_closed[0] && is_closed[1],
                                           assembly.parts[i].end_names.at(at(end))});
      }
    }
  }
  for (auto& [center, all] : by_center) {
    const Vec3 normal = all.front().ring.normal;
    std::erase_if(all, [&](const Member& member) {
      return member.ring.normal != normal && member.ring.normal != -normal;
    });
    if (all.size() < 2) {
      continue;
    }
    std::ranges::stable_sort(all, {}, [](const Member& member) { return member.ring.radius; });
    for (const Member& member : all) {
      group_of_[{member.end.part, at(member.end.end)}] = groups_.size();
    }
    groups_.push_back(std::move(all));
  }
}

void LevelEnds::share(std::vector<RingSampling>& of_runs) const {
  Groups runs(of_runs.size());
  const auto first = [&](std::size_t run) { return runs.of(std::uint32_t(run)); };
  for (const std::vector<Member>& group : groups_) {
    for (std::size_t i = 1; i < group.size(); ++i) {
      const Member &one = group[i - 1], &other = group[i];
      if (one.is_flange && other.is_flange && one.ring.radius == other.ring.radius) {
        runs.unite(std::uint32_t(one.run), std::uint32_t(other.run));
      }
    }
  }
  for (std::size_t run = 0; run < of_runs.size(); ++run) {
    std::uint32_t& segments = of_runs[first(run)].segments;
    segments = std::max(segments, of_runs[run].segments);
  }
  for (std::size_t run = 0; run < of_runs.size(); ++run) {
    of_runs[run] = of_runs[first(run)];
  }
}

void LevelEnds::put_within(const EndIndex& end, tessellation::SampledRing ring) {
  put_within_.insert_or_assign({end.part, at(end.end)}, std::move(ring));
}

std::vector<tessellation::SampledRing> LevelEnds::within(
    const EndIndex& end, std::span<const RingSampling> of_runs) const {
  std::vector<tessellation::SampledRing> result;
  if (const auto own = put_within_.find({end.part, at(end.end)}); own != put_within_.end()) {
    result.push_back(own->second);
    return result;
  }
  const auto group = group_of_.find({end.part, at(end.end)});
  if (group == group_of_.end()) {
    return result;
  }
  const std::vector<Member>& all = groups_[group->second];
  const auto own = std::ranges::find(all, end, &Member::end);
  for (auto member = all.begin(); member->ring.radius < own->ring.radius; ++member) {
    if (result.empty() || member->ring.radius > result.back().ring.radius) {
      const bool is_same_side = member->ring.normal == own->ring.normal;
      result.push_back(
          {member->ring, of_runs[member->run], is_same_side ? member->name : std::string()});
    }
  }
  return result;
}

TriMesh welded(const ResolvedAssembly& assembly, std::span<const std::uint32_t> parts,
               const std::vector<TriMesh>& tubes, const RingSampling& sampling,
               const BuriedEnds& buried, const LevelEnds& level,
               std::span<const RingSampling> of_runs) {
  Welder welder(assembly, parts, sampling, buried, level, of_runs);
  for (const auto part : parts) {
    welder.append(part, tubes[part]);
  }
  return welder.take();
}

std::vector<TriMesh> connected_parts(const TriMesh& mesh) {
  const auto none = std::uint32_t(mesh.points.size());
  const std::vector<std::uint32_t> component =
      connected_components(mesh.triangles, mesh.points.size());
  std::vector<TriMesh> parts;
  std::vector<std::uint32_t> part_of(mesh.points.size(), none), index(mesh.points.size(), none);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::uint32_t& part = part_of[component[mesh.triangles[i][0]]];
    if (part == none) {
      part = std::uint32_t(parts.size());
      parts.push_back({{}, {}, {}, mesh.names});
    }
    TriMesh& here = parts[part];
    Triangle triangle = mesh.triangles[i];
    for (std::uint32_t& corner : triangle) {
      if (index[corner] == none) {
        index[corner] = std::uint32_t(here.points.size());
        here.points.push_back(mesh.points[corner]);
      }
      corner = index[corner];
    }
    here.triangles.push_back(triangle);
    here.labels.push_back(mesh.labels[i]);
  }
  return parts;
}

}  // namespace dupin::assembly
