#include "mpi/mpi_module.h"

#include <algorithm>

#include <mpi.h>

namespace {

/// Of bytes that MPI counts in one message by an int.
constexpr std::uint64_t kMost = std::uint64_t{1} << 30;

int start(int* rank, int* count) {
  if (const int fault = MPI_Init(nullptr, nullptr); fault != MPI_SUCCESS) {
    return fault;
  }
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  MPI_Comm_rank(MPI_COMM_WORLD, rank);
  return MPI_Comm_size(MPI_COMM_WORLD, count);
}

int send(int to, const char* bytes, std::uint64_t size) {
  int fault = MPI_Send(&size, 1, MPI_UINT64_T, to, 0, MPI_COMM_WORLD);
  for (std::uint64_t at = 0; at < size && fault == MPI_SUCCESS; at += kMost) {
    fault = MPI_Send(bytes + at, static_cast<int>(std::min(kMost, size - at)), MPI_BYTE, to, 0,
                     MPI_COMM_WORLD);
  }
  return fault;
}

int receive(int from, std::string* bytes) {
  std::uint64_t size = 0;
  int fault = MPI_Recv(&size, 1, MPI_UINT64_T, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  bytes->resize(fault == MPI_SUCCESS ? size : 0);
  for (std::uint64_t at = 0; at < size && fault == MPI_SUCCESS; at += kMost) {
    fault = MPI_Recv(bytes->data() + at, static_cast<int>(std::min(kMost, size - at)), MPI_BYTE,
                     from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  }
  return fault;
}

int finish() { return MPI_Finalize(); }

}  // namespace

const dupin::cli::MpiModule* dupin_mpi_module_1() {
  static const dupin::cli::MpiModule kModule{start, send, receive, finish};
  return &kModule;
}
