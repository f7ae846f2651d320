#include "checking/inspection.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "boxes/bounds.h"
#include "checking/self_intersection.h"
#include "dupin/kernel/coordinates.h"
#include "exact/exact_numbers.h"
#include "mesh/coincident_points.h"
#include "mesh/edge_table.h"
#include "mesh/measure.h"
#include "mesh/shell_nesting.h"
#include "predicates/triangle_overlap.h"
#include "support/blocks.h"
#include "support/none.h"
#include "support/sequences.h"

namespace dupin::checking {
namespace {

constexpr std::size_t kDefectCount = static_cast<std::size_t>(Defect::isolated_point) + 1;

// Faces that have the same three corners.
std::vector<std::vector<std::uint32_t>> duplicate_groups(std::span<const Triangle> triangles,
                                                         const mesh::EdgeTable& edges) {
  std::vector<std::vector<std::uint32_t>> groups;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> apexes;  // with face
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const mesh::Edge edge = edges[i];
    apexes.clear();
    for (const std::uint32_t half_edge : edge.half_edges) {
      const std::uint32_t apex =
          triangles[half_edge / 3][mesh::next_half_edge(mesh::next_half_edge(half_edge)) % 3];
      if (apex > edge.high) {  // else the group turns up at another of its edges
        apexes.emplace_back(apex, half_edge / 3);
      }
    }
    std::sort(apexes.begin(), apexes.end());
    for (auto begin = apexes.begin(); begin != apexes.end();) {
      const auto end = std::find_if(begin, apexes.end(),
                                    [&](const auto& entry) { return entry.first != begin->first; });
      if (end - begin > 1) {
        auto& group = groups.emplace_back();
        std::for_each(begin, end, [&](const auto& entry) { group.push_back(entry.second); });
      }
      begin = end;
    }
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

class Inspector {
 public:
  Inspector(const TriMesh& mesh, const CheckOptions& options, double margin, TileShare share = {})
      : mesh_(mesh),
        options_(options),
        margin_(margin),
        share_(std::move(share)),
        points_(mesh.points),
        kept_(kDefectCount) {
    report().points = mesh.points.size();
    report().triangles = mesh.triangles.size();
    report().counts.assign(kDefectCount, 0);
  }

  Inspection run() {
    screen_points();
    screen_triangles();
    const mesh::EdgeTable edges(triangles_, points_.size());
    const auto fans = mesh::corner_fans(triangles_, edges);
    const mesh::Shells shells = mesh::shells(triangles_.size(), edges);
    check_edges(edges);
    check_vertices(fans);
    report_shells(shells, edges, fans);
    if (are_places_known_) {
      check_places(edges);
    }
    if (is_tile()) {
      keep_shells(shells);
    } else if (are_places_known_) {
      measure(shells);
    }
    append_findings(std::move(kept_), report());
    return std::move(inspection_);
  }

 private:
  Report& report() { return inspection_.report; }

  [[nodiscard]] bool is_tile() const { return !share_.counted.points.empty(); }

  // Of a position in triangles_.
  [[nodiscard]] bool counts_face(std::uint32_t face) const {
    return share_.counted.face(face_ids_[face]);
  }

  [[nodiscard]] bool found(Defect defect) { return report().count(defect) > 0; }

  // Faces are given as positions in triangles_.
  void add(Defect defect, std::vector<std::uint32_t> faces, std::vector<std::uint32_t> points,
           const Vec3& place) {
    for (std::uint32_t& face : faces) {
      face = face_ids_[face];
    }
    add_original(defect, std::move(faces), std::move(points), place);
  }

  void add_original(Defect defect, std::vector<std::uint32_t> faces,
                    std::vector<std::uint32_t> points, const Vec3& place) {
    const auto index = static_cast<std::size_t>(defect);
    ++report().counts[index];
    if (kept_[index].size() < options_.limit) {
      kept_[index].push_back({defect, std::move(faces), std::move(points), place});
    }
  }

  [[nodiscard]] Vec3 middle(std::uint32_t a, std::uint32_t b) const {
    return points_[a] / 2 + points_[b] / 2;
  }

  void screen_points() {
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (!points_[i].allFinite()) {
        add_original(Defect::non_finite_point, {}, {i}, points_[i]);
        are_places_known_ = false;
      } else if (!is_in_range(points_[i])) {
        add_original(Defect::point_out_of_range, {}, {i}, points_[i]);
        are_places_known_ = false;
      }
    }
  }

  // Keeps the faces that have three different corners, so that the rest can be looked at.
  void screen_triangles() {
    std::vector<bool> used(points_.size());
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      const Triangle& corners = mesh_.triangles[i];
      const auto bad = std::find_if(corners.begin(), corners.end(),
                                    [&](std::uint32_t c) { return c >= points_.size(); });
      if (bad != corners.end()) {
        add_original(Defect::bad_index, {i}, {*bad}, Vec3::Zero());
        continue;
      }
      for (const std::uint32_t corner : corners) {
        used[corner] = true;
      }
      if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
        if (share_.counted.face(i)) {
          add_original(Defect::degenerate_face, {i}, {corners.begin(), corners.end()},
                       points_[corners[0]]);
        }
        continue;
      }
      triangles_.push_back(corners);
      face_ids_.push_back(i);
    }
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      if (!used[i] && points_[i].allFinite()) {
        add_original(Defect::isolated_point, {}, {i}, points_[i]);
      }
    }
  }

  static std::optional<Defect> defect_of(const mesh::Edge& edge, const mesh::EdgeTable& edges) {
    const auto& along = edge.half_edges;
    if (along.size() == 1) {
      return Defect::boundary_edge;
    }
    if (along.size() > 2) {
      return Defect::non_manifold_edge;
    }
    return edges.origin(along[0]) == edges.origin(along[1])
               ? std::optional(Defect::inconsistent_orientation)
               : std::nullopt;
  }

  void check_edges(const mesh::EdgeTable& edges) {
    const auto faulty = support::indices_where(
        edges.size(), [&](std::uint32_t i) { return defect_of(edges[i], edges).has_value(); });
    mark_rim(edges, faulty);
    for (const std::uint32_t i : faulty) {
      const mesh::Edge edge = edges[i];
      if (!share_.counted.point(edge.low)) {
        continue;
      }
      std::vector<std::uint32_t> faces;
      for (const std::uint32_t half_edge : edge.half_edges) {
        faces.push_back(half_edge / 3);
      }
      std::sort(faces.begin(), faces.end());
      add(*defect_of(edge, edges), std::move(faces), {edge.low, edge.high},
          middle(edge.low, edge.high));
    }
  }

  // Of the ends of edges that are run through more often one way than the other, and of a tile the
  // points that others count.
  void mark_rim(const mesh::EdgeTable& edges, std::span<const std::uint32_t> faulty) {
    if (faulty.empty() && share_.counted.points.empty()) {
      return;
    }
    rim_.resize(points_.size());
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      rim_[i] = share_.counted.point(i) ? 0 : 1;
    }
    for (const std::uint32_t i : faulty) {
      const mesh::Edge edge = edges[i];
      const auto ascending = std::ranges::count_if(
          edge.half_edges, [&](std::uint32_t h) { return edges.origin(h) == edge.low; });
      if (2 * static_cast<std::size_t>(ascending) != edge.half_edges.size()) {
        rim_[edge.low] = rim_[edge.high] = 1;
      }
    }
  }

  void check_vertices(std::span<const std::uint32_t> fans) {
    std::vector<std::uint32_t> fan_count(points_.size());
    std::uint32_t used = 0;
    for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
      if (!share_.counted.point(point_of(corner))) {
        continue;
      }
      std::uint32_t& count = fan_count[point_of(corner)];
      used += count == 0 ? 1 : 0;
      count += fans[corner] == corner ? 1 : 0;
    }
    report().euler_number = used;
    if (std::none_of(fan_count.begin(), fan_count.end(), [](auto n) { return n > 1; })) {
      return;
    }
    std::vector<std::vector<std::uint32_t>> faces(points_.size());
    for (std::uint32_t corner = 0; corner < fans.size(); ++corner) {
      if (fan_count[point_of(corner)] > 1) {
        faces[point_of(corner)].push_back(corner / 3);
      }
    }
    for (std::uint32_t point = 0; point < points_.size(); ++point) {
      if (fan_count[point] > 1) {
        add(Defect::non_manifold_vertex, std::move(faces[point]), {point}, points_[point]);
      }
    }
  }

  [[nodiscard]] std::uint32_t point_of(std::uint32_t corner) const {
    return triangles_[corner / 3][corner % 3];
  }

  void report_shells(const mesh::Shells& shells, const mesh::EdgeTable& edges,
                     std::span<const std::uint32_t> fans) {
    mesh::Counted counted{share_.counted.points, {}};
    std::vector<std::uint8_t> faces_counted;
    if (!share_.counted.faces.empty()) {
      faces_counted =
          support::selected(share_.counted.faces, std::span<const std::uint32_t>(face_ids_));
      counted.faces = faces_counted;
    }
    const auto numbers = mesh::euler_numbers(shells, edges, fans, counted);
    for (std::size_t i = 0; i < shells.count; ++i) {
      const auto faces = shells.faces_of(i);
      const auto own = std::ranges::count_if(faces, [&](auto f) { return counted.face(f); });
      report().shells.push_back(
          {face_ids_[faces[0]], static_cast<std::size_t>(own), 0, 0, numbers[i]});
      report().genus += (2 - numbers[i]) / 2;
      report().euler_number += own;
    }
    report().components = shells.count;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      report().euler_number -= counted.point(edges[i].low) ? 1 : 0;
    }
  }

  void keep_shells(const mesh::Shells& shells) {
    inspection_.shell_of_face.assign(mesh_.triangles.size(), support::kNone);
    for (std::size_t i = 0; i < face_ids_.size(); ++i) {
      inspection_.shell_of_face[face_ids_[i]] = shells.of_face[i];
    }
  }

  // What depends on coordinates.
  void check_places(const mesh::EdgeTable& edges) {
    const auto representatives = mesh::coincident_representatives(points_);
    std::vector<Triangle> merged = triangles_;
    for (Triangle& corners : merged) {
      for (std::uint32_t& corner : corners) {
        corner = representatives[corner];
      }
    }
    const auto copies = check_degenerate_and_duplicate(merged, edges);
    if (options_.self_intersections && (copies.empty() || is_tile())) {
      check_self_intersections(representatives, merged);
    } else if (options_.self_intersections) {
      check_intersections_of_copies(representatives, copies);
    }
    if (!is_tile() && report().closed() && !found(Defect::degenerate_face) &&
        !found(Defect::duplicate_face)) {
      check_contacts(representatives);
    }
  }

  // Returns the groups of faces with the same corners.
  std::vector<std::vector<std::uint32_t>> check_degenerate_and_duplicate(
      const std::vector<Triangle>& merged, const mesh::EdgeTable& edges) {
    const auto flat = support::indices_where(merged.size(), [&](std::uint32_t i) {
      const auto& [p, q, r] = merged[i];
      return predicates::collinear(points_[p], points_[q], points_[r]);
    });
    for (const std::uint32_t i : flat) {
      if (counts_face(i)) {
        add(Defect::degenerate_face, {i}, {triangles_[i].begin(), triangles_[i].end()},
            points_[merged[i][0]]);
      }
    }
    if (flat.empty() && merged == triangles_) {
      auto groups = duplicate_groups(triangles_, edges);
      add_duplicates(groups);
      return groups;
    }
    std::vector<Triangle> proper;
    std::vector<std::uint32_t> positions;
    for (std::uint32_t i = 0; i < merged.size(); ++i) {
      if (!std::binary_search(flat.begin(), flat.end(), i)) {
        proper.push_back(merged[i]);
        positions.push_back(i);
      }
    }
    auto groups = duplicate_groups(proper, mesh::EdgeTable(proper, points_.size()));
    for (auto& group : groups) {
      for (std::uint32_t& face : group) {
        face = positions[face];
      }
    }
    add_duplicates(groups);
    return groups;
  }

  void add_duplicates(const std::vector<std::vector<std::uint32_t>>& groups) {
    for (const auto& group : groups) {
      const Triangle& corners = triangles_[group[0]];
      if (share_.counted.point(std::ranges::min(corners))) {
        add(Defect::duplicate_face, group, {corners.begin(), corners.end()}, points_[corners[0]]);
      }
    }
  }

  void check_self_intersections(std::span<const std::uint32_t> representatives,
                                std::span<const Triangle> merged) {
    // Contacts are looked at later, duplicates have been.
    const auto is_wanted = [&](const FacePair& pair) {
      return !std::ranges::is_permutation(merged[pair.first], merged[pair.second]) &&
             (!share_.counts_pair ||
              share_.counts_pair(face_ids_[pair.first], face_ids_[pair.second]));
    };
    auto found = find_self_intersections(points_, triangles_,
                                         {.limit = options_.limit,
                                          .representatives = representatives,
                                          .contacts = false,
                                          .closed = true,
                                          .rim = rim_,
                                          .margin = margin_,
                                          .wanted = is_wanted});
    inspection_.stable = std::move(found.stable);
    for (const FacePair& pair : found.pairs) {
      add(Defect::self_intersection, {pair.first, pair.second}, {},
          place_between(pair.first, pair.second));
    }
    report().counts[static_cast<std::size_t>(Defect::self_intersection)] =
        found.crossings + found.overlaps;
  }

  // The same where faces have copies: one of each is looked at, and stands for all.
  void check_intersections_of_copies(std::span<const std::uint32_t> representatives,
                                     const std::vector<std::vector<std::uint32_t>>& copies) {
    std::vector<std::uint32_t> group_of(triangles_.size(), support::kNone), firsts;
    for (std::uint32_t i = 0; i < copies.size(); ++i) {
      std::ranges::for_each(copies[i], [&](std::uint32_t face) { group_of[face] = i; });
    }
    for (std::uint32_t face = 0; face < triangles_.size(); ++face) {
      if (group_of[face] == support::kNone || copies[group_of[face]].front() == face) {
        firsts.push_back(face);
      }
    }
    const auto alike = [&](const std::uint32_t& first) {  // of those that are looked at
      const std::uint32_t group = group_of[first];
      return group == support::kNone ? std::span(&first, 1) : std::span(copies[group]);
    };
    std::atomic<std::size_t> count = 0;
    const auto is_wanted = [&](const FacePair& pair) {
      count += alike(firsts[pair.first]).size() * alike(firsts[pair.second]).size();
      return true;
    };
    const auto triangles = support::selected(std::span<const Triangle>(triangles_), firsts);
    const auto found = find_self_intersections(points_, triangles,
                                               {.limit = options_.limit,
                                                .representatives = representatives,
                                                .contacts = false,
                                                .wanted = is_wanted});
    std::set<std::array<std::uint32_t, 2>> pairs;  // the lowest ones
    const auto lowest_alike = [&](std::uint32_t position) {
      const auto faces = alike(firsts[position]);
      return faces.first(std::min(faces.size(), options_.limit));
    };
    for (const FacePair& pair : found.pairs) {
      for (const std::uint32_t a : lowest_alike(pair.first)) {
        for (const std::uint32_t b : lowest_alike(pair.second)) {
          pairs.insert({std::min(a, b), std::max(a, b)});
          if (pairs.size() > options_.limit) {
            pairs.erase(std::prev(pairs.end()));
          }
        }
      }
    }
    for (const auto& [a, b] : pairs) {
      add(Defect::self_intersection, {a, b}, {}, place_between(a, b));
    }
    report().counts[static_cast<std::size_t>(Defect::self_intersection)] = count;
  }

  // The middle of what the boxes of two faces have in common.
  [[nodiscard]] Vec3 place_between(std::uint32_t a, std::uint32_t b) const {
    const auto box = [&](std::uint32_t face) {
      return boxes::bounds_of(support::selected(points_, triangles_[face]));
    };
    const Eigen::AlignedBox3d common = box(a).intersection(box(b));
    return common.min() / 2 + common.max() / 2;
  }

  void check_contacts(std::span<const std::uint32_t> representatives) {
    inspection_.contacts = mesh::find_contacts({points_, triangles_}, representatives);
    for (const mesh::ContactPlace& contact : inspection_.contacts) {
      const bool edge = contact.kind == Contact::Kind::edge;
      add(contact.alternating ? Defect::contact : Defect::self_intersection, contact.faces,
          edge ? std::vector{contact.from, contact.to} : std::vector{contact.from},
          middle(contact.from, contact.to));
    }
  }

  void measure(const mesh::Shells& shells) {
    const mesh::MeshView view(points_, triangles_);
    report().area = mesh::area(view);
    std::vector<int> signs;
    mpq_class sum;
    for (std::size_t i = 0; i < shells.count; ++i) {
      const auto faces =
          support::selected(std::span<const Triangle>(triangles_), shells.faces_of(i));
      const mpq_class volume = mesh::exact_volume({points_, faces});
      report().shells[i].volume = exact::nearest_double(volume);
      signs.push_back(sgn(volume));
      sum += volume;
    }
    report().volume = exact::nearest_double(sum);
    if (report().is_solid()) {
      check_nesting(shells, mesh::nesting_depths(view, shells), signs);
    }
  }

  // `signs` are those of the shells' volumes.
  void check_nesting(const mesh::Shells& shells, std::span<const int> depths,
                     std::span<const int> signs) {
    report().components = 0;
    for (std::size_t i = 0; i < shells.count; ++i) {
      report().shells[i].depth = depths[i];
      const bool outer = depths[i] % 2 == 0;
      report().components += outer ? 1 : 0;
      if (signs[i] != (outer ? 1 : -1)) {
        const auto faces = shells.faces_of(i);
        add(Defect::inside_out_component, {faces.begin(), faces.end()}, {},
            points_[triangles_[faces[0]][0]]);
      }
    }
  }

  const TriMesh& mesh_;
  const CheckOptions options_;
  double margin_;
  const TileShare share_;
  std::span<const Vec3> points_;
  std::vector<Triangle> triangles_;         // those with three different corners
  std::vector<std::uint32_t> face_ids_;     // of triangles_ in the mesh
  std::vector<std::vector<Finding>> kept_;  // by defect
  std::vector<std::uint8_t> rim_;           // see SelfIntersectionOptions
  bool are_places_known_ = true;
  Inspection inspection_;
};

}  // namespace

Inspection inspect(const TriMesh& mesh, const CheckOptions& options, double margin) {
  return Inspector(mesh, options, margin).run();
}

Inspection inspect_tile(const TriMesh& mesh, const CheckOptions& options, const TileShare& share) {
  return Inspector(mesh, options, 0, share).run();
}

void append_findings(std::vector<std::vector<Finding>> kept, Report& report) {
  for (auto& findings : kept) {
    std::sort(findings.begin(), findings.end(),
              [](const Finding& a, const Finding& b) { return a.faces < b.faces; });
    std::move(findings.begin(), findings.end(), std::back_inserter(report.findings));
  }
}

}  // namespace dupin::checking
