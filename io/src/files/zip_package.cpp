#include "files/zip_package.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "dupin/kernel/error.h"
#include "files/late_zip.h"

namespace dupin::files {
namespace {

constexpr std::uint64_t kAlwaysAllowed = std::uint64_t{64} << 20;
constexpr std::uint64_t kLargestRatio = 200;  // XML with many equal numbers reaches about 50
constexpr int kFastCompression = 1;           // level 6 takes four times as long for 10 % less

class ZipError {
 public:
  ZipError() { zip().error_init(&error_); }
  ~ZipError() { zip().error_fini(&error_); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;
  zip_error_t* get() { return &error_; }
  [[nodiscard]] std::string message() { return zip().error_strerror(&error_); }

 private:
  zip_error_t error_;
};

struct Discard {
  void operator()(zip_t* archive) const { zip().discard(archive); }
  void operator()(zip_source_t* source) const { zip().source_free(source); }
  void operator()(zip_file_t* entry) const { zip().fclose(entry); }
};
using Handle = std::unique_ptr<zip_t, Discard>;
using Source = std::unique_ptr<zip_source_t, Discard>;
using Entry = std::unique_ptr<zip_file_t, Discard>;

[[noreturn]] void fail_to_write(const std::string& reason) {
  throw Error(Errc::io_failed, "cannot write the ZIP archive: " + reason);
}

[[noreturn]] void fail_to_read(std::string_view file, const std::string& message) {
  throw Error(Errc::parse_failed, message, {}, std::string(file));
}

void add_entry(zip_t* archive, const ZipEntry& entry) {
  Source source(zip().source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0));
  const zip_int64_t index =
      source ? zip().file_add(archive, entry.name.c_str(), source.get(), ZIP_FL_ENC_UTF_8) : -1;
  if (index < 0) {
    fail_to_write(zip().strerror(archive));
  }
  (void)source.release();  // the archive has it now
  const auto place = static_cast<zip_uint64_t>(index);
  constexpr zip_uint16_t kMidnight = 0;
  constexpr zip_uint16_t kFirstOf1980 = (1U << 5) | 1U;  // the earliest date that ZIP can tell
  if (zip().set_file_compression(archive, place, ZIP_CM_DEFLATE, kFastCompression) != 0 ||
      zip().file_set_dostime(archive, place, kMidnight, kFirstOf1980, 0) != 0) {
    fail_to_write(zip().strerror(archive));
  }
}

// Names of parts are pieces of URIs (ECMA-376 part 2); what writes the archive may not know that.
std::string decoded(std::string_view name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = name.data() + i + 1;
    if (name[i] == '%' && i + 2 < name.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      result += static_cast<char>(byte);
      i += 2;
    } else {
      result += name[i];
    }
  }
  return result;
}

std::string contents(zip_source_t* source) {
  zip_stat_t status;
  if (zip().source_stat(source, &status) != 0 || zip().source_open(source) != 0) {
    fail_to_write("no memory");
  }
  std::string bytes(status.size, '\0');
  const zip_int64_t taken = zip().source_read(source, bytes.data(), bytes.size());
  zip().source_close(source);
  if (taken != static_cast<zip_int64_t>(bytes.size())) {
    fail_to_write("no memory");
  }
  return bytes;
}

}  // namespace

std::string zip_archive(const std::vector<ZipEntry>& entries) {
  ZipError error;
  Source buffer(zip().source_buffer_create(nullptr, 0, 0, error.get()));
  if (!buffer) {
    fail_to_write(error.message());
  }
  Handle archive(zip().open_from_source(buffer.get(), ZIP_TRUNCATE, error.get()));
  if (!archive) {
    fail_to_write(error.message());
  }
  zip().source_keep(buffer.get());  // the archive frees one reference, we the other
  for (const ZipEntry& entry : entries) {
    add_entry(archive.get(), entry);
  }
  if (zip().close(archive.get()) != 0) {
    fail_to_write(zip().strerror(archive.get()));
  }
  (void)archive.release();  // closed
  return contents(buffer.get());
}

std::string part_name(std::string_view target) {
  std::vector<std::string_view> steps;
  while (!target.empty()) {
    const std::string_view step = target.substr(0, target.find('/'));
    target.remove_prefix(std::min(step.size() + 1, target.size()));
    if (step == ".." && !steps.empty()) {
      steps.pop_back();
    } else if (!step.empty() && step != "." && step != "..") {
      steps.push_back(step);
    }
  }
  std::string name;
  for (const std::string_view step : steps) {
    name += (name.empty() ? "" : "/") + std::string(step);
  }
  return name;
}

struct ZipPackage::Archive {
  Handle zip;
};

ZipPackage::ZipPackage(std::string_view bytes, std::string_view file)
    : file_(file), size_(bytes.size()) {
  ZipError error;
  Source buffer(zip().source_buffer_create(bytes.data(), bytes.size(), 0, error.get()));
  Handle archive(buffer ? zip().open_from_source(buffer.get(), ZIP_RDONLY, error.get()) : nullptr);
  if (!archive) {
    fail_to_read(file, "found no ZIP archive (" + error.message() + "), expected a 3MF package");
  }
  (void)buffer.release();  // the archive has it now
  archive_ = std::make_unique<Archive>(Archive{std::move(archive)});
}

ZipPackage::~ZipPackage() = default;

std::int64_t ZipPackage::place_of(const std::string& name) const {
  zip_t* const archive = archive_->zip.get();
  const zip_int64_t index = zip().name_locate(archive, name.c_str(), 0);
  return index >= 0 ? index : zip().name_locate(archive, name.c_str(), ZIP_FL_NOCASE);
}

std::string ZipPackage::read(std::string_view name) {
  zip_t* const archive = archive_->zip.get();
  const std::string wanted(name);
  zip_int64_t index = place_of(wanted);
  if (index < 0) {
    index = place_of(decoded(wanted));
  }
  zip_stat_t status;
  if (index < 0 || zip().stat_index(archive, static_cast<zip_uint64_t>(index), 0, &status) != 0) {
    fail_to_read(file_, "found no entry '" + wanted + "' in the ZIP archive, expected one");
  }
  if (status.size > kAlwaysAllowed && status.size > kLargestRatio * status.comp_size) {
    throw Error(Errc::limit_exceeded,
                "the entry '" + wanted + "' expands from " + std::to_string(status.comp_size) +
                    " to " + std::to_string(status.size) + " bytes, more than 200 times its size",
                {}, file_);
  }
  expanded_ += status.size;
  if (expanded_ > kAlwaysAllowed && expanded_ > kLargestRatio * size_) {
    throw Error(Errc::limit_exceeded,
                "the entries of the ZIP archive expand from " + std::to_string(size_) +
                    " bytes to more than 200 times as many",
                {}, file_);
  }
  const Entry entry(zip().fopen_index(archive, static_cast<zip_uint64_t>(index), 0));
  if (!entry) {
    fail_to_read(file_, "cannot read the entry '" + wanted + "' (" + zip().strerror(archive) +
                            "), expected one that is stored or deflated, and not encrypted");
  }
  std::string bytes(status.size, '\0');
  std::size_t filled = 0;
  zip_int64_t taken = 1;
  while (taken > 0) {
    // At the declared end one more read makes libzip compare the checksum, and tells of more data.
    char surplus = 0;
    const bool full = filled == bytes.size();
    taken = zip().fread(entry.get(), full ? &surplus : bytes.data() + filled,
                        full ? 1 : bytes.size() - filled);
    filled += taken > 0 ? static_cast<std::size_t>(taken) : 0;
    if (filled > bytes.size()) {
      taken = -1;
    }
  }
  if (taken < 0 || filled != bytes.size()) {
    fail_to_read(file_, "found a damaged entry '" + wanted + "' (" +
                            zip().file_strerror(entry.get()) + "), expected its " +
                            std::to_string(bytes.size()) + " bytes");
  }
  return bytes;
}

std::string unzip(std::string_view archive, std::string_view name, std::string_view file) {
  return ZipPackage(archive, file).read(name);
}

}  // namespace dupin::files
