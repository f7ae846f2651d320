#include <gtest/gtest.h>

#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

// A value at the place "/p" of a document.
class Value {
 public:
  explicit Value(const std::string& text) : json_(parse_json(text, source_)) {}
  [[nodiscard]] JsonNode node() const { return {json_, source_, "/p"}; }

 private:
  std::string source_ = "d";
  Json json_;
};

// What `read` makes of a value, or the fault it finds.
template <class Read>
std::string fault(const std::string& text, const Read& read) {
  const Value value(text);
  try {
    (void)read(value.node());
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::parse_failed);
    return error.what();
  }
  return "accepted";
}

TEST(PartValues, vectors_have_three_numbers) {
  EXPECT_EQ(vector(Value("[1, -2.5, 3e2]").node()), Vec3(1, -2.5, 300));
  const std::pair<const char*, const char*> rows[] = {
      {"[1, 2]", "d#/p: must be three numbers [x, y, z], not 2"},
      {"[1, 2, 3, 4]", "d#/p: must be three numbers [x, y, z], not 4"},
      {"[1, 2, \"3\"]", "d#/p/2: must be a number, not string"},
      {"{}", "d#/p: must be an array, not object"},
  };
  for (const auto& [text, message] : rows) {
    EXPECT_EQ(fault(text, vector), message);
  }
}

TEST(PartValues, ports_are_an_end_of_a_part) {
  const std::pair<const char*, PortReference> rows[] = {
      {"\"a.start\"", {"a", End::start}},
      {"\"a.end\"", {"a", End::end}},
      {"\"tank 1.2.end\"", {"tank 1.2", End::end}},
      {"\"start.end.start\"", {"start.end", End::start}},
  };
  for (const auto& [text, expected] : rows) {
    EXPECT_EQ(port(Value(text).node()), expected) << text;
  }
  for (const char* text : {"a", "", "a.", "a.End", ".end", "end", "a.end "}) {
    EXPECT_EQ(
        fault('"' + std::string(text) + '"', port),
        "d#/p: must name a port as 'part.start' or 'part.end', not '" + std::string(text) + "'");
  }
  EXPECT_EQ(fault("7", port), "d#/p: must be a string, not number");
}

TEST(PartValues, whole_numbers_have_32_bits) {
  const std::pair<const char*, std::optional<std::uint32_t>> rows[] = {
      {"0", 0},           {"4294967295", 4294967295},
      {"4294967296", {}}, {"18446744073709551615", {}},
      {"-1", {}},         {"1.0", {}},
      {"\"1\"", {}},      {"true", {}},
  };
  for (const auto& [text, expected] : rows) {
    EXPECT_EQ(whole_number(Value(text).node()), expected) << text;
  }
}

TEST(PartValues, pairs_are_two_numbers_of_a_meaning) {
  const auto read = [](const JsonNode& node) { return pair(node, "start, end"); };
  EXPECT_EQ(read(Value("[1, 2]").node()), (std::array<double, 2>{1, 2}));
  EXPECT_EQ(fault("[1]", read), "d#/p: must be two numbers [start, end]");
  EXPECT_EQ(fault("[1, null]", read), "d#/p/1: must be a number, not null");
}

TEST(PartValues, numbers_may_be_left_to_us) {
  EXPECT_EQ(number_or_auto(Value("0.5").node()), 0.5);
  EXPECT_EQ(number_or_auto(Value("\"auto\"").node()), std::nullopt);
  for (const char* text : {"\"Auto\"", "null", "[1]"}) {
    EXPECT_EQ(fault(text, number_or_auto), "d#/p: must be a number or \"auto\"");
  }
}

TEST(PartValues, sections_are_circles_or_ellipses) {
  const Section circle = section(Value(R"({"radius": 2})").node());
  EXPECT_EQ(circle.radius, 2);
  EXPECT_FALSE(circle.axes);
  const Section ellipse = section(Value(R"({"semi_axes": [2, 3], "axis": [0, 1, 0]})").node());
  EXPECT_EQ(ellipse.radius, 2);
  ASSERT_TRUE(ellipse.axes);
  EXPECT_EQ(ellipse.axes->across, 3);
  EXPECT_EQ(ellipse.axes->axis, Vec3(0, 1, 0));
  EXPECT_EQ(fault(R"({"semi_axes": [2, 3]})", section), "d#/p: the key 'axis' is missing");
  EXPECT_EQ(fault(R"({"semi_axes": 2, "axis": [0, 1, 0]})", section),
            "d#/p/semi_axes: must be an array, not number");
  EXPECT_EQ(fault(R"({"semi_axes": [2], "axis": [0, 1, 0]})", section),
            "d#/p/semi_axes: must be two numbers [along the axis, across it]");
  EXPECT_EQ(fault("{}", section), "d#/p: the key 'radius' is missing");
}

TEST(PartValues, parts_begin_at_a_port_or_a_place) {
  EXPECT_EQ(std::get<PortReference>(origin(Value(R"({"from": "a.end"})").node())),
            (PortReference{"a", End::end}));
  const auto place = std::get<Place>(
      origin(Value(R"({"from": [1, 2, 3], "direction": [0, 0, 2], "radius": 4})").node()));
  EXPECT_EQ(place.point, Vec3(1, 2, 3));
  EXPECT_EQ(place.direction, Vec3(0, 0, 2));
  EXPECT_EQ(place.radius, 4);
  EXPECT_FALSE(place.axes);
  // A section of which the document has the numbers elsewhere.
  const auto other = std::get<Place>(origin(
      Value(R"({"from": [1, 2, 3], "direction": [0, 0, 2]})").node(), {5, SectionAxes{{}, 6}}));
  EXPECT_EQ(other.radius, 5);
  EXPECT_EQ(other.axes.value().across, 6);
}

TEST(PartValues, no_other_keys_are_allowed) {
  const auto read = [](const JsonNode& node) {
    allow_only(node, {"from", "to"});
    return 0;
  };
  for (const char* text : {"{}", R"({"to": 1})", R"({"to": 1, "from": 2})"}) {
    EXPECT_EQ(fault(text, read), "accepted");
  }
  EXPECT_EQ(fault(R"({"to": 1, "form": 2})", read),
            "d#/p/form: unknown key; known here are from, to");
  EXPECT_EQ(fault("[]", read), "d#/p: must be an object, not array");
}

// The second set is for parts from a port, all others for parts from a point.
const std::vector<KeySet> kSets = {{false, {"from", "to", "radius"}},
                                   {true, {"from", "length"}},
                                   {false, {"from", "direction", "length", "radius"}}};

TEST(PartValues, a_set_of_keys_is_found_by_all_of_them) {
  const auto match = [](const JsonNode& node) { return matching_key_set(node, kSets); };
  const std::pair<const char*, std::size_t> rows[] = {
      {R"({"from": [0, 0, 0], "to": 0, "radius": 0})", 0},
      {R"({"radius": 0, "to": 0, "from": [0, 0, 0]})", 0},
      {R"({"from": "a.end", "length": 0})", 1},
      {R"({"from": [0, 0, 0], "direction": 0, "length": 0, "radius": 0})", 2},
      {R"({"from": [0, 0, 0], "to": 0, "semi_axes": 0, "axis": 0})", 0},
  };
  for (const auto& [text, expected] : rows) {
    EXPECT_EQ(match(Value(text).node()), expected) << text;
  }
  const std::pair<const char*, const char*> faults[] = {
      {R"({"from": "a.end"})", "d#/p: from a port, give {from, length}"},
      {R"({"from": "a.end", "length": 0, "radius": 0})", "d#/p: from a port, give {from, length}"},
      {R"({"from": [0, 0, 0], "length": 0})",
       "d#/p: from a point, give {from, to, radius} or {from, direction, length, radius}"},
      {R"({"from": [0, 0, 0], "axis": 0})",
       "d#/p/axis: does not go with the other keys; beside them are known from, to, radius, "
       "length, "
       "direction"},
      {R"({"from": [0, 0, 0], "semi_axes": 0})",
       "d#/p: from a point, give {from, to, semi_axes, axis} or {from, direction, length, "
       "semi_axes, axis}"},
      {R"({"from": [0, 0, 0], "semi_axes": 0, "radius": 0})",
       "d#/p/radius: does not go with the other keys; beside them are known from, to, semi_axes, "
       "axis, length, direction"},
      {R"({"from": [0, 0, 0], "x": 0})",
       "d#/p/x: unknown key; known here are from, to, radius, size, schedule, outside_diameter, "
       "inside_diameter, length, direction, semi_axes, axis"},
      {R"({"to": 0})", "d#/p: the key 'from' is missing"},
      {R"({"from": 1})", "d#/p/from: must be a point [x, y, z] or a port 'part.end', not number"},
  };
  for (const auto& [text, message] : faults) {
    EXPECT_EQ(fault(text, match), message) << text;
  }
}

}  // namespace
}  // namespace dupin::json
