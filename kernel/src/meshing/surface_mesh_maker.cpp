#include "meshing/surface_mesh_maker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "meshing/curve_points.h"
#include "meshing/edge_lengths.h"
#include "meshing/region_mesher.h"

namespace dupin::meshing {
namespace {

constexpr int kAttempts = 6;
constexpr double kLess = 0.5;

double distance_from_segment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 way = b - a;
  const double squared = way.squaredNorm();
  const double part = squared > 0 ? std::clamp((point - a).dot(way) / squared, 0.0, 1.0) : 0;
  return (a + part * way - point).norm();
}

/// Tells the caller, on its own thread, how many regions have their mesh; cancelled once, all are.
class SharedProgress {
 public:
  SharedProgress(const Progress& progress, std::size_t total)
      : progress_(progress), total_(total) {}

  [[nodiscard]] Progress callback() {
    return [this](std::string_view stage, double) {
      if (progress_ && std::this_thread::get_id() == thread_ && !stopped_) {
        const double done = static_cast<double>(done_) / static_cast<double>(total_);
        stopped_ = !progress_(stage, done);
      }
      return !stopped_;
    };
  }
  void count() { ++done_; }

 private:
  const Progress& progress_;
  std::size_t total_;
  std::thread::id thread_ = std::this_thread::get_id();
  std::atomic<std::size_t> done_{0};
  std::atomic<bool> stopped_{false};
};

class Maker {
 public:
  explicit Maker(const GivenSolid& given)
      : given_(given),
        options_(given.options()),
        regions_(regions_of(given)),
        wishes_(regions_.size()),
        balls_(regions_.size()),
        meshes_(regions_.size()),
        shares_(given.features().curves.size(), 1) {}

  SolverMesh run() {
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      place_points();
      mesh_regions();
      if (ask_for_less_of_failed(attempt)) {
        continue;
      }
      tell(options_.progress, "prove");
      if (std::optional<SolverMesh> proved = prove()) {
        return std::move(*proved);
      }
    }
    throw Error(Errc::unroundable, fault_);
  }

 private:
  /// Meshes that end at other points than before are no longer there.
  void place_points() {
    constexpr double kShare = 0.5;  // of the distance
    const EdgeLengths lengths(given_.surface(), given_.features(),
                              kShare * (options_.distance - given_.features().absorbed),
                              0.9 * given_.largest_edge());
    lengths.require_room(given_.most_points_on_curves(), EdgeLengths::Between::regions);
    points_ = points_along(given_.features(), lengths, shares_, given_.most_points_on_curves());
    require_room(points_.points.size());
    numbers_.assign(regions_.size(), {});
    for_each_in_parallel(regions_.size(), [&](std::size_t r) {
      std::vector<std::uint32_t>& numbers = numbers_[r];
      for (const std::uint32_t c : regions_[r].curves) {
        const auto& chain = points_.chains[c];
        numbers.insert(numbers.end(), chain.begin(), chain.end());
      }
      std::ranges::sort(numbers);
      numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
      CurvePoints balls;
      for (const std::uint32_t i : numbers) {
        balls.points.push_back(points_.points[i]);
      }
      for (const std::uint32_t c : regions_[r].curves) {
        std::vector<std::uint32_t> chain;
        for (const std::uint32_t i : points_.chains[c]) {
          chain.push_back(
              static_cast<std::uint32_t>(std::ranges::lower_bound(numbers, i) - numbers.begin()));
        }
        balls.chains.push_back(std::move(chain));
      }
      if (balls.points != balls_[r].points || balls.chains != balls_[r].chains) {
        meshes_[r].reset();
      }
      balls_[r] = std::move(balls);
    });
  }

  /// Of regions that have none.
  void mesh_regions() {
    std::vector<std::size_t> open;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (!meshes_[r]) {
        open.push_back(r);
      }
    }
    // Large ones first, so that none is begun when all others are done.
    std::ranges::stable_sort(open, std::greater(),
                             [&](std::size_t r) { return regions_[r].mesh.triangles.size(); });
    SharedProgress shared(options_.progress, open.size());
    const Progress progress = shared.callback();
    for_each_in_parallel(open.size(), [&](std::size_t i) {
      const std::size_t r = open[i];
      tell(progress, "mesh");
      meshes_[r] = mesh_region(regions_[r], balls_[r], given_, wishes_[r], progress);
      shared.count();
    });
    std::size_t count = points_.points.size();
    for (std::size_t r = 0; r < meshes_.size(); ++r) {
      count += meshes_[r] ? meshes_[r]->points.size() - balls_[r].points.size() : 0;
    }
    require_room(count);
  }
  void require_room(std::size_t count) const {
    if (count > options_.most_points) {
      throw too_many(options_.most_points);
    }
  }

  /// A curve between two of them gets half as long edges once: a quarter at each attempt would be
  /// a thousand times as many points after all.
  void ask_for_less(const std::vector<std::size_t>& regions) {
    std::set<std::uint32_t> curves;
    for (const std::size_t region : regions) {
      wishes_[region].share *= kLess;
      meshes_[region].reset();
      curves.insert(regions_[region].curves.begin(), regions_[region].curves.end());
    }
    for (const std::uint32_t c : curves) {
      shares_[c] *= kLess;
    }
  }
  bool ask_for_less_of_failed(int attempt) {
    std::vector<std::size_t> failed;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (!meshes_[r]) {
        fault_ = wishes_[r].fault;
        // Without curves nothing changes from the second attempt on: it would fail again.
        if (attempt > 0 && regions_[r].curves.empty()) {
          throw Error(Errc::unroundable, fault_);
        }
        wishes_[r] = {};
        failed.push_back(r);
      }
    }
    ask_for_less(failed);
    return !failed.empty();
  }

  /// All regions' meshes as one, and the region of each triangle.
  [[nodiscard]] TriMesh joined(std::vector<std::uint32_t>& regions) const {
    TriMesh skin;
    for (const CurvePoint& point : points_.points) {
      skin.points.push_back(point.place);
    }
    for (std::size_t r = 0; r < meshes_.size(); ++r) {
      const RegionMesh& mesh = *meshes_[r];
      std::vector<std::uint32_t> numbers = numbers_[r];
      for (std::size_t i = numbers.size(); i < mesh.points.size(); ++i) {
        numbers.push_back(static_cast<std::uint32_t>(skin.points.size()));
        skin.points.push_back(mesh.points[i]);
      }
      for (const auto& [a, b, c] : mesh.triangles) {
        skin.triangles.push_back({numbers[a], numbers[b], numbers[c]});
        regions.push_back(static_cast<std::uint32_t>(r));
      }
    }
    return skin;
  }

  std::optional<SolverMesh> prove() {
    std::vector<std::uint32_t> regions;
    SolverMesh result;
    TriMesh& skin = result.mesh.surface;
    skin = joined(regions);
    given_.label(skin, regions);
    try {
      result.surface = Solid::from(skin);
    } catch (const Error& error) {
      fault_ = std::string("the mesh is no solid: ") + error.what();
      constexpr std::size_t kMany = 100'000;
      const std::vector<Finding> findings = check(skin, {.limit = kMany}).findings;
      require_thickness(skin, regions, findings);
      ask_for_less_at_faults(skin, regions, findings);
      return std::nullopt;
    }
    if (!given_.hangs_together_as(result.surface)) {
      fault_ = "the mesh does not hang together as the solid does; allow less distance";
      std::vector<std::size_t> all(regions_.size());
      std::iota(all.begin(), all.end(), std::size_t{0});
      ask_for_less(all);
      return std::nullopt;
    }
    result.report = given_.report_of(skin, regions);
    for (const std::optional<RegionMesh>& mesh : meshes_) {
      result.report.deviation = std::max(result.report.deviation, mesh->deviation);
    }
    result.report.deviation += given_.slack();
    return result;
  }

  /// Notes how far sides that cross each other are apart in the solid, where that is most. Throws
  /// if what is left of the distance after all attempts would still be more, unless it is at an
  /// edge that both sides have in common, where triangles get smaller, too.
  void require_thickness(const TriMesh& skin, const std::vector<std::uint32_t>& regions,
                         const std::vector<Finding>& findings) {
    double thickness = -1;
    Vec3 thickest = Vec3::Zero();
    std::array<std::uint32_t, 2> sides{};
    for (const Finding& finding : findings) {
      for (std::size_t i = 1; is_fatal(finding.defect) && i < finding.faces.size(); ++i) {
        const std::uint32_t f = finding.faces[0], g = finding.faces[i];
        const auto& [a, b, c] = skin.triangles[f];
        const Vec3 middle = (skin.points[a] + skin.points[b] + skin.points[c]) / 3;
        const auto own = given_.surface().nearest(middle, regions[f], 2 * options_.distance);
        const auto other =
            own && regions[g] != regions[f]
                ? given_.surface().nearest(own->point, regions[g], 2 * options_.distance)
                : std::nullopt;
        if (other && other->distance > thickness) {
          thickness = other->distance;
          thickest = own->point;
          sides = {regions[f], regions[g]};
        }
      }
    }
    if (thickness > 0) {
      fault_ = given_.too_thin(thickest, thickness);
      if (thickness < options_.distance * std::pow(kLess, kAttempts - 1) &&
          !is_at_edge(thickest, sides)) {
        throw Error(Errc::unroundable, fault_);
      }
    }
  }

  [[nodiscard]] bool is_at_edge(const Vec3& place,
                                const std::array<std::uint32_t, 2>& sides) const {
    for (const Curve& curve : given_.features().curves) {
      const bool is_between =
          curve.regions == sides || curve.regions == std::array{sides[1], sides[0]};
      for (std::size_t i = 1; is_between && i < curve.points.size(); ++i) {
        if (distance_from_segment(place, curve.points[i - 1], curve.points[i]) <=
            options_.distance) {
          return true;
        }
      }
    }
    return false;
  }

  void ask_for_less_at_faults(const TriMesh& skin, const std::vector<std::uint32_t>& regions,
                              const std::vector<Finding>& findings) {
    std::vector<std::uint8_t> at_fault(regions_.size(), 0), is_bad(skin.points.size(), 0);
    for (const Finding& finding : findings) {
      if (is_fatal(finding.defect)) {
        for (const std::uint32_t f : finding.faces) {
          at_fault[regions[f]] = 1;
        }
        for (const std::uint32_t v : finding.points) {
          is_bad[v] = 1;
        }
      }
    }
    for (std::size_t f = 0; f < skin.triangles.size(); ++f) {
      if (std::ranges::any_of(skin.triangles[f], [&](std::uint32_t v) { return is_bad[v] != 0; })) {
        at_fault[regions[f]] = 1;
      }
    }
    std::vector<std::size_t> faulty;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (at_fault[r] != 0) {
        faulty.push_back(r);
      }
    }
    ask_for_less(faulty);
  }

  const GivenSolid& given_;
  const RemeshOptions& options_;
  std::vector<Region> regions_;
  std::vector<RegionWish> wishes_;
  std::vector<CurvePoints> balls_;  // per region
  std::vector<std::optional<RegionMesh>> meshes_;
  std::vector<double> shares_;  // per curve, of lengths along it
  CurvePoints points_;
  std::vector<std::vector<std::uint32_t>> numbers_;  // per region, of its balls
  std::string fault_;                                // of the last mesh that was not proved
};

}  // namespace

SolverMesh make_surface_mesh(const GivenSolid& given) { return Maker(given).run(); }

}  // namespace dupin::meshing
