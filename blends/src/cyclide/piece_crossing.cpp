#include "cyclide/piece_crossing.h"

#include <algorithm>
#include <cmath>

#include "cyclide/arc_bounds.h"
#include "dupin/blends/cyclide_form.h"
#include "ringed/nearest_in_disc.h"

namespace dupin::cyclide {
namespace {

using Discs = std::vector<Ring>;

// A longer piece than this many of its radii is looked at in coarser steps.
constexpr double kMostDiscs = 48;

Discs discs_of(const PeArc& arc) {
  const double wanted = std::ceil(2 * pe_length(arc) / least_radius(arc));
  const int count = int(std::clamp(wanted, 8.0, kMostDiscs));
  Discs discs;
  for (int i = 0; i <= count; ++i) {
    discs.push_back(circle_at(arc, parameter_at(arc, double(i) / count)));
  }
  return discs;
}

// A diameter of the neighbour, in travel direction, that ends or begins in the ring.
Discs discs_beyond(const Ring& ring, bool is_before) {
  Discs discs;
  for (int i = 0; i <= 4; ++i) {
    const double way = ring.radius * (is_before ? i - 4 : i) / 2;
    discs.push_back({ring.center + way * ring.normal, ring.normal,
                     std::max(0.0, ring.radius + way * ring.slope)});
  }
  return discs;
}

// Whether a disc of `others` reaches between two of `discs`, with its point nearest to the first.
bool reaches_into(const Discs& discs, const Discs& others) {
  constexpr double kDeep = 1.0 / 16;
  for (std::size_t i = 0; i + 1 < discs.size(); ++i) {
    const Ring &disc = discs[i], &next = discs[i + 1];
    const double depth = kDeep * (next.center - disc.center).norm();
    const double reach = disc.radius + (next.center - disc.center).norm();
    for (const Ring& other : others) {
      const double apart = reach + other.radius;
      if ((other.center - disc.center).squaredNorm() > apart * apart) {
        continue;
      }
      const Vec3 point = ringed::nearest_in_disc(other, disc.center), chord = point - disc.center;
      const double ahead = chord.dot(disc.normal);
      const double aside = (chord - ahead * disc.normal).norm();
      if (ahead > depth && (point - next.center).dot(next.normal) < -depth &&
          aside < (1 - kDeep) * disc.radius) {
        return true;
      }
    }
  }
  return false;
}

bool cross(const Discs& a, const Discs& b) { return reaches_into(a, b) || reaches_into(b, a); }

}  // namespace

bool pieces_cross(const std::vector<PeArc>& pieces, const Ring& start, const Ring& end) {
  std::vector<Discs> all{discs_beyond(start, true)};
  for (const PeArc& piece : pieces) {
    all.push_back(discs_of(piece));
  }
  all.push_back(discs_beyond(end, false));
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const bool are_neighbours = i == 0 && j + 1 == all.size();  // not the pieces' fault
      if (!are_neighbours && cross(all[i], all[j])) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace dupin::cyclide
