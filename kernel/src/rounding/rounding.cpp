#include "dupin/kernel/rounding.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include <tbb/parallel_invoke.h>

#include "boxes/bounds.h"
#include "dupin/kernel/connected_components.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "mesh/coincident_points.h"
#include "mesh/exact_mesh.h"
#include "rounding/edits/edit_strategy.h"
#include "rounding/edits/first_repair.h"
#include "rounding/edits/mesh_part.h"
#include "rounding/edits/small_shells.h"
#include "rounding/edits/thicken_in_slabs.h"
#include "rounding/misplaced_shells.h"
#include "rounding/open_slits.h"
#include "rounding/past_rounds.h"
#include "rounding/pinches.h"
#include "rounding/point_rounding.h"
#include "rounding/rounding_options.h"
#include "rounding/self_crossings.h"
#include "rounding/shell_check.h"
#include "rounding/shell_orientation.h"
#include "rounding/sliver_voids.h"
#include "rounding/thin_shells.h"
#include "support/bulk_vector.h"

namespace dupin::rounding {
namespace {

/// The first attempt at repair reaches 4 steps of the lattice, each further one 4 times as far.
constexpr double kReachGrowth = 4;

/// So many faults are no accident of single points: open slits are looked for before repair.
constexpr std::size_t kManyFaults = 256;

/// Sliver voids and open slits are filled where narrower: what is wider, the format can tell.
constexpr double kWidestSlit = 64;  // steps

/// Where repair with some reach leaves faults (PastRounds::snap_reach), or with less finds that
/// going on is not worth it, the surface is made a solid again as it is; and that at most so often.
constexpr int kSnaps = 32;

}  // namespace

class Rounding {
 public:
  Rounding(const mesh::ExactMesh& exact, Coordinates coordinates, const RoundingOptions& options,
           PastRounds past = {})
      : exact_(exact),
        options_(options),
        past_(std::move(past)),
        coordinates_(coordinates),
        lattice_(coordinates, options.output_grid),
        origin_(past_.thickenings + past_.snaps > 0 ? Vec3(Vec3::Zero())
                                                    : chosen_origin(options, exact.points)),
        rounded_(round_points(exact, lattice_, origin_)),
        representatives_(mesh::representatives_at_contacts(exact)) {
    if (!(rounded_.largest_on_lattice <= largest_number())) {
      throw Error(Errc::unroundable,
                  "coordinates of up to " + decimal(rounded_.largest_on_lattice, kMessageDigits) +
                      " exceed the range of binary32, which ends at " +
                      decimal(largest_number(), kMessageDigits) +
                      "; use a format that holds doubles (OFF, OBJ, PLY instead of STL)");
    }
    rounded_.largest = std::max(rounded_.largest, largest_of(options, past_.origin + origin_));
    step_ = lattice_.step(rounded_.largest);
    double_step_ = exact::FloatLattice(Coordinates::binary64).step(rounded_.largest);
    tolerance_ = options.tolerance > 0 ? options.tolerance : usual_tolerance();
    past_.triangles = past_.triangles == 0 ? exact.triangles.size() : past_.triangles;
  }

  /// The one that is taken where none is asked for.
  [[nodiscard]] double usual_tolerance() const { return kDefaultTolerance * step_; }

  /// What run() returns, with the contacts that are left, and the shells to warn of.
  Rounded run_with_warnings() {
    Rounded result = run();
    if (!result.contacts_.empty()) {
      result.contacts_ = contacts_of(result.mesh_, result.report_.origin);
    }
    RoundingReport& report = result.report_;
    const bool is_repaired = report.repair_reach > 0 || report.removed_triangles > 0 ||
                             !report.filled_places.empty() || !report.snapped_places.empty();
    const PointMoves moves{lattice_, report.origin, is_repaired ? report.largest_move : 0};
    if (report.largest_move > 0) {
      for (const auto& [place, thickness, move] :
           thin_shells(exact_, shell_of(), moves, report.largest_move)) {
        report.thin_shells.push_back({place, thickness, move});
      }
    }
    return result;
  }

  Rounded run() {
    if (auto done = thickened()) {
      return std::move(*done);
    }
    if (past_.thickenings > 0) {  // such solids have voids, which are sought before what is dearer
      if (auto done = without_voids()) {
        return std::move(*done);
      }
    }
    const auto groups = mesh::groups_apart(exact_.stable, lattice_, step_, !origin_.isZero(0));
    const Embedding embedding{rounded_.on_lattice, exact_.triangles, representatives_, groups};
    const auto moved = marked_faces(exact_.triangles, rounded_.moved);
    if (past_.thickenings > 0 && !past_.has_filled_slits) {
      if (auto done = without_expected_slits(embedding, moved)) {
        return std::move(*done);
      }
    }
    // Voids may be why there are many; they are filled whatever the faults are.
    const bool voids_first = !exact_.contacts.empty() && !past_.has_filled_voids;
    auto few = voids_first ? find_faults_below(kManyFaults, embedding, moved) : std::nullopt;
    if (voids_first && !few) {
      if (auto done = without_voids()) {
        return std::move(*done);
      }
    }
    const std::vector<Fault> found = few ? *std::move(few) : find_faults(embedding, moved);
    const mesh::MeshView direct(rounded_.on_lattice, exact_.triangles);
    const double move = largest_move(rounded_.largest_move);
    if (found.empty() && exact_.contacts.empty() &&
        keeps_shell_orientation(direct, rounded_.moved, move)) {
      return unrepaired(move);
    }
    std::vector<std::uint32_t> broken = found.empty() ? misplaced(direct, move) : faces_of(found);
    if (broken.empty()) {
      return unrepaired(move);
    }
    return repaired(found, std::move(broken));
  }

 private:
  /// The places of the points in the nearest doubles.
  [[nodiscard]] std::span<const Vec3> doubles() const {
    return rounded_.shifted.empty() ? exact_.points : rounded_.shifted;
  }

  /// Found when first asked for: most solids round without any question that needs them.
  const std::vector<std::uint32_t>& shell_of() {
    if (shell_of_.empty()) {
      shell_of_ = connected_components(exact_.triangles, exact_.points.size());
    }
    return shell_of_;
  }

  [[nodiscard]] double largest_number() const {
    return coordinates_ == Coordinates::binary64 ? std::numeric_limits<double>::max()
                                                 : std::numeric_limits<float>::max();
  }

  /// Where parts nearly coincide, a union has more triangles thinner than a step than others, and
  /// rounding folds them over one another. They are collapsed before, among doubles, where they
  /// are not in each other's way, once, and once after slits are filled. None if there are few, or
  /// if that does not do.
  std::optional<Rounded> thickened() {
    if (lattice_.holds_doubles() || past_.thickenings > (past_.has_filled_slits ? 1 : 0) ||
        !is_full_of_needles({rounded_.on_lattice, exact_.triangles})) {
      return std::nullopt;
    }
    if (past_.has_filled_slits) {
      if (auto done = without_voids()) {
        return done;
      }
    }
    EditedMesh mesh = unedited(whole());
    const double reach = std::min(step_, (tolerance_ - past_.distance()) / kReachGrowth);
    thicken_doubles(mesh, whole(), rounded_.inexact, reach, kReachGrowth * double_step_);
    const auto alive = mesh.alive_faces();
    const double move = largest_move(mesh, alive);
    PastRounds past = past_;
    past.moved = move - past_.filled();
    for (std::uint32_t v = 0; v < mesh.points().size(); ++v) {
      past.moved_points += mesh.faces(v).empty() || mesh.point(v) != doubles()[v] ? 1 : 0;
    }
    past.origin += origin_;
    ++past.thickenings;
    const std::vector<Fault> left = mesh.faults_among(alive);
    const auto broken =
        left.empty() ? misplaced({mesh.points(), mesh.triangles_of(alive)}, move) : faces_of(left);
    Rounded surface = finished(mesh, alive, {});
    if (!broken.empty()) {
      past.snapped_places.emplace_back(mesh.point(mesh.triangle(alive[broken[0]])[0]) +
                                       past.origin);
      return cut(surface, left, std::move(past));
    }
    mesh::ExactMesh solid;
    solid.points = std::move(surface.mesh_.points);
    solid.triangles = std::move(surface.mesh_.triangles);
    solid.labels = std::move(surface.mesh_.labels);
    solid.names = exact_.names;
    solid.sources = std::move(surface.sources_);
    solid.contacts = exact_.contacts;
    return Rounding(solid, coordinates_, options_, std::move(past)).run();
  }

  /// The surface made a solid again where it crosses itself, and rounded. None if nothing is left,
  /// or if what is lost is further away from it than the rest of the tolerance.
  std::optional<Rounded> cut(const Rounded& surface, std::span<const Fault> faults,
                             PastRounds past) {
    const double most = tolerance_ - past.distance() - kReachGrowth * step_;
    if (!(most > 0)) {
      return std::nullopt;
    }
    const auto made =
        without_self_crossings(surface.mesh(), surface.sources(), faults, step_, most);
    if (!made) {
      would_lose_ = true;
      return std::nullopt;
    }
    past.moved += made->lost;
    past.lost_shells += made->lost_shells;
    return Rounding(made->solid, coordinates_, options_, std::move(past)).run();
  }

  /// Fills slits and voids, repairs and snaps, as far as the tolerance allows.
  Rounded repaired(const std::vector<Fault>& broken_pairs, std::vector<std::uint32_t> broken) {
    if (auto done = without_voids()) {
      return std::move(*done);
    }
    if (fills_slits_first() && broken_pairs.size() >= kManyFaults) {
      if (auto done = without_open_slits(broken_pairs)) {
        return std::move(*done);
      }
    }
    const double farthest = tolerance_ - past_.distance();
    double reach = std::min(kReachGrowth * step_, farthest);
    auto repair = first_repair_in_part(whole(), broken, broken_pairs, limits(reach), step_);
    if (repair && repair->part) {
      if (auto done = spliced(*repair, reach)) {
        return std::move(*done);
      }
      repair.reset();
    }
    if (!repair) {
      repair = first_repair(whole(), broken, broken_pairs, limits(reach));
    }
    EditedMesh& mesh = *repair->mesh;
    while (true) {
      const auto alive = mesh.alive_faces();
      const double move = largest_move(mesh, alive);
      broken = faults(mesh, alive, move);
      if (broken.empty() && (!alive.empty() || options_.whole)) {
        return finished(mesh, alive,
                        {.largest_move = move,
                         .repair_reach = reach,
                         .removed_shells = repair->removed_shells});
      }
      const bool is_urgent = past_.idle_snaps == 0 && (!repair->is_ended || !pinches(mesh).empty());
      const bool may_cut = is_urgent || reach >= past_.snap_reach() * step_;
      if (auto done = begun_anew(mesh, alive, broken_pairs, broken, may_cut)) {
        return std::move(*done);
      }
      if (reach == farthest) {
        if (auto done = without_open_slits(broken_pairs)) {
          return std::move(*done);
        }
        throw unroundable(broken.empty() ? doubles()[0] : mesh.point(mesh.triangle(broken[0])[0]),
                          alive.empty());
      }
      reach = std::min(kReachGrowth * reach, farthest);
      repair->removed_shells += remove_small_shells(mesh, broken, reach);
      repair->is_ended = repair_further(mesh, broken, limits(reach));
    }
  }

  /// What else there is where repair with some reach leaves faults.
  std::optional<Rounded> begun_anew(const EditedMesh& mesh, std::span<const std::uint32_t> alive,
                                    const std::vector<Fault>& broken_pairs,
                                    const std::vector<std::uint32_t>& left, bool may_cut) {
    if (fills_slits_first()) {
      if (auto done = without_open_slits(broken_pairs)) {
        return done;
      }
    }
    if (!may_cut || past_.snaps == kSnaps || left.empty() || alive.empty()) {
      return std::nullopt;
    }
    return snapped(mesh, alive, left);
  }

  /// Between coarse numbers slits are those between ends that were meant to meet, and are what most
  /// faults are at. Between doubles they come of rounding alone, as where turned parts are flush:
  /// to mend and to cut takes a sixth of the time, and what fills them would leave more faults.
  [[nodiscard]] bool fills_slits_first() const { return !lattice_.holds_doubles(); }

  /// None if there are no sliver voids.
  std::optional<Rounded> without_voids() {
    if (past_.has_filled_voids || !may_have_voids()) {
      return std::nullopt;
    }
    past_.has_filled_voids = true;
    const double widest = std::min(kWidestSlit * step_, tolerance_ - past_.distance());
    const auto filled = SliverVoids(exact_, representatives_, widest).filled(widest);
    if (!filled) {
      return std::nullopt;
    }
    PastRounds past = past_;
    past.void_width = std::max(past.void_width, filled->width);
    past.filled_places.insert(past.filled_places.end(), filled->places.begin(),
                              filled->places.end());
    return Rounding(filled->mesh, coordinates_, options_, std::move(past)).run();
  }

  /// None if there are none, or if the tolerance does not allow it, or if that has been done.
  std::optional<Rounded> without_open_slits(const std::vector<Fault>& broken_pairs) {
    const double widest = std::min((tolerance_ - past_.distance()) / 4, kWidestSlit * step_);
    if (past_.has_filled_slits || widest < kSlitOverlap * step_) {
      return std::nullopt;
    }
    past_.has_filled_slits = true;
    const auto filled = fill_open_slits(exact_, broken_pairs, step_, widest);
    if (!filled) {
      return std::nullopt;
    }
    PastRounds past = past_;
    past.slit_reach = filled->reach;
    past.has_filled_voids = false;
    past.filled_places.insert(past.filled_places.end(), filled->places.begin(),
                              filled->places.end());
    return Rounding(filled->mesh, coordinates_, options_, std::move(past)).run();
  }

  /// Where there were many needles, most faults are at slits. To fill these, no other faults have
  /// to be found, which are dearer than to look at triangles that face each other. None if there
  /// are few.
  std::optional<Rounded> without_expected_slits(const Embedding& embedding,
                                                std::span<const std::uint8_t> moved) {
    const FacingTriangles facing(exact_, step_);
    const std::vector<Fault> across = find_faults(embedding, moved, std::cref(facing));
    return across.size() < kManyFaults ? std::nullopt : without_open_slits(across);
  }

  [[nodiscard]] std::vector<Vec3> pinches(const EditedMesh& mesh) const {
    return pinched_places(mesh, representatives_, rounded_.moved);
  }

  /// The surface as far as it is repaired, which has `left` triangles broken, made a solid again
  /// where it still crosses itself, and rounded anew: iterated snap rounding. None if that is no
  /// surface to make a solid of.
  std::optional<Rounded> snapped(const EditedMesh& mesh, std::span<const std::uint32_t> alive,
                                 const std::vector<std::uint32_t>& left) {
    Rounded surface = finished(mesh, alive, {});
    std::vector<Fault> faults = mesh.faults_among(alive);
    const double closed = close_pinches(pinches(mesh), kReachGrowth * step_, surface.mesh_, faults);
    PastRounds past = past_;
    past.moved = largest_move(mesh, alive) + closed - past_.filled();
    past.moved_points = surface.report().moved;
    past.snapped_places.emplace_back(mesh.point(mesh.triangle(left[0])[0]) + origin_ +
                                     past_.origin);
    past.origin += origin_;
    past.count_snap(left.size());
    return cut(surface, faults, std::move(past));
  }

  [[nodiscard]] BrokenMesh whole() const {
    return {doubles(), rounded_.on_lattice, exact_.triangles, exact_.labels, representatives_};
  }

  /// Where the surface may be cut instead (begun_anew), edits need not go to any length.
  [[nodiscard]] RepairLimits limits(double reach) const {
    const double cut = kSnapReach * step_;
    const bool is_last = past_.snaps == kSnaps || past_.idle_snaps > 0 || reach > cut ||
                         tolerance_ - past_.distance() < cut;
    return {lattice_, step_, reach, is_last};
  }

  /// Without a second shell and without contacts the solid leaves free one connected space.
  bool may_have_voids() {
    return !exact_.contacts.empty() ||
           std::ranges::any_of(shell_of(), [](std::uint32_t shell) { return shell != 0; });
  }

  /// Triangles, by their places, of shells on wrong sides and at contacts that became crossings.
  std::vector<std::uint32_t> misplaced(const mesh::MeshView& mesh, double move) {
    std::vector<std::uint32_t> faces =
        misplaced_shells(mesh::MeshView(exact_), shell_of(), mesh, move);
    if (!exact_.contacts.empty()) {
      const auto crossed = crossed_contacts(mesh, representatives_);
      faces.insert(faces.end(), crossed.begin(), crossed.end());
    }
    return faces;
  }

  /// Faces of faults, else misplaced ones.
  std::vector<std::uint32_t> faults(const EditedMesh& mesh, std::span<const std::uint32_t> alive,
                                    double move) {
    const std::vector<Fault> found = mesh.faults();
    if (!found.empty()) {
      return faces_of(found);
    }
    const auto triangles = mesh.triangles_of(alive);
    std::vector<std::uint32_t> faces = misplaced({mesh.points(), triangles}, move);
    for (std::uint32_t& face : faces) {
      face = alive[face];
    }
    return faces;
  }

  Rounded unrepaired(double move);
  std::optional<Rounded> spliced(const FirstRepair& repair, double reach);
  [[nodiscard]] Rounded finished(const EditedMesh& mesh, std::span<const std::uint32_t> alive,
                                 RoundingReport report) const;
  [[nodiscard]] Rounded with_report(RoundingReport report, std::size_t triangles) const;
  [[nodiscard]] double largest_move(double from_doubles) const;
  [[nodiscard]] double largest_move(const EditedMesh& repaired,
                                    std::span<const std::uint32_t> alive) const;
  [[nodiscard]] Error unroundable(const Vec3& at, bool is_nothing) const;

  const mesh::ExactMesh& exact_;
  const RoundingOptions& options_;
  PastRounds past_;
  Coordinates coordinates_;
  exact::FloatLattice lattice_;
  Vec3 origin_;
  RoundedPoints rounded_;
  std::vector<std::uint32_t> representatives_, shell_of_;
  double step_ = 0, double_step_ = 0, tolerance_ = 0;
  bool would_lose_ = false;  // what is further away than the tolerance, if it were cut
};

/// A result of so many triangles, less its mesh and sources.
Rounded Rounding::with_report(RoundingReport report, std::size_t triangles) const {
  Rounded result;
  report.coordinates = coordinates_;
  report.origin = origin_ + past_.origin;
  report.removed_triangles = past_.triangles - std::min(past_.triangles, triangles);
  report.moved += past_.moved_points;
  report.removed_shells += past_.lost_shells;
  report.slit_width = std::max(past_.void_width, past_.slit_reach);
  report.filled_places = past_.filled_places;
  report.snapped_places = past_.snapped_places;
  result.mesh_.names = exact_.names;
  result.contacts_ = exact_.contacts;
  result.report_ = report;
  return result;
}

/// The solid's own triangles, on the rounded points, which are taken.
Rounded Rounding::unrepaired(double move) {
  RoundingReport report{.largest_move = move};
  report.moved = static_cast<std::size_t>(std::ranges::count(rounded_.moved, 1));
  Rounded result = with_report(std::move(report), exact_.triangles.size());
  result.mesh_.points = std::move(rounded_.on_lattice);
  tbb::parallel_invoke([&] { support::assign_bulk(exact_.triangles, result.mesh_.triangles); },
                       [&] { support::assign_bulk(exact_.sources, result.sources_); },
                       [&] { support::assign_bulk(exact_.labels, result.mesh_.labels); });
  return result;
}

/// The mesh of the faces that repair has left alive.
Rounded Rounding::finished(const EditedMesh& mesh, std::span<const std::uint32_t> alive,
                           RoundingReport report) const {
  Rounded result = with_report(std::move(report), alive.size());
  result.mesh_ = mesh.mesh_of(alive);
  result.mesh_.names = exact_.names;
  for (std::uint32_t v = 0; v < mesh.points().size(); ++v) {
    const bool has_moved = rounded_.moved[v] != 0 || mesh.point(v) != rounded_.on_lattice[v];
    result.report_.moved += mesh.faces(v).empty() || has_moved ? 1 : 0;
  }
  support::reserve_bulk(result.sources_, alive.size());
  for (const std::uint32_t face : alive) {
    result.sources_.push_back(exact_.sources[mesh.parent(face)]);
  }
  return result;
}

/// The whole mesh, its part replaced by the repaired one; none if that is not free of faults. Takes
/// the rounded points, or leaves them as they were.
std::optional<Rounded> Rounding::spliced(const FirstRepair& repair, double reach) {
  const MeshPart& part = *repair.part;
  const EditedMesh& mesh = *repair.mesh;
  RoundingReport report{.repair_reach = reach, .removed_shells = repair.removed_shells};
  const BrokenMesh original = part.view();
  double vertex = rounded_.largest_move, surface = 0;
  std::vector<std::uint32_t> unused, dead;  // points and triangles of the whole
  std::size_t moved = 0;                    // which rounding has left in place
  for (std::uint32_t v = 0; v < mesh.points().size(); ++v) {
    const std::uint32_t point = part.points()[v];
    const bool is_used = !mesh.faces(v).empty();
    const bool is_kept = is_used && mesh.point(v) == original.on_lattice[v];
    moved += rounded_.moved[point] == 0 && !is_kept ? 1 : 0;
    vertex = std::max(vertex, mesh.reach(v));
    if (!is_used) {
      unused.push_back(point);
    }
  }
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.alive(f)) {
      surface = std::max(surface, mesh.deviation(f));
    } else {
      dead.push_back(part.faces()[f]);
    }
  }
  report.largest_move = largest_move(vertex + surface);
  report.moved = moved + static_cast<std::size_t>(std::ranges::count(rounded_.moved, 1));
  Rounded result = with_report(report, exact_.triangles.size() - dead.size());
  TriMesh& whole = result.mesh_;
  tbb::parallel_invoke([&] { support::assign_bulk(exact_.triangles, whole.triangles); },
                       [&] { support::assign_bulk(exact_.sources, result.sources_); },
                       [&] { support::assign_bulk(exact_.labels, whole.labels); });
  whole.points = std::move(rounded_.on_lattice);
  part.put(mesh, whole, result.sources_);
  const bool meets_rest = part.meets_rest(mesh, {whole.points, whole.triangles, representatives_});
  erase_at(dead, whole.triangles);
  if (meets_rest || !misplaced({whole.points, whole.triangles}, report.largest_move).empty()) {
    rounded_.on_lattice = std::move(whole.points);
    part.put_back(rounded_.on_lattice);
    return std::nullopt;
  }
  erase_at(dead, result.sources_);
  erase_at(dead, whole.labels);
  erase_points(unused, whole);
  return result;
}

double Rounding::largest_move(const EditedMesh& repaired,
                              std::span<const std::uint32_t> alive) const {
  double vertex = 0, surface = 0;
  for (std::uint32_t v = 0; v < exact_.points.size(); ++v) {
    const Vec3& place = rounded_.on_lattice[v];
    const bool is_kept = repaired.point(v) == place && repaired.reach(v) == 0;
    vertex = std::max(vertex, is_kept ? (place - doubles()[v]).norm() : repaired.reach(v));
  }
  for (const std::uint32_t f : alive) {
    surface = std::max(surface, repaired.deviation(f));
  }
  return largest_move(vertex + surface);
}

/// Of exact place to nearest double, of that to the lattice and by repair, as given; and of all
/// that was done before. The factor covers the rounding of these few sums and norms.
double Rounding::largest_move(double from_doubles) const {
  const double rounding = rounded_.any_inexact ? std::sqrt(0.75) * double_step_ : 0;
  return (from_doubles + rounding + past_.distance()) * (1 + 0x1p-48);
}

Error Rounding::unroundable(const Vec3& at, bool is_nothing) const {
  const Eigen::AlignedBox3d box =
      options_.whole ? options_.whole->box : boxes::bounds_of(doubles());
  return unroundable_error(
      {.at = at + origin_ + past_.origin,
       .tolerance = tolerance_,
       .coordinates = coordinates_,
       .is_far = box.sizes().maxCoeff() < rounded_.largest,
       .is_on_output_grid = options_.output_grid > 0 && step_ == options_.output_grid,
       .is_loss = would_lose_,
       .is_nothing = is_nothing,
       .do_doubles_tell = box.sizes().maxCoeff() > double_step_});
}

}  // namespace dupin::rounding

namespace dupin {

Rounded to_mesh(const Solid& solid, Coordinates coordinates, const RoundingOptions& options) {
  const UsualArithmetic usual;
  rounding::validate(options);
  try {
    return rounding::Rounding(solid.exact(), coordinates, options).run_with_warnings();
  } catch (const Error& error) {
    if (error.code() != Errc::unroundable || !options.tries_remedies) {
      throw;
    }
    throw with_remedies_tried(error, {&solid, 1}, coordinates, options,
                              [&](const RoundingOptions& tried) {
                                return rounding::does_round([&] {
                                  static_cast<void>(to_mesh(solid, coordinates, tried));
                                  return true;
                                });
                              });
  }
}

Error with_remedies_tried(const Error& error, std::span<const Solid> solids,
                          Coordinates coordinates, const RoundingOptions& options,
                          const std::function<bool(const RoundingOptions&)>& would_do) {
  const UsualArithmetic arithmetic;
  double usual = 0;
  for (const Solid& solid : solids) {
    usual =
        std::max(usual, rounding::Rounding(solid.exact(), coordinates, options).usual_tolerance());
  }
  RoundingOptions tried = options;
  tried.tries_remedies = false;
  return rounding::with_remedies_tried(error, tried, usual, would_do);
}

}  // namespace dupin
