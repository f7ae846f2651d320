#include <set>
#include <string>

#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "json/certificate_motions.h"
#include "support/fillet_loops.h"

namespace dupin::json {
namespace {

TEST(CertificateMotions, are_read_as_they_were_written) {
  std::set<std::string> kinds;
  for (const auto& [name, loop] : test::loops_of_all_kinds()) {
    const Json written = motion_value(loop);
    ASSERT_EQ(written.size(), 1U);
    kinds.insert(written.begin().key());
    const Json again = Json::parse(written.dump());
    const CanalFillet read = certificate_motion(JsonNode(again, "c.json", ""));
    EXPECT_EQ(read.motion.index(), loop.motion.index()) << name;
    EXPECT_EQ(motion_value(read), written) << name;
    for (const double chi : {0.3, 2.1, 4.4}) {
      EXPECT_EQ(ball(read, chi).center, ball(loop, chi).center) << name;
      EXPECT_EQ(ball(read, chi).radius, ball(loop, chi).radius) << name;
    }
  }
  EXPECT_EQ(kinds.size(), 6U);
}

TEST(CertificateMotions, name_what_they_lack) {
  const auto message = [](const Json& json) -> std::string {
    try {
      (void)certificate_motion(JsonNode(json, "c.json", ""));
    } catch (const Error& error) {
      return error.what();
    }
    return "read";
  };
  Json written = motion_value(test::loops_of_all_kinds().front().loop);
  EXPECT_NE(message(Json::object()).find("must have the key of a motion"), std::string::npos);
  written["rolling_through"].erase("height");
  EXPECT_NE(message(written).find("height"), std::string::npos);
  written["rolling_through"]["height"] = "1";
  EXPECT_NE(message(written).find("/rolling_through/height"), std::string::npos);
}

}  // namespace
}  // namespace dupin::json
