#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "dupin/kernel/tiled_check.h"

namespace dupin {

namespace files {
class Descriptor;
}

/// That of the environment's TMPDIR, if it says one, or else /tmp; there or not.
[[nodiscard]] std::filesystem::path temporary_folder();

/// A temporary file without a name, so that nothing is left of it however the process ends. It is
/// in temporary_folder(). All functions throw Error{io_failed} with the system's reason, naming the
/// folder.
class ScratchFile : public Scratch {
 public:
  ScratchFile();

  void write(std::uint64_t at, std::span<const char> bytes) override;
  void read(std::uint64_t at, std::span<char> bytes) const override;

 private:
  std::filesystem::path folder_;
  std::shared_ptr<const files::Descriptor> file_;
};

}  // namespace dupin
