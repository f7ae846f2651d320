#pragma once

#include <zip.h>

// Of libzip what packages are read and written with; it brings a library of cryptography along.
#define DUPIN_ZIP_FUNCTIONS(FUNCTION) \
  FUNCTION(close)                     \
  FUNCTION(discard)                   \
  FUNCTION(error_fini)                \
  FUNCTION(error_init)                \
  FUNCTION(error_strerror)            \
  FUNCTION(fclose)                    \
  FUNCTION(file_add)                  \
  FUNCTION(file_set_dostime)          \
  FUNCTION(file_strerror)             \
  FUNCTION(fopen_index)               \
  FUNCTION(fread)                     \
  FUNCTION(name_locate)               \
  FUNCTION(open_from_source)          \
  FUNCTION(set_file_compression)      \
  FUNCTION(source_buffer)             \
  FUNCTION(source_buffer_create)      \
  FUNCTION(source_close)              \
  FUNCTION(source_free)               \
  FUNCTION(source_keep)               \
  FUNCTION(source_open)               \
  FUNCTION(source_read)               \
  FUNCTION(source_stat)               \
  FUNCTION(stat_index)                \
  FUNCTION(strerror)

namespace dupin::files {

/// Its functions, without "zip_".
struct Zip {
#define DUPIN_ZIP_MEMBER(name) decltype(&::zip_##name) name = nullptr;
  DUPIN_ZIP_FUNCTIONS(DUPIN_ZIP_MEMBER)
#undef DUPIN_ZIP_MEMBER
};

/// Loaded when it is first asked for. Throws Error{invalid_argument} if it is not there.
[[nodiscard]] const Zip& zip();

}  // namespace dupin::files
