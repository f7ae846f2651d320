#include "dupin/io/atomic_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <span>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include "dupin/io/scratch_file.h"
#include "dupin/io/system_error.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "files/descriptor.h"

namespace dupin {
namespace {

namespace fs = std::filesystem;
using files::Descriptor;

[[noreturn]] void fail(const std::string& action, const fs::path& path, int reason) {
  throw SystemError("cannot " + action, reason, path.string());
}

/// The system reads names up to a NUL: what follows would be left out without a word.
void require_whole_name(const fs::path& path) {
  if (path.native().find('\0') != std::string::npos) {
    throw Error(Errc::invalid_argument, "the name of a file cannot have a NUL in it", {},
                path.string());
  }
}

/// So many bytes take the disk and the system their time.
constexpr std::size_t kMuch = std::size_t{1} << 23;

/// Bytes to read at once into memory that stays in the cache.
constexpr std::size_t kPiece = std::size_t{1} << 18;

Descriptor opened(const fs::path& path) {
  require_whole_name(path);
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

/// What a signal handler has to know of the files that are aside. Read and changed under Exclusive
/// alone.
struct Register {
  std::vector<const char*> aside;
  bool has_committed = false, may_go_on = false;
};

// Never destroyed: handlers may run after the end of main.
constinit Register* the_register = nullptr;

constinit std::atomic_flag is_busy;

/// One thread at a time makes, renames or removes files that are aside, and is not interrupted: a
/// handler in another thread waits for the few calls that takes, and never for its own.
class Exclusive {
 public:
  Exclusive() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
    acquire();
  }
  ~Exclusive() {
    is_busy.clear();
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  Exclusive(const Exclusive&) = delete;
  Exclusive& operator=(const Exclusive&) = delete;

  static void acquire() {
    while (is_busy.test_and_set()) {
    }
  }

 private:
  sigset_t before_;
};

/// A new file in `folder`, readable as the process's mask says, or the system's reason, negative.
/// Its name does not depend on the target's, which may be as long as names can be.
int create_aside(const fs::path& folder, fs::path& aside) {
  static std::atomic<unsigned> files{0};
  for (;;) {
    const std::string name = std::to_string(::getpid()) + "-" + std::to_string(files++);
    aside = folder / (".dupin-" + name + ".part");
    const Exclusive exclusive;
    if (the_register == nullptr) {
      the_register = new Register;
    }
    the_register->aside.reserve(the_register->aside.size() + 1);
    const int descriptor = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      the_register->aside.push_back(aside.c_str());
    }
    if (descriptor >= 0 || errno != EEXIST) {
      return descriptor >= 0 ? descriptor : -errno;
    }
  }
}

/// The file is there no more, under this name at least.
void forget(const fs::path& aside) {
  std::erase_if(the_register->aside, [&](const char* name) { return name == aside.c_str(); });
}

void remove_aside(const fs::path& aside) {
  const Exclusive exclusive;
  ::unlink(aside.c_str());
  forget(aside);
}

/// Makes the rename last through a power cut. Some file systems cannot, which is no fault of ours.
void sync_directory(const fs::path& file) {
  const fs::path parent = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const Descriptor directory(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.number() >= 0) {
    (void)::fsync(directory.number());
  }
}

/// The file of this name, if it is a large one, lest it is gone for good when another takes its
/// place: the system would free all that it holds before it goes on.
Descriptor held_if_large(const fs::path& path) {
  Descriptor file(::open(path.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  const bool is_large = file.number() >= 0 && ::fstat(file.number(), &status) == 0 &&
                        static_cast<std::uint64_t>(status.st_size) >= kMuch;
  return Descriptor(is_large ? file.release() : -1);
}

/// Nobody waits for that.
void close_meanwhile(Descriptor& file) {
  const int number = file.release();
  if (number < 0) {
    return;
  }
  try {
    std::thread([number] { const Descriptor held(number); }).detach();
  } catch (const std::system_error&) {  // no more threads
    const Descriptor held(number);
  }
}

struct Target {
  fs::path path;
  bool exists = false, replaceable = true;
  mode_t mode = 0;
};

Target target_of(const fs::path& path) {
  require_whole_name(path);
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) {
    fail("write the file", path, errno);
  }
  if (!exists) {
    return {end_of_links(path)};
  }
  if (S_ISDIR(status.st_mode)) {
    fail("write the file", path, EISDIR);
  }
  if (::access(path.c_str(), W_OK) != 0) {
    fail("write the file", path, errno);
  }
  Target target{path, true, S_ISREG(status.st_mode), status.st_mode};
  if (target.replaceable) {
    // Links in /proc may point to what has no name any more.
    fs::path real = end_of_links(path);
    struct stat there {};
    target.replaceable = ::stat(real.c_str(), &there) == 0 && there.st_dev == status.st_dev &&
                         there.st_ino == status.st_ino;
    target.path = target.replaceable ? real : path;
  }
  return target;
}

/// Writes, with the permissions of what will be replaced; 0 or the system's reason.
int fill(Descriptor& file, std::string_view bytes, const Target& target) {
  int reason = write_all(file.number(), bytes);
  if (reason == 0 && target.exists && target.replaceable &&
      ::fchmod(file.number(), target.mode & 07777U) != 0) {
    reason = errno;
  }
  if (reason == 0 && ::fsync(file.number()) != 0) {
    reason = errno;
  }
  const int close_reason = file.close();
  return reason != 0 ? reason : close_reason;
}

/// What somebody else has opened, and closes.
class LeftOpen : public Descriptor {
 public:
  using Descriptor::Descriptor;
  LeftOpen(const LeftOpen&) = delete;
  LeftOpen& operator=(const LeftOpen&) = delete;
  ~LeftOpen() { (void)release(); }
};

// See files::read_whole().
std::string read_open(const Descriptor& file, const fs::path& path, std::uint64_t most) {
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) {
    fail("read the file", path, errno);
  }
  const std::uint64_t size =
      S_ISREG(status.st_mode) ? static_cast<std::uint64_t>(status.st_size) : 0;
  std::string bytes(S_ISREG(status.st_mode) ? size + 1 : 65536, '\0');
  for (std::size_t filled = 0;;) {
    const std::size_t taken = read_some(file, std::span(bytes).subspan(filled), path);
    filled += taken;
    if (taken == 0) {
      bytes.resize(filled);
      return bytes;
    }
    if (filled > size && filled - size > most) {
      throw Error(Errc::limit_exceeded,
                  "is a pipe, a device or grows, and has not ended after " +
                      decimal_at_most(double(filled) / 1e6) + " MB; allowed are " +
                      decimal_at_most(double(most) / 1e6) + " MB, or a regular file of any size",
                  {}, path.string());
    }
    if (filled == bytes.size()) {
      bytes.resize(2 * bytes.size());
    }
  }
}

// While the bytes are moved to more memory, they take three times as much.
std::uint64_t most_without_end() {
  return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) / 4;
}

}  // namespace

std::string files::read_whole(const fs::path& path, std::uint64_t most) {
  return read_open(opened(path), path, most);
}

std::string read_file(const fs::path& path) { return files::read_whole(path, most_without_end()); }

std::string read_standard_input(const std::string& shown) {
  const LeftOpen file(STDIN_FILENO);
  return read_open(file, shown, most_without_end());
}

AsideFile::AsideFile(const fs::path& path, std::string_view bytes) {
  const Target target = target_of(path);
  target_ = target.path;
  replaceable_ = target.replaceable;
  Descriptor file(create_aside(replaceable_ ? target_.parent_path() : temporary_folder(), aside_));
  if (file.number() < 0) {
    fail("create a file beside it", target_, -file.number());
  }
  pending_ = true;
  if (const int reason = fill(file, bytes, target); reason != 0) {
    remove_aside(aside_);
    fail("write the file", target_, reason);
  }
}

AsideFile::AsideFile(const fs::path& path, const AsidePath& made) : aside_(made.path) {
  const Target target = target_of(path);
  target_ = target.path;
  replaceable_ = target.replaceable;
  const Exclusive exclusive;
  if (the_register == nullptr) {
    the_register = new Register;
  }
  the_register->aside.push_back(aside_.c_str());
  pending_ = true;
}

AsideFile::~AsideFile() {
  if (pending_) {
    remove_aside(aside_);
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

bool AsideFile::holds_at(std::uint64_t at, std::string_view bytes) const {
  const Descriptor file = opened(aside_);
  if (::lseek(file.number(), static_cast<off_t>(at), SEEK_SET) < 0) {
    fail("read the file", aside_, errno);
  }
  std::vector<char> piece(std::min(kPiece, bytes.size()));
  while (!bytes.empty()) {
    const std::size_t wanted = std::min(piece.size(), bytes.size());
    const std::size_t size = read_some(file, std::span(piece).first(wanted), aside_);
    if (size == 0 || !bytes.starts_with(std::string_view(piece.data(), size))) {
      return false;
    }
    bytes.remove_prefix(size);
  }
  return true;
}

void AsideFile::append(std::string_view bytes) { write(O_APPEND, 0, bytes); }

void AsideFile::replace(std::uint64_t at, std::string_view bytes) { write(0, at, bytes); }

void AsideFile::write(int flags, std::uint64_t at, std::string_view bytes) {
  Descriptor file(::open(aside_.c_str(), O_WRONLY | O_CLOEXEC | flags));
  if (file.number() < 0 || ::lseek(file.number(), static_cast<off_t>(at), SEEK_SET) < 0) {
    fail("write the file", target_, errno);
  }
  int reason = write_all(file.number(), bytes);
  unsent_ += bytes.size();
  if (reason == 0 && unsent_ >= kMuch) {
    // The disk begins, so that sync() has less to wait for; it is no fault if it does not.
    (void)::sync_file_range(file.number(), 0, 0, SYNC_FILE_RANGE_WRITE);
    unsent_ = 0;
  }
  reason = reason != 0 ? reason : file.close();
  if (reason != 0) {
    fail("write the file", target_, reason);
  }
  is_synced_ = false;
}

void AsideFile::sync() {
  const Descriptor file = opened(aside_);
  if (::fsync(file.number()) != 0) {
    fail("write the file", target_, errno);
  }
  is_synced_ = true;
}

void AsideFile::commit() {
  if (!is_synced_) {
    sync();
  }
  if (!replaceable_) {
    const std::string bytes = read_file(aside_);
    Descriptor device(::open(target_.c_str(), O_WRONLY | O_CLOEXEC));
    const int reason = device.number() < 0 ? errno : write_all(device.number(), bytes);
    if (reason != 0) {
      fail("write the file", target_, reason);
    }
    const Exclusive exclusive;
    the_register->has_committed = true;
    return;
  }
  Descriptor replaced = held_if_large(target_);
  {
    const Exclusive exclusive;
    if (::rename(aside_.c_str(), target_.c_str()) != 0) {
      fail("put the file in place", target_, errno);
    }
    pending_ = false;
    forget(aside_);
    the_register->has_committed = true;
  }
  close_meanwhile(replaced);
  sync_directory(target_);
}

bool abandon_files() noexcept {
  Exclusive::acquire();
  if (the_register != nullptr) {
    if (the_register->has_committed && !the_register->may_go_on) {
      the_register->may_go_on = true;
      is_busy.clear();
      return false;
    }
    for (const char* aside : the_register->aside) {
      ::unlink(aside);
    }
  }
  return true;  // and nobody else is let in
}

fs::path end_of_links(fs::path path) {
  constexpr int kMostLinks = 40;  // as Linux has it
  std::error_code failure;
  for (int i = 0; i < kMostLinks && fs::is_symlink(path, failure); ++i) {
    path = path.parent_path() / fs::read_symlink(path, failure);  // the latter alone if absolute
  }
  return path;
}

void write_file(const fs::path& path, std::string_view bytes) {
  AsideFile file(path, bytes);
  file.commit();
}

}  // namespace dupin
