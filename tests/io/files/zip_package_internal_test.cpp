#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "files/zip_package.h"

namespace dupin::files {
namespace {

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(ZipPackage, gives_back_what_was_put_in) {
  const std::string big(100000, 'x');
  const std::string zip =
      zip_archive({{"a/b.txt", std::string("1\0002", 3)}, {"big", big}, {"e", ""}});
  EXPECT_EQ(unzip(zip, "a/b.txt", "f"), std::string("1\0002", 3));
  EXPECT_EQ(unzip(zip, "A/B.TXT", "f"), std::string("1\0002", 3)) << "names in any case";
  EXPECT_EQ(unzip(zip, "big", "f"), big);
  EXPECT_EQ(unzip(zip, "e", "f"), "");
  EXPECT_LT(zip.size(), 2000U) << "it is compressed";
}

TEST(ZipPackage, of_the_same_entries_has_the_same_bytes) {
  EXPECT_EQ(zip_archive({{"a", "1"}, {"b", "2"}}), zip_archive({{"a", "1"}, {"b", "2"}}));
  EXPECT_NE(zip_archive({{"a", "1"}, {"b", "2"}}), zip_archive({{"b", "2"}, {"a", "1"}}));
}

TEST(ZipPackage, faults_are_told_with_the_file) {
  const std::string zip = zip_archive({{"a", "some text that is stored or deflated"}});
  EXPECT_EQ(message_of([&] { (void)unzip("junk", "a", "f"); }),
            "f: found no ZIP archive (Not a zip archive), expected a 3MF package");
  EXPECT_EQ(message_of([&] { (void)unzip(zip, "b", "f"); }),
            "f: found no entry 'b' in the ZIP archive, expected one");
}

TEST(ZipPackage, damaged_contents_are_noticed) {
  const std::string text = "some text that is stored or deflated, twice: some text that is";
  const std::string zip = zip_archive({{"a", text}});
  std::size_t refused = 0;
  for (std::size_t place = 31; place < zip.size(); ++place) {
    std::string damaged = zip;
    damaged[place] = static_cast<char>(damaged[place] ^ 4);
    try {
      EXPECT_EQ(unzip(damaged, "a", "f"), text) << "other contents with byte " << place;
    } catch (const Error& error) {
      const bool is_told = error.code() == Errc::parse_failed ||
                           error.code() == Errc::limit_exceeded;  // by a damaged size
      EXPECT_TRUE(is_told) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, text.size() / 2);
}

TEST(ZipPackage, entries_that_expand_without_measure_are_refused) {
  const std::string zip = zip_archive({{"a", std::string(std::size_t{65} << 20, ' ')}});
  try {
    (void)unzip(zip, "a", "f");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded);
  }
}

}  // namespace
}  // namespace dupin::files
