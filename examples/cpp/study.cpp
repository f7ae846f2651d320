// A study: how thick the outlet of a reducer may be until the blend folds. What is impossible is an
// Error with its code, part and place.

#include <iostream>

#include "dupin/blends/build.h"

namespace {

dupin::Assembly reducer(double radius) {
  dupin::Assembly assembly;
  assembly.tolerance = 0.2;
  assembly.parts = {
      {"inlet", dupin::PipeBetween{.from = {-10, 0, 0}, .to = {0, 0, 0}, .radius = 1}},
      {"outlet",
       dupin::PipeAlong{
           .from = dupin::Place{.point = {8, 8, 0}, .direction = {0, 1, 0}, .radius = radius},
           .length = 10}},
      {"blend", dupin::CyclicBlendBetween{.from = {"inlet", dupin::End::end},
                                          .to = {"outlet", dupin::End::start},
                                          .options = {.k = 10, .l = 10}}},
  };
  return assembly;
}

}  // namespace

int main() {
  for (const double radius : {1.0, 2.0, 4.0, 6.0, 8.0, 10.0}) {
    std::cout << "radius " << radius << ": ";
    try {
      const dupin::Built built = dupin::build(reducer(radius));
      const dupin::PartReport& blend = built.parts.back();
      std::cout << (*blend.margin_lower > 0 ? "regular" : "undecided") << ", "
                << (blend.error_bound <= 0.2 ? "mesh within the tolerance" : "mesh too coarse")
                << '\n';
    } catch (const dupin::Error& error) {
      std::cout << dupin::name(error.code()) << " in '" << error.part() << "' at " << error.where()
                << '\n';
    }
  }
}
