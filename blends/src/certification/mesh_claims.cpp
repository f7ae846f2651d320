#include "certification/mesh_claims.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "dupin/blends/cyclide_tube.h"
#include "surfaces/kneecap_chain_mesh.h"

namespace dupin::certification {
namespace {

constexpr double kAbove = 1 + 0x1p-40;  // what was rounded may be

// Of so many pieces whose bands are marched in intervals, a few milliseconds each: the checker's
// work does not last for more.
constexpr std::ptrdiff_t kMostMarched = 2048;

bool is_marched(const Piece& piece) {
  const auto* ringed = std::get_if<RingedSurface>(&piece);
  return ringed == nullptr || std::holds_alternative<HermiteSpine>(ringed->spine) ||
         std::holds_alternative<BezierSpine>(ringed->spine);
}

// The most segments that triangles so deep in a ball allow.
std::uint32_t segments_of(double depth, double radius) {
  const double half = std::acos(std::max(1 - depth / radius * kAbove, -1.0));
  const double most = std::numbers::pi / half / kAbove;
  return most < CertificateLimits::kSegments ? std::uint32_t(most) : CertificateLimits::kSegments;
}

// Appends to a claim about the skins outside of this one.
void append_skin(const Chain& skin, const RingSampling& sampling, double tolerance,
                 std::vector<double>& knots, MeshClaim& claim) {
  if (skin.joints == Joints::smooth) {
    Tessellation mesh = tessellate(skin, sampling, {tolerance});
    knots = std::move(mesh.knots);
    claim.error_bound = std::max(claim.error_bound, mesh.error_bound);
    claim.axes = std::max(claim.axes, mesh.axes);
    return;
  }
  const std::vector<PeArc> arcs = cyclide_pieces(skin);
  surfaces::KneecapChainMesh mesh = surfaces::kneecap_chain_mesh(
      end_ring(skin, End::start), end_ring(skin, End::end), arcs, sampling, {tolerance});
  knots = std::move(mesh.knots);
  claim.error_bound = std::max(claim.error_bound, mesh.tessellation.error_bound);
  KneecapMesh& knees = claim.kneecaps ? *claim.kneecaps : claim.kneecaps.emplace();
  knees.turn = std::max(knees.turn, kAbove * mesh.turn);
  knees.apart = std::max(knees.apart, kAbove * mesh.apart);
  for (std::size_t i = 0; i < mesh.depths.size(); ++i) {
    knees.segments.push_back(segments_of(mesh.depths[i], arcs[i].end().r));
  }
}

}  // namespace

std::optional<MeshClaim> mesh_claim(const Sphere& sphere, const RingSampling& sampling, double) {
  return MeshClaim{sampling.segments, sampling.grid, {}, tessellate(sphere, sampling).error_bound};
}

// Polygons of joints with kneecaps have no longer steps than regular ones of a segment less.
std::optional<MeshClaim> mesh_claim(const Chain& chain, const RingSampling& sampling,
                                    double tolerance) {
  if (std::ranges::count_if(chain.pieces, is_marched) > kMostMarched) {
    return std::nullopt;
  }
  const bool has_kneecaps = chain.joints == Joints::spherical;
  MeshClaim claim{has_kneecaps ? sampling.segments - 1 : sampling.segments, sampling.grid, {}, 0};
  Chain outside = chain;
  outside.wall = 0;
  append_skin(outside, sampling, tolerance, claim.knots, claim);
  if (chain.wall > 0) {
    append_skin(inner_skin(chain), sampling, tolerance, claim.inner_knots, claim);
  }
  return claim.knots.empty() ? std::nullopt : std::optional(std::move(claim));
}

double widest_turn(const TriMesh& mesh, const Ring& ring, double grid) {
  const double moved = std::numbers::sqrt3 / 2 * grid;
  const auto arm = [&](std::uint32_t vertex) -> Vec3 {
    const Vec3 from = mesh.points[vertex] - ring.center;
    return from - from.dot(ring.normal) * ring.normal;
  };
  double widest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 a = arm(t.at(i)), b = arm(t.at((i + 1) % 3));
      widest = std::max(
          widest, std::atan2(a.cross(b).norm(), a.dot(b)) - moved / a.norm() - moved / b.norm());
    }
  }
  return widest;
}

}  // namespace dupin::certification
