#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Every *_fuzzer.cpp defines these two. With clang (cmake --preset fuzz) libFuzzer calls them for
// as long as it is let; otherwise fuzz_driver.cpp does, for a number of inputs that are the same
// each time.

/// Whatever the bytes are, this returns; what must not be is an exception or an abort.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace dupin::test {

/// What inputs are mutated from; none where any bytes will do.
[[nodiscard]] std::vector<std::string> fuzz_seeds();

}  // namespace dupin::test
