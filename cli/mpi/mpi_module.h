#pragma once

#include <cstdint>
#include <string>

namespace dupin::cli {

/// What the module does that is linked with MPI, and loaded under mpirun only. All functions return
/// MPI's error code, 0 for none.
struct MpiModule {
  int (*start)(int* rank, int* count);
  int (*send)(int to, const char* bytes, std::uint64_t size);
  int (*receive)(int from, std::string* bytes);
  int (*finish)();
};

inline constexpr const char* kMpiModuleFile = "libdupin_mpi.so";
inline constexpr const char* kMpiEntryPoint = "dupin_mpi_module_1";

}  // namespace dupin::cli

extern "C" __attribute__((visibility("default"))) const dupin::cli::MpiModule* dupin_mpi_module_1();
