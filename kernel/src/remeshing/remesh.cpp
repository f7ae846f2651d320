#include "dupin/kernel/remesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include <Eigen/Geometry>

#include "dupin/kernel/error.h"
#include "dupin/kernel/rounding.h"
#include "mesh/coincident_points.h"
#include "remeshing/poor_triangles.h"
#include "remeshing/relaxation.h"
#include "remeshing/steps.h"
#include "support/blocks.h"

namespace dupin {
namespace {

using namespace remeshing;

constexpr std::size_t kMostTriangles = 8'000'000;
/// Sizes change by so much, at most, per length.
constexpr double kGradation = 0.25;
/// Levels end when they split less than one edge for so many triangles.
constexpr std::size_t kFew = 1000;
constexpr int kLevels = 16, kIterations = 3, kImprovements = 8, kRefinements = 8;

void check_options(const RemeshOptions& options) {
  const auto refuse = [](const std::string& what) { throw Error(Errc::invalid_argument, what); };
  if (!(options.distance > 0) || !std::isfinite(options.distance)) {
    refuse("the distance of remeshing must be positive and finite");
  }
  if (!(options.largest_edge >= 0) || !std::isfinite(options.largest_edge) ||
      !(options.smallest_edge >= 0) || !std::isfinite(options.smallest_edge)) {
    refuse("lengths of edges must be 0, for a choice, or positive and finite");
  }
  if (options.largest_edge > 0 && options.smallest_edge > options.largest_edge) {
    refuse("the smallest edge must not be longer than the largest one");
  }
  if (!(options.smallest_angle >= 0 && options.smallest_angle <= M_PI / 6)) {
    refuse("the smallest angle must be between 0 and 30 degrees");
  }
  if (!(options.feature_angle > 0 && options.feature_angle < M_PI)) {
    refuse("the angle of sharp edges must be between 0 and 180 degrees");
  }
}

SizeLimits limits_of(const TriMesh& mesh, const RemeshOptions& options) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.points) {
    box.extend(point);
  }
  SizeLimits limits;
  limits.distance = options.distance;
  limits.largest = options.largest_edge > 0 ? options.largest_edge : box.diagonal().norm() / 10;
  limits.smallest = options.smallest_edge > 0 ? options.smallest_edge : options.distance;
  limits.largest = std::max(limits.largest, limits.smallest);
  return limits;
}

std::vector<std::uint8_t> contact_points(const TriMesh& mesh) {
  const auto first = mesh::coincident_representatives(mesh.points);
  std::vector<std::uint8_t> fixed(first.size(), 0);
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    if (first[v] != v) {
      fixed[v] = fixed[first[v]] = 1;
    }
  }
  return fixed;
}

class Remeshing {
 public:
  Remeshing(const Rounded& rounded, const RemeshOptions& options)
      : given_(rounded.mesh()),
        options_(options),
        limits_(limits_of(given_, options)),
        features_(find_features(given_, contact_points(given_),
                                {options.feature_angle, 2 * options.distance})),
        reference_(given_.points, given_.triangles, features_.regions),
        field_(given_, features_, limits_),
        mesh_(given_, features_),
        shop_{mesh_, features_, reference_, field_, limits_, std::sin(options.smallest_angle)} {
    double largest = 0;
    for (const Vec3& point : given_.points) {
      largest = std::max(largest, point.cwiseAbs().maxCoeff());
    }
    slack_ = largest * 0x1p-46;  // covers the rounding of a distance, tenfold
  }

  Remeshed run() {
    find_wishes();
    mesh_.grade_sizes(kGradation);
    flip_edges(shop_);
    for (int i = 0; i < kIterations; ++i) {
      iterate();
    }
    improve();
    for (int i = 0; i < kRefinements; ++i) {
      if (prove()) {
        return result();
      }
      mesh_.grade_sizes(kGradation);
      iterate();
      improve();
    }
    std::ostringstream text;
    text << "the distance of " << options_.distance << " cannot be kept near " << fault_.x() << " "
         << fault_.y() << " " << fault_.z() << "; allow more, or a smaller smallest edge";
    throw Error(Errc::unroundable, text.str());
  }

 private:
  void iterate() {
    std::size_t split = 0;
    for (int i = 0; i < kLevels; ++i) {
      collapse_short_edges(shop_);
      flip_edges(shop_);
      split = split_long_edges(shop_);
      if (mesh_.alive_count() > kMostTriangles) {
        throw Error(Errc::limit_exceeded,
                    "edges so short ask for more than 8 million triangles; allow a larger distance "
                    "or smallest edge");
      }
      if (split <= mesh_.alive_count() / kFew) {
        break;
      }
    }
    if (split > 0) {
      flip_edges(shop_);
    }
    relax_points(shop_);
    flip_edges(shop_);
    mesh_.grade_sizes(kGradation);
  }

  void improve() {
    shop_.least_sine = std::sin(options_.smallest_angle) * 1.02;
    for (int i = 0; i < kImprovements; ++i) {
      std::size_t edits = flip_edges(shop_);
      edits += widen_angles(shop_);
      edits += collapse_poor(shop_);
      edits += split_below_poor(shop_);
      if (edits == 0) {
        break;
      }
    }
  }

  /// What the places of points alone ask for.
  void find_wishes() {
    support::for_each_block(
        mesh_.point_count(),
        [&](const support::Block& block) {
          for (std::size_t i = block.begin; i < block.end; ++i) {
            find_wish(static_cast<std::uint32_t>(i));
          }
        },
        256);
  }
  void find_wish(std::uint32_t v) {
    WorkingPoint& point = mesh_.point(v);
    std::vector<std::uint32_t> regions;
    for (const std::uint32_t f : mesh_.around(v)) {
      const Face& face = mesh_.face(f);
      regions.push_back(face.region);
      const Span& span = face.spans[face.corner(v)];
      if (point.freedom == Freedom::curve && span.is_sharp()) {
        point.wish = field_.on_curve(point.place, span.curve, span.from);
      }
    }
    if (regions.empty()) {
      return;
    }
    if (point.freedom == Freedom::none) {
      point.wish = field_.at_corner(point.place, v, regions);
    } else if (point.freedom == Freedom::region) {
      point.wish = field_.in_region(point.place, regions.front());
    }
  }

  /// The distances both ways. Where one cannot be proved, shorter edges are asked for.
  bool prove() {
    std::tie(now_, numbers_) = mesh_.compact();
    std::vector<std::uint32_t> regions;
    for (const std::uint32_t f : numbers_) {
      regions.push_back(mesh_.face(f).region);
    }
    const ReferenceSurface made(now_.points, now_.triangles, regions);
    std::vector<double> there(now_.triangles.size()), back(given_.triangles.size());
    measure(reference_, now_, regions, there);
    measure(made, given_, features_.regions, back);
    deviation_ = 0;
    for (const std::vector<double>* side : {&there, &back}) {
      for (const double distance : *side) {
        deviation_ = std::max(deviation_, distance + slack_);
      }
    }
    if (deviation_ <= options_.distance) {
      return true;
    }
    for (std::size_t i = 0; i < there.size(); ++i) {
      if (there[i] + slack_ > options_.distance) {
        ask_for_less(numbers_[i]);
      }
    }
    for (std::size_t i = 0; i < back.size(); ++i) {
      if (back[i] + slack_ > options_.distance) {
        ask_near(static_cast<std::uint32_t>(i), made);
      }
    }
    return false;
  }
  void measure(const ReferenceSurface& to, const TriMesh& from,
               const std::vector<std::uint32_t>& regions, std::vector<double>& distances) const {
    support::for_each_block(
        distances.size(),
        [&](const support::Block& block) {
          for (std::size_t i = block.begin; i < block.end; ++i) {
            const auto& [a, b, c] = from.triangles[i];
            distances[i] = to.bound({from.points[a], from.points[b], from.points[c]}, regions[i],
                                    options_.distance - slack_)
                               .value_or(std::numeric_limits<double>::infinity());
          }
        },
        128);
  }
  void ask_for_less(std::uint32_t face) {
    const auto [a, b, c] = mesh_.places(mesh_.face(face).corners);
    fault_ = (a + b + c) / 3;
    for (const std::uint32_t v : mesh_.face(face).corners) {
      WorkingPoint& point = mesh_.point(v);
      point.wish = std::max(0.6 * std::min(point.wish, point.size), limits_.smallest / 8);
    }
  }
  /// Where a triangle that was given is far from those that were made.
  void ask_near(std::uint32_t given, const ReferenceSurface& made) {
    const auto& [a, b, c] = given_.triangles[given];
    const std::array<Vec3, 3> corners = {given_.points[a], given_.points[b], given_.points[c]};
    std::vector<Vec3> places = {corners[0], corners[1], corners[2]};
    constexpr int kSteps = 16;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; i + k <= kSteps; ++k) {
        places.push_back((i * corners[0] + k * corners[1] + (kSteps - i - k) * corners[2]) /
                         kSteps);
      }
    }
    for (const Vec3& place : places) {
      const auto near = made.nearest(place, features_.regions[given], Vec3::Zero(),
                                     options_.distance, 64 * options_.distance);
      if (near && near->distance > 0.9 * options_.distance) {
        ask_for_less(numbers_[near->face]);
      }
    }
  }

  Remeshed result() {
    Remeshed remeshed;
    for (const std::uint32_t f : numbers_) {
      const std::uint32_t parent = mesh_.face(f).parent;
      if (!given_.labels.empty()) {
        now_.labels.push_back(given_.labels[parent]);
      }
    }
    now_.names = given_.names;
    remeshed.solid = Solid::from(now_);
    const PoorTriangles poor(mesh_, features_, options_.smallest_angle, limits_.smallest);
    remeshed.report = poor.report();
    remeshed.report.deviation = deviation_;
    return remeshed;
  }

  const TriMesh& given_;
  RemeshOptions options_;
  SizeLimits limits_;
  Features features_;
  ReferenceSurface reference_;
  SizeField field_;
  WorkingMesh mesh_;
  Workshop shop_;
  double slack_ = 0;
  TriMesh now_;
  std::vector<std::uint32_t> numbers_;
  double deviation_ = 0;
  Vec3 fault_ = Vec3::Zero();
};

}  // namespace

Remeshed remesh(const Solid& solid, const RemeshOptions& options) {
  check_options(options);
  if (solid.empty()) {
    return {};
  }
  const Rounded rounded = to_mesh(solid);
  return Remeshing(rounded, options).run();
}

}  // namespace dupin
