#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "dupin/io/volume_mesh.h"
#include "dupin/kernel/connected_components.h"
#include "dupin/kernel/error.h"
#include "volumes/gmsh_library.h"

namespace dupin {
namespace {

using volumes::GmshLibrary;

constexpr int kTriangle = 2, kTetrahedron = 4;  // gmsh's types of elements

/// A connected piece of the surface.
struct Shell {
  std::vector<std::uint32_t> triangles;
  double volume = 0;                 ///< negative around a void
  std::vector<std::size_t> voids{};  ///< that lie in it
};

/// How often a closed surface winds around a point.
double winding(const TriMesh& mesh, const Shell& shell, const Vec3& point) {
  double sum = 0;
  for (const std::uint32_t f : shell.triangles) {
    const auto& [i, k, l] = mesh.triangles[f];
    const Vec3 a = mesh.points[i] - point, b = mesh.points[k] - point, c = mesh.points[l] - point;
    const double p = a.norm(), q = b.norm(), r = c.norm();
    sum +=
        2 * std::atan2(a.cross(b).dot(c), p * q * r + a.dot(b) * r + b.dot(c) * p + c.dot(a) * q);
  }
  return sum / (4 * std::numbers::pi);
}

/// The shells, and which voids are whose.
std::vector<Shell> shells_of(const TriMesh& mesh) {
  const std::vector<std::uint32_t> component =
      connected_components(mesh.triangles, mesh.points.size());
  std::vector<Shell> shells;
  std::vector<std::size_t> number(mesh.points.size(), std::numeric_limits<std::size_t>::max());
  for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
    const auto& [a, b, c] = mesh.triangles[f];
    std::size_t& shell = number[component[a]];
    if (shell == std::numeric_limits<std::size_t>::max()) {
      shell = shells.size();
      shells.emplace_back();
    }
    shells[shell].triangles.push_back(f);
    const Vec3& origin = mesh.points[mesh.triangles[shells[shell].triangles.front()][0]];
    shells[shell].volume +=
        (mesh.points[a] - origin).cross(mesh.points[b] - origin).dot(mesh.points[c] - origin);
  }
  for (std::size_t i = 0; i < shells.size(); ++i) {
    Shell* around = nullptr;
    const Vec3& place = mesh.points[mesh.triangles[shells[i].triangles.front()][0]];
    for (Shell& shell : shells) {
      if (shells[i].volume < 0 && shell.volume > 0 &&
          (around == nullptr || shell.volume < around->volume) &&
          winding(mesh, shell, place) > 0.5) {
        around = &shell;
      }
    }
    if (around != nullptr) {
      around->voids.push_back(i);
    }
  }
  return shells;
}

/// A model of gmsh's, while there is one.
class Session {
 public:
  explicit Session(const GmshLibrary& library) : gmsh_(library) {
    gmsh_.initialize(0, nullptr, 0, &fault_);
    for (const auto& [name, value] :
         {std::pair("General.Terminal", 0.0), std::pair("General.NumThreads", 1.0),
          std::pair("Mesh.Algorithm3D", 1.0), std::pair("Mesh.Optimize", 1.0),
          std::pair("Mesh.OptimizeNetgen", 0.0)}) {
      gmsh_.set_number(name, value, &fault_);
    }
    gmsh_.start_log(&fault_);
    gmsh_.add_model("solid", &fault_);
  }
  ~Session() { gmsh_.finalize(&fault_); }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// All points of the surface, in one entity with its first triangles.
  void add_surface(int tag, const TriMesh& mesh, const std::vector<std::uint32_t>& triangles) {
    call([&](int* fault) { gmsh_.add_discrete_entity(2, tag, nullptr, 0, fault); });
    if (tag == 1) {
      std::vector<std::size_t> tags(mesh.points.size());
      std::vector<double> places;
      for (std::size_t i = 0; i < tags.size(); ++i) {
        tags[i] = i + 1;
        places.insert(places.end(), mesh.points[i].data(), mesh.points[i].data() + 3);
      }
      call([&](int* fault) {
        gmsh_.add_nodes(2, tag, tags.data(), tags.size(), places.data(), places.size(), nullptr, 0,
                        fault);
      });
    }
    std::vector<std::size_t> tags, corners;
    for (const std::uint32_t f : triangles) {
      tags.push_back(f + 1);
      for (const std::uint32_t v : mesh.triangles[f]) {
        corners.push_back(v + 1);
      }
    }
    call([&](int* fault) {
      gmsh_.add_elements(tag, kTriangle, tags.data(), tags.size(), corners.data(), corners.size(),
                         fault);
    });
  }

  /// A volume within the first surface and outside of the others.
  void add_volume(std::vector<int> surfaces) {
    std::vector<int> loops;
    for (int& surface : surfaces) {
      call([&](int* fault) { loops.push_back(gmsh_.add_surface_loop(&surface, 1, -1, fault)); });
    }
    call([&](int* fault) { gmsh_.add_volume(loops.data(), loops.size(), -1, fault); });
  }

  void generate() {
    call([&](int* fault) { gmsh_.synchronize(fault); });
    call([&](int* fault) { gmsh_.generate(3, fault); });
  }

  void read(VolumeMesh& mesh) {
    std::size_t *tags = nullptr, *nodes = nullptr, count = 0, node_count = 0, none = 0;
    double *places = nullptr, *parameters = nullptr;
    std::size_t places_count = 0;
    call([&](int* fault) {
      gmsh_.get_nodes(&tags, &count, &places, &places_count, &parameters, &none, -1, -1, 0, 0,
                      fault);
    });
    const std::size_t most = count > 0 ? *std::max_element(tags, tags + count) : 0;
    std::vector<std::uint32_t> number(most + 1, 0);
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i) {
      order[i] = i;
    }
    std::ranges::sort(order, {}, [&](std::size_t i) { return tags[i]; });
    const std::size_t given = mesh.points.size();
    for (const std::size_t i : order) {
      if (tags[i] <= given) {
        number[tags[i]] = static_cast<std::uint32_t>(tags[i] - 1);
        continue;
      }
      number[tags[i]] = static_cast<std::uint32_t>(mesh.points.size());
      mesh.points.emplace_back(places[3 * i], places[3 * i + 1], places[3 * i + 2]);
    }
    gmsh_.free(tags);
    gmsh_.free(places);
    gmsh_.free(parameters);
    call([&](int* fault) {
      gmsh_.get_elements(kTetrahedron, &tags, &count, &nodes, &node_count, -1, 0, 1, fault);
    });
    for (std::size_t i = 0; i + 3 < node_count; i += 4) {
      mesh.tetrahedra.push_back(
          {number[nodes[i]], number[nodes[i + 1]], number[nodes[i + 2]], number[nodes[i + 3]]});
    }
    gmsh_.free(tags);
    gmsh_.free(nodes);
  }

 private:
  template <class Call>
  void call(const Call& function) {
    fault_ = 0;
    function(&fault_);
    if (fault_ != 0) {
      throw Error(Errc::boolean_failed, "gmsh could not make tetrahedra: " + last_words());
    }
  }
  /// The last error that gmsh has told of.
  std::string last_words() {
    char** lines = nullptr;
    std::size_t count = 0;
    int fault = 0;
    gmsh_.get_log(&lines, &count, &fault);
    std::string words = "it does not say why";
    for (std::size_t i = 0; fault == 0 && i < count; ++i) {
      const std::string line = lines[i];
      if (line.starts_with("Error")) {
        words = line;
      }
      gmsh_.free(lines[i]);
    }
    gmsh_.free(lines);
    return words;
  }

  const GmshLibrary& gmsh_;
  int fault_ = 0;
};

}  // namespace

bool has_volume_mesher() { return GmshLibrary::instance() != nullptr; }

VolumeMesh fill_with_tetrahedra(const TriMesh& surface) {
  static std::mutex one_at_a_time;  // gmsh has one state
  const std::scoped_lock lock(one_at_a_time);
  const GmshLibrary* const library = GmshLibrary::instance();
  if (library == nullptr) {
    throw Error(Errc::invalid_argument,
                "the library of gmsh " GMSH_API_VERSION
                ", which makes volume meshes, is not installed; on Debian, apt-get install "
                "libgmsh-dev");
  }
  VolumeMesh mesh;
  mesh.points = surface.points;
  mesh.surface = surface;
  mesh.surface.points.clear();
  Session session(*library);
  const std::vector<Shell> shells = shells_of(surface);
  for (std::size_t i = 0; i < shells.size(); ++i) {
    session.add_surface(static_cast<int>(i) + 1, surface, shells[i].triangles);
  }
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (shells[i].volume > 0) {
      std::vector<int> surfaces = {static_cast<int>(i) + 1};
      for (const std::size_t inner : shells[i].voids) {
        surfaces.push_back(static_cast<int>(inner) + 1);
      }
      session.add_volume(std::move(surfaces));
    }
  }
  session.generate();
  session.read(mesh);
  check_volume_mesh(mesh);
  return mesh;
}

}  // namespace dupin
