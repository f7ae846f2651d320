// An assembly made by a program: two pipes, a blend between them, and a solid of it in a file.

#include <iostream>

#include "dupin/blends/build.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/mesh_file.h"

int main() {
  dupin::Assembly assembly;
  assembly.tolerance = 0.1;
  assembly.parts = {
      {"inlet", dupin::PipeBetween{.from = {-10, 0, 0}, .to = {0, 0, 0}, .radius = 1}},
      {"outlet",
       dupin::PipeAlong{
           .from = dupin::Place{.point = {10, 4, 0}, .direction = {1, 2, 10}, .radius = 2},
           .length = 10}},
      {"blend", dupin::CyclideBlendBetween{.from = {"inlet", dupin::End::end},
                                           .to = {"outlet", dupin::End::start}}},
  };
  std::cout << dupin::document_text(assembly);

  const dupin::Built built = dupin::build(assembly);
  for (const dupin::PartReport& part : built.parts) {
    std::cout << part.name << " (" << part.kind << "): " << part.construction
              << (part.construction.empty() ? "" : ", ") << part.segments << " segments around\n";
  }
  const dupin::Rounded rounded = dupin::to_mesh(built.solid, dupin::Coordinates::binary32);
  const dupin::Report report = dupin::write_verified("assembly.stl", rounded.mesh());
  std::cout << "watertight: " << (report.is_solid() ? "yes" : "no") << ", genus " << report.genus
            << '\n';
}
