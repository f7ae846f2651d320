// What a program's static objects make of the library is what it makes in main: its own objects
// come before the archives in link order, so that no constant of ours may wait for its initialiser.
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "dupin/blends/build.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/mesh_file.h"
#include "dupin/kernel/boolean.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/rounding.h"
#include "dupin/kernel/simplify.h"

namespace {

using namespace dupin;

constexpr std::array kExamples{"cone-to-pipe",        "crane-hook",   "cyclide-blends",
                               "hollow-tee",          "junction",     "oval-duct",
                               "reducing-elbow",      "ringed-canal", "skew-pipes",
                               "straight-reducer-r2", "tee",          "u-bend"};

// A pair of numbers that is none: its message says what they would be.
constexpr const char* kMalformed =
    R"({"units": "mm", "tolerance": 0.02, "parts": [{"name": "duct", "pipe": {"from": [0, 0, 0],
        "direction": [1, 0, 0], "length": 4, "semi_axes": [2], "axis": [0, 0, 1]}}]})";

template <class Work>
std::string result_of(const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    return error.what();
  }
}

std::string built(const Assembly& assembly) {
  const Built made = build(assembly);
  const Solid& solid = made.solid;
  const Rounded rounded = to_mesh(solid, Coordinates::binary32);
  const Simplified coarse = simplify(solid, assembly.tolerance);
  return std::to_string(solid.triangle_count()) + " " + decimal(solid.volume()) + " " +
         decimal(mesh_error(made)) + " " + decimal(rounded.report().largest_move) + " " +
         std::to_string(coarse.mesh.triangles.size());
}

std::string certified(const Assembly& assembly) {
  const std::string text = certificate_json(certify(assembly));
  verify(parse_certificate(text));
  return text;
}

std::vector<std::string> all_results() {
  std::vector<std::string> results{
      result_of([] { return std::to_string(parse_assembly(kMalformed, "m").parts.size()); })};
  for (const char* const name : kExamples) {
    const Assembly assembly = read_assembly(std::string(DUPIN_EXAMPLES) + "/" + name + ".json");
    results.push_back(result_of([&] { return built(assembly); }));
    results.push_back(result_of([&] { return certified(assembly); }));
  }
  return results;
}

const std::vector<std::string> kEarly = all_results();  // NOLINT(cert-err58-cpp)

}  // namespace

int main() {
  const std::vector<std::string> now = all_results();
  int differing = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i] != kEarly[i]) {
      ++differing;
      std::printf("result %zu in a static object:\n%.400s\nin main:\n%.400s\n", i,
                  kEarly[i].c_str(), now[i].c_str());
    }
  }
  return differing == 0 ? 0 : 1;
}
