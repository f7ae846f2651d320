#include "support/pipe_cases.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>

namespace dupin::test {
namespace {

using Ring = std::vector<Vec3>;
enum class End { centre, fan };

struct Shape {
  std::uint32_t segments, rows;
  double phase = 0;  // in segments
};

// Points of the axes exactly, where the angle is a quarter turn.
Ring ring(const Vec3& centre, const Vec3& u, const Vec3& w, double radius, const Shape& shape) {
  Ring points;
  for (std::uint32_t i = 0; i < shape.segments; ++i) {
    const double angle = 2 * std::numbers::pi * (i + shape.phase) / shape.segments;
    double c = std::cos(angle), s = std::sin(angle);
    if (shape.phase == 0 && 4 * i % shape.segments == 0) {
      c = std::round(c);
      s = std::round(s);
    }
    points.push_back(centre + u * (radius * c) + w * (radius * s));
  }
  return points;
}

void close(TriMesh& mesh, std::uint32_t first, std::uint32_t n, End end, const Vec3& centre,
           bool is_top) {
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.triangles.push_back(is_top ? Triangle{a, b, c} : Triangle{a, c, b});
  };
  if (end == End::fan) {
    for (std::uint32_t i = 1; i + 1 < n; ++i) {
      add(first, first + i, first + i + 1);
    }
    return;
  }
  const auto middle = static_cast<std::uint32_t>(mesh.points.size());
  mesh.points.push_back(centre);
  for (std::uint32_t i = 0; i < n; ++i) {
    add(middle, first + i, first + (i + 1) % n);
  }
}

// Rings follow each other along the axis u x w.
TriMesh loft(const std::vector<Ring>& rings, const Vec3& from, const Vec3& to, End ends) {
  TriMesh mesh;
  const auto n = static_cast<std::uint32_t>(rings[0].size());
  for (const Ring& r : rings) {
    mesh.points.insert(mesh.points.end(), r.begin(), r.end());
  }
  const auto last = static_cast<std::uint32_t>((rings.size() - 1) * n);
  for (std::uint32_t row = 0; row < last; row += n) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = row + i, b = row + (i + 1) % n;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
  }
  close(mesh, 0, n, ends, from, false);
  close(mesh, last, n, ends, to, true);
  return mesh;
}

TriMesh pipe(const Vec3& from, const Vec3& to, const Vec3& u, const Vec3& w, double radius,
             const Shape& shape) {
  std::vector<Ring> rings;
  for (std::uint32_t row = 0; row <= shape.rows; ++row) {
    const double t = static_cast<double>(row) / shape.rows;
    rings.push_back(
        ring(row == shape.rows ? to : Vec3(from + (to - from) * t), u, w, radius, shape));
  }
  return loft(rings, from, to, End::centre);
}

TriMesh pipe_z(const Vec3& from, double length, double radius, const Shape& shape) {
  return pipe(from, from + length * Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY(), radius, shape);
}
TriMesh pipe_x(const Vec3& from, double length, double radius, const Shape& shape) {
  return pipe(from, from + length * Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), radius, shape);
}
TriMesh pipe_y(const Vec3& from, double length, double radius, const Shape& shape) {
  return pipe(from, from + length * Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX(), radius, shape);
}

std::vector<TriMesh> tee(const Shape& shape) {
  return {pipe_z({0, 0, -5}, 10, 1, shape), pipe_x({0, 0, 0}, 10, 0.7, shape)};
}

// Of about so many thousand triangles, finer around than along the more there are.
std::vector<TriMesh> tee_of(int thousands) {
  const auto segments = 4 * static_cast<std::uint32_t>(std::lround(8 * std::pow(thousands, 0.6)));
  return tee({segments, 250 * static_cast<std::uint32_t>(thousands) / segments});
}

std::vector<TriMesh> header(int branches, const Shape& shape = {64, 15}) {
  std::vector<TriMesh> parts = {pipe_x({0, 0, 0}, 0.8 * branches + 1, 1, shape)};
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < branches; ++i) {
    const double angle = golden_angle * i;
    const Vec3 from(0.9 + 0.8 * i, 0, 0), along(0, std::cos(angle), std::sin(angle));
    parts.push_back(
        pipe(from, from + 3 * along, Vec3::UnitX(), along.cross(Vec3::UnitX()), 0.3, shape));
  }
  return parts;
}

std::vector<TriMesh> rack(int pipes, double lift, std::uint32_t rows) {
  const Shape shape{64, rows};
  std::vector<TriMesh> parts;
  const double length = 2 * pipes;
  parts.reserve(2 * static_cast<std::size_t>(pipes));
  for (int i = 0; i < pipes; ++i) {
    parts.push_back(pipe_x({-1, 2.0 * i, 0}, length, 0.4, shape));
  }
  for (int i = 0; i < pipes; ++i) {
    parts.push_back(pipe_y({2.0 * i, -1, lift}, length, 0.4, shape));
  }
  return parts;
}

// Equal pipes through the origin, about axes in the plane z = 0.
std::vector<TriMesh> star(int pipes) {
  const Shape shape{48, 1};
  std::vector<TriMesh> parts;
  for (int i = 0; i < pipes; ++i) {
    const double angle = std::numbers::pi * i / pipes;
    const Vec3 along(std::cos(angle), std::sin(angle), 0), across(-along[1], along[0], 0);
    parts.push_back(pipe(-3 * along, 3 * along, across, Vec3::UnitZ(), 0.4, shape));
  }
  return parts;
}

// The same about axes all over the sphere, on a spiral.
std::vector<TriMesh> star_general(int pipes) {
  const Shape shape{48, 1};
  std::vector<TriMesh> parts;
  for (int i = 0; i < pipes; ++i) {
    const double height = (i + 0.5) / pipes, radius = std::sqrt(1 - height * height);
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const Vec3 along(radius * std::cos(angle), radius * std::sin(angle), height);
    const Vec3 across = along.cross(Vec3(0.3, 0.5, -0.8)).normalized();
    parts.push_back(pipe(-3 * along, 3 * along, across, along.cross(across), 0.4, shape));
  }
  return parts;
}

// Pipes about one axis that all overlap, turned by up to 0.06; each by `step` above the one before.
std::vector<TriMesh> coaxial(int pipes, double step) {
  std::vector<TriMesh> parts;
  std::uint32_t random = 1;
  for (int i = 0; i < pipes; ++i) {
    random = random * 1664525u + 1013904223u;
    const double turn = 0.06 * random / 0x1p32;
    parts.push_back(pipe_z({0, 0, step * i}, 10, 1, {64, 1, turn * 64 / (2 * std::numbers::pi)}));
  }
  return parts;
}

// Triangular prisms about one axis with flush ends, each turned by a little more than the last: all
// of them by the angle between two sides.
std::vector<TriMesh> prismspin(int prisms) {
  std::vector<TriMesh> parts;
  for (int i = 0; i < prisms; ++i) {
    parts.push_back(pipe_z({0, 0, 0}, 1, 1, {3, 1, static_cast<double>(i) / prisms}));
  }
  return parts;
}

// Prisms over stars of 12 points about one axis with flush ends, turned likewise.
std::vector<TriMesh> gears(int prisms) {
  std::vector<TriMesh> parts;
  for (int i = 0; i < prisms; ++i) {
    TriMesh part = pipe_z({0, 0, 0}, 1, 1, {24, 1, 2.0 * i / prisms});
    for (std::size_t corner = 0; corner < 48; corner += 2) {
      part.points[corner].head<2>() *= 0.7;
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

// Two pipes of so many sides beside each other that overlap, with flush ends.
std::vector<TriMesh> flush(int sides) {
  const auto n = static_cast<std::uint32_t>(sides);
  return {pipe_z({0, 0, 0}, 10, 1, {n, 1}), pipe_z({0.7, 0, 0}, 10, 1, {n, 1, 0.3})};
}

// Equal parallel pipes in a square grid, each touching its neighbours along lines, exactly.
std::vector<TriMesh> bundle(int pipes) {
  const int columns = static_cast<int>(std::ceil(std::sqrt(pipes)));
  std::vector<TriMesh> parts;
  for (int i = 0; i < pipes; ++i) {
    parts.push_back(pipe_z({0.5 * (i % columns), 0.5 * (i / columns), 0}, 4, 0.25, {32, 1}));
  }
  return parts;
}

// Parallel pipes that do not touch, one beside the other.
std::vector<TriMesh> row(int pipes) {
  std::vector<TriMesh> parts;
  for (int i = 0; i < pipes; ++i) {
    parts.push_back(pipe_z({1.0 * i, 0, 0}, 4, 0.25, {16, 1}));
  }
  return parts;
}

// Straight pipes and bends in turn, neighbours with the same ring: bends close it in a fan, pipes
// around its centre or alike.
std::vector<TriMesh> chain(int bends, End bend_ends) {
  const Shape shape{64, 16};
  std::vector<TriMesh> parts;
  Vec3 at(0.1, 0.2, 0.3), d = Vec3(1, 0.3, 0.2).normalized();
  Vec3 u = Vec3::UnitY().cross(d).normalized(), w = d.cross(u);
  double radius = 0.5;
  Ring shared = ring(at, u, w, radius, shape);
  for (int i = 0;; ++i) {
    const Vec3 end = at + 2 * d;
    std::vector<Ring> rings = {shared};
    for (std::uint32_t row = 1; row <= shape.rows; ++row) {
      rings.push_back(ring(row == shape.rows ? end : Vec3(at + 2.0 * row / shape.rows * d), u, w,
                           radius, shape));
    }
    parts.push_back(loft(rings, at, end, End::centre));
    at = end;
    if (i == bends) {
      return parts;
    }
    const double angle = i * 2.399963;
    const Vec3 next = Vec3(1, 0.8 * std::cos(angle), 0.8 * std::sin(angle)).normalized();
    const Vec3 far = at + 1.5 * (d + next);
    const std::array<Vec3, 4> bezier = {at, at + d, far - next, far};
    const double next_radius = i % 2 == 1 ? 0.5 : 0.3;
    std::vector<Ring> bend = {rings.back()};
    for (std::uint32_t row = 1; row <= shape.rows; ++row) {
      const double s = static_cast<double>(row) / shape.rows, q = 1 - s;
      const Vec3 p = bezier[0] * (q * q * q) + bezier[1] * (3 * q * q * s) +
                     bezier[2] * (3 * q * s * s) + bezier[3] * (s * s * s);
      const Vec3 tangent =
          ((bezier[1] - bezier[0]) * (q * q) + (bezier[2] - bezier[1]) * (2 * q * s) +
           (bezier[3] - bezier[2]) * (s * s))
              .normalized();
      u = (u - tangent * u.dot(tangent)).normalized();
      w = tangent.cross(u);
      bend.push_back(ring(p, u, w, radius + (next_radius - radius) * s * s * (3 - 2 * s), shape));
    }
    parts.push_back(loft(bend, at, far, bend_ends));
    at = far;
    d = next;
    radius = next_radius;
    shared = bend.back();
  }
}

const std::map<std::string, std::function<std::vector<TriMesh>()>, std::less<>>& cases() {
  static const Shape coarse{64, 4};
  static const std::map<std::string, std::function<std::vector<TriMesh>()>, std::less<>> all{
      {"tee_n32",
       [] {
         return tee({32, 1});
       }},
      {"tee_n128",
       [] {
         return tee({128, 1});
       }},
      {"tee_n512",
       [] {
         return tee({512, 1});
       }},
      {"tee_n2048",
       [] {
         return tee({2048, 1});
       }},
      {"tee_10k",
       [] {
         return tee({128, 19});
       }},
      {"tee_100k",
       [] {
         return tee({512, 48});
       }},
      {"tee_1M",
       [] {
         return tee({2048, 121});
       }},
      {"rack_small", [] { return rack(4, 0.5, 1); }},
      {"rack_eq_small", [] { return rack(4, 0, 1); }},
      {"rack", [] { return rack(20, 0.5, 1); }},
      {"rack_fine", [] { return rack(20, 0.5, 40); }},
      {"rack_eq", [] { return rack(20, 0, 1); }},
      {"blend_1", [] { return chain(1, End::centre); }},
      {"blend_1_fan", [] { return chain(1, End::fan); }},
      {"chain_10", [] { return chain(10, End::centre); }},
      {"chain_10_fan", [] { return chain(10, End::fan); }},
      {"chain_100", [] { return chain(100, End::centre); }},
      {"chain_100_fan", [] { return chain(100, End::fan); }},
      {"coax",
       [] {
         return std::vector{pipe_z({0, 0, 0}, 4, 1, coarse), pipe_z({0, 0, 2.5}, 4.5, 1, coarse)};
       }},
      {"coax_phase",
       [] {
         return std::vector{pipe_z({0, 0, 0}, 4, 1, coarse),
                            pipe_z({0, 0, 2.5}, 4.5, 1, {64, 4, 0.5})};
       }},
      {"coax_turned",
       [] {
         return std::vector{pipe_z({0, 0, 0}, 4, 1, coarse),
                            pipe_z({0, 0, 2.5}, 4.5, 1, {64, 4, std::sqrt(0.2)})};
       }},
      {"coax_butt",
       [] {
         return std::vector{pipe_z({0, 0, 0}, 4, 1, coarse), pipe_z({0, 0, 4}, 3, 1, coarse)};
       }},
      {"same",
       [] {
         return std::vector{pipe_z({0, 0, 0}, 4, 1, coarse), pipe_z({0, 0, 0}, 4, 1, coarse)};
       }},
      {"tangent_par",
       [] {
         return std::vector{pipe_z({0, 0, 0}, 4, 1, coarse), pipe_z({1.75, 0, 1}, 4, 0.75, coarse)};
       }},
      {"tangent_perp",
       [] {
         return std::vector{pipe_z({0, 0, -2}, 4, 1, coarse),
                            pipe_y({1.75, -2, 0}, 4, 0.75, coarse)};
       }},
      {"inner_tangent",
       [] {
         return std::vector{pipe_z({0, 0, 0}, 4, 1, coarse), pipe_z({0.25, 0, 1}, 4, 0.75, coarse)};
       }},
      {"flushcap",
       [] {
         return std::vector{pipe_z({0, 0, 0}, 4, 1, coarse), pipe_x({0, 0, 3.25}, 3, 0.75, coarse)};
       }},
      {"steinmetz",
       [] {
         const Shape fine{128, 4};
         return std::vector{pipe_z({0, 0, -3}, 6, 1, fine), pipe_x({-3, 0, 0}, 6, 1, fine)};
       }},
  };
  return all;
}

// Cases of any size: FAMILY_COUNT.
const std::map<std::string, std::vector<TriMesh> (*)(int), std::less<>>& families() {
  static const std::map<std::string, std::vector<TriMesh> (*)(int), std::less<>> all{
      {"star", star},
      {"star_general", star_general},
      {"tee_thousands", tee_of},
      {"header", [](int branches) { return header(branches); }},
      {"header_coarse",
       [](int branches) {
         return header(branches, {16, 1});
       }},
      {"rack", [](int pipes) { return rack(pipes, 0.5, 1); }},
      {"rack_eq", [](int pipes) { return rack(pipes, 0, 1); }},
      {"bundle", bundle},
      {"row", row},
      {"coaxial", [](int pipes) { return coaxial(pipes, 0.05); }},
      {"coaxial_flush", [](int pipes) { return coaxial(pipes, 0); }},
      {"prismspin", prismspin},
      {"gears", gears},
      {"flush", flush}};
  return all;
}

std::vector<TriMesh> parts_of(std::string_view name) {
  if (const auto place = cases().find(name); place != cases().end()) {
    return place->second();
  }
  const std::size_t end = std::min(name.rfind('_'), name.size() - 1);
  const auto family = families().find(name.substr(0, end));
  int count = 0;
  const char* const last = name.data() + name.size();
  const auto [read, error] = std::from_chars(name.data() + end + 1, last, count);
  if (family == families().end() || error != std::errc() || read != last || count < 1) {
    throw std::out_of_range("no pipe case " + std::string(name));
  }
  return family->second(count);
}

Vec3 turned(const Vec3& p) {
  const Vec3 axis = Vec3(1, std::sqrt(2.0), std::sqrt(3.0)).normalized();
  const double angle = std::sqrt(0.7), c = std::cos(angle), s = std::sin(angle);
  return p * c + axis.cross(p) * s + axis * (axis.dot(p) * (1 - c));
}

}  // namespace

std::vector<TriMesh> pipe_case(std::string_view name) {
  constexpr std::string_view kTurned = "_rot";
  const bool is_turned = name.ends_with(kTurned);
  if (is_turned) {
    name.remove_suffix(kTurned.size());
  }
  std::vector<TriMesh> parts = parts_of(name);
  for (TriMesh& part : parts) {
    if (is_turned) {
      std::transform(part.points.begin(), part.points.end(), part.points.begin(), turned);
    }
  }
  return parts;
}

std::vector<std::string> pipe_case_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : cases()) {
    names.push_back(name);
  }
  return names;
}

}  // namespace dupin::test
