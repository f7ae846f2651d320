#pragma once

#include <string>

#include <gtest/gtest.h>

#include "dupin/blends/resolve.h"
#include "dupin/io/assembly_json.h"
#include "dupin/kernel/error.h"

namespace dupin::test {

/// A document around one list of parts.
inline std::string document(const std::string& parts) {
  return R"({"units": "mm", "tolerance": 0.05, "parts": [)" + parts + "]}";
}

inline constexpr const char* kPipe =
    R"({"name": "a", "pipe": {"from": [0, 0, 0], "to": [9, 0, 0], "radius": 1}})";
inline constexpr const char* kOther =
    R"({"name": "b", "pipe": {"from": [15, 3, 0], "to": [20, 3, 0], "radius": 2}})";

inline std::string pipe_and(const std::string& part) {
  std::string parts = kPipe;
  parts += ", ";
  parts += part;
  return document(parts);
}

inline constexpr const char* kTee =
    R"({"name": "run", "pipe": {"from": [-9, 0, 0], "to": [9, 0, 0], "radius": 2}},
       {"name": "branch", "pipe": {"from": [0, 0, 0], "to": [0, 0, 9], "radius": 1}}, )";

inline std::string tee_and(const std::string& part) { return document(kTee + part); }

/// A document that is refused, by reading or, with another code, by resolving.
struct Malformed {
  std::string text, where, message;
  Errc code = Errc::parse_failed;
};

inline void expect_fault(const Malformed& row) {
  try {
    (void)resolve(parse_assembly(row.text, "d.json"));
    ADD_FAILURE() << "accepted: " << row.text;
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), row.where) << row.text;
    EXPECT_EQ(error.what(), row.where + ": " + row.message) << row.text;
    EXPECT_EQ(name(error.code()), name(row.code)) << row.text;
  }
}

/// The shape of the last part of a document.
template <class Shape>
Shape read_last(const std::string& text) {
  return std::get<Shape>(parse_assembly(text).parts.back().shape);
}

}  // namespace dupin::test
