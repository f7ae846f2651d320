#include "mpi/mpi_module.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

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

/// MPI waits by asking again and again, which would take a processor from those that others wait
/// for.
int broadcast_some(void* bytes, std::uint64_t size, int from) {
  constexpr std::chrono::microseconds kShortest{50}, kLongest{5000};
  auto pause = kShortest;
  MPI_Request request = MPI_REQUEST_NULL;
  int fault = MPI_Ibcast(bytes, static_cast<int>(size), MPI_BYTE, from, MPI_COMM_WORLD, &request);
  for (int is_done = 0; fault == MPI_SUCCESS;) {
    fault = MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
    if (is_done != 0) {
      break;
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, kLongest);
  }
  // NOLINTNEXTLINE(clang-analyzer-optin.mpi.MPI-Checker): there is none where it has failed
  return fault != MPI_SUCCESS ? fault : MPI_Wait(&request, MPI_STATUS_IGNORE);
}

int broadcast(int from, std::string* bytes) {
  std::uint64_t size = bytes->size();
  int fault = broadcast_some(&size, sizeof(size), from);
  bytes->resize(fault == MPI_SUCCESS ? size : 0);
  for (std::uint64_t at = 0; at < size && fault == MPI_SUCCESS; at += kMost) {
    fault = broadcast_some(bytes->data() + at, std::min(kMost, size - at), from);
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
    const std::uint64_t place = at + done;
    return MPI_File_write_at(*static_cast<MPI_File*>(file), static_cast<MPI_Offset>(place),
                             bytes + done, wanted, MPI_BYTE, status);
  });
}

int read_file(void* file, std::uint64_t at, char* bytes, std::uint64_t size, std::uint64_t* taken) {
  return in_calls(size, taken, [&](std::uint64_t done, int wanted, MPI_Status* status) {
    const std::uint64_t place = at + done;
    return MPI_File_read_at(*static_cast<MPI_File*>(file), static_cast<MPI_Offset>(place),
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
  static const dupin::cli::MpiModule functions{start,      broadcast, finish,     open_file,
                                               write_file, read_file, close_file, reason};
  return &functions;
}
