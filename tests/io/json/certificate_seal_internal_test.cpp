#include <string>

#include <gtest/gtest.h>

#include "dupin/io/sha256.h"
#include "json/certificate_seal.h"

namespace dupin::json {
namespace {

const std::string kBeginning = "{\n  \"claims\": [1, 2],\n";

TEST(CertificateSeal, is_the_digest_of_all_before_it) {
  EXPECT_EQ(sealed(kBeginning), kBeginning + "  \"sha256\": \"" + sha256(kBeginning) + "\"\n}\n");
  EXPECT_TRUE(has_seal(sealed(kBeginning)));
  EXPECT_TRUE(has_seal(sealed("")));
}

TEST(CertificateSeal, is_broken_by_every_change) {
  const std::string text = sealed(kBeginning);
  for (std::size_t place = 0; place < text.size(); ++place) {
    std::string changed = text;
    changed[place] = static_cast<char>(changed[place] ^ 1);
    EXPECT_FALSE(has_seal(changed)) << place;
    EXPECT_FALSE(has_seal(text.substr(0, place))) << place;
  }
  EXPECT_FALSE(has_seal(text + "\n"));
  EXPECT_FALSE(has_seal(" " + text));
}

}  // namespace
}  // namespace dupin::json
