// What do unions of pipes cost, in time and memory, and how does the time grow with their size?
// Usage: boolean_bench [CASE...]. Without arguments: the quick cases; `all` adds the large ones.
// Every result is compared with a volume that other programs have found before its time counts.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <tbb/global_control.h>

#include "dupin/kernel/boolean.h"
#include "dupin/kernel/cross_check.h"
#include "process_usage.h"
#include "support/pipe_cases.h"
#include "union_cases.h"

namespace dupin {
namespace {

struct Measurement {
  double cpu = HUGE_VAL, wall = HUGE_VAL, bytes = 0;
  std::size_t triangles = 0;
};

Measurement measure(const std::vector<Solid>& operands, const bench::UnionCase& row,
                    std::size_t threads, int repetitions) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  Measurement best;
  for (int i = 0; i < repetitions; ++i) {
    bench::reset_peak();
    const double resident = bench::process_memory("VmRSS:");
    const bench::Seconds start = bench::now();
    const Solid united = unite(operands);
    const bench::Seconds took = bench::since(start);
    best.cpu = std::min(best.cpu, took.processor);
    best.wall = std::min(best.wall, took.wall);
    best.bytes = std::max(best.bytes, bench::process_memory("VmHWM:") - resident);
    best.triangles = united.triangle_count();
    if (i == 0 && !bench::has_known_volume(row.name, united.volume(), 1e-11)) {
      std::printf("%s: the volume is %.12g, not %.12g\n", row.name.data(), united.volume(),
                  row.volume);
      std::exit(1);
    }
  }
  return best;
}

void run(const bench::UnionCase& row, bool with_corefinement) {
  std::vector<Solid> operands;
  std::size_t triangles = 0;
  for (const TriMesh& mesh : test::pipe_case(row.name)) {
    operands.push_back(Solid::from(mesh));
    triangles += mesh.triangles.size();
  }
  const int repetitions = triangles < 300000 ? 5 : 2;
  const Measurement two = measure(operands, row, 2, repetitions);
  const Measurement one = measure(operands, row, 1, repetitions);
  std::printf("%-16s %9zu %9zu %9.4f %9.4f %9.4f %7.2f %9.0f", row.name.data(), triangles,
              one.triangles, one.cpu, one.wall, two.wall, one.wall / two.wall,
              std::max(one.bytes, two.bytes) / static_cast<double>(triangles));
  if (with_corefinement && row.corefine && has_cross_check()) {
    const bench::Seconds start = bench::now();
    (void)combine_by(CrossCheckEngine::corefinement, SetOperation::unite, operands);
    const double rival = bench::since(start).processor;
    std::printf(" %11.4f %7.1f", rival, rival / one.cpu);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace
}  // namespace dupin

int main(int argc, char** argv) {
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  const auto has = [&](std::string_view word) {
    return std::find(wanted.begin(), wanted.end(), word) != wanted.end();
  };
  std::printf("%-16s %9s %9s %9s %9s %9s %7s %9s %11s %7s\n", "union", "triangles", "of result",
              "CPU s", "wall s", "2 threads", "faster", "bytes/tri", "corefined s", "ratio");
  for (const dupin::bench::UnionCase& row : dupin::bench::kUnionCases) {
    const bool by_name = has(row.name);
    if (by_name || has("all") ||
        (row.is_quick && (wanted.empty() || (has("corefinement") && argc == 2)))) {
      dupin::run(row, has("corefinement"));
    }
  }
  return 0;
}
