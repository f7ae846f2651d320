#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "dupin/kernel/check.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/repair.h"
#include "dupin/kernel/rounding.h"
#include "support/shapes.h"

// Closed soups that are anything but solids, with the volume of what they wind around known before
// they were spoilt.
namespace dupin {
namespace {

using test::box;
using test::joined;

using Random = std::mt19937;

std::uint32_t below(Random& random, std::size_t count) {
  return static_cast<std::uint32_t>(random() % count);
}

mpq_class six_volumes(const TriMesh& mesh) {
  mpq_class sum;
  for (const Triangle& t : mesh.triangles) {
    std::array<std::array<mpq_class, 3>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        p[i][k] = mesh.points[t[i]][static_cast<Eigen::Index>(k)];
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      sum += p[0][k] * (p[1][l] * p[2][m] - p[1][m] * p[2][l]);
    }
  }
  return sum;
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

std::uint32_t added(TriMesh& mesh, const Vec3& point) {
  mesh.points.push_back(point);
  return static_cast<std::uint32_t>(mesh.points.size() - 1);
}

// A point of the segment that doubles hold exactly; coordinates are small multiples of 2^-20.
Vec3 between(const Vec3& a, const Vec3& b, int i, int n) { return a + (b - a) * i / n; }

// Divides one side of an edge at up to some hundred points, and bridges the crack with faces
// without area: a fan from one end, or pairs that meet in the middle, halved again and again.
void add_fan(TriMesh& mesh, std::size_t face, Random& random) {
  const Triangle t = mesh.triangles[face];
  const std::size_t k = random() % 3;
  const std::uint32_t from = t[k], to = t[(k + 1) % 3], apex = t[(k + 2) % 3];
  const int pieces = 1 << (1 + random() % 8);  // up to 256, so that points stay on the line
  std::vector<std::uint32_t> line{from};
  for (int i = 1; i < pieces; ++i) {
    line.push_back(added(mesh, between(mesh.points[from], mesh.points[to], i, pieces)));
  }
  line.push_back(to);
  mesh.triangles[face] = {line[0], line[1], apex};
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    mesh.triangles.push_back({line[i], line[i + 1], apex});
  }
  if (random() % 2 == 0) {  // a fan
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      mesh.triangles.push_back({from, line[i + 1], line[i]});
    }
    return;
  }
  for (std::size_t step = 1; 2 * step < line.size(); step *= 2) {
    for (std::size_t i = 0; i + 2 * step < line.size(); i += 2 * step) {
      mesh.triangles.push_back({line[i], line[i + 2 * step], line[i + step]});
    }
  }
}

// A face becomes three, around a point in it; two of those that result have the face's plane only.
void add_sliver(TriMesh& mesh, std::size_t face, Random& random) {
  const Triangle t = mesh.triangles[face];
  const Vec3 middle = between(mesh.points[t[0]], mesh.points[t[1]], 1, 2);
  const std::uint32_t p =
      added(mesh, between(middle, mesh.points[t[2]], 1, 1 << (1 + random() % 16)));
  mesh.triangles[face] = {t[0], t[1], p};
  mesh.triangles.push_back({t[1], t[2], p});
  mesh.triangles.push_back({t[2], t[0], p});
}

// A spike without volume: a face goes out and back. Then points collapse.
void add_collapsed(TriMesh& mesh, std::size_t face, Random& random) {
  const Triangle t = mesh.triangles[face];
  const std::uint32_t p = added(mesh, mesh.points[t[random() % 3]]);
  mesh.triangles[face] = {t[0], t[1], p};
  mesh.triangles.push_back({t[1], t[2], p});
  mesh.triangles.push_back({t[2], t[0], p});
}

TriMesh unwelded(const TriMesh& mesh) {
  TriMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t corner : t) {
      soup.points.push_back(mesh.points[corner]);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

// Blocks of a grid, some side by side, and their number: no two cover each other.
TriMesh blocks(Random& random) {
  std::set<std::array<int, 3>> places;
  for (std::uint32_t n = 1 + below(random, 3); n > 0; --n) {
    places.insert({static_cast<int>(below(random, 3)), static_cast<int>(below(random, 3)), 0});
  }
  std::vector<TriMesh> all;
  for (const auto& [x, y, z] : places) {
    const Vec3 low(16 * x, 16 * y, 16 * z);
    all.push_back(box(low, low + Vec3(16, 16, 16)));
  }
  return joined(all);
}

struct Soup {
  TriMesh mesh;
  mpq_class six_volumes;
};

Soup spoilt(Random& random) {
  Soup soup{blocks(random), 0};
  TriMesh& mesh = soup.mesh;
  soup.six_volumes = six_volumes(mesh);
  for (std::uint32_t n = below(random, 5); n > 0; --n) {
    const std::size_t face = random() % mesh.triangles.size();
    switch (random() % 3) {
      case 0:
        add_fan(mesh, face, random);
        break;
      case 1:
        add_sliver(mesh, face, random);
        break;
      default:
        add_collapsed(mesh, face, random);
    }
  }
  EXPECT_EQ(six_volumes(mesh), soup.six_volumes);
  const std::size_t whole = mesh.triangles.size();
  const bool is_single = soup.six_volumes == 6 * 16 * 16 * 16;
  for (std::uint32_t n = below(random, 4); n > 0; --n) {  // copies, some of them turned
    Triangle t = mesh.triangles[random() % whole];
    if (random() % 2 == 0) {
      turn(t);
    }
    mesh.triangles.push_back(t);
  }
  for (std::uint32_t n = is_single ? below(random, 3) : 0; n > 0; --n) {
    turn(mesh.triangles[random() % whole]);
  }
  if (random() % 2 == 0) {
    mesh = unwelded(mesh);
  }
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  return soup;
}

TEST(RandomSoups, closed_soups_become_the_solids_that_they_were) {
  Random random(15);
  for (int round = 0; round < 1000; ++round) {
    SCOPED_TRACE(round);
    const Soup soup = spoilt(random);
    try {
      const Solid solid = repair(soup.mesh).solid;
      EXPECT_EQ(solid.exact_volume() * 6, soup.six_volumes);
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

// A closed fan around points of one line, but for their rounding.
TriMesh nearly_flat_fan(Random& random, double scale) {
  std::uniform_real_distribution<double> number(-1, 1);
  const auto any = [&] { return Vec3(number(random), number(random), number(random)); };
  TriMesh mesh;
  mesh.points.push_back(scale * any());
  const Vec3 start = any(), way = any();
  const std::uint32_t count = 5 + below(random, 4);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double along = static_cast<double>(below(random, 16)) / 8 - 1;
    mesh.points.emplace_back(scale * (start + along * way));
  }
  for (std::uint32_t i = 1; i <= count; ++i) {
    mesh.triangles.push_back({i, i % count + 1, 0});
    if (i > 1 && i < count) {
      mesh.triangles.push_back({1, i + 1, i});
    }
  }
  return mesh;
}

// What they bound is 1e-17 times as thick as wide: exact numbers of its points leave what doubles
// hold, the sooner the smaller they are.
TEST(RandomSoups, nearly_flat_fans_end_in_solids_or_true_reasons) {
  Random random(19);
  int solids = 0;
  for (int round = 0; round < 150; ++round) {
    SCOPED_TRACE(round);
    const TriMesh mesh = nearly_flat_fan(random, round % 2 == 0 ? 1 : 1e-50);
    try {
      const Solid solid = repair(mesh).solid;
      EXPECT_TRUE(check(to_mesh(solid, Coordinates::binary64).mesh()).is_solid());
      ++solids;
    } catch (const Error& error) {
      EXPECT_NE(error.code(), Errc::internal) << error.what();
      EXPECT_EQ(error.message().find("please report"), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(solids, 50);
}

// Sums of tetrahedra over few points: faces have copies both ways, and edges many faces.
Soup tetrahedra(Random& random) {
  Soup soup;
  for (int i = 0; i < 8; ++i) {
    soup.mesh.points.emplace_back(below(random, 4), below(random, 4), below(random, 4));
  }
  for (std::uint32_t n = 1 + below(random, 5); n > 0; --n) {
    std::array<std::uint32_t, 4> p{};
    std::ranges::generate(p, [&] { return below(random, 8); });
    const TriMesh one{
        soup.mesh.points,
        {{p[0], p[2], p[1]}, {p[0], p[1], p[3]}, {p[1], p[2], p[3]}, {p[0], p[3], p[2]}},
        {},
        {}};
    const bool is_inside_out = six_volumes(one) < 0;
    for (Triangle t : one.triangles) {
      if (is_inside_out) {
        turn(t);
      }
      soup.mesh.triangles.push_back(t);
    }
  }
  return soup;
}

// How often the mesh winds around a point: signed crossings of an upright ray, whose direction and
// start meet no edge.
int winding_number(const TriMesh& mesh, const Vec3& at) {
  const Vec3 way(0.0123456789, 0.0314159265, 1);
  int winding = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.points[t[0]] - at, b = mesh.points[t[1]] - at, c = mesh.points[t[2]] - at;
    const double ab = a.cross(b).dot(way), bc = b.cross(c).dot(way), ca = c.cross(a).dot(way);
    const bool is_met = (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
    const double height = a.dot(b.cross(c)) / (ab + bc + ca);
    winding += is_met && height > 0 ? (ab > 0 ? 1 : -1) : 0;
  }
  return winding;
}

TEST(RandomSoups, sums_of_tetrahedra_are_united) {
  Random random(16);
  std::uniform_real_distribution<double> coordinate(0, 3);
  for (int round = 0; round < 1000; ++round) {
    SCOPED_TRACE(round);
    const Soup soup = tetrahedra(random);
    const Solid solid = repair(soup.mesh).solid;
    const TriMesh result{solid.nearest_points(), solid.triangles(), {}, {}};
    for (int i = 0; i < 20; ++i) {
      const Vec3 at(coordinate(random), coordinate(random), coordinate(random));
      EXPECT_EQ(winding_number(result, at) > 0, winding_number(soup.mesh, at) > 0);
    }
  }
}

TEST(RandomSoups, what_is_open_is_refused_with_its_place) {
  Random random(17);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    TriMesh mesh = box({0, 0, 0}, {16, 16, 16});
    mesh.triangles.erase(mesh.triangles.begin() + below(random, 12));
    for (std::uint32_t n = below(random, 4); n > 0; --n) {
      add_fan(mesh, random() % mesh.triangles.size(), random);
    }
    try {
      (void)repair(mesh);
      ADD_FAILURE() << "should have thrown";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::not_closed);
      EXPECT_NE(error.message().find(", which only face "), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace dupin
