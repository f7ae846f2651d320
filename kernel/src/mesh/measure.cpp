#include "mesh/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <CGAL/Interval_nt.h>
#include <Eigen/Geometry>

#include "exact/exact_numbers.h"
#include "exact/exact_sum.h"
#include "mesh/ball_mesh.h"
#include "support/blocks.h"
#include "support/none.h"

namespace dupin::mesh {
namespace {

using CGAL::Mpzf;

bool has_implicit_corner(const MeshView& mesh, const Triangle& corners) {
  return *std::max_element(corners.begin(), corners.end()) >= mesh.double_count();
}

void add_determinant(exact::ExactSum& sum, const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add_product(a[i], b[j], c[k]);
    sum.add_product(-a[i], b[k], c[j]);
  }
}

// numerator / denominator, denominator > 0, not in lowest terms.
struct Fraction {
  mpz_class numerator, denominator;
};

Fraction quotient(const Mpzf& numerator, const Mpzf& denominator) {
  const mpq_class n = exact::rational(numerator), d = exact::rational(denominator);
  return {n.get_num() * d.get_den(), n.get_den() * d.get_num()};
}

// Exact points, of which faces one after another ask for the same: some are made anew each time.
class RecentPoints {
 public:
  explicit RecentPoints(const MeshView& mesh) : mesh_(mesh), entries_(kSize) {}

  [[nodiscard]] const ExactPoint& operator[](std::uint32_t index) {
    Entry& entry = entries_[index % kSize];
    if (entry.index != index) {
      entry = {index, mesh_.exact(index)};
    }
    return entry.point;
  }

 private:
  static constexpr std::size_t kSize = 64;
  struct Entry {
    std::uint32_t index = support::kNone;
    ExactPoint point;
  };
  const MeshView& mesh_;
  std::vector<Entry> entries_;
};

Fraction determinant(RecentPoints& points, const Triangle& corners) {
  const ExactPoint a = points[corners[0]], b = points[corners[1]], c = points[corners[2]];
  Mpzf value;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    value = value + a[i] * (b[j] * c[k] - b[k] * c[j]);
  }
  return quotient(value, a[3] * b[3] * c[3]);
}

double approximate_determinant(const MeshView& mesh, const Triangle& corners) {
  return mesh.points[corners[0]].dot(mesh.points[corners[1]].cross(mesh.points[corners[2]]));
}

// Balanced, so that the long numbers meet late.
Fraction sum(std::span<const Triangle> triangles, std::span<const std::uint32_t> faces,
             RecentPoints& points) {
  if (faces.empty()) {
    return {0, 1};
  }
  if (faces.size() == 1) {
    return determinant(points, triangles[faces[0]]);
  }
  const Fraction left = sum(triangles, faces.first(faces.size() / 2), points);
  const Fraction right = sum(triangles, faces.subspan(faces.size() / 2), points);
  return {left.numerator * right.denominator + right.numerator * left.denominator,
          left.denominator * right.denominator};
}

struct Bounds {
  mpq_class lower, upper;
};

// Six times the volume, in two parts: what only doubles contribute, and the rest.
class SixVolumes {
 public:
  explicit SixVolumes(const MeshView& mesh) : mesh_(mesh) {
    constexpr std::size_t kBlock = 1 << 16;
    std::vector<mpq_class> parts(support::block_count(mesh.triangles.size(), kBlock));
    support::for_each_block(
        mesh.triangles.size(),
        [&](const support::Block& block) {
          exact::ExactSum sum;
          for (std::size_t i = block.begin; i < block.end; ++i) {
            const Triangle& t = mesh.triangles[i];
            if (!has_implicit_corner(mesh, t)) {
              add_determinant(sum, mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
            }
          }
          parts[block.number] = sum.value();
        },
        kBlock);
    for (const mpq_class& part : parts) {
      doubles_ += part;
    }
    for (std::uint32_t i = 0; mesh.implicit != nullptr && i < mesh.triangles.size(); ++i) {
      if (has_implicit_corner(mesh, mesh.triangles[i])) {
        implicit_faces_.push_back(i);
      }
    }
  }

  [[nodiscard]] mpq_class exact() const {
    RecentPoints points(mesh_);
    const Fraction rest = sum(mesh_.triangles, implicit_faces_, points);
    mpq_class total(rest.numerator, rest.denominator);
    total.canonicalize();
    return total + doubles_;
  }

  // Calls decide(bounds) with ever narrower bounds, at last with equal ones, until it returns a
  // value.
  template <class Decide>
  [[nodiscard]] auto refine(Decide&& decide) const {
    if (!implicit_faces_.empty()) {
      for (int bits = 128; bits <= 2048; bits *= 2) {
        if (const auto decision = decide(bounds(bits - magnitude()))) {
          return *decision;
        }
      }
    }
    const mpq_class value = exact();
    return *decide(Bounds{value, value});
  }

 private:
  [[nodiscard]] int magnitude() const {
    double sum = 0;
    for (const std::uint32_t face : implicit_faces_) {
      sum += std::abs(approximate_determinant(mesh_, mesh_.triangles[face]));
    }
    return std::isfinite(sum) && sum > 0 ? std::ilogb(sum) : 0;
  }

  // Each determinant rounded down to a multiple of 2^-fraction_bits.
  [[nodiscard]] Bounds bounds(int fraction_bits) const {
    mpz_class sum = 0, term;
    RecentPoints points(mesh_);
    for (const std::uint32_t face : implicit_faces_) {
      Fraction value = determinant(points, mesh_.triangles[face]);
      mpz_class& scaled = fraction_bits >= 0 ? value.numerator : value.denominator;
      scaled <<= static_cast<mp_bitcnt_t>(std::abs(fraction_bits));
      mpz_fdiv_q(term.get_mpz_t(), value.numerator.get_mpz_t(), value.denominator.get_mpz_t());
      sum += term;
    }
    return {doubles_ + scaled_down(sum, fraction_bits),
            doubles_ + scaled_down(sum + implicit_faces_.size(), fraction_bits)};
  }

  [[nodiscard]] static mpq_class scaled_down(const mpz_class& value, int bits) {
    const auto shift = static_cast<mp_bitcnt_t>(std::abs(bits));
    const mpq_class whole(value);
    return bits >= 0 ? mpq_class(whole >> shift) : mpq_class(whole << shift);
  }

  MeshView mesh_;
  mpq_class doubles_;
  std::vector<std::uint32_t> implicit_faces_;
};

// The sign of the volume that closed triangles enclose, if doubles tell it; else 0. With u =
// 2^-52, which also bounds directed rounding, each of the six products of a determinant is off by
// less than 9 u of itself, all six together are at most the product of the three 1-norms, and n
// sums add less than n u. Differences and products of coordinates in range do not underflow. Of
// implicit points the nearest doubles are known: coordinates of differences are off by u of the
// largest, and a determinant by what the product of the norms grows by if each has as much more.
int quick_volume_sign(const MeshView& mesh) {
  struct Sums {
    double volume = 0, magnitude = 0, off = 0;
  };
  const Vec3 origin = mesh.points[mesh.triangles.front()[0]];
  std::vector<Sums> parts(support::block_count(mesh.triangles.size()));
  support::for_each_block(mesh.triangles.size(), [&](const support::Block& block) {
    Sums sums;
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const Vec3 &a = mesh.points[mesh.triangles[i][0]], &b = mesh.points[mesh.triangles[i][1]],
                 &c = mesh.points[mesh.triangles[i][2]];
      const Vec3 p = a - origin, u = b - a, v = c - a;
      const double of_p = p.lpNorm<1>(), of_u = u.lpNorm<1>(), of_v = v.lpNorm<1>();
      sums.volume += p.dot(u.cross(v));
      sums.magnitude += of_p * of_u * of_v;
      if (mesh.implicit != nullptr) {
        const double off =
            0x1p-50 * (origin.lpNorm<1>() + a.lpNorm<1>() + b.lpNorm<1>() + c.lpNorm<1>());
        sums.off +=
            off * (of_p * of_u + of_u * of_v + of_v * of_p + off * (of_p + of_u + of_v + off));
      }
    }
    parts[block.number] = sums;
  });
  Sums all;
  for (const Sums& part : parts) {
    all.volume += part.volume;
    all.magnitude += part.magnitude;
    all.off += part.off;
  }
  const double doubt =
      all.magnitude * (static_cast<double>(mesh.triangles.size()) + 20) * 0x1p-51 + 2 * all.off;
  return (all.volume > doubt) - (all.volume < -doubt);
}

// A sum over all triangles, by blocks that do not depend on the number of threads.
template <class Term>
double sum_of(const MeshView& mesh, const Term& term) {
  std::vector<CompensatedSum> parts(support::block_count(mesh.triangles.size()));
  support::for_each_block(mesh.triangles.size(), [&](const support::Block& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      parts[block.number].add(term(mesh.triangles[i]));
    }
  });
  CompensatedSum sum;
  for (const CompensatedSum& part : parts) {
    sum.add(part.value());
  }
  return sum.value();
}

// Twice the area by the processor's widest numbers, and a bound for what rounding does to it.
struct QuickArea {
  double doubled, error;
};

QuickArea quick_double_area(const MeshView& mesh, const Triangle& corners) {
  using Wide = Eigen::Matrix<long double, 3, 1>;
  constexpr auto kWideHalfUlp = std::numeric_limits<long double>::epsilon() / 2;
  constexpr auto kHalfUlp = std::numeric_limits<double>::epsilon() / 2;
  const Wide a = mesh.points[corners[0]].cast<long double>(),
             b = mesh.points[corners[1]].cast<long double>(),
             c = mesh.points[corners[2]].cast<long double>();
  const Wide u = b - a, v = c - a;
  const long double doubled = u.cross(v).norm();
  // Of each coordinate of u and v: rounding of the difference, and of implicit points themselves.
  const long double off =
      has_implicit_corner(mesh, corners)
          ? 2 * kHalfUlp * std::max({a.lpNorm<1>(), b.lpNorm<1>(), c.lpNorm<1>()})
          : 0;
  const long double length_u = u.lpNorm<1>(), length_v = v.lpNorm<1>();
  const long double off_u = kWideHalfUlp * length_u + 3 * off,
                    off_v = kWideHalfUlp * length_v + 3 * off;
  // More than underflow takes, also of the squares in the norm.
  constexpr double kUnderflow = 0x1p-400;
  // The cross product's own rounding is below 3 half ulps of the products, the norm's below 4 of
  // the result; factor 2 covers the second order.
  const long double error =
      2 * (length_u * off_v + length_v * off_u + off_u * off_v +
           3 * kWideHalfUlp * length_u * length_v + 4 * kWideHalfUlp * doubled);
  return {static_cast<double>(doubled),
          static_cast<double>(error + 2 * kHalfUlp * doubled) + kUnderflow};
}

// Of all areas, or of one, that rounding may take.
constexpr double kPart = 1e-13;

double exact_double_area(const MeshView& mesh, const Triangle& corners) {
  const ExactPoint a = mesh.exact(corners[0]), b = mesh.exact(corners[1]),
                   c = mesh.exact(corners[2]);
  std::array<Mpzf, 3> u, v;
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = b[i] * a[3] - a[i] * b[3];
    v[i] = c[i] * a[3] - a[i] * c[3];
  }
  Mpzf squares;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Mpzf component = u[j] * v[k] - u[k] * v[j];
    squares = squares + component * component;
  }
  const Mpzf weight = a[3] * a[3] * b[3] * c[3];
  constexpr mp_bitcnt_t kPrecision = 128;
  const mpf_class numerator(exact::rational(squares), kPrecision),
      denominator(exact::rational(weight), kPrecision);
  return mpf_class(sqrt(numerator) / denominator).get_d();
}

double careful_double_area(const MeshView& mesh, const Triangle& corners) {
  const QuickArea area = quick_double_area(mesh, corners);
  return area.error < kPart * area.doubled ? area.doubled : exact_double_area(mesh, corners);
}

}  // namespace

mpq_class exact_volume(const MeshView& mesh) { return SixVolumes(mesh).exact() / 6; }

double nearest_volume(const MeshView& mesh) {
  return SixVolumes(mesh).refine([](const Bounds& six) -> std::optional<double> {
    const double lower = exact::nearest_double(six.lower / 6),
                 upper = exact::nearest_double(six.upper / 6);
    return lower == upper ? std::optional(lower) : std::nullopt;
  });
}

int volume_sign(const MeshView& mesh) {
  if (mesh.triangles.empty()) {
    return 0;
  }
  if (const int quick = quick_volume_sign(mesh); quick != 0) {
    return quick;
  }
  if (mesh.implicit != nullptr) {
    const CGAL::Protect_FPU_rounding<true> upward;
    if (const int sign = volume_sign(BallMesh(mesh, mesh.triangles)); sign != 0) {
      return sign;
    }
  }
  return SixVolumes(mesh).refine([](const Bounds& six) -> std::optional<int> {
    const int lower = sgn(six.lower), upper = sgn(six.upper);
    return lower == upper ? std::optional(lower) : std::nullopt;
  });
}

double area(const MeshView& mesh) {
  const auto doubled = [&](const Triangle& t) { return quick_double_area(mesh, t).doubled; };
  const auto error = [&](const Triangle& t) { return quick_double_area(mesh, t).error; };
  const double quick = sum_of(mesh, doubled);
  if (sum_of(mesh, error) < kPart * quick) {
    return quick / 2;
  }
  return sum_of(mesh, [&](const Triangle& t) { return careful_double_area(mesh, t); }) / 2;
}

void AreaSum::add(const std::array<Vec3, 3>& corners) {
  if (in_block_ == support::Block::kSize) {
    add(std::exchange(block_, {}), all_);
    in_block_ = 0;
  }
  constexpr Triangle kOnly{0, 1, 2};
  const MeshView triangle(corners, {&kOnly, 1});
  const QuickArea area = quick_double_area(triangle, kOnly);
  block_.doubled.add(area.doubled);
  block_.error.add(area.error);
  block_.careful.add(careful_double_area(triangle, kOnly));
  ++in_block_;
}

double AreaSum::value() const {
  Sums sums = all_;
  if (in_block_ > 0) {
    add(block_, sums);
  }
  return (sums.error.value() < kPart * sums.doubled.value() ? sums.doubled : sums.careful).value() /
         2;
}

void AreaSum::add(const Sums& block, Sums& all) {
  all.doubled.add(block.doubled.value());
  all.error.add(block.error.value());
  all.careful.add(block.careful.value());
}

}  // namespace dupin::mesh
