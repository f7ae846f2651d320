#include "tiles/district_output.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "dupin/io/streamed_format.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "exit_code.h"

namespace dupin::cli {
namespace {

/// Of the standard tolerance of rounding, 1024 spacings of the numbers of a file at the largest
/// coordinate, and half a spacing more.
constexpr double kMostSpacings = 1025;

}  // namespace

DistrictMargin district_margin(const Destination& to, const RoundingOptions& rounding,
                               const ContactChoice& contacts) {
  const double digits = to.format.coordinates == Coordinates::binary32 ? 23 : 52;
  const double relative =
      rounding.tolerance > 0 ? std::exp2(-digits) : kMostSpacings * std::exp2(-digits);
  // Numbers are as large as they are seen from the origin.
  const double origin = rounding.origin.choice == Origin::Choice::given
                            ? rounding.origin.place.cwiseAbs().maxCoeff()
                            : 0;
  return {rounding.tolerance + kMostSpacings * rounding.output_grid + contacts.length +
              relative * origin,
          relative};
}

RoundingOptions rounding_of_districts(RoundingOptions rounding, std::span<const Boxes> boxes) {
  const Eigen::AlignedBox3d all = bounds_of(boxes);
  if (boxes.size() < 2 || !all.min().allFinite() || !all.max().allFinite()) {
    return rounding;
  }
  rounding.whole = {.box = all};
  const Vec3 origin = to_mesh(Solid(), Coordinates::binary64, rounding).report().origin;
  rounding.origin = {.choice = Origin::Choice::given, .place = origin};
  const double largest = std::max((all.min() - origin).cwiseAbs().maxCoeff(),
                                  (all.max() - origin).cwiseAbs().maxCoeff());
  rounding.whole->largest = std::exp2(std::ilogb(largest));
  return rounding;
}

namespace {

Rounded rounded_districts(std::span<const Solid> solids, std::span<const Boxes> boxes,
                          const Destination& to, const RoundingOptions& rounding,
                          const ContactChoice& contacts, OutputReport& report) {
  std::vector<std::optional<Rounded>> rounded(solids.size());
  std::vector<OutputReport> reports(solids.size());
  for_each_in_parallel(rounded.size(), [&](std::size_t i) {
    rounded[i] = settled_and_rounded(solids[i], to, rounding, contacts, reports[i]);
  });
  std::vector<Rounded> all;
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    all.push_back(*std::move(rounded[i]));
    if (reports[i].settled) {
      add_settled(*std::move(reports[i].settled), report);
    }
  }
  Rounded whole = joined(all, boxes);
  require_something_left(whole.report(), whole.mesh().triangles.size(), rounding);
  require_something_left(report, whole.mesh().triangles.size());
  return whole;
}

}  // namespace

OutputReport write_districts(std::span<const Solid> solids, std::span<const Boxes> boxes,
                             const Destination& to, const RoundingOptions& rounding,
                             MeshHeader header, const ContactChoice& contacts, TriMesh* written,
                             const NormalsOf& normals) {
  OutputReport report;
  const Rounded whole = rounded_or_told_how(
      solids, to.format.coordinates, rounding_of_districts(rounding, boxes),
      [&](const RoundingOptions& options) {
        report = {};
        return rounded_districts(solids, boxes, to, rounding_of_districts(options, boxes), contacts,
                                 report);
      });
  return write_rounded(whole, to, std::move(header), std::move(report), {}, written, normals);
}

namespace {

DistrictOutput whole_output(const Solid& solid, std::span<const Boxes> boxes, std::size_t district,
                            const DistrictPlaces& places, const Destination& to,
                            const RoundingOptions& rounding, const ContactChoice& contacts,
                            std::span<const Seam> seams) {
  DistrictOutput result;
  const Rounded rounded = settled_and_rounded(solid, to, rounding, contacts, result.report);
  if (boxes.size() > 1 && !lies_in(rounded, boxes[district])) {
    throw Error(Errc::internal,
                "internal error, please report it: a district does not lie in its boxes", {},
                to.path);
  }
  OpenPiece open;
  open.report = check(rounded);
  result.voids = voids_of(rounded, open.report, district, places);
  if (!seams.empty()) {
    open = opened(rounded.mesh(), rounded.report().origin, std::move(open.report), seams);
  }
  result.report.check = std::move(open.report);
  result.sides = std::move(open.sides);
  result.report.rounding = rounded.report();
  result.report.contacts = rounded.contacts();
  result.piece = mesh_piece(rounded, to.format, to.path);
  if (!seams.empty()) {
    std::vector<std::string> names;
    std::ranges::transform(seams, std::back_inserter(names), &Seam::name);
    result.piece =
        without(std::move(result.piece), rounded.mesh(), to.format, open.end_faces, names);
  }
  for (const std::uint32_t label : std::set(solid.labels().begin(), solid.labels().end())) {
    result.seen.push_back(solid.names()[label]);
  }
  return result;
}

}  // namespace

DistrictOutput district_output(const Solid& solid, std::span<const Boxes> boxes,
                               std::size_t district, const DistrictPlaces& places,
                               const Destination& to, const RoundingOptions& rounding,
                               const ContactChoice& contacts, std::span<const Seam> seams) {
  try {
    return whole_output(solid, boxes, district, places, to, rounding, contacts, seams);
  } catch (const Error& error) {
    if (seams.empty() || (error.code() != Errc::unroundable && error.code() != Errc::internal)) {
      throw;
    }
  }
  return unfit_output(seams.size());
}

DistrictOutput unfit_output(std::size_t seams) {
  DistrictOutput result;
  result.report.check.emplace();
  result.sides.resize(seams);
  return result;
}

DistrictFile::DistrictFile(const Destination& to, std::vector<Vec3> places,
                           const Processes* processes)
    : to_(to),
      places_(std::move(places)),
      stream_(writing([&] { return mesh_stream(to.path, to.format, processes); })) {
  report_.check.emplace();
}

void DistrictFile::append(DistrictOutput district, std::size_t file) {
  writing([&] { stream_->append(district.piece, file); });
  seen_.insert(district.seen.begin(), district.seen.end());
  OutputReport& own = district.report;
  shells_before_.push_back(report_.check->shells.size());
  depths_.add(district.voids);
  add(*own.check, *report_.check);
  add(own.rounding, report_.rounding);
  std::ranges::move(own.contacts, std::back_inserter(report_.contacts));
  if (own.settled) {
    add_settled(*std::move(own.settled), report_);
  }
}

void DistrictFile::flush() {
  writing([&] { stream_->flush(); });
}

void DistrictFile::require_something(const RoundingOptions& rounding) const {
  require_something_left(report_.rounding, report_.check->triangles, rounding);
  require_something_left(report_, report_.check->triangles);
}

void DistrictFile::deepen_shells() {
  std::vector<ShellReport>& shells = report_.check->shells;
  shells_before_.push_back(shells.size());
  for (std::size_t i = 0; i < places_.size() && i + 1 < shells_before_.size(); ++i) {
    const int depth = depths_.at(places_[i]);
    for (std::size_t k = shells_before_[i]; k < shells_before_[i + 1]; ++k) {
      shells[k].depth += depth;
    }
  }
}

OutputReport DistrictFile::commit(MeshHeader header, const NormalsOf& normals) {
  const Vec3& origin = report_.rounding.origin;
  note_origin(origin, header);
  MeshStream::Normals of_piece;
  if (normals && to_.format.has_normals) {
    of_piece = [&](const TriMesh& piece) {
      TriMesh mesh = piece;
      for (Vec3& point : mesh.points) {
        point += origin;
      }
      return normals(mesh, report_.rounding.largest_move);
    };
  }
  writing([&] { stream_->commit(header, of_piece); });
  deepen_shells();
  report_.file = to_.path;
  report_.format = to_.format.name;
  report_.verification = to_.verification;
  return std::move(report_);
}

}  // namespace dupin::cli
