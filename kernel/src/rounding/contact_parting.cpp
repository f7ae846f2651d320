#include "rounding/contact_parting.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "boxes/bounds.h"
#include "dupin/kernel/connected_components.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "mesh/coincident_points.h"
#include "mesh/exact_mesh.h"
#include "rounding/edits/edit_strategy.h"
#include "rounding/edits/edited_mesh.h"
#include "rounding/misplaced_shells.h"
#include "rounding/rounding_options.h"
#include "rounding/self_crossings.h"
#include "support/sequences.h"

namespace dupin::rounding {
namespace {

/// Edits to be tried for each reach.
constexpr std::uint64_t kTrials = 1 << 15;

/// At most so many pairs of triangles are parted: more, as of some hundred parts that share an
/// edge, find no room beside each other within reach, and took minutes of trials.
constexpr std::uint64_t kMostPairs = 1 << 17;

/// About how many pairs of triangles touch in points of theirs that are in one place.
std::uint64_t touching_pairs(const TriMesh& mesh) {
  std::vector<std::uint64_t> faces(mesh.points.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      ++faces[v];
    }
  }
  const std::vector<std::uint32_t> representatives = mesh::coincident_representatives(mesh.points);
  std::vector<std::uint64_t> before(mesh.points.size(), 0);  // of points before, in that place
  std::uint64_t pairs = 0;
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    std::uint64_t& others = before[representatives[v]];
    pairs += faces[v] * others;
    others += faces[v];
  }
  return pairs;
}

/// Of any place of the surface.
double largest_move(const EditedMesh& mesh) {
  double vertex = 0, surface = 0;
  for (std::uint32_t v = 0; v < mesh.points().size(); ++v) {
    vertex = std::max(vertex, mesh.reach(v));
  }
  for (const std::uint32_t face : mesh.alive_faces()) {
    surface = std::max(surface, mesh.deviation(face));
  }
  return vertex + surface;
}

/// A face of each shell that editing has turned inside out, or taken through another one, whole.
std::vector<std::uint32_t> misplaced_by_editing(const TriMesh& before, const EditedMesh& after,
                                                double move) {
  const auto alive = after.alive_faces();
  const auto triangles = after.triangles_of(alive);
  std::vector<std::uint32_t> faces =
      misplaced_shells({before.points, before.triangles},
                       connected_components(before.triangles, before.points.size()),
                       {after.points(), triangles}, move);
  for (std::uint32_t& face : faces) {
    face = alive[face];
  }
  return faces;
}

/// What two roundings did, the second of what the first made, less their numbers and origin, which
/// are those of the first.
RoundingReport one_after_other(RoundingReport first, const RoundingReport& second) {
  first.moved += second.moved;
  first.largest_move += second.largest_move;
  first.repair_reach = std::max(first.repair_reach, second.repair_reach);
  first.removed_triangles += second.removed_triangles;
  first.removed_shells += second.removed_shells;
  first.slit_width = std::max(first.slit_width, second.slit_width);
  for (auto [more, all] : {std::pair(&second.filled_places, &first.filled_places),
                           std::pair(&second.snapped_places, &first.snapped_places)}) {
    std::ranges::transform(*more, std::back_inserter(*all),
                           [&](const Vec3& place) -> Vec3 { return place + first.origin; });
  }
  return first;
}

}  // namespace

/// One rounded solid, edited.
class ContactParting::Attempt {
 public:
  Attempt(const Rounded& touching, const ContactParting& how)
      : touching_(touching),
        each_(support::numbers_below(whole().points.size())),
        edited_(whole().points, whole().triangles, whole().labels, each_) {
    part_touching(how);
    move_ = largest_move(edited_);
    if (edited_.faults().empty()) {
      misplaced_ = misplaced_by_editing(whole(), edited_, move_);
    }
  }

  [[nodiscard]] bool is_done() const { return edited_.faults().empty() && misplaced_.empty(); }

  /// The faults' triangles numbered as in surface().
  [[nodiscard]] std::vector<Fault> faults() const {
    return edited_.faults_among(edited_.alive_faces());
  }

  /// Of the first fault, or of a misplaced shell.
  [[nodiscard]] Vec3 place() const {
    const auto faults = edited_.faults();
    return edited_.point(edited_.triangle(faults.empty() ? misplaced_[0] : faults[0].first)[0]);
  }

  /// The solid as far as it is parted, and told.
  [[nodiscard]] Rounded surface() const {
    Rounded result;
    result.report_ = touching_.report();
    RoundingReport& report = result.report_;
    const auto alive = edited_.alive_faces();
    report.parted.insert(report.parted.end(), touching_.contacts().begin(),
                         touching_.contacts().end());
    report.parted_by += move_;
    report.largest_move += move_;
    report.removed_triangles += whole().triangles.size() - alive.size();
    for (std::uint32_t v = 0; v < whole().points.size(); ++v) {
      report.moved += edited_.faces(v).empty() || edited_.point(v) != whole().points[v] ? 1 : 0;
    }
    result.mesh_ = edited_.mesh_of(alive);
    result.mesh_.names = whole().names;
    for (const std::uint32_t face : alive) {
      result.sources_.push_back(touching_.sources()[edited_.parent(face)]);
    }
    return result;
  }

 private:
  static constexpr double kNear = 4, kFar = 16;  // steps of the lattice

  [[nodiscard]] const TriMesh& whole() const { return touching_.mesh(); }

  /// In the part of the mesh around, if that is small and what is made of it keeps clear of the
  /// rest.
  void part_touching(const ContactParting& how) {
    const std::vector<Vec3>& points = whole().points;
    const Embedding embedding{points, whole().triangles, each_};
    const auto touching = mesh::shared_places(mesh::coincident_representatives(points));
    const std::vector<Fault> faults =
        find_faults(embedding, marked_faces(whole().triangles, touching));
    const auto part =
        MeshPart::around({points, points, whole().triangles, whole().labels, each_},
                         faces_of(faults), std::min(kFar * how.step_, how.room(touching_)), 0);
    if (part) {
      EditedMesh mesh = unedited(part->view());
      mesh.add_faults(part->numbered(faults));
      mend(mesh, how);
      if (!part->meets_rest(mesh, embedding)) {
        edited_.take_over(mesh, part->faces(), part->points());
        return;
      }
    }
    edited_.add_faults(faults);
    mend(edited_, how);
  }

  void mend(EditedMesh& mesh, const ContactParting& how) const {
    for (const double reach : {kNear * how.step_, kFar * how.step_}) {
      if (!mesh.faults().empty()) {
        mend_faults(mesh, how.lattice_, std::min(reach, how.room(touching_)), {kTrials, kTrials});
      }
    }
  }

  const Rounded& touching_;
  std::vector<std::uint32_t> each_;
  EditedMesh edited_;
  double move_ = 0;
  std::vector<std::uint32_t> misplaced_;  // a face of each shell on its wrong side
};

/// Of the surface, what it winds around a positive number of times: shells that are so thin that
/// editing has turned them inside out are not. None if the rest of the tolerance does not allow it,
/// or it leaves nothing.
std::optional<Rounded> ContactParting::rounded_again(const Attempt& attempt) const {
  const Rounded surface = attempt.surface();
  const RoundingReport& before = surface.report();
  RoundingOptions options = options_;
  options.tolerance = room(surface);
  options.origin = {};
  if (!(options.tolerance > 0)) {
    return std::nullopt;
  }
  const auto cut = without_self_crossings(surface.mesh(), surface.sources(), attempt.faults(),
                                          step_, options.tolerance / 2);
  if (!cut) {
    return std::nullopt;
  }
  options.tolerance -= cut->lost;
  try {
    Rounded again =
        to_mesh(Solid(std::make_shared<const mesh::ExactMesh>(cut->solid)), coordinates_, options);
    for (Contact& contact : again.contacts_) {
      contact.from += before.origin;
      contact.to += before.origin;
    }
    again.report_ = one_after_other(before, again.report());
    again.report_.largest_move += cut->lost;
    again.report_.removed_shells += cut->lost_shells;
    again.report_.snapped_places.push_back(attempt.place() + before.origin);
    return again;
  } catch (const Error& error) {
    if (error.code() != Errc::unroundable) {
      throw;
    }
    return std::nullopt;
  }
}

ContactParting::ContactParting(const Rounded& touching, const RoundingOptions& options)
    : coordinates_(touching.report().coordinates),
      options_(options),
      lattice_(coordinates_, options.output_grid) {
  const auto box = boxes::bounds_of(touching.mesh().points);
  step_ = lattice_.step(std::max(box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff(),
                                 largest_of(options, touching.report().origin)));
  if (!(options.tolerance > 0)) {
    options_.tolerance = kDefaultTolerance * step_;
  }
}

std::optional<Rounded> ContactParting::run(const Rounded& touching) const {
  constexpr int kAttempts = 8;
  std::optional<Rounded> current = touching;
  for (int i = 0; i < kAttempts && current && !current->contacts().empty(); ++i) {
    if (touching_pairs(current->mesh()) > kMostPairs) {
      return std::nullopt;
    }
    const Attempt attempt(*current, *this);
    current = attempt.is_done() ? attempt.surface() : rounded_again(attempt);
  }
  return current && current->contacts().empty() ? std::move(current) : std::nullopt;
}

}  // namespace dupin::rounding

namespace dupin {

Rounded parted(Rounded touching, const RoundingOptions& options) {
  const UsualArithmetic usual;
  if (touching.contacts().empty()) {
    return touching;
  }
  auto apart = rounding::ContactParting(touching, options).run(touching);
  return apart ? *std::move(apart) : touching;
}

}  // namespace dupin
