#include <string>

#include <gtest/gtest.h>

#include "dupin/io/assembly_json.h"
#include "dupin/io/graph_file.h"
#include "dupin/io/pcf.h"
#include "io/text/utf16_text.h"

namespace dupin {
namespace {

TEST(Utf16Documents, are_called_that_by_every_reader) {
  test::expect_utf16_refused(
      R"({"units": "mm", "parts": []})", "a.json",
      [](const std::string& text, const std::string& file) { (void)parse_assembly(text, file); });
  test::expect_utf16_refused(
      "UNITS-BORE MM\n", "a.pcf",
      [](const std::string& text, const std::string& file) { (void)parse_pcf(text, file); });
  for (const std::string name : {"a.swc", "a.graph", "a"}) {
    test::expect_utf16_refused("1 0 0 0 0 2 -1\n", name,
                               [](const std::string& text, const std::string& file) {
                                 (void)parse_graph_file(text, file);
                               });
  }
}

}  // namespace
}  // namespace dupin
