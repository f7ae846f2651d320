// How ends of pipes miss each other, measured without rounding.

#include <iostream>

#include "dupin/blends/resolve.h"
#include "dupin/kernel/gap.h"

int main() {
  dupin::Assembly assembly;
  assembly.parts = {
      {"a", dupin::PipeBetween{.from = {0, 0, 0}, .to = {1, 0, 0}, .radius = 1}},
      {"b", dupin::PipeAlong{.from = dupin::PortReference{"a", dupin::End::end}, .length = 1}},
      {"c", dupin::PipeBetween{.from = {2 + 0x1p-51, 0, 0}, .to = {3, 0, 0}, .radius = 1}},
      {"d", dupin::PipeBetween{.from = {3, 0.25, 0}, .to = {4, 0.25, 0}, .radius = 1.5}},
  };
  const std::vector<dupin::Port> ports = dupin::ports(dupin::resolve(assembly));
  for (const dupin::GapPair& pair : dupin::pair_ends(ports, 0.5)) {
    const dupin::GapReport& gap = pair.report;
    std::cout << ports[pair.first].name << " - "
              << (pair.second ? ports[*pair.second].name : "nothing") << ": "
              << dupin::name(gap.verdict);
    if (pair.second) {
      std::cout << ", axial " << gap.axial_dot << ", radius " << gap.radius_difference
                << ", offset squared " << gap.offset_squared;
    }
    std::cout << '\n';
  }
}
