#include "remeshing/relaxation.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "remeshing/batch.h"

namespace dupin::remeshing {
namespace {

/// Moves may make angles smaller that are larger than 35 degrees.
constexpr double kGoodSine = 0.5736;
constexpr double kCurveShare = 0.8;
constexpr int kRounds = 8;  // points next to each other do not move in one round

Claim move_claim(const WorkingMesh& mesh, std::uint32_t v) {
  Claim claim{{}, {v}, mesh.neighbours(v)};
  claim.faces.assign(mesh.around(v).begin(), mesh.around(v).end());
  claim.marks.push_back(v);
  return claim;
}

/// Moves of one point.
class Mover {
 public:
  Mover(const Workshop& shop, std::uint32_t v)
      : shop_(shop), mesh_(shop.mesh), v_(v), before_(smallest_sine_around(shop.mesh, v)) {
    edit_.before.assign(mesh_.around(v).begin(), mesh_.around(v).end());
    for (const std::uint32_t f : edit_.before) {
      edit_.after.push_back(mesh_.face(f));
    }
    if (mesh_.point(v).freedom == Freedom::curve) {
      find_curve();
    } else {
      find_normal();
    }
  }

  [[nodiscard]] bool on_curve() const { return curve_.is_sharp(); }
  [[nodiscard]] const Vec3& normal() const { return normal_; }
  [[nodiscard]] double before() const { return before_; }
  /// The least and the greatest length along the curve, and that of the point.
  [[nodiscard]] double behind() const { return curve_.from; }
  [[nodiscard]] double ahead() const { return curve_.to; }
  [[nodiscard]] double here() const { return here_; }
  [[nodiscard]] std::uint32_t point_behind() const { return behind_; }
  [[nodiscard]] std::uint32_t point_ahead() const { return ahead_; }

  /// The move to the place nearest to one, if angles stay as they should: none below `least`.
  [[nodiscard]] std::optional<Edit> to(const Vec3& place, double least) const {
    const Vec3& old = mesh_.place(v_);
    const double reach = 4 * (place - old).norm() + shop_.limits.distance;
    const auto on = shop_.reference.nearest(place, edit_.after.front().region, normal_,
                                            shop_.limits.distance, reach);
    if (!on) {
      return std::nullopt;
    }
    Edit edit = edit_;
    edit.moved = {v_, on->point};
    return accepted(std::move(edit), least);
  }
  [[nodiscard]] std::optional<Edit> to(double length, double least) const {
    const Curve& curve = shop_.features.curves[curve_.curve];
    const Vec3 place = curve.at(length);
    const double most = kCurveShare * shop_.limits.distance;
    if (curve.deviation(curve_.from, length, mesh_.place(behind_), place) > most ||
        curve.deviation(length, curve_.to, place, mesh_.place(ahead_)) > most) {
      return std::nullopt;
    }
    Edit edit = edit_;
    edit.moved = {v_, place};
    for (Face& face : edit.after) {
      const int i = face.corner(v_);
      Span &leaves = face.spans[i], &enters = face.spans[(i + 2) % 3];
      leaves.from = leaves.is_sharp() ? length : 0;
      enters.to = enters.is_sharp() ? length : 0;
    }
    return accepted(std::move(edit), least);
  }

 private:
  void find_curve() {
    for (const std::uint32_t f : edit_.before) {
      const Face& face = mesh_.face(f);
      const int i = face.corner(v_);
      const Span& leaves = face.spans[i];
      if (!leaves.is_sharp()) {
        continue;
      }
      curve_.curve = leaves.curve;
      here_ = leaves.from;
      const std::uint32_t other = face.corners[(i + 1) % 3];
      if (leaves.to > leaves.from) {
        curve_.to = leaves.to;
        ahead_ = other;
      } else {
        curve_.from = leaves.to;
        behind_ = other;
      }
    }
  }
  void find_normal() {
    for (const std::uint32_t f : edit_.before) {
      const auto [a, b, c] = mesh_.places(mesh_.face(f).corners);
      normal_ += (b - a).cross(c - a);
    }
    normal_.normalize();
  }
  [[nodiscard]] std::optional<Edit> accepted(Edit edit, double least) const {
    const EditCheck check(shop_, edit);
    if (check.smallest_sine() < least || !check.keeps_sides() || !check.stays_near()) {
      return std::nullopt;
    }
    return edit;
  }

  const Workshop& shop_;
  const WorkingMesh& mesh_;
  std::uint32_t v_;
  double before_;
  Edit edit_;
  Vec3 normal_ = Vec3::Zero();
  Span curve_;  // from the neighbour behind to that ahead
  double here_ = 0;
  std::uint32_t behind_ = 0, ahead_ = 0;
};

/// The middle of the faces around, weighed by how many of the wanted size they would hold.
Vec3 middle_around(const WorkingMesh& mesh, std::uint32_t v) {
  Vec3 sum = Vec3::Zero();
  double weights = 0;
  for (const std::uint32_t f : mesh.around(v)) {
    const Triangle& t = mesh.face(f).corners;
    const auto [a, b, c] = mesh.places(t);
    const double size = mesh.point(t[0]).size + mesh.point(t[1]).size + mesh.point(t[2]).size;
    const double weight = (b - a).cross(c - a).norm() / (size * size);
    sum += weight * (a + b + c) / 3;
    weights += weight;
  }
  return weights > 0 ? Vec3(sum / weights) : mesh.place(v);
}

std::optional<Edit> relaxed(const Workshop& shop, std::uint32_t v) {
  const WorkingMesh& mesh = shop.mesh;
  const Mover mover(shop, v);
  const double least = std::min(mover.before(), kGoodSine);
  if (mover.on_curve()) {
    const double behind = mesh.point(mover.point_behind()).size,
                 ahead = mesh.point(mover.point_ahead()).size, mine = mesh.point(v).size;
    const double share = (behind + mine) / (behind + 2 * mine + ahead);
    const double target = mover.behind() + share * (mover.ahead() - mover.behind());
    return std::abs(target - mover.here()) > 0.02 * mine ? mover.to(target, least) : std::nullopt;
  }
  const Vec3 old = mesh.place(v);
  Vec3 shift = middle_around(mesh, v) - old;
  shift -= shift.dot(mover.normal()) * mover.normal();
  return shift.norm() > 0.02 * mesh.point(v).size ? mover.to(Vec3(old + shift), least)
                                                  : std::nullopt;
}

/// Tries places around, nearer and nearer.
std::optional<Edit> widened(const Workshop& shop, std::uint32_t v) {
  const WorkingMesh& mesh = shop.mesh;
  const Mover mover(shop, v);
  double best = mover.before() * 1.01;
  std::optional<Edit> found;
  const auto keep = [&](std::optional<Edit> edit) {
    if (edit) {
      best = EditCheck(shop, *edit).smallest_sine();
      found = std::move(edit);
    }
  };
  if (mover.on_curve()) {
    for (const double share : {-0.5, -0.25, -0.1, 0.1, 0.25, 0.5}) {
      const double room = share > 0 ? mover.ahead() - mover.here() : mover.here() - mover.behind();
      keep(mover.to(mover.here() + share * room, best));
    }
    return found;
  }
  double size = 0;
  for (const std::uint32_t w : mesh.neighbours(v)) {
    size = std::max(size, mesh.length(v, w));
  }
  const Vec3 u = mover.normal().unitOrthogonal(), w = mover.normal().cross(u);
  Vec3 here = mesh.place(v);
  for (double step = size / 3; step > size / 40; step /= 2) {
    const Vec3 start = here;
    for (int i = 0; i < 8; ++i) {
      const double angle = M_PI * i / 4;
      keep(mover.to(Vec3(start + step * (std::cos(angle) * u + std::sin(angle) * w)), best));
    }
    here = found ? found->moved->second : start;
  }
  return found;
}

}  // namespace

void relax_points(Workshop& shop) {
  const WorkingMesh& mesh = shop.mesh;
  Pass pass(shop.mesh);
  std::vector<std::uint8_t> is_done(mesh.point_count(), 0);
  for (int i = 0; i < kRounds; ++i) {
    EditKind kind;
    kind.is_at_points = true;
    kind.claim = [&](const Candidate& at) { return move_claim(mesh, at.from); };
    kind.collect = [&](std::uint32_t v, std::vector<Candidate>& found) {
      if (mesh.is_used(v) && is_done[v] == 0 && mesh.point(v).freedom != Freedom::none) {
        found.push_back({0, v, v});
      }
    };
    kind.build = [&](const Candidate& at) {
      is_done[at.from] = 1;
      return relaxed(shop, at.from);
    };
    pass.round(kind);
  }
}

std::size_t widen_angles(Workshop& shop) {
  const WorkingMesh& mesh = shop.mesh;
  Pass pass(shop.mesh);
  std::size_t moved = 0;
  for (int i = 0; i < kRounds; ++i) {
    EditKind kind;
    kind.is_at_points = true;
    kind.claim = [&](const Candidate& at) { return move_claim(mesh, at.from); };
    kind.collect = [&](std::uint32_t v, std::vector<Candidate>& found) {
      if (mesh.is_used(v) && mesh.point(v).freedom != Freedom::none) {
        const double sine = smallest_sine_around(mesh, v);
        if (sine < shop.least_sine) {
          found.push_back({sine, v, v});
        }
      }
    };
    kind.build = [&](const Candidate& at) { return widened(shop, at.from); };
    const std::size_t now = pass.round(kind);
    moved += now;
    if (now == 0) {
      break;
    }
  }
  return moved;
}

}  // namespace dupin::remeshing
