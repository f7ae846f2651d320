#include "dupin/kernel/simplify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <queue>

#include <Eigen/Geometry>

#include "boxes/box_quantizer.h"
#include "boxes/box_tree.h"
#include "dupin/kernel/connected_components.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/rounding.h"
#include "mesh/coincident_points.h"
#include "predicates/triangle_overlap.h"
#include "rounding/contact_edges.h"
#include "rounding/edits/edited_mesh.h"
#include "rounding/shell_sides.h"
#include "support/sequences.h"

namespace dupin {
namespace {

using rounding::EditedMesh;
using rounding::EditRule;
using Vec2 = Eigen::Vector2d;

/// Vertices with more faces stay: the cost of comparing fans is cubic.
constexpr std::size_t kMostFaces = 64;

/// A point over the plane in which two patches are compared.
struct Lifted {
  Vec2 foot;
  double height;
};

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The vertices around `centre`, counter-clockwise; vertex i and i + 1 make a face with it.
std::vector<std::uint32_t> link(const EditedMesh& mesh, std::uint32_t centre) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const std::uint32_t f : mesh.faces(centre)) {
    const Triangle& t = mesh.triangle(f);
    const int i = t[0] == centre ? 0 : t[1] == centre ? 1 : 2;
    edges.emplace_back(t[(i + 1) % 3], t[(i + 2) % 3]);
  }
  std::vector<std::uint32_t> ring;
  for (std::uint32_t at = edges.front().first; ring.size() < edges.size();) {
    ring.push_back(at);
    at = std::ranges::find(edges, at, [](const auto& edge) { return edge.first; })->second;
  }
  return ring;
}

/// The largest vertical distance between the fan of triangles about a point and the fan that
/// replaces it when the point is collapsed into rim[0], where both are graphs over one plane;
/// nothing if they are not. Both fans are linear between the points compared: the centre, and the
/// crossings of the spokes of one fan with those of the other.
class FanDistance {
 public:
  /// The centre is the origin.
  explicit FanDistance(const std::vector<Lifted>& rim) : rim_(rim) {}

  [[nodiscard]] std::optional<double> largest() const {
    if (!is_graph()) {
      return std::nullopt;
    }
    double largest = 0;
    const std::size_t n = rim_.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
      largest = std::max(largest, above_triangle(rim_[0], rim_[i], rim_[i + 1]));
      for (std::size_t k = 1; k < n && i > 1; ++k) {
        largest = std::max(largest, at_crossing(rim_[0], rim_[i], rim_[k]));
      }
    }
    return largest;
  }

 private:
  /// Whether all triangles of both fans lie counter-clockwise, those of the first once around.
  [[nodiscard]] bool is_graph() const {
    double angle = 0;
    const std::size_t n = rim_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 &a = rim_[i].foot, &b = rim_[(i + 1) % n].foot;
      const double turn = cross(a, b);
      if (!(turn > 0)) {
        return false;
      }
      angle += std::atan2(turn, a.dot(b));
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
      if (!(cross(rim_[i].foot - rim_[0].foot, rim_[i + 1].foot - rim_[0].foot) > 0)) {
        return false;
      }
    }
    return angle < 3 * std::numbers::pi;  // 2 pi, or 4 pi and more for a fan that winds twice
  }

  /// The distance at the centre if the triangle lies under it, else 0.
  [[nodiscard]] static double above_triangle(const Lifted& a, const Lifted& b, const Lifted& c) {
    const double wa = cross(b.foot, c.foot), wb = cross(c.foot, a.foot), wc = cross(a.foot, b.foot);
    const double sum = wa + wb + wc;
    if (!(sum > 0) || std::min({wa, wb, wc}) < -kMargin * sum) {
      return 0;
    }
    return std::abs((wa * a.height + wb * b.height + wc * c.height) / sum);
  }

  /// The distance where the new spoke from a to b crosses the old one to c, else 0.
  [[nodiscard]] static double at_crossing(const Lifted& a, const Lifted& b, const Lifted& c) {
    const Vec2 spoke = b.foot - a.foot;
    const double turn = cross(spoke, c.foot);
    const double s = -cross(a.foot, c.foot) / turn, t = -cross(a.foot, spoke) / turn;
    if (!(s >= -kMargin && s <= 1 + kMargin && t >= -kMargin && t <= 1 + kMargin)) {
      return 0;
    }
    return std::abs(a.height + s * (b.height - a.height) - t * c.height);
  }

  // Looks a little beyond the ends, so that rounding loses no crossing between two triangles.
  static constexpr double kMargin = 0x1p-20;
  const std::vector<Lifted>& rim_;
};

/// A point of each shell, if there are several. What passes over a whole shell passes over its
/// point, as long as that stays.
class Witnesses {
 public:
  explicit Witnesses(const TriMesh& mesh)
      : shell_of_(connected_components(mesh.triangles, mesh.points.size())),
        quantizer_(mesh.points),
        points_(one_of_each_shell(mesh)),
        tree_(boxes_of(mesh.points)) {}

  /// Per point the lowest one of its shell.
  [[nodiscard]] std::span<const std::uint32_t> shell_of() const { return shell_of_; }
  [[nodiscard]] bool contain(std::uint32_t point) const {
    return std::ranges::binary_search(points_, point);
  }
  /// Whether the box may have one of another shell than that of `point`.
  [[nodiscard]] bool are_within(const Eigen::AlignedBox3d& box, std::uint32_t point) const {
    bool are = false;
    tree_.visit(quantizer_.around(box),
                [&](std::uint32_t witness) { are = are || points_[witness] != shell_of_[point]; });
    return are;
  }

 private:
  [[nodiscard]] std::vector<std::uint32_t> one_of_each_shell(const TriMesh& mesh) const {
    std::vector<std::uint32_t> points;
    points.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
      points.push_back(shell_of_[t[0]]);
    }
    support::sort_unique(points);
    return points.size() > 1 ? points : std::vector<std::uint32_t>();
  }
  [[nodiscard]] std::vector<boxes::Box> boxes_of(const std::vector<Vec3>& points) const {
    std::vector<boxes::Box> result;
    result.reserve(points_.size());
    for (const std::uint32_t point : points_) {
      const auto at = quantizer_.map(points[point]);
      result.push_back(quantizer_.around({at, at, at}));
    }
    return result;
  }

  std::vector<std::uint32_t> shell_of_;
  boxes::BoxQuantizer quantizer_;
  std::vector<std::uint32_t> points_;
  boxes::BoxTree tree_;
};

class Simplification {
 public:
  Simplification(const Rounded& rounded, double tolerance)
      : input_(rounded.mesh()),
        tolerance_(tolerance),
        labels_(labels(rounded.mesh())),
        representatives_(mesh::coincident_representatives(rounded.mesh().points)),
        mesh_(rounded.mesh().points, rounded.mesh().triangles, labels_, representatives_),
        witnesses_(rounded.mesh()),
        sides_(witnesses_.shell_of()),
        contact_edges_(representatives_),
        deviation_(rounded.mesh().triangles.size(), 0) {
    double largest = 0;
    for (const Vec3& point : input_.points) {
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
    }
    // Covers the rounding of the few operations per coordinate in FanDistance, tenfold.
    slack_ = largest * 0x1p-46;
  }

  void run(const Progress& progress) {
    constexpr std::size_t kBetweenTold = 1024;
    tell(progress, "simplify");
    for (std::uint32_t v = 0; v < input_.points.size(); ++v) {
      enqueue(v);
    }
    for (std::size_t looks = 1; !queue_.empty(); ++looks) {
      if (looks % kBetweenTold == 0) {  // how many are left to look at is not known
        tell(progress, "simplify", 1 - double(queue_.size()) / double(queue_.size() + looks));
      }
      const auto [harm, vertex] = queue_.top();
      queue_.pop();
      for (const Option& option : options(vertex)) {
        if (option.harm > harm) {
          queue_.emplace(option.harm, vertex);
          break;
        }
        if (collapse(vertex, option)) {
          break;
        }
      }
    }
  }

  [[nodiscard]] Simplified result(const std::vector<Source>& sources) const {
    Simplified result;
    std::vector<std::uint32_t> position(input_.points.size());
    for (std::uint32_t v = 0; v < input_.points.size(); ++v) {
      position[v] = static_cast<std::uint32_t>(result.mesh.points.size());
      if (!mesh_.faces(v).empty()) {
        result.mesh.points.push_back(mesh_.point(v));
      }
    }
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      if (mesh_.alive(f)) {
        const Triangle& t = mesh_.triangle(f);
        result.mesh.triangles.push_back({position[t[0]], position[t[1]], position[t[2]]});
        result.sources.push_back(sources[f]);
        if (!input_.labels.empty()) {
          result.mesh.labels.push_back(input_.labels[f]);
        }
        result.deviation = std::max(result.deviation, deviation_[f]);
      }
    }
    result.mesh.names = input_.names;
    result.removed_triangles = input_.triangles.size() - result.mesh.triangles.size();
    return result;
  }

 private:
  /// A collapse into `to` that the tolerance allows: the deviation of the faces it makes.
  struct Option {
    double harm, length;
    std::uint32_t to;
    friend auto operator<=>(const Option&, const Option&) = default;
  };
  using Waiting = std::pair<double, std::uint32_t>;  // the least harm of a vertex

  static std::vector<std::uint32_t> labels(const TriMesh& mesh) {
    std::vector<std::uint32_t> labels = mesh.labels;
    labels.resize(mesh.triangles.size(), 0);
    return labels;
  }

  void enqueue(std::uint32_t vertex) {
    const std::vector<Option> choice = options(vertex);
    if (!choice.empty()) {
      queue_.emplace(choice[0].harm, vertex);
    }
  }

  bool collapse(std::uint32_t from, const Option& option) {
    const std::vector<std::uint32_t> star(mesh_.faces(from).begin(), mesh_.faces(from).end());
    const std::vector<std::uint32_t> ring = link(mesh_, from);
    Eigen::AlignedBox3d swept(mesh_.point(from));
    for (const std::uint32_t corner : ring) {
      swept.extend(mesh_.point(corner));
    }
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    if (witnesses_.are_within(swept, from) || !sides_.stay(mesh_, from, option.to, swept) ||
        !contact_edges_.stay(mesh_, from, option.to) ||
        !mesh_.collapse(from, option.to, {rounding::FaultRule::none, kAnywhere})) {
      return false;
    }
    for (const std::uint32_t f : star) {
      deviation_[f] = option.harm;
    }
    std::ranges::for_each(ring, [&](std::uint32_t vertex) { enqueue(vertex); });
    return true;
  }

  /// The collapses of a vertex that the tolerance and the labels allow, the least harmful first.
  [[nodiscard]] std::vector<Option> options(std::uint32_t from) const {
    std::vector<Option> allowed;
    if (mesh_.faces(from).empty() || mesh_.faces(from).size() > kMostFaces ||
        witnesses_.contain(from)) {
      return allowed;
    }
    std::vector<std::uint32_t> ring = link(mesh_, from);
    const std::vector<std::uint32_t> borders = borders_at(from, ring);
    double before = 0;
    for (const std::uint32_t f : mesh_.faces(from)) {
      before = std::max(before, deviation_[f]);
    }
    const Vec3& centre = mesh_.point(from);
    std::vector<Lifted> rim = lifted(centre, ring);
    for (std::size_t i = 0; i < ring.size() && !rim.empty(); ++i) {
      const auto distance =
          may_go_to(from, ring[0], borders) ? FanDistance(rim).largest() : std::nullopt;
      if (distance && before + *distance + slack_ <= tolerance_) {
        allowed.push_back(
            {before + *distance + slack_, (mesh_.point(ring[0]) - centre).norm(), ring[0]});
      }
      std::rotate(ring.begin(), ring.begin() + 1, ring.end());
      std::rotate(rim.begin(), rim.begin() + 1, rim.end());
    }
    std::sort(allowed.begin(), allowed.end());
    return allowed;
  }

  /// The ring over the plane through the centre along the mean of its faces; empty if these have
  /// none.
  [[nodiscard]] std::vector<Lifted> lifted(const Vec3& centre,
                                           const std::vector<std::uint32_t>& ring) const {
    std::vector<Lifted> rim;
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      normal +=
          (mesh_.point(ring[i]) - centre).cross(mesh_.point(ring[(i + 1) % ring.size()]) - centre);
    }
    if (!(normal.norm() > 0)) {
      return rim;
    }
    normal.normalize();
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
    for (const std::uint32_t corner : ring) {
      const Vec3 offset = mesh_.point(corner) - centre;
      rim.push_back({{u.dot(offset), v.dot(offset)}, normal.dot(offset)});
    }
    return rim;
  }

  /// The ends of the borders between labels that meet in a vertex.
  [[nodiscard]] std::vector<std::uint32_t> borders_at(
      std::uint32_t from, const std::vector<std::uint32_t>& ring) const {
    std::vector<std::uint32_t> borders;
    for (const std::uint32_t corner : ring) {
      const auto left = mesh_.face_with_edge(from, corner);
      const auto right = mesh_.face_with_edge(corner, from);
      if (!left || !right || labels_[*left] != labels_[*right]) {
        borders.push_back(corner);
      }
    }
    return borders;
  }

  /// Whether borders allow the collapse: there are none, or one that runs straight through, along
  /// it.
  [[nodiscard]] bool may_go_to(std::uint32_t from, std::uint32_t to,
                               const std::vector<std::uint32_t>& borders) const {
    if (borders.empty()) {
      return true;
    }
    if (borders.size() != 2 || (borders[0] != to && borders[1] != to)) {
      return false;
    }
    const Vec3 &a = mesh_.point(borders[0]), &b = mesh_.point(borders[1]),
               &middle = mesh_.point(from);
    return predicates::collinear(middle, a, b) && (a - middle).dot(b - middle) < 0;
  }

  const TriMesh& input_;
  double tolerance_, slack_ = 0;
  std::vector<std::uint32_t> labels_, representatives_;
  EditedMesh mesh_;
  Witnesses witnesses_;
  rounding::ShellSides sides_;
  rounding::ContactEdges contact_edges_;
  std::vector<double> deviation_;  // of each face from the surface given
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue_;
};

}  // namespace

Simplified simplify(const Solid& solid, double tolerance, const Progress& progress) {
  const UsualArithmetic usual;
  if (!(tolerance > 0) || !std::isfinite(tolerance)) {
    throw Error(Errc::invalid_argument,
                "the tolerance of simplification must be positive and finite");
  }
  const Rounded rounded = to_mesh(solid);
  Simplification simplification(rounded, tolerance);
  simplification.run(progress);
  return simplification.result(rounded.sources());
}

}  // namespace dupin
