#include "dupin/io/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "dupin/kernel/error.h"

namespace dupin {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& action, const fs::path& path, int reason) {
  throw Error(Errc::io_failed, "cannot " + action + ": " + std::generic_category().message(reason),
              {}, path.string());
}

/// Bytes to read at once into memory that stays in the cache.
constexpr std::size_t kPiece = std::size_t{1} << 18;

/// An open file; closed on every way out.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) {
      ::close(number_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }
  /// Closes, and tells the reason if the system refuses (a full disk may say so only here).
  [[nodiscard]] int close() { return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

 private:
  int number_;
};

Descriptor opened(const fs::path& path) {
  const int number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (number < 0) {
    fail("read the file", path, errno);
  }
  return Descriptor(number);
}

/// Fills the piece from its beginning, as far as the system gives at once; 0 at the file's end.
std::size_t read_some(const Descriptor& file, std::span<char> piece, const fs::path& path) {
  for (;;) {
    const ssize_t taken = ::read(file.number(), piece.data(), piece.size());
    if (taken >= 0) {
      return static_cast<std::size_t>(taken);
    }
    if (errno != EINTR) {
      fail("read the file", path, errno);
    }
  }
}

int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      return errno;
    }
    bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  return 0;
}

/// A new file beside `target`, readable as its permissions or the process's mask say.
int create_aside(const fs::path& target, fs::path& aside) {
  static std::atomic<unsigned> files{0};
  for (;;) {
    const std::string suffix = std::to_string(::getpid()) + "-" + std::to_string(files++);
    aside = target.parent_path() / ("." + target.filename().string() + "." + suffix + ".part");
    const int descriptor = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) {
      return descriptor;
    }
  }
}

/// Makes the rename last through a power cut. Some file systems cannot, which is no fault of ours.
void sync_directory(const fs::path& file) {
  const fs::path parent = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const Descriptor directory(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.number() >= 0) {
    (void)::fsync(directory.number());
  }
}

fs::path resolved(const fs::path& target) {
  std::error_code ignored;
  if (!fs::is_symlink(target, ignored)) {
    return target;
  }
  fs::path real = fs::weakly_canonical(target, ignored);
  return ignored ? target : real;
}

}  // namespace

std::string read_file(const fs::path& path) {
  const Descriptor file = opened(path);
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) {
    fail("read the file", path, errno);
  }
  std::string bytes(S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) + 1 : 65536,
                    '\0');
  for (std::size_t filled = 0;;) {
    const std::size_t taken = read_some(file, std::span(bytes).subspan(filled), path);
    filled += taken;
    if (taken == 0) {
      bytes.resize(filled);
      return bytes;
    }
    if (filled == bytes.size()) {
      bytes.resize(2 * bytes.size());
    }
  }
}

AsideFile::AsideFile(const fs::path& target, std::string_view bytes) : target_(resolved(target)) {
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    fail("write the file", target_, EISDIR);
  }
  if (exists && ::access(target_.c_str(), W_OK) != 0) {
    fail("write the file", target_, errno);
  }
  replaceable_ = !exists || S_ISREG(status.st_mode);
  std::error_code ignored;
  const fs::path beside =
      replaceable_ ? target_ : fs::temp_directory_path(ignored) / target_.filename();
  Descriptor file(create_aside(beside, aside_));
  if (file.number() < 0) {
    fail("create a file beside it", target_, errno);
  }
  pending_ = true;
  int reason = write_all(file.number(), bytes);
  if (reason == 0 && exists && replaceable_ &&
      ::fchmod(file.number(), status.st_mode & 07777U) != 0) {
    reason = errno;
  }
  if (reason == 0 && ::fsync(file.number()) != 0) {
    reason = errno;
  }
  const int close_reason = file.close();
  if (reason == 0) {
    reason = close_reason;
  }
  if (reason != 0) {
    ::unlink(aside_.c_str());
    fail("write the file", target_, reason);
  }
}

AsideFile::~AsideFile() {
  if (pending_) {
    ::unlink(aside_.c_str());
  }
}

bool AsideFile::holds(std::string_view bytes) const {
  const Descriptor file = opened(aside_);
  std::vector<char> piece(kPiece);
  for (;;) {
    const std::size_t size = read_some(file, piece, aside_);
    if (size == 0) {
      return bytes.empty();
    }
    if (!bytes.starts_with(std::string_view(piece.data(), size))) {
      return false;
    }
    bytes.remove_prefix(size);
  }
}

void AsideFile::commit() {
  if (!replaceable_) {
    const std::string bytes = read_file(aside_);
    Descriptor device(::open(target_.c_str(), O_WRONLY | O_CLOEXEC));
    const int reason = device.number() < 0 ? errno : write_all(device.number(), bytes);
    if (reason != 0) {
      fail("write the file", target_, reason);
    }
    return;
  }
  if (::rename(aside_.c_str(), target_.c_str()) != 0) {
    fail("put the file in place", target_, errno);
  }
  pending_ = false;
  sync_directory(target_);
}

void write_file(const fs::path& path, std::string_view bytes) {
  AsideFile file(path, bytes);
  file.commit();
}

}  // namespace dupin
