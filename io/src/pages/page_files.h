#pragma once

#include <string_view>

namespace dupin::pages {

/// The files that a page is put together of, as they are in this folder, made into text by
/// cmake/EmbedFiles.cmake; the viewer library as it is installed.
struct PageFiles {
  std::string_view version;  ///< of Dupin
  std::string_view page, style, script;
  std::string_view library, library_licence;  ///< empty in a build without three.js
};

[[nodiscard]] PageFiles page_files();

}  // namespace dupin::pages
