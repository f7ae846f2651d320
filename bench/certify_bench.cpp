// How long do a certificate and its verification take?

#include <cstdlib>
#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>

#include "dupin/blends/certificate.h"
#include "dupin/blends/certify.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/certificate_json.h"
#include "measured.h"

namespace dupin {
namespace {

Assembly example(const std::string& name) {
  return read_assembly(std::filesystem::path(DUPIN_SOURCE_DIR) / "examples" / name);
}

void certify_bench(benchmark::State& state, const std::string& name) {
  const Assembly assembly = example(name);
  Certificate certificate;
  for ([[maybe_unused]] const auto iteration : state) {
    certificate = certify(assembly);
    benchmark::DoNotOptimize(certificate);
  }
  bench::require(certificate.findings() == 0, "all claims are proved");
  state.counters["bytes"] = static_cast<double>(certificate_json(certificate).size());
}

void verify_bench(benchmark::State& state, const std::string& name) {
  const Certificate certificate = certify(example(name));
  bench::require(certificate.findings() == 0, "all claims are proved");
  for ([[maybe_unused]] const auto iteration : state) {
    verify(certificate);
  }
}

}  // namespace
}  // namespace dupin

int main(int argc, char** argv) {
  for (const std::string name :
       {"reducer.json", "header.json", "plant-run.json", "skew-cross.json"}) {
    benchmark::RegisterBenchmark(("certify/" + name).c_str(), [=](auto& state) {
      dupin::certify_bench(state, name);
    })->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("verify/" + name).c_str(), [=](auto& state) {
      dupin::verify_bench(state, name);
    })->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return EXIT_SUCCESS;
}
