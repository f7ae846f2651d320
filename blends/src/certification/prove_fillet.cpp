#include "certification/prove_fillet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"
#include "verification/claims/fillet_claims.h"
#include "verification/motions/contact_arcs.h"
#include "verification/work.h"

namespace dupin::certification {
namespace {

constexpr std::uint64_t kWork = CertificateLimits::kWork;

// Whether the search comes to its end within so much work; the checks of the caller's certificate
// are not charged.
template <class Search>
bool ends_within(std::uint64_t work, const Search& search) {
  const verification::WorkLimit limit(work);
  try {
    search();
    return true;
  } catch (const Error& error) {
    if (error.code() != Errc::limit_exceeded) {
      throw;
    }
    return false;
  }
}

double parameter_at(double angle) {
  constexpr double kFine = 0x1p50;
  double psi = std::remainder(angle / 2 + std::numbers::pi / 4, std::numbers::pi);
  psi = psi < 0 ? psi + std::numbers::pi : psi;
  const double half = psi < std::numbers::pi / 2 ? 0 : 1;
  const double phi = psi - half * std::numbers::pi / 2;
  const double share = std::sin(phi) / (std::sin(phi) + std::cos(phi));
  const double t = half + std::round(share * kFine) / kFine;
  return t < 2 ? std::max(t, 0.0) : 0;
}

using verification::ArcCell;

// Stretches that are regular, and others. Searches for shorter and shorter leaves ask for many of
// them again.
class Cells {
 public:
  Cells(const CanalFillet& loop, double margin) : loop_(loop), margin_(margin) {}

  // Leaves no longer than `longest`, halved until each is regular, and not so long that its own
  // arcs are not told apart, as near a sharp turn.
  bool append(double longest, const ParameterInterval& t, std::vector<ArcCell>& cells) {
    constexpr double kShortest = 0x1p-40, kShort = 0x1p-20;
    const double length = t.to - t.from;
    if (length <= longest) {
      if (const auto& cell = at(t); cell && (length < kShort || is_apart(*cell))) {
        cells.push_back(*cell);
        return true;
      }
    }
    const double middle = std::midpoint(t.from, t.to);
    return length > kShortest && append(longest, {t.from, middle}, cells) &&
           append(longest, {middle, t.to}, cells);
  }

  [[nodiscard]] double margin() const { return margin_; }

 private:
  // Nor would those be of a few such leaves, one after the other.
  [[nodiscard]] bool is_apart(ArcCell cell) const {
    constexpr double kLeaves = 4;
    cell.arcs.length *= kLeaves;
    return verification::holds(loop_, {cell}, {cell.t, cell.t, {}});
  }

  const std::optional<ArcCell>& at(const ParameterInterval& t) {
    const std::pair key(t.from, t.to);
    auto known = known_.find(key);
    if (known == known_.end()) {
      known = known_.emplace(key, verification::regular_cell(loop_, t, margin_)).first;
    }
    return known->second;
  }

  const CanalFillet& loop_;
  double margin_;
  std::map<std::pair<double, double>, std::optional<ArcCell>> known_;
};

const Vec3& furthest(const std::vector<Vec3>& points, const Vec3& d) {
  return *std::ranges::max_element(points, {}, [&](const Vec3& p) { return p.dot(d); });
}

// A plane between two sets of points, if there is one: a perceptron.
Vec3 direction_between(const std::vector<Vec3>& first, const std::vector<Vec3>& second) {
  constexpr int kSteps = 24;
  Vec3 d = Vec3::Zero();
  for (const Vec3& p : second) {
    d += p / double(second.size());
  }
  for (const Vec3& p : first) {
    d -= p / double(first.size());
  }
  for (int i = 0; i < kSteps; ++i) {
    const Vec3 gap = furthest(second, -d) - furthest(first, d);
    if (gap.dot(d) > 0) {
      break;
    }
    d = d.normalized() + gap.normalized();
  }
  return d.normalized();
}

// How the first foot moves.
Vec3 motion(const verification::ContactArcs& arcs) {
  const Vec3 tangent = middle(arcs.tangent), toward = middle(arcs.toward[0]);
  return (middle(arcs.passing) * tangent +
          middle(arcs.radius) * middle(arcs.spin[0]) * tangent.cross(toward))
      .normalized();
}

class PairSearch {
 public:
  PairSearch(const CanalFillet& loop, const std::vector<ArcCell>& cells, std::size_t pairs)
      : loop_(loop), cells_(cells), pairs_(pairs) {}

  EmbeddedClaim run() {
    const ParameterInterval first{0, 1}, second{1, 2};
    EmbeddedClaim claim{Verdict::proved, {}, {}};
    if (!settle({first, first, {}}, kDepth) || !settle({first, second, {}}, kDepth) ||
        !settle({second, second, {}}, kDepth)) {
      return {};
    }
    claim.leaves = std::move(leaves_);
    return claim;
  }

 private:
  static constexpr int kDepth = 40;
  static constexpr double kShortWay = 0.25;

  bool settle(const DiscPairs& pair, int depth) {
    if (auto leaf = settled(pair)) {
      leaves_.push_back(*leaf);
      return true;
    }
    if (depth == 0 || ++divided_ > pairs_) {
      return false;
    }
    const auto halves = [](const ParameterInterval& t) {
      const double middle = std::midpoint(t.from, t.to);
      return std::array<ParameterInterval, 2>{{{t.from, middle}, {middle, t.to}}};
    };
    if (pair.first == pair.second) {
      const auto [a, b] = halves(pair.first);
      return settle({a, a, {}}, depth - 1) && settle({a, b, {}}, depth - 1) &&
             settle({b, b, {}}, depth - 1);
    }
    const bool longer = pair.first.to - pair.first.from > pair.second.to - pair.second.from;
    const auto parts = halves(longer ? pair.first : pair.second);
    return std::ranges::all_of(parts, [&](const ParameterInterval& t) {
      return settle(longer ? DiscPairs{t, pair.second, {}} : DiscPairs{pair.first, t, {}},
                    depth - 1);
    });
  }

  [[nodiscard]] std::optional<DiscPairs> settled(DiscPairs pair) const {
    const bool neighbours =
        pair.second.from <= pair.first.to || (pair.first.from == 0 && pair.second.to == 2);
    if (neighbours) {
      if (verification::holds(loop_, cells_, pair)) {
        return pair;
      }
      if (pair.first == pair.second) {
        return std::nullopt;
      }
      pair.direction = direction_at_corner(pair);
      return pair.direction && verification::holds(loop_, cells_, pair) ? std::optional(pair)
                                                                        : std::nullopt;
    }
    DiscPairs apart = pair;
    apart.direction = direction_between(corners(pair.first), corners(pair.second));
    if (verification::holds(loop_, cells_, apart)) {
      return apart;
    }
    const double way =
        std::min(pair.second.to - pair.first.from, 2 - pair.second.from + pair.first.to);
    return way < kShortWay && verification::holds(loop_, cells_, pair) ? std::optional(pair)
                                                                       : std::nullopt;
  }

  // Between the ways of a foot before and after.
  [[nodiscard]] std::optional<Vec3> direction_at_corner(const DiscPairs& pair) const {
    const bool at_one = pair.first.to == 1 && pair.second.from == 1;
    if (!verification::has_corner(loop_, at_one ? 1 : 0)) {
      return std::nullopt;
    }
    const auto after = at_one ? std::ranges::lower_bound(cells_, 1.0, {},
                                                         [](const ArcCell& c) { return c.t.from; })
                              : cells_.begin();
    const auto before = std::prev(at_one ? after : cells_.end());
    return (motion(before->arcs) + motion(after->arcs)).normalized();
  }

  // Of what holds the arcs.
  [[nodiscard]] std::vector<Vec3> corners(const ParameterInterval& t) const {
    std::vector<Vec3> points;
    for (const ArcCell& cell : cells_) {
      if (cell.t.to > t.from && cell.t.from < t.to) {
        for (const auto& corner : cell.arcs.corners) {
          points.push_back(middle(corner));
        }
      }
    }
    return points;
  }

  const CanalFillet& loop_;
  const std::vector<ArcCell>& cells_;
  std::size_t pairs_, divided_ = 0;
  std::vector<DiscPairs> leaves_;
};

double size_of(const CanalFillet& loop) {
  const MovingBall at = ball(loop, 0);
  return at.center.norm() + at.radius + loop.quadrics[0].center.norm() + loop.quadrics[0].radius +
         loop.quadrics[1].center.norm() + loop.quadrics[1].radius;
}

// Where stretches have no length, enclosures are nearly as narrow as rounding lets them be. Corners
// are left out.
void refuse_far_balls(const CanalFillet& loop, const ContactClaim& coarsest) {
  constexpr int kPlaces = 16;
  for (int i = 0; i < kPlaces; ++i) {
    const double t = (2 * i + 1.0) / kPlaces;
    if (!verification::touches_on(loop, coarsest, {t, t})) {
      throw Error(Errc::invalid_argument,
                  "the ball that rolls along it is further from the pipes than the tolerance");
    }
  }
}

// A claim that holds on all of a loop, made wider where it does not hold at a place with room, in
// one walk: what held before holds then, too. The angle is made wider first, which far from the
// origin rounding hides sooner than the distance.
class ContactSearch {
 public:
  ContactSearch(const CanalFillet& loop, const ContactClaim& finest, const ContactClaim& coarsest)
      : loop_(loop), claim_(finest), coarsest_(coarsest) {}

  std::optional<ContactClaim> run() {
    constexpr int kStretches = 16, kHalvings = 32;
    for (int i = 0; i < kStretches; ++i) {
      if (!settle({2.0 * i / kStretches, 2.0 * (i + 1) / kStretches}, kHalvings)) {
        return std::nullopt;
      }
    }
    return claim_;
  }

 private:
  bool settle(const ParameterInterval& t, int halvings) {
    if (verification::touches_on(loop_, claim_, t)) {
      return true;
    }
    const double middle = std::midpoint(t.from, t.to);
    return halvings > 0 && widen_at(middle) && settle({t.from, middle}, halvings - 1) &&
           settle({middle, t.to}, halvings - 1);
  }

  bool widen_at(double t) {
    const auto holds = [&](double offset) {
      return verification::touches_on(loop_, {offset / 2, claim_.deviation / 2}, {t, t});
    };
    while (!holds(claim_.offset)) {
      double& bound = holds(coarsest_.offset) ? claim_.offset : claim_.deviation;
      bound *= 4;
      if (claim_.offset > coarsest_.offset || claim_.deviation > coarsest_.deviation) {
        return false;
      }
    }
    return true;
  }

  const CanalFillet& loop_;
  ContactClaim claim_, coarsest_;
};

std::optional<ContactClaim> prove_contact(const CanalFillet& loop, double tolerance) {
  constexpr double kFinest = 0x1p-48, kCoarsestAngle = 0x1p-12;
  constexpr std::uint64_t kWorkOfFinest = kWork / 6, kWorkOfCoarsest = kWork / 3;
  const ContactClaim finest{kFinest * size_of(loop), kFinest}, coarsest{tolerance, kCoarsestAngle};
  std::optional<ContactClaim> claim;
  if (!ends_within(kWorkOfFinest, [&] { claim = ContactSearch(loop, finest, coarsest).run(); })) {
    (void)ends_within(kWorkOfCoarsest,
                      [&] { claim = ContactSearch(loop, coarsest, coarsest).run(); });
  }
  if (!claim) {
    (void)ends_within(kWork, [&] { refuse_far_balls(loop, coarsest); });
  }
  return claim;
}

MeshClaim mesh_claim(const LoopMesh& mesh) {
  MeshClaim claim{mesh.segments, mesh.grid, {}, 0};
  std::ranges::transform(mesh.rows, std::back_inserter(claim.knots), parameter_at);
  std::ranges::sort(claim.knots);
  claim.knots.push_back(2);
  return claim;
}

// Claims with leaves that are no longer than this, if they hold.
bool claim_with(const CanalFillet& loop, const LoopMesh& mesh, Cells& known, double longest,
                std::size_t pairs, LoopClaims& result) {
  std::vector<ArcCell> cells;
  if (!known.append(longest, {0, 1}, cells) || !known.append(longest, {1, 2}, cells)) {
    return false;
  }
  LoopClaims claims;
  claims.regular = {Verdict::proved, known.margin(), {}, {}};
  for (const ArcCell& cell : cells) {
    claims.regular.leaves.push_back(cell.t);
  }
  claims.mesh = mesh_claim(mesh);
  claims.mesh->error_bound = verification::mesh_error(cells, *claims.mesh);
  if (!std::isfinite(claims.mesh->error_bound)) {
    claims.mesh.reset();
  }
  claims.embedded = PairSearch(loop, cells, pairs).run();
  result = std::move(claims);
  return true;
}

}  // namespace

LoopClaims prove_loop(const CanalFillet& loop, const LoopMesh& mesh, const LoopGoals& goals) {
  constexpr double kFine = 0x1p-9;  // for the mesh's sake alone
  constexpr double kShare = 0.97;   // of the margin that is known, as another way has proved it
  const CanalRegularity known = prove_regular(loop);
  LoopClaims claims;
  claims.regular.margin = goals.margin.value_or(0);
  if (known.verdict == Verdict::proved) {
    Cells cells(loop, goals.margin.value_or(kShare * known.regularity));
    for (double longest = 0x1p-6; longest >= 0x1p-10; longest /= 2) {
      bool holds = false;
      if (!ends_within(
              kWork,
              [&] { holds = claim_with(loop, mesh, cells, longest, goals.pairs, claims); }) ||
          !holds) {
        break;  // shorter leaves are more work still
      }
      const bool close = claims.mesh && claims.mesh->error_bound <= goals.tolerance;
      if (claims.embedded.verdict == Verdict::proved && (close || longest <= kFine)) {
        break;
      }
    }
  }
  claims.contact = prove_contact(loop, goals.tolerance);
  return claims;
}

}  // namespace dupin::certification
