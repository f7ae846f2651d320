#include "dupin/io/schema.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/kernel/error.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

const std::filesystem::path kFolder = test::source_folder() / "io";

TEST(Schema, is_the_file_in_the_sources) {
  EXPECT_EQ(assembly_schema(), read_file(kFolder / "assembly.schema.json"));
  EXPECT_EQ(certificate_schema(), read_file(kFolder / "certificate.schema.json"));
}

TEST(Schema, a_document_may_say_where_it_is) {
  const std::string rest =
      R"("units": "mm", "tolerance": 1, "parts": [{"name": "a", "sphere": {"center": [0, 0, 0], "radius": 1}}]})";
  EXPECT_EQ(document_text(parse_assembly(R"({"$schema": "a.json", )" + rest)),
            document_text(parse_assembly("{" + rest)));
  try {
    (void)parse_assembly(R"({"$schema": 1, )" + rest, "a.json");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "a.json#/$schema");
  }
}

}  // namespace
}  // namespace dupin
