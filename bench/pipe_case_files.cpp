// Writes the operands of a case of pipes as mesh files, for contests from file to file.
// Usage: pipe_case_files CASE FOLDER EXTENSION; prints their paths.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "dupin/io/mesh_file.h"
#include "support/pipe_cases.h"

int main(int count, char** arguments) {
  if (count != 4) {
    std::fputs("usage: CASE FOLDER EXTENSION\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = arguments[2];
  std::size_t number = 0;
  for (const dupin::TriMesh& mesh : dupin::test::pipe_case(arguments[1])) {
    const auto path = folder / (std::to_string(number++) + "." + arguments[3]);
    dupin::write_mesh(path, mesh, dupin::format_of(path));
    std::puts(path.c_str());
  }
  return EXIT_SUCCESS;
}
