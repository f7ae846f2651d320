// What do unions of pipes cost, in time and memory, and how does the time grow with their size?
// Usage: boolean_bench [CASE...]. Without arguments: the quick cases; `all` adds the large ones.
// Every result is compared with a volume that other programs have found before its time counts.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

#include <malloc.h>
#include <tbb/global_control.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/cross_check.h"
#include "support/pipe_cases.h"

namespace dupin {
namespace {

// Volumes by Nef polyhedra, else by CGAL's corefinement, else by Manifold, to the digits given;
// those of stars and coaxial pipes by an arrangement of all at once.
struct Case {
  const char* name;
  double volume;
  bool is_quick;
  bool corefine;  ///< CGAL's corefinement takes this pair in a few seconds
};
constexpr Case kCases[] = {{"tee_10k", 45.3536257847, true, true},
                           {"tee_10k_rot", 45.3536257847, true, true},
                           {"tee_100k", 45.3704349115, true, true},
                           {"tee_100k_rot", 45.3704349115, true, true},
                           {"tee_1M", 45.3714856204, false, true},
                           {"tee_1M_rot", 45.3714856204, false, true},
                           {"header_10", 33.9090906937, true, true},
                           {"header_10_rot", 33.9090906937, true, true},
                           {"header_100", 310.861969283, true, true},
                           {"header_100_rot", 310.861969283, true, true},
                           {"header_1000", 3080.39075241, false, false},
                           {"header_1000_rot", 3080.39075241, false, false},
                           {"rack", 766.619264157, false, true},
                           {"rack_rot", 766.619264157, false, false},
                           {"rack_fine", 766.619264157, false, true},
                           {"rack_fine_rot", 766.619264157, false, true},
                           {"rack_eq", 666.751802906, false, false},
                           {"rack_eq_rot", 666.751802906, false, false},
                           {"blend_1", 3.66059546586, true, true},
                           {"blend_1_fan", 3.66059546586, true, false},
                           {"chain_100", 244.585937639, false, true},
                           {"chain_100_fan", 244.585937639, false, false},
                           {"star_8", 17.2239547743, true, false},
                           {"star_8_rot", 17.2239547743, true, false},
                           {"star_20", 22.011367079, true, false},
                           {"star_20_rot", 22.011367079, true, false},
                           {"star_40", 22.586871262, false, false},
                           {"star_40_rot", 22.586871262, false, false},
                           {"star_general_20", 43.1917098307, true, false},
                           {"star_general_40", 71.8331703636, false, false},
                           {"coaxial_20", 34.3840263024, true, false},
                           {"coaxial_20_rot", 34.3840263024, true, false},
                           {"coaxial_40", 37.5256094212, false, false},
                           {"coaxial_flush_20", 31.4026038202, false, false},
                           {"coaxial_flush_20_rot", 31.4026038202, false, false}};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Linux: the process's resident memory, now or its peak since the last reset, in bytes.
double memory(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == key) {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  }
  return 0;
}

// What was freed goes back to the system first, lest it be taken again unseen.
void reset_peak() {
  ::malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
}

struct Measurement {
  double cpu = HUGE_VAL, wall = HUGE_VAL, bytes = 0;
  std::size_t triangles = 0;
};

Measurement measure(const std::vector<Solid>& operands, const Case& row, std::size_t threads,
                    int repetitions) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  Measurement best;
  for (int i = 0; i < repetitions; ++i) {
    reset_peak();
    const double resident = memory("VmRSS:");
    const double cpu = cpu_seconds(), wall = wall_seconds();
    const Solid united = unite(operands);
    best.cpu = std::min(best.cpu, cpu_seconds() - cpu);
    best.wall = std::min(best.wall, wall_seconds() - wall);
    best.bytes = std::max(best.bytes, memory("VmHWM:") - resident);
    best.triangles = united.triangle_count();
    if (i == 0 && !(std::abs(united.volume() - row.volume) < 1e-11 * row.volume)) {
      std::printf("%s: the volume is %.12g, not %.12g\n", row.name, united.volume(), row.volume);
      std::exit(1);
    }
  }
  return best;
}

void run(const Case& row, bool with_corefinement) {
  std::vector<Solid> operands;
  std::size_t triangles = 0;
  for (const TriMesh& mesh : test::pipe_case(row.name)) {
    operands.push_back(Solid::from(mesh));
    triangles += mesh.triangles.size();
  }
  const int repetitions = triangles < 300000 ? 5 : 2;
  const Measurement two = measure(operands, row, 2, repetitions);
  const Measurement one = measure(operands, row, 1, repetitions);
  std::printf("%-16s %9zu %9zu %9.4f %9.4f %9.4f %7.2f %9.0f", row.name, triangles, one.triangles,
              one.cpu, one.wall, two.wall, one.wall / two.wall,
              std::max(one.bytes, two.bytes) / static_cast<double>(triangles));
  if (with_corefinement && row.corefine && has_cross_check()) {
    const double cpu = cpu_seconds();
    (void)combine_by(CrossCheckEngine::corefinement, SetOperation::unite, operands);
    const double rival = cpu_seconds() - cpu;
    std::printf(" %11.4f %7.1f", rival, rival / one.cpu);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace dupin

int main(int argc, char** argv) {
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  const auto has = [&](const char* word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  };
  std::printf("%-16s %9s %9s %9s %9s %9s %7s %9s %11s %7s\n", "union", "triangles", "of result",
              "CPU s", "wall s", "2 threads", "faster", "bytes/tri", "corefined s", "ratio");
  for (const dupin::Case& row : dupin::kCases) {
    const bool by_name = has(row.name);
    if (by_name || has("all") ||
        (row.is_quick && (wanted.empty() || (has("corefinement") && argc == 2)))) {
      dupin::run(row, has("corefinement"));
    }
  }
  return 0;
}
