#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "files/zip_package.h"
#include "support/message_of.h"

namespace dupin::files {
namespace {

using test::message_of;

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

TEST(ZipPackage, targets_of_relationships_are_names_of_parts) {
  for (const char* const target : {"/3D/a.model", "3D/a.model", "./3D/a.model", "3D/b/../a.model",
                                   "/../3D/./a.model", "//3D//a.model"}) {
    EXPECT_EQ(part_name(target), "3D/a.model") << target;
  }
  for (const char* const target : {"", "/", ".", "..", "a/.."}) {
    EXPECT_EQ(part_name(target), "") << target;
  }
}

TEST(ZipPackage, names_may_be_encoded_or_not) {
  const std::string zip =
      zip_archive({{"a b", "space"}, {"c%20d", "encoded"}, {"50%", "percent"}, {"%zz", "none"}});
  EXPECT_EQ(unzip(zip, "a%20b", "f"), "space");
  EXPECT_EQ(unzip(zip, "A%20B", "f"), "space");
  EXPECT_EQ(unzip(zip, "c%20d", "f"), "encoded");
  EXPECT_EQ(unzip(zip, "50%", "f"), "percent");
  EXPECT_EQ(unzip(zip, "50%25", "f"), "percent");
  EXPECT_EQ(unzip(zip, "%zz", "f"), "none");
  EXPECT_EQ(message_of([&] { (void)unzip(zip, "c d", "f"); }),
            "f: found no entry 'c d' in the ZIP archive, expected one");
}

// The reason is not that it is damaged.
TEST(ZipPackage, entries_that_cannot_be_read_are_told_from_damaged_ones) {
  std::string encrypted = zip_archive({{"a", "text"}}), packed = encrypted;
  const std::size_t entry = encrypted.find("PK\x01\x02");
  ASSERT_NE(entry, std::string::npos);
  for (char* const flags : {&encrypted[6], &encrypted[entry + 8]}) {
    *flags = static_cast<char>(*flags | 1);
  }
  EXPECT_EQ(message_of([&] { (void)unzip(encrypted, "a", "f"); }),
            "f: cannot read the entry 'a' (No password provided), expected one that is stored or "
            "deflated, and not encrypted");
  packed[entry + 10] = packed[8] = 98;  // PPMd
  EXPECT_EQ(message_of([&] { (void)unzip(packed, "a", "f"); }),
            "f: cannot read the entry 'a' (Compression method not supported), expected one that is "
            "stored or deflated, and not encrypted");
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
