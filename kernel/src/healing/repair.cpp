#include "dupin/kernel/repair.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "healing/degenerate_faces.h"
#include "healing/face_copies.h"
#include "healing/kept_surface.h"
#include "healing/lost_faces.h"
#include "healing/open_edges.h"
#include "healing/polygon_soup.h"
#include "mesh/edge_table.h"
#include "mesh/exact_mesh.h"

namespace dupin {
namespace {

// Refuses what is no mesh; of others returns what is wrong but for self-intersections, which may
// be very many.
Report inspected(const TriMesh& mesh) {
  Report report = check(mesh, {.limit = 1, .self_intersections = false});
  const bool is_mesh = report.count(Defect::non_finite_point) +
                           report.count(Defect::point_out_of_range) +
                           report.count(Defect::bad_index) ==
                       0;
  const auto is_name = [&](std::uint32_t label) { return label < mesh.names.size(); };
  const bool is_labelled =
      mesh.labels.empty() || (mesh.labels.size() == mesh.triangles.size() &&
                              std::all_of(mesh.labels.begin(), mesh.labels.end(), is_name));
  if (!is_mesh || !is_labelled) {
    (void)Solid::from(mesh);  // says what is wrong
  }
  return report;
}

// None if it is no solid as it is, whatever it lacks.
std::optional<Solid> proved(const TriMesh& mesh, const Report& report) {
  if (!report.is_solid()) {
    return std::nullopt;
  }
  try {
    return Solid::from(mesh);
  } catch (const Error& error) {
    if (error.code() == Errc::cancelled || error.code() == Errc::limit_exceeded ||
        error.code() == Errc::internal) {
      throw;
    }
    return std::nullopt;
  }
}

// The mended soup as a solid, if it neither crosses nor touches itself: then no arrangement is
// needed, which compares all triangles about a point. Sources name faces of the mesh.
std::optional<mesh::ExactMesh> proved(const healing::PolygonSoup& soup, const TriMesh& mesh) {
  TriMesh surface{soup.points, soup.triangles, {}, mesh.names};
  for (std::size_t i = 0; !mesh.labels.empty() && i < soup.sources.size(); ++i) {
    surface.labels.push_back(mesh.labels[soup.sources[i]]);
  }
  const auto solid = proved(surface, inspected(surface));
  if (!solid || !solid->exact().contacts.empty()) {
    return std::nullopt;
  }
  mesh::ExactMesh exact = solid->exact();
  for (Source& source : exact.sources) {
    source.triangle = soup.sources[source.triangle];
  }
  return exact;
}

// One shell of a soup, and nothing else.
TriMesh shell_of(const healing::PolygonSoup& soup, std::span<const std::uint32_t> faces,
                 const TriMesh& mesh) {
  TriMesh shell{{}, {}, {}, mesh.names};
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  for (const std::uint32_t face : faces) {
    Triangle corners = soup.triangles[face];
    for (std::uint32_t& corner : corners) {
      const auto [at, is_new] =
          number.emplace(corner, static_cast<std::uint32_t>(shell.points.size()));
      if (is_new) {
        shell.points.push_back(soup.points[corner]);
      }
      corner = at->second;
    }
    shell.triangles.push_back(corners);
    if (!mesh.labels.empty()) {
      shell.labels.push_back(mesh.labels[soup.sources[face]]);
    }
  }
  return shell;
}

// The union of the shells of the mended soup, if there are many and each is a solid by itself: what
// all wind around is the same, and where many are in one place it is found in steps (unite()).
// Sources name faces of the mesh.
std::optional<mesh::ExactMesh> united_shells(const healing::PolygonSoup& soup, const TriMesh& mesh,
                                             const Progress& progress) {
  constexpr std::size_t kMany = 16;
  const mesh::Shells shells =
      mesh::shells(soup.triangles.size(), mesh::EdgeTable(soup.triangles, soup.points.size()));
  std::vector<Solid> solids;
  for (std::size_t i = 0; i < shells.count && shells.count > kMany; ++i) {
    const TriMesh shell = shell_of(soup, shells.faces_of(i), mesh);
    auto solid = proved(shell, inspected(shell));
    if (!solid) {
      return std::nullopt;
    }
    solids.push_back(*solid);
  }
  if (solids.empty()) {
    return std::nullopt;
  }
  mesh::ExactMesh all = unite(solids, {.progress = progress}).exact();
  for (Source& source : all.sources) {
    const std::uint32_t face = solids[source.operand].sources()[source.triangle].triangle;
    source = {0, soup.sources[shells.faces_of(source.operand)[face]]};
  }
  return all;
}

}  // namespace

Repaired repair(const TriMesh& mesh, const Progress& progress) {
  const UsualArithmetic usual;
  if (auto solid = proved(mesh, inspected(mesh))) {
    return {*solid, {}};
  }
  RepairReport report;
  healing::MergedPoints merged = healing::merge_duplicate_points(mesh);
  healing::PolygonSoup& soup = merged.soup;
  report.merged_points = merged.copies;
  report.degenerate_faces = healing::drop_degenerate_faces(soup);
  const healing::PolygonSoup given = soup;
  healing::SettledCopies settled = healing::close_surface(soup);
  report.duplicate_faces = settled.dropped;
  const bool was_closed = settled.dropped == 0 && std::ranges::count(settled.is_turned, 1) == 0;
  healing::refuse_open_edges(soup, mesh);
  const healing::Cavities cavities =
      healing::turn_shells_outward(soup, settled.is_paired, settled.is_turned);
  report.cavities = cavities.count;
  if (settled.has_copies) {
    settled = healing::settle_copies(soup, settled.is_turned);
    report.duplicate_faces += settled.dropped;
  }
  report.turned_faces =
      static_cast<std::size_t>(std::ranges::count(settled.is_turned, std::uint8_t{1}));

  auto plain = proved(soup, mesh);
  const bool is_plain = plain.has_value();
  if (!plain) {
    plain = united_shells(soup, mesh, progress);
  }
  mesh::ExactMesh solid = plain ? std::move(*plain) : healing::wound_around(soup, mesh, progress);
  if (!was_closed || cavities.count > 0 || cavities.touching) {
    healing::KnownFaces known{std::vector<std::uint8_t>(mesh.triangles.size(), 0), was_closed};
    for (const std::uint32_t face : cavities.faces) {
      known.is_of_cavity[face] = 1;
    }
    if (healing::add_or_refuse_lost(given, soup, solid, known, true)) {
      solid = healing::wound_around(soup, mesh, progress);
      (void)healing::add_or_refuse_lost(given, soup, solid, known, false);
    }
  }
  report.united_overlaps = !is_plain && !healing::keeps_surface(solid, soup);
  report.parted_contacts = !is_plain && !solid.contacts.empty();
  return {Solid(std::make_shared<const mesh::ExactMesh>(std::move(solid))), report};
}

}  // namespace dupin
