#include <gtest/gtest.h>

#include "files/late_library.h"

namespace dupin::files {
namespace {

TEST(LateLibrary, finds_functions_by_name) {
  LateLibrary library("libm.so.6");
  double (*root)(double) = nullptr;
  library.find(root, "sqrt");
  ASSERT_NE(root, nullptr);
  EXPECT_EQ(root(9), 3);
  EXPECT_EQ(library.missing(), "");
}

TEST(LateLibrary, says_what_it_has_not_found_first) {
  LateLibrary library("libm.so.6");
  double (*first)(double) = nullptr;
  double (*second)(double) = nullptr;
  double (*root)(double) = nullptr;
  library.find(first, "no_such_function");
  library.find(second, "nor_this_one");
  library.find(root, "sqrt");
  EXPECT_EQ(first, nullptr);
  EXPECT_EQ(second, nullptr);
  EXPECT_NE(root, nullptr);
  EXPECT_NE(library.missing().find("no_such_function"), std::string::npos) << library.missing();

  LateLibrary none("libnosuchlibrary.so.1");
  none.find(root, "sqrt");
  EXPECT_EQ(root, nullptr);
  EXPECT_NE(none.missing().find("libnosuchlibrary.so.1"), std::string::npos) << none.missing();
}

}  // namespace
}  // namespace dupin::files
