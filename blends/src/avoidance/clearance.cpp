#include "avoidance/clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include <Eigen/Geometry>

#include "surfaces/pieces/surface_piece.h"

namespace dupin::avoidance {
namespace {

double size_of(const Obstacle& shape) {
  double squared = 0;
  for (const Vec3& edge : shape.edges) {
    squared += edge.squaredNorm();
  }
  return std::sqrt(squared);
}

class Prover {
 public:
  Prover(std::span<const Piece> pipe, std::span<const NamedObstacle> obstacles, double wanted)
      : pipe_(pipe), wanted_(wanted) {
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      all_.push_back({i, &obstacles[i].shape, &obstacles[i].parts, !obstacles[i].parts.empty()});
    }
  }

  Clearance run() {
    prove_all();
    return result_;
  }

  TightSpot tightest(const TightSpot& known) {
    result_.spot = known;
    is_refined_ = true;
    looked_at_ = 0;
    prove_all();
    return *result_.spot;
  }

 private:
  void prove_all() {
    for (std::size_t i = 0; i < pipe_.size(); ++i) {
      piece_ = i;
      discs_ = std::visit([](const auto& piece) { return surfaces::discs(piece); }, pipe_[i]);
      prove({0, 1}, all_, 0);
    }
  }

  // What is not to be undercut.
  [[nodiscard]] double wanted() const {
    constexpr double kPart = 1023. / 1024;
    return is_refined_ ? kPart * result_.spot->distance : wanted_;
  }

  // What is in the way, or a box that holds it.
  struct Near {
    std::size_t obstacle;
    const Obstacle* shape;
    const std::vector<ObstacleBox>* parts;
    bool is_of_mesh;
  };

  // What encloses the disc in the middle, as if it were the disc itself.
  [[nodiscard]] TravelRing disc_at(double t) const {
    const surfaces::DiscHull hull = discs_.hull({t, t});
    return {hull.middle(), hull.axis.normalized(), hull.radius.upper};
  }

  // Whether nothing of it can be a tighter spot than what was found. Where triangles are run into,
  // one of them tells.
  [[nodiscard]] bool is_settled(const Near& one, double bound) const {
    if (!result_.spot) {
      return false;
    }
    return bound >= result_.spot->distance || (one.is_of_mesh && result_.spot->distance <= 0);
  }

  // Of the obstacles that larger stretches left. Where the disc in the middle is too near to one,
  // the stretch is refuted, and no smaller one is looked at for its sake. Boxes are opened where
  // they are near, and no smaller than the stretch: of a fine mesh little is looked at.
  void prove(const ParameterInterval& t, std::vector<Near> near, int depth) {
    constexpr int kMostHalvings = 24;
    // Stretches: nothing is proved beyond. Of where it is tightest less is known then.
    const std::size_t most = is_refined_ ? 1 << 10 : 1 << 14;
    if (is_refined_ && result_.spot->distance <= 0) {
      return;
    }
    ++looked_at_;
    const bool is_last = depth == kMostHalvings || looked_at_ > most;
    const double middle = (t.from + t.to) / 2;
    const TravelRing disc = disc_at(middle);
    const surfaces::DiscHull hull = discs_.hull(t);
    std::vector<Near> left;
    while (!near.empty()) {
      const Near one = near.back();
      near.pop_back();
      const Approach found = approach(disc, *one.shape);
      const double bound = separation(hull, *one.shape, found.direction);
      if (bound >= wanted()) {
        result_.least = std::min(result_.least, bound);
      } else if (is_settled(one, bound)) {
        continue;
      } else if (!one.parts->empty() && (is_last || size_of(*one.shape) >= hull.extent())) {
        for (const ObstacleBox& part : *one.parts) {
          near.push_back({one.obstacle, &part.shape, &part.parts, true});
        }
      } else if (one.parts->empty() && (!(found.distance > wanted()) || is_last)) {
        note({piece_, one.obstacle, middle, *one.shape, found.distance, found.place});
        if (is_refined_ && !is_last) {  // a part of the stretch may be nearer
          left.push_back(one);
        }
      } else {
        left.push_back(one);
      }
    }
    if (!left.empty()) {
      const auto [first, second] = surfaces::halves(t);
      prove(first, left, depth + 1);
      prove(second, std::move(left), depth + 1);
    }
  }

  void note(const TightSpot& spot) {
    if (!result_.spot || spot.distance < result_.spot->distance) {
      result_.spot = spot;
    }
  }

  std::span<const Piece> pipe_;
  std::vector<Near> all_;
  double wanted_;
  bool is_refined_ = false;  // the tightest spot is sought, not whether there is one
  std::size_t piece_ = 0, looked_at_ = 0;
  surfaces::PieceDiscs discs_;
  Clearance result_{std::numeric_limits<double>::infinity(), {}};
};

}  // namespace

Clearance prove_clearance(std::span<const Piece> pipe, std::span<const NamedObstacle> obstacles,
                          double wanted) {
  return Prover(pipe, obstacles, wanted).run();
}

TightSpot tightest_spot(std::span<const Piece> pipe, std::span<const NamedObstacle> obstacles,
                        const TightSpot& known) {
  return Prover(pipe, obstacles, known.distance).tightest(known);
}

Clearance prove_clearance(std::span<const RingedSurface> pipe,
                          std::span<const NamedObstacle> obstacles, double wanted) {
  return prove_clearance(std::vector<Piece>(pipe.begin(), pipe.end()), obstacles, wanted);
}

}  // namespace dupin::avoidance
