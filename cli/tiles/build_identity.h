#pragma once

#include <string>

namespace dupin::cli {

/// Of the running program and the library that it has loaded: what tells their code from that of
/// any other build, by other sources, options or compilers, even of the same version. The linker's
/// build ids, which depend on the code alone; for a file without one, the digest of its bytes. The
/// same text for all processes of one build.
[[nodiscard]] const std::string& build_identity();

}  // namespace dupin::cli
