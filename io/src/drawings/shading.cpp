#include "drawings/shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "text/label_colour.h"

namespace dupin::drawings {
namespace {

constexpr int kFine = 3;  // points of a pixel in each direction
// Facets of a smooth surface differ by less, as a rule: those of eight segments by 45 degrees.
constexpr double kSmoothCosine = 0.7;

// A normal for each corner of each triangle: that of the facets around with like normals.
std::vector<std::array<Vec3, 3>> corner_normals(const Solid& solid) {
  const auto& points = solid.nearest_points();
  const auto& triangles = solid.triangles();
  std::vector<Vec3> areas(triangles.size());
  std::vector<std::vector<std::uint32_t>> around(points.size());
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    areas[i] = (points[b] - points[a]).cross(points[c] - points[a]);
    for (const std::uint32_t corner : triangles[i]) {
      around[corner].push_back(i);
    }
  }
  std::vector<std::array<Vec3, 3>> result(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Vec3 own = areas[i].normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 sum = Vec3::Zero();
      for (const std::uint32_t other : around[triangles[i].at(k)]) {
        sum += areas[other].normalized().dot(own) > kSmoothCosine ? areas[other] : Vec3::Zero();
      }
      result[i].at(k) = sum.norm() > 0 ? Vec3(sum.normalized()) : own;
    }
  }
  return result;
}

// Light of the sky and of a lamp at the upper left, before the picture.
Vec3 lit(const text::Colour& colour, const Vec3& normal) {
  static const Vec3 kLamp = Vec3(-0.45, 0.6, 0.66).normalized();
  static const Vec3 kHalf = (kLamp + Vec3::UnitZ()).normalized();
  const double sky = 0.42 + 0.18 * normal[1];
  const double lamp = 0.52 * std::max(0.0, normal.dot(kLamp));
  const double gloss = 0.14 * std::pow(std::max(0.0, normal.dot(kHalf)), 24);
  const Vec3 own(colour[0], colour[1], colour[2]);
  return ((sky + lamp) * own + Vec3::Constant(255 * gloss)).cwiseMin(255).cwiseMax(0);
}

class Rasteriser {
 public:
  Rasteriser(int width, int height)
      : width_(width),
        height_(height),
        nearest_(std::size_t(width) * std::size_t(height), -std::numeric_limits<float>::infinity()),
        colours_(nearest_.size(), 0) {}

  // Corners in points of the fine grid, nearness as the third coordinate; normals in the picture.
  void draw(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals,
            const text::Colour& colour) {
    const auto& [a, b, c] = corners;
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area == 0) {
      return;
    }
    const auto range = [](double low, double high, int size) {
      return std::pair(std::max(0, int(std::ceil(low - 0.5))),
                       std::min(size - 1, int(std::floor(high - 0.5))));
    };
    const auto [left, right] =
        range(std::min({a[0], b[0], c[0]}), std::max({a[0], b[0], c[0]}), width_);
    const auto [top, bottom] =
        range(std::min({a[1], b[1], c[1]}), std::max({a[1], b[1], c[1]}), height_);
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        const double u = ((px - a[0]) * (c[1] - a[1]) - (py - a[1]) * (c[0] - a[0])) / area;
        const double v = ((b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0])) / area;
        if (u < 0 || v < 0 || u + v > 1) {
          continue;
        }
        const std::size_t at = std::size_t(y) * std::size_t(width_) + std::size_t(x);
        const auto near = float(a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]));
        if (near > nearest_[at]) {
          nearest_[at] = near;
          const Vec3 normal =
              ((1 - u - v) * normals[0] + u * normals[1] + v * normals[2]).normalized();
          colours_[at] = packed(lit(colour, normal));
        }
      }
    }
  }

  // Each pixel the mean of its points.
  [[nodiscard]] Picture picture() const {
    Picture result{width_ / kFine, height_ / kFine, {}};
    result.pixels.reserve(std::size_t(result.width) * std::size_t(result.height));
    for (int y = 0; y < result.height; ++y) {
      for (int x = 0; x < result.width; ++x) {
        result.pixels.push_back(mean(x, y));
      }
    }
    return result;
  }

 private:
  static std::uint32_t packed(const Vec3& colour) {
    const auto byte = [&](int i) { return std::uint32_t(std::lround(colour[i])); };
    return 0xFF000000U | byte(0) << 16 | byte(1) << 8 | byte(2);
  }

  // With premultiplied alpha.
  [[nodiscard]] std::uint32_t mean(int x, int y) const {
    std::array<std::uint32_t, 4> sums{};
    for (int j = 0; j < kFine; ++j) {
      for (int i = 0; i < kFine; ++i) {
        const std::uint32_t one =
            colours_[std::size_t(y * kFine + j) * std::size_t(width_) + std::size_t(x * kFine + i)];
        for (std::size_t channel = 0; channel < 4; ++channel) {
          sums.at(channel) += one >> (8 * channel) & 0xFFU;
        }
      }
    }
    std::uint32_t result = 0;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      constexpr std::uint32_t kCount = kFine * kFine;
      result |= (sums.at(channel) + kCount / 2) / kCount << (8 * channel);
    }
    return result;
  }

  int width_, height_;
  std::vector<float> nearest_;
  std::vector<std::uint32_t> colours_;
};

}  // namespace

Picture shaded(const Solid& solid, const std::map<std::string, std::string>& colours,
               const View& view, const PaperSheet& sheet, double pixels_per_millimetre) {
  const int width = int(std::ceil(sheet.size[0] * pixels_per_millimetre)),
            height = int(std::ceil(sheet.size[1] * pixels_per_millimetre));
  Rasteriser raster(width * kFine, height * kFine);
  const double to_fine = pixels_per_millimetre * kFine;
  const auto normals = corner_normals(solid);
  const auto& points = solid.nearest_points();
  const std::vector<text::Colour> of_labels = text::label_colours(solid.names(), colours);
  for (std::size_t i = 0; i < solid.triangle_count(); ++i) {
    std::array<Vec3, 3> corners, own;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 seen = view(points[solid.triangles()[i].at(k)]);
      corners.at(k) = {to_fine * (sheet.origin[0] + sheet.factor * seen[0]),
                       to_fine * (sheet.origin[1] - sheet.factor * seen[1]), seen[2]};
      own.at(k) = view(normals[i].at(k));
    }
    raster.draw(corners, own,
                solid.labels().empty() ? text::label_colour(0) : of_labels.at(solid.labels()[i]));
  }
  return raster.picture();
}

}  // namespace dupin::drawings
