#include "tiles/build_identity.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <elf.h>
#include <link.h>

#include "dupin/io/atomic_file.h"
#include "dupin/io/sha256.h"

namespace dupin::cli {
namespace {

/// In hexadecimal; empty if the notes have none.
std::string build_id_in(std::string_view notes) {
  constexpr std::size_t kAlignment = 4;
  const auto padded = [](std::size_t size) { return (size + kAlignment - 1) & ~(kAlignment - 1); };
  while (notes.size() >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes.data(), sizeof(note));
    const std::size_t begin = sizeof(note) + padded(note.n_namesz);
    if (begin + note.n_descsz > notes.size()) {
      break;
    }
    const std::string_view owner = notes.substr(sizeof(note), note.n_namesz);
    if (note.n_type == NT_GNU_BUILD_ID && owner.starts_with("GNU") &&
        owner.size() == sizeof("GNU")) {
      std::string digits;
      for (const char c : notes.substr(begin, note.n_descsz)) {
        constexpr std::string_view kDigits = "0123456789abcdef";
        const auto byte = static_cast<unsigned char>(c);
        digits += {kDigits[byte / 16], kDigits[byte % 16]};
      }
      return digits;
    }
    notes.remove_prefix(std::min(notes.size(), begin + padded(note.n_descsz)));
  }
  return {};
}

struct Loaded {
  std::string path, build_id;
};

/// The program, which comes first and has no name, or a library of ours.
int note_loaded(dl_phdr_info* info, std::size_t, void* all) {
  const std::string path = info->dlpi_name;
  if (!path.empty() && !std::filesystem::path(path).filename().string().starts_with("libdupin")) {
    return 0;
  }
  Loaded loaded{path.empty() ? "/proc/self/exe" : path, {}};
  for (const ElfW(Phdr) & segment : std::span(info->dlpi_phdr, info->dlpi_phnum)) {
    if (segment.p_type == PT_NOTE && loaded.build_id.empty()) {
      // NOLINTNEXTLINE(performance-no-int-to-ptr): where the loader says it is
      const auto* const begin = reinterpret_cast<const char*>(info->dlpi_addr + segment.p_vaddr);
      loaded.build_id = build_id_in({begin, segment.p_memsz});
    }
  }
  static_cast<std::vector<Loaded>*>(all)->push_back(std::move(loaded));
  return 0;
}

}  // namespace

const std::string& build_identity() {
  static const std::string identity = [] {
    std::vector<Loaded> all;
    dl_iterate_phdr(note_loaded, &all);
    std::string text;
    for (const Loaded& loaded : all) {
      text += (text.empty() ? "" : " ") +
              (loaded.build_id.empty() ? sha256(read_file(loaded.path)) : loaded.build_id);
    }
    return text;
  }();
  return identity;
}

}  // namespace dupin::cli
