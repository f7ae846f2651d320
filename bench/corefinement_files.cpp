// The union of mesh files by CGAL's corefinement, as in its own examples: points constructed in
// doubles, files by CGAL, nothing proved and nothing verified. Usage: corefinement_files OUT IN...
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using Surface = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

Surface read(const std::string& path) {
  Surface surface;
  if (!processing::IO::read_polygon_mesh(path, surface)) {
    throw std::runtime_error("cannot read " + path);
  }
  return surface;
}

void write(const std::string& path, const Surface& surface) {
  constexpr int kDigits = 17;
  if (!CGAL::IO::write_polygon_mesh(path, surface, CGAL::parameters::stream_precision(kDigits))) {
    throw std::runtime_error("cannot write " + path);
  }
}

// Halves first, so that every surface goes through few unions.
Surface united(const std::vector<std::string>& files, std::size_t begin, std::size_t end) {
  if (end - begin == 1) {
    return read(files[begin]);
  }
  const std::size_t middle = begin + (end - begin) / 2;
  Surface a = united(files, begin, middle), b = united(files, middle, end), result;
  if (!processing::corefine_and_compute_union(a, b, result)) {
    throw std::runtime_error("corefinement refuses");
  }
  return result;
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const std::vector<std::string> files(arguments + 2, arguments + count);
    write(arguments[1], united(files, 0, files.size()));
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
}
