#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "dupin/blends/part_measures.h"
#include "io/json/document_fault.h"

namespace dupin {
namespace {

using test::expect_fault;
using test::Malformed;
using test::pipe_and;
using test::read_last;

// How deep the head on a pipe of radius 1 is.
double depth(const std::string& form) {
  const auto resolved = resolve(
      parse_assembly(pipe_and(R"({"name": "h", "head": {"from": "a.end", )" + form + "}}")));
  return port_ring(resolved.parts[1].shape, End::end)->center.x() - 9;
}

TEST(HeadKey, has_the_depth_of_its_form) {
  EXPECT_NEAR(depth(R"("form": "ellipsoidal")"), 0.5, 1e-5);
  EXPECT_NEAR(depth(R"("form": "ellipsoidal", "depth": 0.8)"), 0.8, 1e-5);
  // DIN 28011 and DIN 28013: about 0.1935 and 0.255 of the outside diameter, from the crown's and
  // the knuckle's radius.
  const auto of_diameter = [](double crown, double knuckle) {
    return crown - std::sqrt(std::pow(crown - knuckle, 2) - std::pow(0.5 - knuckle, 2));
  };
  EXPECT_NEAR(depth(R"("form": "kloepper")"), 2 * of_diameter(1, 0.1), 1e-5);
  EXPECT_NEAR(depth(R"("form": "korbbogen")"), 2 * of_diameter(0.8, 0.154), 1e-5);
  EXPECT_EQ(depth(R"("form": "torispherical", "crown": 2, "knuckle": 0.2)"),
            depth(R"("form": "kloepper")"));
}

TEST(HeadKey, is_closed_at_its_end) {
  const std::string text =
      pipe_and(R"({"name": "h", "head": {"from": "a.end", "form": "kloepper"}})");
  EXPECT_EQ(read_last<TorisphericalHead>(text).form, HeadForm::kloepper);
  const auto resolved = resolve(parse_assembly(text));
  EXPECT_EQ(ports(resolved).size(), 3) << "the pipe's two and the start";
  EXPECT_EQ(resolved.parts[1].end_names[1], "h");
}

TEST(HeadKey, says_what_is_wrong_with_it) {
  constexpr Errc kBad = Errc::invalid_argument;
  const auto head = [](const std::string& keys) {
    return pipe_and(R"({"name": "h", "head": {)" + keys + "}}");
  };
  const std::string at = "d.json#/parts/1/head";
  const Malformed rows[] = {
      {head(R"("from": "a.end")"), at, "the key 'form' is missing"},
      {head(R"("from": "a.end", "form": "flat")"), at + "/form",
       R"(must be "ellipsoidal", "torispherical", "kloepper" or "korbbogen", not "flat")"},
      {head(R"("from": "a.end", "form": "kloepper", "depth": 1)"), at + "/depth",
       "unknown key; known here are from, form"},
      {head(R"("from": "a.end", "form": "torispherical", "crown": 2)"), at,
       "the key 'knuckle' is missing"},
      {head(R"("from": "a.end", "form": "ellipsoidal", "depth": 0)"), at + "/depth",
       "'h': must be a positive number between 1e-12 and 1e12, not 0", kBad},
      {head(R"("from": "a.end", "form": "torispherical", "crown": 2, "knuckle": 1)"),
       at + "/knuckle",
       "'h': the knuckle's radius must be less than the pipe's, 1, and the crown's larger", kBad},
      {head(R"("from": "a.end", "form": "torispherical", "crown": 1, "knuckle": 0.1)"),
       at + "/crown",
       "'h': the knuckle's radius must be less than the pipe's, 1, and the crown's larger", kBad},
      {pipe_and(R"({"name": "h", "head": {"from": "a.end", "form": "kloepper"}},
                   {"name": "b", "pipe": {"from": "h.end", "length": 1}})"),
       "d.json#/parts/2/pipe/from", "'b': 'h' is closed: it has no end", kBad},
  };
  for (const auto& row : rows) {
    expect_fault(row);
  }
}

}  // namespace
}  // namespace dupin
