// The main of fuzzers that are built without libFuzzer: FUZZER COUNT [SEED] runs so many inputs,
// FUZZER FILE the one in the file.

#include <charconv>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>

#include "support/fuzz_target.h"
#include "support/mutation.h"

namespace {

// From a buffer of exactly this size, so that sanitisers see reads behind its end.
bool runs(const std::string& input) {
  const std::vector<std::uint8_t> bytes(input.begin(), input.end());
  try {
    return LLVMFuzzerTestOneInput(bytes.data(), bytes.size()) == 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return false;
  }
}

std::string any_bytes(std::mt19937_64& random) {
  std::string bytes(1 + random() % 128, '\0');
  for (char& byte : bytes) {
    byte = static_cast<char>(random() % 256);
  }
  return bytes;
}

bool number(const char* text, std::uint64_t& value) {
  const char* end = text + std::strlen(text);
  return std::from_chars(text, end, value).ptr == end;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t count = 0, seed = 2026;
  if (argc < 2 || argc > 3 || (argc == 3 && !number(argv[2], seed))) {
    std::cerr << "usage: " << argv[0] << " COUNT [SEED] | FILE\n";
    return 2;
  }
  if (!number(argv[1], count)) {
    std::ifstream file(argv[1], std::ios::binary);
    return runs({std::istreambuf_iterator<char>(file), {}}) ? 0 : 1;
  }
  // Tests run side by side.
  const std::string file = std::filesystem::path(argv[0]).filename().string() + ".input";
  std::mt19937_64 random(seed);
  const std::vector<std::string> seeds = dupin::test::fuzz_seeds();
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string input = seeds.empty()
                                  ? any_bytes(random)
                                  : dupin::test::mutated(seeds[random() % seeds.size()], random);
    // Before it runs: what aborts cannot tell.
    std::ofstream(file, std::ios::binary).write(input.data(), std::streamsize(input.size()));
    if (!runs(input)) {
      std::cerr << "input " << i << " of seed " << seed << " is in " << file << '\n';
      return 1;
    }
  }
  std::cout << count << " inputs\n";
  return 0;
}
