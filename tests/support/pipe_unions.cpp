#include "support/pipe_unions.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>

#include "support/shapes.h"

namespace dupin::test {
namespace {

using Rotation = Eigen::Quaterniond;

/// Uniform numbers that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) * 0x1p-32;
  }

 private:
  std::mt19937 engine_;
};

Rotation any_rotation(Random& random) {
  Rotation rotation(0, 0, 0, 0);
  do {
    rotation.coeffs() = Eigen::Vector4d{random(-1, 1), random(-1, 1), random(-1, 1), random(-1, 1)};
  } while (rotation.squaredNorm() > 1 || rotation.squaredNorm() < 0.01);
  return rotation.normalized();
}

Rotation tilt(double angle) { return Rotation(Eigen::AngleAxisd(angle, Vec3::UnitX())); }

struct Cylinder {
  double radius, length, phase;  // the phase in segments
  Rotation rotation;
  Vec3 centre;
};

/// About the rotated z axis; fans about the middles of the ends.
Solid solid(const Cylinder& cylinder, std::uint32_t segments) {
  TriMesh mesh;
  const auto add = [&](const Vec3& local) {
    mesh.points.push_back(cylinder.rotation * local + cylinder.centre);
  };
  for (const double z : {-cylinder.length / 2, cylinder.length / 2}) {
    for (std::uint32_t i = 0; i < segments; ++i) {
      const double angle = 2 * std::numbers::pi * (i + cylinder.phase) / segments;
      add(Vec3(cylinder.radius * std::cos(angle), cylinder.radius * std::sin(angle), z));
    }
  }
  add(Vec3(0, 0, -cylinder.length / 2));
  add(Vec3(0, 0, cylinder.length / 2));
  const std::uint32_t low = 2 * segments, high = low + 1;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t j = (i + 1) % segments;
    mesh.triangles.push_back({i, j, segments + j});
    mesh.triangles.push_back({i, segments + j, segments + i});
    mesh.triangles.push_back({j, i, low});
    mesh.triangles.push_back({segments + i, segments + j, high});
  }
  return Solid::from(mesh);
}

std::vector<Cylinder> plant(double radius, std::uint32_t seed, Random& random) {
  const Vec3 place(238409, 81742, 606708);
  const Rotation along = any_rotation(random);
  const double branch = seed % 2 == 0 ? radius : 0.7 * radius;
  return {{radius, 6 * radius, 0, along, place},
          {branch, 6 * radius, 0.37, along * tilt(random(0.5, 1.5)),
           place + along * Vec3(0, 0, radius * random(-0.5, 0.5))}};
}

std::vector<Cylinder> cylinders(UnionKind kind, std::uint32_t seed, Random& random) {
  const Rotation along = any_rotation(random);
  const Vec3 origin = Vec3::Zero();
  switch (kind) {
    case UnionKind::equal:
      return {{1, 6, 0, along, origin}, {1, 6, 0, along * tilt(std::numbers::pi / 2), origin}};
    case UnionKind::near: {
      const double apart = std::pow(10, random(-9, -3));
      const Vec3 shift{apart * random(0, 1), apart * random(0, 1), 2.3};
      return {{1, 4, 0, along, origin},
              {1 + apart * random(-0.5, 0.5), 4, 0, along, along * shift}};
    }
    case UnionKind::rotated:
      return {{1, 6, 0, along, origin},
              {0.7, 6, 0.3, along * tilt(random(0.3, 1.5)),
               along * Vec3{random(0, 0.1), 0, random(0, 1)}}};
    case UnionKind::far: {
      const Vec3 place{random(0, 1000), random(0, 1000), random(0, 1000)};
      return {{10, 60, 0, along, place}, {10, 60, 0, along * tilt(random(0.3, 1.5)), place}};
    }
    case UnionKind::multi: {
      std::vector<Cylinder> several;
      several.reserve(4);
      for (int i = 0; i < 4; ++i) {
        several.push_back({1, 6, 0.37 * i, any_rotation(random), origin});
      }
      return several;
    }
    case UnionKind::plant_10:
      return plant(10, seed, random);
    case UnionKind::plant_84:
      return plant(84, seed, random);
  }
  return {};
}

}  // namespace

std::string_view name(UnionKind kind) {
  switch (kind) {
    case UnionKind::equal:
      return "equal";
    case UnionKind::near:
      return "near";
    case UnionKind::rotated:
      return "rotated";
    case UnionKind::far:
      return "far";
    case UnionKind::multi:
      return "multi";
    case UnionKind::plant_10:
      return "plant, r = 10";
    case UnionKind::plant_84:
      return "plant, r = 84";
  }
  return "unknown";
}

std::vector<Solid> pipes(UnionKind kind, std::uint32_t segments, std::uint32_t seed) {
  Random random(1000 * seed + segments);
  std::vector<Solid> solids;
  for (const Cylinder& cylinder : cylinders(kind, seed, random)) {
    solids.push_back(solid(cylinder, segments));
  }
  return solids;
}

std::vector<Solid> resting_pipes(int count, std::uint32_t seed, double apart) {
  const Vec3 far(1.7e6 + 0.1, 1.9e6 + 0.3, 1.2e6 + 0.7);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> off(-0.2, 0.2);
  std::vector<Solid> pipes;
  for (int i = 0; i < count; ++i) {
    TriMesh along_x = tube(30, 0, 150. * count, 32), along_y = along_x;
    const double aside = apart * i + off(random) / 2, height = -60 + off(random);
    for (Vec3& p : along_x.points) {
      p = far + Vec3(p.z(), aside + p.x(), p.y());
    }
    for (Vec3& p : along_y.points) {
      p = far + Vec3(150. * i + p.y(), p.z() - 100, height + p.x());
    }
    pipes.push_back(Solid::from(along_x));
    pipes.push_back(Solid::from(along_y));
  }
  return pipes;
}

}  // namespace dupin::test
