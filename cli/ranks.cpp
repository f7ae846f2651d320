#include "ranks.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <span>
#include <system_error>
#include <thread>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include "dupin/kernel/error.h"
#include "exit_code.h"
#include "interrupt.h"
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

void require(const MpiModule& module, int fault, const char* what, const std::string& file = {}) {
  if (fault != 0) {
    throw Error(Errc::io_failed, std::string("MPI cannot ") + what + ": " + module.reason(fault),
                {}, file);
  }
}

/// A file that all processes see.
class MpiFile : public JointFile {
 public:
  MpiFile(const MpiModule& module, const std::string& path, std::string shown)
      : module_(module),
        shown_(std::move(shown)),
        plain_(::open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
    require(module, module.open(path.c_str(), &file_),
            "open the file, which all processes have to see", shown_);
  }
  ~MpiFile() override {
    if (plain_ >= 0) {
      ::close(plain_);
    }
  }
  MpiFile(const MpiFile&) = delete;
  MpiFile& operator=(const MpiFile&) = delete;

  void write(std::uint64_t at, std::string_view bytes) override {
    std::uint64_t written = 0;
    const int fault = module_.write(file_, at, bytes.data(), bytes.size(), &written);
    // MPI says that it has written less, or some error; why, says the system.
    if (written < bytes.size()) {
      write_plainly(at + written, bytes.substr(written));
    } else {
      require(module_, fault, "write the file", shown_);
    }
  }
  std::uint64_t read(std::uint64_t at, std::span<char> bytes) override {
    std::uint64_t taken = 0;
    require(module_, module_.read(file_, at, bytes.data(), bytes.size(), &taken), "read the file",
            shown_);
    return taken;
  }
  void close() override { require(module_, module_.close(file_), "write the file", shown_); }

 private:
  void write_plainly(std::uint64_t at, std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t some = ::pwrite(plain_, bytes.data(), bytes.size(), static_cast<off_t>(at));
      if (some < 0 && errno != EINTR) {
        throw Error(Errc::io_failed,
                    "cannot write the file: " + std::generic_category().message(errno), {}, shown_);
      }
      at += some > 0 ? static_cast<std::uint64_t>(some) : 0;
      bytes.remove_prefix(some > 0 ? static_cast<std::size_t>(some) : 0);
    }
  }

  const MpiModule& module_;
  std::string shown_;
  int plain_;
  void* file_ = nullptr;  // not closed where an error ends this process, as others would not be
};

/// mpirun's name for this process, as it is known without MPI.
bool is_first_of_mpirun() {
  constexpr std::array kNames{"OMPI_COMM_WORLD_RANK", "PMI_RANK"};
  return std::ranges::none_of(kNames, [](const char* name) {
    const char* const rank = std::getenv(name);
    return rank != nullptr && std::string_view(rank) != "0";
  });
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

void let_another_speak() {
  constexpr std::chrono::seconds kEnough{10};
  if (is_under_mpirun()) {
    end_without_words();
    std::this_thread::sleep_for(kEnough);
  }
}

void let_first_speak() {
  if (!is_first_of_mpirun()) {
    let_another_speak();
  }
}

Ranks::Ranks() {
  if (!is_under_mpirun()) {
    return;
  }
  const MpiModule& module = loaded_module();
  end_without_words();
  int rank = 0, count = 1;
  require(module, module.start(&rank, &count), "start");
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

std::vector<std::string> Ranks::exchanged(std::string_view bytes) const {
  std::vector<std::string> all(count_);
  all[own_] = bytes;
  for (std::size_t rank = 0; module_ != nullptr && rank < count_; ++rank) {
    require(*module_, module_->broadcast(static_cast<int>(rank), &all[rank]), "send");
  }
  return all;
}

std::unique_ptr<JointFile> Ranks::open(const std::filesystem::path& path,
                                       const std::string& shown) const {
  return module_ == nullptr ? nullptr : std::make_unique<MpiFile>(*module_, path.string(), shown);
}

}  // namespace dupin::cli
