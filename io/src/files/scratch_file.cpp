#include "dupin/io/scratch_file.h"

#include <cerrno>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <unistd.h>

#include "dupin/io/system_error.h"
#include "dupin/kernel/error.h"
#include "files/descriptor.h"

namespace dupin {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& action, const fs::path& folder, int reason) {
  throw SystemError("cannot " + action + " a temporary file", reason, folder.string(),
                    "; the environment variable TMPDIR may name another folder");
}

/// A file that has no name, or none any more; -1 if the system refuses.
int nameless(const fs::path& folder) {
  const int direct = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (direct >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)) {
    return direct;
  }
  std::string name = folder / ".dupin-XXXXXX";
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) {
    ::unlink(name.c_str());
  }
  return named;
}

}  // namespace

fs::path temporary_folder() {
  const char* const asked_for = std::getenv("TMPDIR");
  return asked_for != nullptr && *asked_for != '\0' ? asked_for : "/tmp";
}

ScratchFile::ScratchFile() {
  folder_ = temporary_folder();
  file_ = std::make_shared<const files::Descriptor>(nameless(folder_));
  if (file_->number() < 0) {
    fail("make", folder_, errno);
  }
}

void ScratchFile::write(std::uint64_t at, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written =
        ::pwrite(file_->number(), bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (written < 0 && errno != EINTR) {
      fail("write", folder_, errno);
    }
    const std::size_t step = written > 0 ? static_cast<std::size_t>(written) : 0;
    at += step;
    bytes = bytes.subspan(step);
  }
}

void ScratchFile::read(std::uint64_t at, std::span<char> bytes) const {
  if (const int reason = files::read_at(*file_, at, bytes); reason != 0) {
    fail("read", folder_, reason == files::kEnded ? EIO : reason);
  }
}

}  // namespace dupin
