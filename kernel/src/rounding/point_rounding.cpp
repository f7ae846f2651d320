#include "rounding/point_rounding.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "support/blocks.h"
#include "support/bulk_vector.h"

namespace dupin::rounding {
namespace {

int sign(double value) { return (value > 0) - (value < 0); }

/// The exact error of the rounded difference a - b [Knuth, TAOCP 2, 4.2.2].
double difference_error(double a, double b, double difference) {
  const double b_taken = a - difference, a_taken = difference + b_taken;
  return (a - a_taken) + (b_taken - b);
}

/// What many points have in common.
struct Summary {
  Vec3 largest = Vec3::Zero(), largest_on_lattice = Vec3::Zero();  // coordinates
  double squared_move = 0;

  void add(const Vec3& nearest_double, const Vec3& on_lattice) {
    largest = largest.cwiseMax(nearest_double.cwiseAbs());
    largest_on_lattice = largest_on_lattice.cwiseMax(on_lattice.cwiseAbs());
    squared_move = std::max(squared_move, (on_lattice - nearest_double).squaredNorm());
  }
  void add(const Summary& other) {
    largest = largest.cwiseMax(other.largest);
    largest_on_lattice = largest_on_lattice.cwiseMax(other.largest_on_lattice);
    squared_move = std::max(squared_move, other.squared_move);
  }
};

class Rounder {
 public:
  Rounder(const mesh::ExactMesh& mesh, const exact::FloatLattice& lattice, const Vec3& origin,
          RoundedPoints& rounded)
      : mesh_(mesh), lattice_(lattice), origin_(origin), rounded_(rounded) {}

  void round(std::size_t begin, std::size_t end) const {
    const std::size_t doubles = std::clamp<std::size_t>(mesh_.double_count(), begin, end);
    if (!rounded_.shifted.empty()) {
      for (std::size_t i = begin; i < doubles; ++i) {
        round_shifted_double(i);
      }
    } else if (lattice_.holds_doubles()) {
      for (std::size_t i = begin; i < doubles; ++i) {
        rounded_.on_lattice[i] = mesh_.points[i].array() + 0.0;
      }
    } else {
      for (std::size_t i = begin; i < doubles; ++i) {
        rounded_.on_lattice[i] = lattice_.nearest(mesh_.points[i]);
        rounded_.moved[i] = rounded_.on_lattice[i] != mesh_.points[i] ? 1 : 0;
      }
    }
    for (std::size_t i = doubles; i < end; ++i) {
      round_implicit(i);
      rounded_.inexact[i] = rounded_.moved[i] = 1;
    }
  }

 private:
  void round_shifted_double(std::size_t i) const {
    for (int k = 0; k < 3; ++k) {
      const double coordinate = mesh_.points[i][k], value = coordinate - origin_[k];
      const double error = difference_error(coordinate, origin_[k], value);
      rounded_.shifted[i][k] = value + 0.0;
      rounded_.on_lattice[i][k] = lattice_.nearest(value, [&] { return sign(error); });
      if (error != 0) {
        rounded_.inexact[i] = rounded_.moved[i] = 1;
      }
      if (rounded_.on_lattice[i][k] != value) {
        rounded_.moved[i] = 1;
      }
    }
  }

  void round_implicit(std::size_t i) const {
    std::optional<mesh::ExactPoint> known;  // seldom needed
    const auto exact = [&](int k) -> const CGAL::Mpzf& {
      if (!known) {
        known = mesh_.implicit[i - mesh_.double_count()];
      }
      return (*known)[static_cast<std::size_t>(k)];
    };
    for (int k = 0; k < 3; ++k) {
      const double value =
          origin_[k] == 0
              ? mesh_.points[i][k]
              : mesh::nearest_double(exact(k) - CGAL::Mpzf(origin_[k]) * exact(3), exact(3));
      if (!rounded_.shifted.empty()) {
        rounded_.shifted[i][k] = value + 0.0;
      }
      rounded_.on_lattice[i][k] = lattice_.nearest(value, [&] {
        return static_cast<int>(
            CGAL::sign(exact(k) - (CGAL::Mpzf(origin_[k]) + CGAL::Mpzf(value)) * exact(3)));
      });
    }
  }

  const mesh::ExactMesh& mesh_;
  const exact::FloatLattice& lattice_;
  const Vec3& origin_;
  RoundedPoints& rounded_;
};

}  // namespace

RoundedPoints round_points(const mesh::ExactMesh& mesh, const exact::FloatLattice& lattice,
                           const Vec3& origin) {
  constexpr std::size_t kBlockSize = 512;  // implicit points take long
  const std::size_t count = mesh.points.size();
  const bool is_shifted = !origin.isZero(0);
  RoundedPoints rounded;
  support::resize_bulk(rounded.shifted, is_shifted ? count : 0);
  support::resize_bulk(rounded.on_lattice, count);
  rounded.inexact.resize(count, 0);
  rounded.moved.resize(count, 0);
  const Rounder rounder(mesh, lattice, origin, rounded);
  const std::vector<Vec3>& doubles = is_shifted ? rounded.shifted : mesh.points;
  std::vector<Summary> summaries(support::block_count(count, kBlockSize));
  const auto round_block = [&](const support::Block& block) {
    rounder.round(block.begin, block.end);
    Summary summary;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      summary.add(doubles[i], rounded.on_lattice[i]);
    }
    summaries[block.number] = summary;
  };
  support::for_each_block(count, round_block, kBlockSize);
  Summary all;
  for (const Summary& of_block : summaries) {
    all.add(of_block);
  }
  rounded.any_inexact = std::ranges::find(rounded.inexact, 1) != rounded.inexact.end();
  rounded.largest = all.largest.maxCoeff();
  rounded.largest_on_lattice = all.largest_on_lattice.maxCoeff();
  rounded.largest_move = std::sqrt(all.squared_move);
  return rounded;
}

}  // namespace dupin::rounding
