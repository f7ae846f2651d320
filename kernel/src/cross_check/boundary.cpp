#include "cross_check/boundary.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "exact/exact_numbers.h"
#include "mesh/exact_mesh.h"

namespace dupin::cross_check {
namespace {

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

RationalPoint cross(const RationalPoint& a, const RationalPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

mpq_class dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The integers without a common divisor that are in proportion to the numbers, the first of them
// that is not zero positive.
template <std::size_t kCount>
std::array<mpz_class, kCount> primitive(const std::array<mpq_class, kCount>& numbers) {
  mpz_class denominator = 1, divisor = 0;
  for (const mpq_class& number : numbers) {
    denominator = lcm(denominator, number.get_den());
  }
  std::array<mpz_class, kCount> integers;
  for (std::size_t i = 0; i < kCount; ++i) {
    integers[i] = numbers[i].get_num() * (denominator / numbers[i].get_den());
    divisor = gcd(divisor, integers[i]);
  }
  const auto first = std::ranges::find_if(integers, [](const mpz_class& x) { return x != 0; });
  if (first != integers.end() && *first < 0) {
    divisor = -divisor;
  }
  if (divisor != 0) {
    for (mpz_class& integer : integers) {
      mpz_divexact(integer.get_mpz_t(), integer.get_mpz_t(), divisor.get_mpz_t());
    }
  }
  return integers;
}

using Plane = std::array<mpz_class, 4>;
using Line = std::array<mpz_class, 6>;

// a x + b y + c z = d.
Plane plane_of(const Boundary& boundary, std::span<const DirectedEdge> facet) {
  const RationalPoint& apex = boundary.points[facet.front()[0]];
  for (const auto& [from, to] : facet) {
    const RationalPoint normal =
        cross(minus(boundary.points[from], apex), minus(boundary.points[to], apex));
    if (std::ranges::any_of(normal, [](const mpq_class& x) { return x != 0; })) {
      return primitive<4>({normal[0], normal[1], normal[2], dot(normal, apex)});
    }
  }
  return {};  // a facet without area has no boundary either: all its edges are on one line
}

// Plücker's coordinates.
Line line_through(const RationalPoint& a, const RationalPoint& b) {
  const RationalPoint direction = minus(b, a), moment = cross(a, b);
  return primitive<6>({direction[0], direction[1], direction[2], moment[0], moment[1], moment[2]});
}

// The facets of both boundaries as one chain on common points.
class Chain {
 public:
  Chain(const Boundary& a, const Boundary& b) : boundaries_{&a, &b}, points_{number(a, b)} {
    add(0, 1);
    add(1, -1);
  }

  [[nodiscard]] const RationalPoint* corner() const {
    // By line and plane; a point's number is its rank.
    std::map<std::pair<Line, std::uint32_t>, std::map<std::uint32_t, int>> jumps;
    for (const auto& [key, count] : edges_) {
      const auto [plane, low, high] = key;
      if (count != 0) {
        auto& on_line = jumps[{line_through(*places_[low], *places_[high]), plane}];
        on_line[high] += count;
        on_line[low] -= count;
      }
    }
    const RationalPoint* first = nullptr;
    for (const auto& [line, counts] : jumps) {
      for (const auto& [point, count] : counts) {
        if (count != 0 && (first == nullptr || *places_[point] < *first)) {
          first = places_[point];
        }
      }
    }
    return first;
  }

 private:
  using Numbers = std::array<std::vector<std::uint32_t>, 2>;
  struct EdgeInPlane {
    std::uint32_t plane, low, high;
    auto operator<=>(const EdgeInPlane&) const = default;
  };

  // The same for the same place.
  Numbers number(const Boundary& a, const Boundary& b) {
    std::vector<const RationalPoint*> sorted;
    for (const Boundary* boundary : {&a, &b}) {
      for (const RationalPoint& point : boundary->points) {
        sorted.push_back(&point);
      }
    }
    std::vector<std::uint32_t> order(sorted.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto place = [&](std::uint32_t i) -> const RationalPoint& { return *sorted[i]; };
    std::ranges::sort(order, {}, place);
    Numbers numbers{std::vector<std::uint32_t>(a.points.size()),
                    std::vector<std::uint32_t>(b.points.size())};
    for (const std::uint32_t i : order) {
      if (places_.empty() || *places_.back() != place(i)) {
        places_.push_back(sorted[i]);
      }
      const bool of_a = i < a.points.size();
      numbers[of_a ? 0 : 1][of_a ? i : i - a.points.size()] =
          static_cast<std::uint32_t>(places_.size() - 1);
    }
    return numbers;
  }

  void add(std::size_t side, int sign) {
    const Boundary& boundary = *boundaries_[side];
    for (const std::vector<DirectedEdge>& facet : boundary.facets) {
      const auto [entry, is_new] = planes_.try_emplace(plane_of(boundary, facet),
                                                       static_cast<std::uint32_t>(planes_.size()));
      for (const auto& [from, to] : facet) {
        const std::uint32_t start = points_[side][from], end = points_[side][to];
        edges_[{entry->second, std::min(start, end), std::max(start, end)}] +=
            start < end ? sign : -sign;
      }
    }
  }

  std::array<const Boundary*, 2> boundaries_;
  std::vector<const RationalPoint*> places_;  // by number, ascending
  Numbers points_;
  std::map<Plane, std::uint32_t> planes_;
  std::map<EdgeInPlane, int> edges_;  // how often more from low to high than back
};

// numerator / denominator, not in lowest terms.
struct Fraction {
  mpz_class numerator = 0, denominator = 1;
};

Fraction sum(std::span<const mpq_class> terms) {
  if (terms.size() <= 1) {
    return terms.empty() ? Fraction() : Fraction{terms[0].get_num(), terms[0].get_den()};
  }
  const Fraction left = sum(terms.first(terms.size() / 2));
  const Fraction right = sum(terms.subspan(terms.size() / 2));
  if (left.denominator == right.denominator) {
    return {left.numerator + right.numerator, left.denominator};
  }
  return {left.numerator * right.denominator + right.numerator * left.denominator,
          left.denominator * right.denominator};
}

}  // namespace

Boundary boundary_of(const mesh::ExactMesh& mesh) {
  const mesh::MeshView view(mesh);
  Boundary boundary;
  boundary.points.reserve(mesh.points.size());
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    const mesh::ExactPoint point = view.exact(i);
    const mpq_class weight = exact::rational(point[3]);
    boundary.points.push_back({exact::rational(point[0]) / weight,
                               exact::rational(point[1]) / weight,
                               exact::rational(point[2]) / weight});
  }
  boundary.facets.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    boundary.facets.push_back({{t[0], t[1]}, {t[1], t[2]}, {t[2], t[0]}});
  }
  return boundary;
}

mpq_class volume(const Boundary& boundary) {
  std::vector<mpq_class> six;  // times the volumes of pyramids with their tips in the origin
  six.reserve(boundary.facets.size());
  for (const std::vector<DirectedEdge>& facet : boundary.facets) {
    mpq_class& term = six.emplace_back();
    const RationalPoint& apex = boundary.points[facet.front()[0]];
    for (const auto& [from, to] : facet) {
      term += dot(apex, cross(boundary.points[from], boundary.points[to]));
    }
  }
  const Fraction total = sum(six);
  mpq_class value(total.numerator, total.denominator);
  value.canonicalize();
  return value / 6;
}

std::optional<RationalPoint> corner_of_difference(const Boundary& a, const Boundary& b) {
  const Chain chain(a, b);
  const RationalPoint* corner = chain.corner();
  return corner == nullptr ? std::nullopt : std::optional(*corner);
}

}  // namespace dupin::cross_check
