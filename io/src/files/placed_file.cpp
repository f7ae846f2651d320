#include "files/placed_file.h"

#include <algorithm>
#include <span>
#include <vector>

#include "dupin/kernel/error.h"

namespace dupin::files {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 20;

}  // namespace

std::unique_ptr<AsideFile> joint_aside(const std::filesystem::path& target,
                                       const Processes* processes) {
  std::unique_ptr<AsideFile> file;
  if (processes == nullptr || processes->is_first()) {
    file = std::make_unique<AsideFile>(target);
  }
  if (processes != nullptr) {
    const auto made = processes->exchanged(file ? file->path().string() : std::string());
    if (!file) {
      file = std::make_unique<AsideFile>(target, AsidePath{made.front()});
    }
  }
  return file;
}

PlacedFile::PlacedFile(const std::filesystem::path& target, const Processes* processes)
    : shown_(target.string()),
      processes_(processes != nullptr && processes->count() > 1 ? processes : nullptr),
      file_(joint_aside(target, processes_)),
      joint_(processes_ == nullptr ? nullptr : processes_->open(file_->path(), shown_)) {}

void PlacedFile::write(std::uint64_t at, std::string_view bytes) {
  if (joint_) {
    joint_->write(at, bytes);
  } else {
    file_->replace(at, bytes);
  }
  if (!holds_at(at, bytes)) {
    throw Error(Errc::io_failed, "what was written is not what is read back", {}, shown_);
  }
}

void PlacedFile::flush() {
  if (!joint_) {
    file_->sync();
  }
}

bool PlacedFile::holds_at(std::uint64_t at, std::string_view bytes) const {
  if (!joint_) {
    return file_->holds_at(at, bytes);
  }
  std::vector<char> piece(std::min(kPiece, bytes.size()));
  while (!bytes.empty()) {
    const std::span<char> part = std::span(piece).first(std::min(piece.size(), bytes.size()));
    if (joint_->read(at, part) < part.size() ||
        !bytes.starts_with(std::string_view(part.data(), part.size()))) {
      return false;
    }
    at += part.size();
    bytes.remove_prefix(part.size());
  }
  return true;
}

void PlacedFile::abandon() {
  if (joint_) {
    joint_->close();
    joint_.reset();
    (void)processes_->exchanged({});  // the first one removes it
  }
}

void PlacedFile::commit(std::string_view first_bytes) {
  if (joint_) {
    joint_->close();
    joint_.reset();
    (void)processes_->exchanged({});  // closing need not wait for those that still write
  }
  if (processes_ == nullptr || processes_->is_first()) {
    write(0, first_bytes);
    file_->commit();
  }
  if (processes_ != nullptr) {
    (void)processes_->exchanged({});
  }
}

}  // namespace dupin::files
