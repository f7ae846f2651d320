#include "support/plants.h"

#include <array>
#include <cmath>
#include <deque>
#include <numbers>
#include <random>
#include <span>

#include <Eigen/Geometry>

namespace dupin::test {
namespace {

constexpr std::array<double, 8> kRadii = {16.9, 30.2, 57.2, 84.1, 109.5, 136.5, 161.9, 203.2};

/// Where a run of pipe goes on.
struct OpenEnd {
  Vec3 at, direction;
  std::size_t bore = 3;
};

/// A ring of a tube.
struct Section {
  Vec3 centre, direction;
  double radius = 0;
};

/// Rings about the sections, joined, and closed by fans. Every tube has frames of its own.
TriMesh tube_through(std::span<const Section> sections, std::uint32_t segments) {
  TriMesh mesh;
  Vec3 u = sections.front().direction.unitOrthogonal();
  for (const Section& section : sections) {
    const Vec3 axis = section.direction.normalized();
    u = (u - u.dot(axis) * axis).normalized();
    const Vec3 w = axis.cross(u);
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle = 2 * std::numbers::pi * i / segments;
      mesh.points.push_back(section.centre +
                            section.radius * (std::cos(angle) * u + std::sin(angle) * w));
    }
  }
  const auto rings = static_cast<std::uint32_t>(sections.size());
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
    const std::uint32_t low = ring * segments, high = low + segments;
    for (std::uint32_t i = 0; i < segments; ++i) {
      const std::uint32_t next = (i + 1) % segments;
      mesh.triangles.push_back({low + i, low + next, high + next});
      mesh.triangles.push_back({low + i, high + next, high + i});
    }
  }
  const std::uint32_t last = (rings - 1) * segments;
  for (std::uint32_t i = 1; i + 1 < segments; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({last, last + i, last + i + 1});
  }
  return mesh;
}

class PlantMaker {
 public:
  explicit PlantMaker(const PlantOptions& options) : options_(options), random_(options.seed) {}

  std::vector<TriMesh> make() {
    Vec3 at;
    for (double& coordinate : at) {
      coordinate = uniform(options_.least_coordinate, options_.largest_coordinate);
    }
    open_.push_back({at, some_direction(), pick(kRadii.size())});
    while (meshes_.size() < options_.components) {
      if (open_.empty()) {
        at += Vec3(uniform(-9000, 9000), uniform(-9000, 9000), uniform(-3000, 3000));
        open_.push_back({at, some_direction(), pick(kRadii.size())});
      }
      const OpenEnd end = open_.front();
      open_.pop_front();
      add_component(end);
    }
    return std::move(meshes_);
  }

 private:
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) * 0x1p-32);
  }
  std::size_t pick(std::size_t count) { return random_() % count; }

  Vec3 some_direction() {
    if (pick(4) == 0) {
      return Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-0.2, 0.2)).normalized();
    }
    Vec3 direction = Vec3::Zero();
    direction[static_cast<Eigen::Index>(pick(3))] = pick(2) == 0 ? 1 : -1;
    return direction;
  }

  /// Along an axis if the direction is, or at some angle.
  Vec3 across(const Vec3& direction) {
    const Vec3 upright = std::abs(direction.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
    const Vec3 other = upright + 0.3 * Vec3(0.3, 0.7, 0.1);
    return direction.cross(pick(2) == 0 ? upright : other).normalized();
  }

  /// The end point as this component has it, to four decimals as files do.
  Vec3 missed(const Vec3& nominal) {
    const double size = options_.least_misfit *
                        std::pow(options_.largest_misfit / options_.least_misfit, uniform(0, 1));
    Vec3 off(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    Vec3 point = nominal + size * off.normalized();
    for (double& coordinate : point) {
      coordinate = std::round(coordinate * 1e4) / 1e4;
    }
    return point;
  }

  void add(std::span<const Section> sections) {
    meshes_.push_back(tube_through(sections, options_.segments));
  }

  /// Straight from one place to another, with radii at stations along it.
  void add_straight(const Vec3& from, const Vec3& to,
                    std::span<const std::pair<double, double>> profile) {
    const Vec3 a = missed(from), b = missed(to), axis = (b - a).normalized();
    std::vector<Section> sections;
    for (const auto& [station, radius] : profile) {
      sections.push_back({a + station * (b - a), axis, radius});
    }
    add(sections);
  }

  void add_elbow(const OpenEnd& end) {
    const double radius = kRadii[end.bore], bend = 3 * radius;
    const double angle = pick(3) == 0 ? std::numbers::pi / 4 : std::numbers::pi / 2;
    const Vec3 nominal_side = across(end.direction);
    const double leg = bend * std::tan(angle / 2);
    const Vec3 corner = end.at + leg * end.direction;
    const Vec3 out = std::cos(angle) * end.direction + std::sin(angle) * nominal_side;
    const Vec3 from = missed(end.at), to = missed(corner + leg * out), middle = missed(corner);
    const Vec3 d = (middle - from).normalized(), e = (to - middle).normalized();
    const Vec3 side = (e - e.dot(d) * d).normalized();
    const double turn = std::atan2(e.dot(side), e.dot(d));
    const double own_leg = ((middle - from).norm() + (to - middle).norm()) / 2;
    const double own_bend = own_leg / std::tan(turn / 2);
    const Vec3 centre = from + own_bend * side;
    std::vector<Section> sections;
    constexpr int kPieces = 8;
    for (int i = 0; i <= kPieces; ++i) {
      const double t = turn * i / kPieces;
      sections.push_back({centre + own_bend * (std::sin(t) * d - std::cos(t) * side),
                          std::cos(t) * d + std::sin(t) * side, radius});
    }
    add(sections);
    open_.push_back({corner + leg * out, out, end.bore});
  }

  void add_tee(const OpenEnd& end) {
    const double radius = kRadii[end.bore];
    const std::size_t bore = end.bore - pick(std::min<std::size_t>(end.bore, 2) + 1);
    const Vec3 out = end.direction, side = across(out);
    const Vec3 middle = end.at + 2 * radius * out, far = end.at + 4 * radius * out;
    const Vec3 branch = middle + 2 * radius * side;
    const std::pair<double, double> run[] = {{0, radius}, {1, radius}};
    const std::pair<double, double> stub[] = {{0, kRadii[bore]}, {1, kRadii[bore]}};
    add_straight(end.at, far, run);
    add_straight(middle, branch, stub);
    open_.push_back({far, out, end.bore});
    open_.push_back({branch, side, bore});
  }

  void add_component(const OpenEnd& end) {
    const double radius = kRadii[end.bore];
    const auto straight = [&](double length, std::span<const std::pair<double, double>> profile,
                              std::size_t bore) {
      const Vec3 to = end.at + length * end.direction;
      add_straight(end.at, to, profile);
      open_.push_back({to, end.direction, bore});
    };
    const std::pair<double, double> pipe[] = {{0, radius}, {1, radius}};
    switch (pick(10)) {
      case 0:
      case 1:
      case 2:
        return add_elbow(end);
      case 3:
        return add_tee(end);
      case 4: {
        const std::size_t bore = end.bore == 0 ? 1 : end.bore - 1;
        const std::pair<double, double> reducer[] = {{0, radius}, {1, kRadii[bore]}};
        return straight(3 * radius, reducer, bore);
      }
      case 5: {
        const std::pair<double, double> flange[] = {{0, 1.7 * radius}, {1, 1.7 * radius}};
        return straight(0.4 * radius, flange, end.bore);
      }
      case 6: {
        const std::pair<double, double> valve[] = {
            {0, 1.5 * radius}, {0.5, 0.4 * radius}, {1, 1.5 * radius}};
        return straight(4 * radius, valve, end.bore);
      }
      case 7:
        if (pick(3) == 0 && !open_.empty()) {
          return add_straight(end.at, end.at + 2 * radius * end.direction, pipe);  // the end of it
        }
        [[fallthrough]];
      default:
        return straight(uniform(3, 40) * radius, pipe, end.bore);
    }
  }

  const PlantOptions& options_;
  std::mt19937 random_;
  std::deque<OpenEnd> open_;
  std::vector<TriMesh> meshes_;
};

}  // namespace

std::vector<TriMesh> plant(const PlantOptions& options) { return PlantMaker(options).make(); }

}  // namespace dupin::test
