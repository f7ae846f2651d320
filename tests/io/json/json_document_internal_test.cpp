#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "json/json_document.h"
#include "support/message_of.h"

namespace dupin::json {
namespace {

std::string message_of(const auto& action) { return test::message_of(action, Errc::parse_failed); }

TEST(JsonDocument, text_that_is_no_json_is_refused_with_line_and_column) {
  EXPECT_EQ(message_of([] { (void)parse_json("{\n \"a\": x}", "d").size(); }).substr(0, 7),
            "d:2:7: ");
  EXPECT_EQ(message_of([] { (void)parse_json("[1, 1e999]", "d").size(); }),
            "d:1:5: number overflow parsing '1e999'");
  EXPECT_EQ(message_of([] { (void)parse_json("", "d").size(); }).substr(0, 6), "d:1:1:");
}

TEST(JsonDocument, a_nul_byte_is_no_end) {
  for (const std::string behind : {"", "\n", " {"}) {
    const std::string text = std::string("{\"a\":\n 1}") + '\0' + behind;
    EXPECT_EQ(message_of([&] { (void)parse_json(text, "d").size(); }),
              "d:2:4: found a NUL byte behind the document, expected its end");
  }
}

TEST(JsonDocument, a_key_that_occurs_twice_is_refused_with_its_pointer) {
  EXPECT_EQ(
      message_of([] { (void)parse_json(R"({"a": [{}, {"b/c": 1, "b/c": 2}]})", "d").size(); }),
      "d#/a/1/b~1c: the key occurs twice");
  EXPECT_EQ(parse_json(R"([{"a": 1}, {"a": 2}])", "d").size(), 2U) << "in two objects";
}

TEST(JsonDocument, a_node_knows_its_place) {
  const std::string source = "d";
  const Json json = parse_json(R"({"a": [1.5, {"~/": "text"}]})", source);
  const JsonNode root(json, source, "");
  EXPECT_EQ(root.at("a").at(std::size_t{0}).number(), 1.5);
  EXPECT_EQ(root.at("a").require_array(), 2U);
  const JsonNode inner = root.at("a").at(std::size_t{1});
  EXPECT_EQ(inner.at("~/").text(), "text");
  EXPECT_TRUE(inner.has("~/"));
  EXPECT_FALSE(inner.has("b"));
  EXPECT_FALSE(root.at("a").has("b"));
  EXPECT_EQ(message_of([&] { (void)inner.at("~/").number(); }),
            "d#/a/1/~0~1: must be a number, not string");
  EXPECT_EQ(message_of([&] { (void)inner.at("b"); }), "d#/a/1: the key 'b' is missing");
  EXPECT_EQ(message_of([&] { (void)root.at("a").at("b"); }), "d#/a: must be an object, not array");
  EXPECT_EQ(message_of([&] { (void)inner.require_array(); }),
            "d#/a/1: must be an array, not object");
  EXPECT_EQ(message_of([&] { (void)inner.text(); }), "d#/a/1: must be a string, not object");
  EXPECT_EQ(message_of([&] { inner.fail("is odd"); }), "d#/a/1: is odd");
}

TEST(JsonDocument, without_a_source_the_pointer_stands_alone) {
  const std::string source;
  const Json json = parse_json("{\"a\": 1}", source);
  EXPECT_EQ(message_of([&] { JsonNode(json, source, "").at("a").require_object(); }),
            "/a: must be an object, not number");
}

TEST(JsonDocument, that_is_deep_or_has_too_many_keys_is_refused_with_its_place) {
  const std::string deep(100'000, '[');
  EXPECT_THAT(message_of([&] { (void)parse_json("{\n\"a\": " + deep, "d").size(); }),
              testing::HasSubstr("d:2:"));
  std::string keys = "{\"a\": {";
  for (int i = 0; i < 5000; ++i) {
    keys += (i == 0 ? "\"" : ", \"") + std::to_string(i) + "\": 0";
  }
  EXPECT_THAT(message_of([&] { (void)parse_json(keys + "}}", "d").size(); }),
              testing::HasSubstr("d#/a/4096: "));
}

}  // namespace
}  // namespace dupin::json
