#pragma once

#include <cstdint>
#include <string>

namespace dupin::cli {

/// What the module does that is linked with MPI, and loaded under mpirun only. All functions return
/// MPI's error code, 0 for none, and all processes call each of them, but for `write` and `read`.
struct MpiModule {
  int (*start)(int* rank, int* count);
  /// Puts bytes of one process into `bytes` of all others.
  int (*broadcast)(int from, std::string* bytes);
  int (*finish)();

  /// A file that is there.
  int (*open)(const char* path, void** file);
  int (*write)(void* file, std::uint64_t at, const char* bytes, std::uint64_t size,
               std::uint64_t* written);
  int (*read)(void* file, std::uint64_t at, char* bytes, std::uint64_t size, std::uint64_t* taken);
  /// Behind what was written reaching the disk.
  int (*close)(void* file);

  std::string (*reason)(int fault);
};

inline constexpr const char* kMpiModuleFile = "libdupin_mpi.so";
inline constexpr const char* kMpiEntryPoint = "dupin_mpi_module_2";

}  // namespace dupin::cli

extern "C" __attribute__((visibility("default"))) const dupin::cli::MpiModule* dupin_mpi_module_2();
