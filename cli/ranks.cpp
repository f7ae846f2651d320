#include "ranks.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>

#include <dlfcn.h>

#include "dupin/kernel/error.h"
#include "exit_code.h"
#include "mpi/mpi_module.h"

namespace dupin::cli {
namespace {

/// Modules of MPI look for its library among what is loaded for all.
const MpiModule& loaded_module() {
  void* const library = dlopen(kMpiModuleFile, RTLD_NOW | RTLD_GLOBAL);
  void* const entry = library == nullptr ? nullptr : dlsym(library, kMpiEntryPoint);
  if (entry == nullptr) {
    const char* const why = dlerror();
    throw UsageError(
        std::string("mpirun has started several processes, but this build of dupin has no MPI: "
                    "build it where libopenmpi-dev is installed (") +
        (why == nullptr ? "" : why) + ")");
  }
  using Entry = const MpiModule* (*)();
  return *reinterpret_cast<Entry>(entry)();
}

void require(int fault, const char* what) {
  if (fault != 0) {
    throw Error(Errc::io_failed,
                std::string("MPI cannot ") + what + " (its error " + std::to_string(fault) + ")");
  }
}

}  // namespace

// Open MPI says it, and so do the process managers of MPICH and Slurm.
bool is_under_mpirun() {
  constexpr std::array kNames{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"};
  return std::ranges::any_of(kNames, [](const char* name) {
    const char* const count = std::getenv(name);
    return count != nullptr && std::string_view(count) != "1";
  });
}

Ranks::Ranks() {
  if (!is_under_mpirun()) {
    return;
  }
  const MpiModule& module = loaded_module();
  int rank = 0, count = 1;
  require(module.start(&rank, &count), "start");
  module_ = &module;
  count_ = static_cast<std::size_t>(count);
  own_ = static_cast<std::size_t>(rank);
}

Ranks::~Ranks() {
  // Else the others would wait for this one, and this for them.
  if (module_ != nullptr && std::uncaught_exceptions() == 0) {
    (void)module_->finish();
  }
}

void Ranks::send(std::string_view bytes) const {
  require(module_->send(0, bytes.data(), bytes.size()), "send");
}

std::string Ranks::receive(std::size_t from) const {
  std::string bytes;
  require(module_->receive(static_cast<int>(from), &bytes), "receive");
  return bytes;
}

}  // namespace dupin::cli
