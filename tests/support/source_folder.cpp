#include "support/source_folder.h"

namespace dupin::test {

std::filesystem::path source_folder() { return DUPIN_SOURCE_DIR; }

}  // namespace dupin::test
