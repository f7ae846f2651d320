#include "avoidance/clearance.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include <Eigen/Geometry>

#include "surfaces/ringed_piece_operations.h"

namespace dupin::avoidance {
namespace {

class Prover {
 public:
  Prover(std::span<const RingedSurface> pipe, std::span<const NamedObstacle> obstacles,
         double wanted)
      : pipe_(pipe), obstacles_(obstacles), wanted_(wanted) {}

  Clearance run() {
    std::vector<std::size_t> all(obstacles_.size());
    std::iota(all.begin(), all.end(), 0);
    for (std::size_t i = 0; i < pipe_.size(); ++i) {
      piece_ = i;
      discs_ = surfaces::discs(pipe_[i]);
      prove({0, 1}, all, 0);
    }
    return result_;
  }

 private:
  // Of the obstacles that larger stretches left. Where the disc in the middle is too near to one,
  // the stretch is refuted, and no smaller one is looked at for its sake.
  void prove(const ParameterInterval& t, const std::vector<std::size_t>& near, int depth) {
    constexpr int kMostHalvings = 24;
    constexpr std::size_t kMost = 1 << 14;  // stretches: nothing is proved beyond
    ++looked_at_;
    const double middle = (t.from + t.to) / 2;
    const SpinePoint spine = evaluate(pipe_[piece_].spine, middle);
    const TravelRing disc{spine.position, spine.first.normalized(),
                          evaluate(pipe_[piece_].radius, middle).value};
    const surfaces::DiscHull hull = discs_.hull(t);
    std::vector<std::size_t> left;
    for (const std::size_t i : near) {
      const Obstacle& obstacle = obstacles_[i].shape;
      const Approach found = approach(disc, obstacle);
      const double bound = separation(hull, obstacle, found.direction);
      if (bound >= wanted_) {
        result_.least = std::min(result_.least, bound);
      } else if (!(found.distance > wanted_) || depth == kMostHalvings || looked_at_ > kMost) {
        note({piece_, i, middle, found.distance, found.place});
      } else {
        left.push_back(i);
      }
    }
    if (!left.empty()) {
      const auto [first, second] = surfaces::halves(t);
      prove(first, left, depth + 1);
      prove(second, left, depth + 1);
    }
  }

  void note(const TightSpot& spot) {
    if (!result_.spot || spot.distance < result_.spot->distance) {
      result_.spot = spot;
    }
  }

  std::span<const RingedSurface> pipe_;
  std::span<const NamedObstacle> obstacles_;
  double wanted_;
  std::size_t piece_ = 0, looked_at_ = 0;
  surfaces::PieceDiscs discs_;
  Clearance result_{std::numeric_limits<double>::infinity(), {}};
};

}  // namespace

Clearance prove_clearance(std::span<const RingedSurface> pipe,
                          std::span<const NamedObstacle> obstacles, double wanted) {
  return Prover(pipe, obstacles, wanted).run();
}

}  // namespace dupin::avoidance
