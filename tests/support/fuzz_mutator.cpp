// For fuzzers that are linked with libFuzzer: now and then an input starts from one of the seeds,
// so that no corpus has to be made first.

#include <algorithm>
#include <random>

#include "support/fuzz_target.h"
#include "support/mutation.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max, unsigned seed) {
  static const std::vector<std::string> seeds = dupin::test::fuzz_seeds();
  std::mt19937_64 random(seed);
  const std::uint64_t way = random() % 4;
  if (seeds.empty() || way == 0) {
    return LLVMFuzzerMutate(data, size, max);
  }
  std::string bytes(data, data + size);
  if (size < 8 || way == 1) {
    bytes = seeds[random() % seeds.size()];
  }
  bytes = dupin::test::mutated(std::move(bytes), random);
  const std::size_t length = std::min(bytes.size(), max);
  std::copy_n(bytes.begin(), length, data);
  return length;
}
