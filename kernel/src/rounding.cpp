#include "dupin/kernel/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "dupin/kernel/error.h"
#include "exact_mesh.h"
#include "exact_rounding.h"
#include "mesh_repair.h"
#include "shell_check.h"
#include "slits.h"

namespace dupin {
namespace {

using detail::BadItem;
using detail::ExactMesh;
using detail::Lattice;
using detail::RepairMesh;

/// The first attempt at repair reaches 4 steps of the lattice, each further one 4 times as far.
constexpr double kReachGrowth = 4;
constexpr double kDefaultTolerance = 1024;  // steps

/// Enclosed slits are filled before repair reaches a sixteenth of their width: filling moves no
/// point.
constexpr double kSlitWidth = 16;

/// Edits to be tried in all, per bad item that rounding leaves and besides: 50 times as many as the
/// 600 unions of io_written_unions_test need. What takes more gets nowhere.
constexpr std::uint64_t kTrialsPerItem = 64, kTrials = 1 << 17;

/// What has been done before the solid is rounded anew without some slits.
struct Past {
  double reach = 0;          ///< of the next attempt at repair; 0 for the first
  std::uint64_t trials = 0;  ///< left for it
  std::size_t slits = 0;     ///< filled
  double slit_width = 0;     ///< of the widest
  std::size_t removed_triangles = 0;
};

struct Bounds {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};

Bounds bounds(std::span<const Vec3> points) {
  Bounds all;
  if (!points.empty()) {
    all = {points[0], points[0]};
  }
  for (const Vec3& point : points) {
    all.low = all.low.cwiseMin(point);
    all.high = all.high.cwiseMax(point);
  }
  return all;
}

double largest_coordinate(std::span<const Vec3> points) {
  const Bounds all = bounds(points);
  return std::max(all.low.cwiseAbs().maxCoeff(), all.high.cwiseAbs().maxCoeff());
}

void validate(const RoundingOptions& options) {
  int exponent = 0;
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance)) {
    throw Error(Errc::invalid_argument, "the rounding tolerance must be finite and not negative");
  }
  if (options.grid != 0 && !(options.grid > 0 && std::isfinite(options.grid) &&
                             std::frexp(options.grid, &exponent) == 0.5)) {
    throw Error(Errc::invalid_argument,
                "the grid spacing must be 0 or a power of two, such as 0.0009765625 (2^-10)");
  }
  if (!options.origin.place.allFinite()) {
    throw Error(Errc::invalid_argument, "the origin must be finite");
  }
}

Vec3 chosen_origin(const Origin& origin, std::span<const Vec3> points) {
  if (origin.choice == Origin::Choice::keep || points.empty()) {
    return Vec3::Zero();
  }
  if (origin.choice == Origin::Choice::given) {
    return origin.place;
  }
  const Bounds all = bounds(points);
  const double extent = (all.high / 2 - all.low / 2).maxCoeff();
  const double step = extent > 0 ? std::exp2(std::ilogb(extent) - 3) : 0;
  Vec3 place = all.low / 2 + all.high / 2;
  for (double& coordinate : place) {
    coordinate = step > 0 ? std::nearbyint(coordinate / step) * step : coordinate;
  }
  return place;
}

class Rounding {
 public:
  Rounding(const ExactMesh& exact, Coordinates coordinates, const RoundingOptions& options,
           const Past& past = {})
      : exact_(exact),
        options_(options),
        past_(past),
        coordinates_(coordinates),
        lattice_(coordinates, options.grid),
        origin_(chosen_origin(options.origin, exact.points)),
        rounded_(detail::round_points(exact, lattice_, origin_)),
        twins_(detail::exact_twins(exact)),
        classes_(exact.labels) {
    const double largest = largest_coordinate(rounded_.doubles);
    if (!(largest_coordinate(rounded_.on_lattice) <= largest_number())) {
      throw Error(Errc::unroundable,
                  "coordinates exceed the range of binary32; use a format that holds doubles");
    }
    step_ = lattice_.step(largest);
    double_step_ = Lattice(Coordinates::binary64).step(largest);
    tolerance_ = options.tolerance > 0 ? options.tolerance : kDefaultTolerance * step_;
    classes_.resize(exact.triangles.size(), 0);
  }

  Rounded run() {
    RepairMesh direct = mesh_of(rounded_.on_lattice);
    direct.find_bad_items(rounded_.moved);
    std::vector<std::uint32_t> broken = faults(direct);
    if (broken.empty()) {
      return finished(direct, 0, 0);
    }
    return repaired(direct.bad_items(), std::move(broken));
  }

 private:
  [[nodiscard]] double largest_number() const {
    return coordinates_ == Coordinates::binary64 ? std::numeric_limits<double>::max()
                                                 : std::numeric_limits<float>::max();
  }

  /// Fills slits and repairs, as far as the tolerance allows.
  Rounded repaired(const std::vector<BadItem>& broken_pairs, std::vector<std::uint32_t> broken) {
    const bool is_first = past_.reach == 0;
    trials_left_ = is_first ? kTrials + kTrialsPerItem * broken_pairs.size() : past_.trials;
    const double farthest = tolerance_ - past_.slit_width / 2;
    const detail::Slits slits(exact_, twins_, tolerance_);
    for (double reach = is_first ? kReachGrowth * step_ : past_.reach;; reach *= kReachGrowth) {
      reach = std::min(reach, farthest);
      if (const auto filled = slits.filled(std::min(kSlitWidth * reach, tolerance_))) {
        const Past past{
            reach, trials_left_, past_.slits + filled->count,
            std::max(past_.slit_width, filled->width),
            past_.removed_triangles + exact_.triangles.size() - filled->mesh.triangles.size()};
        return Rounding(filled->mesh, coordinates_, options_, past).run();
      }
      RepairMesh mesh = mesh_of(rounded_.doubles);
      const std::size_t shells = detail::remove_small_shells(mesh, broken, reach);
      attempt(mesh, broken, broken_pairs, reach);
      const std::vector<std::uint32_t> left = faults(mesh);
      if (left.empty() && !all_removed(mesh)) {
        return finished(mesh, reach, shells);
      }
      if (reach == farthest || trials_left_ == 0) {
        throw unroundable(left.empty() ? Vec3(rounded_.doubles[0])
                                       : mesh.point(mesh.triangle(left[0])[0]));
      }
      broken.insert(broken.end(), left.begin(), left.end());
    }
  }

  [[nodiscard]] RepairMesh mesh_of(const std::vector<Vec3>& points) const {
    return {points, exact_.triangles, classes_, twins_};
  }

  /// Faces of bad items, else of shells turned inside out and at contacts that became crossings.
  [[nodiscard]] std::vector<std::uint32_t> faults(const RepairMesh& mesh) const {
    std::vector<std::uint32_t> faces;
    for (const BadItem& item : mesh.bad_items()) {
      faces.push_back(item.first);
      faces.push_back(item.second);
    }
    if (faces.empty()) {
      faces = detail::turned_shells(exact_, mesh, largest_move(mesh));
      const auto crossed = exact_.contacts.empty() ? std::vector<std::uint32_t>()
                                                   : detail::crossed_contacts(mesh, twins_);
      faces.insert(faces.end(), crossed.begin(), crossed.end());
    }
    return faces;
  }

  /// Repairs the mesh of doubles, then, for a coarser lattice, thickens what is thin around the
  /// places that rounding breaks, rounds, and repairs again. `broken_pairs` are the bad items of
  /// the mesh that is rounded only.
  void attempt(RepairMesh& mesh, const std::vector<std::uint32_t>& broken,
               const std::vector<BadItem>& broken_pairs, double reach) {
    if (lattice_.holds_doubles()) {
      mesh.find_bad_items(differing_points(mesh), broken_pairs);
      trials_left_ = detail::repair(mesh, lattice_, reach, trials_left_);
      return;
    }
    mesh.find_bad_items(rounded_.inexact);
    trials_left_ = detail::repair(mesh, Lattice(Coordinates::binary64),
                                  reach / step_ * double_step_, trials_left_);
    detail::clean_up(mesh, reach, detail::with_neighbours(mesh, broken));
    std::vector<Vec3> points(mesh.points().begin(), mesh.points().end());
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] =
          points[i] == rounded_.doubles[i] ? rounded_.on_lattice[i] : lattice_.nearest(points[i]);
    }
    mesh.place(std::move(points));
    mesh.find_bad_items(differing_points(mesh), broken_pairs);
    trials_left_ = detail::repair(mesh, lattice_, reach, trials_left_);
  }

  /// The corners of faces that are not as in the mesh that is rounded only.
  [[nodiscard]] std::vector<std::uint8_t> differing_points(const RepairMesh& mesh) const {
    std::vector<std::uint8_t> differing(mesh.points().size(), 0);
    for (std::uint32_t v = 0; v < differing.size(); ++v) {
      differing[v] = mesh.point(v) != rounded_.on_lattice[v] ? 1 : 0;
    }
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      if (mesh.alive(f) && mesh.triangle(f) != exact_.triangles[f]) {
        for (const std::uint32_t v : mesh.triangle(f)) {
          differing[v] = 1;
        }
      }
    }
    return differing;
  }

  [[nodiscard]] Rounded finished(const RepairMesh& mesh, double reach,
                                 std::size_t removed_shells) const;
  [[nodiscard]] bool all_removed(const RepairMesh& mesh) const {
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      if (mesh.alive(f)) {
        return false;
      }
    }
    return true;
  }
  [[nodiscard]] double largest_move(const RepairMesh& mesh) const;
  [[nodiscard]] Error unroundable(const Vec3& at) const;

  const ExactMesh& exact_;
  const RoundingOptions& options_;
  Past past_;
  Coordinates coordinates_;
  Lattice lattice_;
  Vec3 origin_;
  detail::RoundedPoints rounded_;
  std::vector<std::uint32_t> twins_, classes_;
  double step_ = 0, double_step_ = 0, tolerance_ = 0;
  std::uint64_t trials_left_ = 0;
};

Rounded Rounding::finished(const RepairMesh& mesh, double reach, std::size_t removed_shells) const {
  Rounded result;
  RoundingReport& report = result.report;
  report = {.coordinates = coordinates_,
            .origin = origin_,
            .largest_move = largest_move(mesh),
            .repair_reach = reach,
            .removed_triangles = past_.removed_triangles,
            .removed_shells = removed_shells,
            .filled_slits = past_.slits,
            .slit_width = past_.slit_width};
  result.contacts = exact_.contacts;
  result.mesh.names = exact_.names;
  std::vector<std::uint32_t> position(exact_.points.size());
  for (std::uint32_t v = 0; v < exact_.points.size(); ++v) {
    const bool used = !mesh.faces(v).empty();
    const bool moved = rounded_.moved[v] != 0 || mesh.point(v) != rounded_.on_lattice[v];
    report.moved += !used || moved ? 1 : 0;
    position[v] = static_cast<std::uint32_t>(result.mesh.points.size());
    if (used) {
      result.mesh.points.push_back(mesh.point(v));
    }
  }
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (!mesh.alive(f)) {
      ++report.removed_triangles;
      continue;
    }
    const Triangle& t = mesh.triangle(f);
    result.mesh.triangles.push_back({position[t[0]], position[t[1]], position[t[2]]});
    result.sources.push_back(exact_.sources[mesh.parent(f)]);
    if (!exact_.labels.empty()) {
      result.mesh.labels.push_back(exact_.labels[mesh.parent(f)]);
    }
  }
  return result;
}

/// Of exact place to nearest double, of that to the lattice, and by repair; and half the width of
/// slits, in which no place is farther from the solid. The factor covers the rounding of these few
/// sums and norms.
double Rounding::largest_move(const RepairMesh& mesh) const {
  double vertex = 0, surface = 0, rounding = 0;
  for (std::uint32_t v = 0; v < exact_.points.size(); ++v) {
    const bool placed = mesh.point(v) == rounded_.on_lattice[v] && mesh.reach(v) == 0;
    vertex =
        std::max(vertex, placed ? (mesh.point(v) - rounded_.doubles[v]).norm() : mesh.reach(v));
    rounding = rounded_.inexact[v] != 0 ? std::sqrt(0.75) * double_step_ : rounding;
  }
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    surface = mesh.alive(f) ? std::max(surface, mesh.deviation(f)) : surface;
  }
  return (vertex + surface + rounding + past_.slit_width / 2) * (1 + 0x1p-48);
}

Error Rounding::unroundable(const Vec3& at) const {
  const Vec3 place = at + origin_;
  const Bounds all = bounds(rounded_.doubles);
  std::ostringstream where, message;
  where << "(" << place.x() << ", " << place.y() << ", " << place.z() << ")";
  message << "no valid mesh with coordinates of the target format within the tolerance of "
          << tolerance_ << "; what would help: ";
  if ((all.high - all.low).maxCoeff() < largest_coordinate(rounded_.doubles)) {
    message << "recentring (origin auto), ";
  }
  if (coordinates_ == Coordinates::binary32) {
    message << "a format that holds doubles (OFF, OBJ, PLY instead of STL), ";
  }
  message << "a larger tolerance";
  return Error(Errc::unroundable, message.str(), {}, where.str());
}

}  // namespace

Rounded to_mesh(const Solid& solid, Coordinates coordinates, const RoundingOptions& options) {
  validate(options);
  return Rounding(solid.exact(), coordinates, options).run();
}

}  // namespace dupin
