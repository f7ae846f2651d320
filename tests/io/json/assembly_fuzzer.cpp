// Documents: read and resolved, or refused for one of the reasons that are promised. See
// tests/support/fuzz_target.h.

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"
#include "support/fuzz_target.h"
#include "support/source_folder.h"

std::vector<std::string> dupin::test::fuzz_seeds() {
  std::vector<std::string> seeds;
  for (const auto& entry :
       std::filesystem::directory_iterator(dupin::test::source_folder() / "examples")) {
    if (entry.path().extension() == ".json") {
      std::ifstream file(entry.path());
      seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    }
  }
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using dupin::Errc;
  try {
    (void)resolve(dupin::parse_assembly({reinterpret_cast<const char*>(data), size}, "input"));
  } catch (const dupin::Error& error) {
    constexpr std::array kPromised{Errc::parse_failed, Errc::limit_exceeded, Errc::invalid_argument,
                                   Errc::infeasible_blend, Errc::irregular_surface};
    if (std::find(kPromised.begin(), kPromised.end(), error.code()) == kPromised.end()) {
      throw;
    }
  }
  return 0;
}
