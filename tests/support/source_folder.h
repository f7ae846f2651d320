#pragma once

#include <filesystem>

namespace dupin::test {

/// The checkout that was built. Not a macro: what a test is compiled to is the same in every
/// checkout, for ccache.
[[nodiscard]] std::filesystem::path source_folder();

}  // namespace dupin::test
