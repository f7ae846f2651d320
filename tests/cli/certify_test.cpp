#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

using Certify = Tool;

TEST_F(Certify, proves_an_example_and_verify_agrees) {
  const std::string reducer = example("reducer.json");
  const auto proved = json({"certify", reducer, "-o", "a.cert.json"}, 0);
  EXPECT_EQ(proved.at("findings"), 0);
  EXPECT_EQ(proved.at("parts").size(), 3);
  EXPECT_EQ(json({"verify", "a.cert.json", reducer}, 0), proved);
  const ProcessResult other = dupin({"verify", "a.cert.json", example("u-bend.json")});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_THAT(other.err, HasSubstr("the certificate is not about this document"));
}

TEST_F(Certify, takes_the_tolerance_of_the_command_line) {
  const std::string reducer = example("reducer.json");
  const auto bound_of = [&](const std::string& tolerance) {
    return json({"certify", reducer, "-o", "a.cert.json", "--tolerance", tolerance}, 0)
        .at("parts")[2]
        .at("error_bound")
        .get<double>();
  };
  EXPECT_LE(bound_of("0.01mm"), 0.01);
  EXPECT_GT(bound_of("0.1mm"), 0.01);
}

TEST_F(Certify, a_claim_that_is_too_bold_is_a_finding) {
  const ProcessResult result =
      dupin({"certify", example("reducer.json"), "-o", "-", "--margin", "0.5"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("refuted: blend: margin above 0.5\n"));
  EXPECT_EQ(dupin({"verify", "-", "-q"}, result.out).exit_code, 1);
}

}  // namespace
}  // namespace dupin::test
