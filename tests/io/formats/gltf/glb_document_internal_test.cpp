#include <string>

#include <gtest/gtest.h>

#include "dupin/io/glb.h"
#include "dupin/kernel/error.h"
#include "formats/gltf/glb_document.h"
#include "io/formats/gltf/glb_parts.h"
#include "support/message_of.h"
#include "support/sample_meshes.h"

namespace dupin::formats {
namespace {

std::string message_of(const auto& action) { return test::message_of(action, Errc::parse_failed); }

TEST(GlbDocument, members_are_there_or_their_place_is_told) {
  const std::string glb =
      test::with_json(glb_bytes(test::tetrahedron()),
                      R"({"n": 7, "names": [{"name": " a\u0001b "}, {"name": 3}, "\u00e4"]})");
  const GlbDocument document(glb, "x");
  EXPECT_EQ(document.bytes().size(), 96U);
  EXPECT_EQ(document.count("names"), 3U);
  EXPECT_EQ(document.count("none"), 0U);
  EXPECT_EQ(document.unsigned_member(document.json(), "", "n"), 7U);
  EXPECT_EQ(document.unsigned_member(document.json(), "", "m", 5), 5U);
  EXPECT_EQ(document.name(*document.entry(0, "names").first), "a b");
  EXPECT_EQ(document.name(*document.entry(1, "names").first), "");
  EXPECT_EQ(document.name(*document.entry(2, "names").first), "");
  EXPECT_EQ(message_of([&] { (void)document.entry(3, "names"); }),
            "x:/names/3: found nothing there, expected an entry");
  EXPECT_EQ(message_of([&] { (void)document.count("n"); }), "x:/n: found no array, expected one");
  EXPECT_EQ(message_of([&] { (void)document.unsigned_member(document.json(), "", "m"); }),
            "x:: found no 'm', expected one");
}

}  // namespace
}  // namespace dupin::formats
