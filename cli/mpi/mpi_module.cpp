#include "mpi/mpi_module.h"

#include <algorithm>
#include <array>

#include <mpi.h>

namespace {

/// Of bytes that MPI counts in one call by an int.
constexpr std::uint64_t kMost = std::uint64_t{1} << 30;

int start(int* rank, int* count) {
  if (const int fault = MPI_Init(nullptr, nullptr); fault != MPI_SUCCESS) {
    return fault;
  }
  MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
  MPI_Comm_rank(MPI_COMM_WORLD, rank);
  return MPI_Comm_size(MPI_COMM_WORLD, count);
}

int broadcast(int from, std::string* bytes) {
  std::uint64_t size = bytes->size();
  int fault = MPI_Bcast(&size, 1, MPI_UINT64_T, from, MPI_COMM_WORLD);
  bytes->resize(fault == MPI_SUCCESS ? size : 0);
  for (std::uint64_t at = 0; at < size && fault == MPI_SUCCESS; at += kMost) {
    fault = MPI_Bcast(bytes->data() + at, static_cast<int>(std::min(kMost, size - at)), MPI_BYTE,
                      from, MPI_COMM_WORLD);
  }
  return fault;
}

int finish() { return MPI_Finalize(); }

// Files return their errors, if nobody says otherwise.
int open_file(const char* path, void** file) {
  auto* const opened = new MPI_File(MPI_FILE_NULL);
  *file = opened;
  return MPI_File_open(MPI_COMM_WORLD, path, MPI_MODE_RDWR, MPI_INFO_NULL, opened);
}

/// Calls transfer(offset, size, status) until all is done or nothing more is; how much was.
template <class Transfer>
int in_calls(std::uint64_t size, std::uint64_t* done, const Transfer& transfer) {
  *done = 0;
  while (*done < size) {
    const auto wanted = static_cast<int>(std::min(kMost, size - *done));
    MPI_Status status;
    if (const int fault = transfer(*done, wanted, &status); fault != MPI_SUCCESS) {
      return fault;
    }
    int count = 0;
    if (const int fault = MPI_Get_count(&status, MPI_BYTE, &count); fault != MPI_SUCCESS) {
      return fault;
    }
    if (count <= 0) {
      break;
    }
    *done += static_cast<std::uint64_t>(count);
  }
  return MPI_SUCCESS;
}

int write_file(void* file, std::uint64_t at, const char* bytes, std::uint64_t size,
               std::uint64_t* written) {
  return in_calls(size, written, [&](std::uint64_t done, int wanted, MPI_Status* status) {
    return MPI_File_write_at(*static_cast<MPI_File*>(file), static_cast<MPI_Offset>(at + done),
                             bytes + done, wanted, MPI_BYTE, status);
  });
}

int read_file(void* file, std::uint64_t at, char* bytes, std::uint64_t size, std::uint64_t* taken) {
  return in_calls(size, taken, [&](std::uint64_t done, int wanted, MPI_Status* status) {
    return MPI_File_read_at(*static_cast<MPI_File*>(file), static_cast<MPI_Offset>(at + done),
                            bytes + done, wanted, MPI_BYTE, status);
  });
}

int close_file(void* file) {
  auto* const opened = static_cast<MPI_File*>(file);
  const int fault = MPI_File_sync(*opened);
  const int last = MPI_File_close(opened);
  delete opened;
  return fault != MPI_SUCCESS ? fault : last;
}

std::string reason(int fault) {
  std::array<char, MPI_MAX_ERROR_STRING + 1> text{};
  int size = 0;
  return MPI_Error_string(fault, text.data(), &size) == MPI_SUCCESS
             ? std::string(text.data(), static_cast<std::size_t>(size))
             : "error " + std::to_string(fault);
}

}  // namespace

const dupin::cli::MpiModule* dupin_mpi_module_2() {
  static const dupin::cli::MpiModule kModule{start,      broadcast, finish,     open_file,
                                             write_file, read_file, close_file, reason};
  return &kModule;
}
