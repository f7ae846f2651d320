#include <string>

#include <gtest/gtest.h>

#include "json/certificate_pieces.h"

namespace dupin::json {
namespace {

const std::string kSource = "c";

Piece read(const std::string& text) {
  const Json json = parse_json(text, kSource);
  return certificate_piece(JsonNode(json, kSource, ""));
}

const std::string kStart =
    R"("start": {"center": [1, 2, 3], "normal": [0, 0, -1], "radius": 0.5, "slope": 0.25})";
const std::string kEnd =
    R"("end": {"center": [4, 5, 6], "normal": [0, 1, 0], "radius": 0.75, "slope": -0.125,)"
    R"( "ellipse": {"axis": [1, 0, 0], "across": 2, "across_slope": 0.0625}})";

const Ring kStartRing{Vec3(1, 2, 3), Vec3(0, 0, -1), 0.5, 0.25};
const Ring kEndRing{Vec3(4, 5, 6), Vec3(0, 1, 0), 0.75, -0.125, Ellipse{Vec3(1, 0, 0), 2, 0.0625}};

std::string piece(const std::string& kind, const std::string& numbers) {
  return "{\"" + kind + "\": {" + kStart + ", " + kEnd + ", " + numbers + "}}";
}

const std::string kLine = R"("spine": {"line": {"from": [1, 2, 3], "to": [4, 5, 6]}})";
const std::string kConstant = R"("radius": {"constant": [0.5]})";

template <class Kind>
Kind read_as(const std::string& kind, const std::string& numbers) {
  const Kind result = std::get<Kind>(read(piece(kind, numbers)));
  EXPECT_EQ(result.start, kStartRing);
  EXPECT_EQ(result.end, kEndRing);
  return result;
}

TEST(CertificatePieces, ringed_surfaces_have_any_spine) {
  const std::pair<const char*, Spine> rows[] = {
      {R"({"line": {"from": [1, 2, 3], "to": [4, 5, 6]}})",
       LineSpine{Vec3(1, 2, 3), Vec3(4, 5, 6)}},
      {R"({"arc": {"center": [1, 2, 3], "axis": [0, 0, 1], "start": [4, 2, 3], "angle": 1.5}})",
       ArcSpine{Vec3(1, 2, 3), Vec3(0, 0, 1), Vec3(4, 2, 3), 1.5}},
      {R"({"hermite": {"from": [1, 2, 3], "to": [4, 5, 6], "start_velocity": [7, 8, 9], "end_velocity": [10, 11, 12]}})",
       HermiteSpine{Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9), Vec3(10, 11, 12)}},
      {R"({"bezier": {"points": [[1, 2, 3], [4, 5, 6], [7, 8, 9]], "weights": [1, 0.5, 2]}})",
       BezierSpine{{Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9)}, {1, 0.5, 2}}},
      {R"({"bezier": {"points": [[1, 2, 3], [4, 5, 6]], "weights": []}})",
       BezierSpine{{Vec3(1, 2, 3), Vec3(4, 5, 6)}}},
  };
  for (const auto& [text, spine] : rows) {
    const auto surface = read_as<RingedSurface>(
        "ringed_surface", "\"spine\": " + std::string(text) + ", " + kConstant);
    EXPECT_EQ(surface.spine, spine) << text;
  }
}

TEST(CertificatePieces, ringed_surfaces_have_any_law) {
  const std::pair<const char*, RadiusLaw> rows[] = {
      {R"({"constant": [0.5]})", ConstantRadius{0.5}},
      {R"({"linear": [0.5, 0.75]})", LinearRadius{0.5, 0.75}},
      {R"({"cubic": [0.5, 0.75]})", CubicRadius{0.5, 0.75}},
      {R"({"cyclide": [0.5, 0.75]})", CyclideRadius{0.5, 0.75}},
      {R"({"bezier": [0.5, 0.625, 0.75]})", BezierRadius{{0.5, 0.625, 0.75}}},
  };
  for (const auto& [text, law] : rows) {
    const auto surface =
        read_as<RingedSurface>("ringed_surface", kLine + ", \"radius\": " + std::string(text));
    EXPECT_EQ(surface.radius, law) << text;
  }
}

TEST(CertificatePieces, of_other_kinds_have_their_numbers) {
  const auto elliptic = read_as<EllipticTube>(
      "elliptic_tube", kLine + R"(, "first": {"constant": [2]}, "second": {"linear": [0.5, 0.75]},
                   "turn": -0.25, "continuity": "G2")");
  EXPECT_EQ(elliptic.spine, Spine(LineSpine{Vec3(1, 2, 3), Vec3(4, 5, 6)}));
  EXPECT_EQ(elliptic.first, RadiusLaw(ConstantRadius{2}));
  EXPECT_EQ(elliptic.second, RadiusLaw(LinearRadius{0.5, 0.75}));
  EXPECT_EQ(elliptic.turn, -0.25);
  EXPECT_EQ(elliptic.continuity, Continuity::g2);

  const auto cyclide = read_as<CyclidePiece>(
      "cyclide",
      R"("first": [1, 2, 3, 4], "tangent": [5, 6, 7, 8], "last": [9, 10, 11, 12], "chord": 1.5)");
  EXPECT_EQ(cyclide.first, (PeVector{Vec3(1, 2, 3), 4}));
  EXPECT_EQ(cyclide.tangent, (PeVector{Vec3(5, 6, 7), 8}));
  EXPECT_EQ(cyclide.last, (PeVector{Vec3(9, 10, 11), 12}));
  EXPECT_EQ(cyclide.chord, 1.5);

  const auto rational =
      read_as<RationalRingedTube>("rational_ringed_surface",
                                  R"("center": [[1, 0, 0], [2, 0, 0], [3, 0, 0], [4, 0, 0]],
                                     "radius": [0.5, 0.625, 0.75, 0.875],
                                     "rotation": [[1, 0, 0, 0], [0, 1, 2, 3]])");
  EXPECT_EQ(rational.surface.center,
            (std::array<Vec3, 4>{Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(4, 0, 0)}));
  EXPECT_EQ(rational.surface.radius, (std::array{0.5, 0.625, 0.75, 0.875}));
  EXPECT_EQ(rational.surface.rotation,
            (std::vector<std::array<double, 4>>{{1, 0, 0, 0}, {0, 1, 2, 3}}));
}

// With digits that only the very double has.
TEST(CertificatePieces, are_written_as_they_are_read) {
  const std::string ends = kLine + ", ";
  const std::string rows[] = {
      piece("ringed_surface", ends + R"("radius": {"cyclide": [0.1, 0.30000000000000004]})"),
      piece(
          "ringed_surface",
          R"("spine": {"arc": {"center": [1.0, 2.0, 3.0], "axis": [0.0, 0.0, 1.0], "start": [4.0, 2.0, 3.0], "angle": 1.5707963267948966}}, "radius": {"bezier": [5e-324, 1.7976931348623157e+308]})"),
      piece(
          "ringed_surface",
          R"("spine": {"hermite": {"from": [1.0, 2.0, 3.0], "to": [4.0, 5.0, 6.0], "start_velocity": [7.0, 8.0, 9.0], "end_velocity": [10.0, 11.0, 12.0]}}, "radius": {"cubic": [1.0, 2.0]})"),
      piece(
          "ringed_surface",
          R"("spine": {"bezier": {"points": [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]], "weights": [1.0, 0.1]}}, "radius": {"linear": [1.0, 2.0]})"),
      piece(
          "elliptic_tube",
          ends +
              R"("first": {"constant": [0.1]}, "second": {"cubic": [1, 2]}, "turn": 0.1, "continuity": "G1")"),
      piece(
          "cyclide",
          R"("first": [1, 2, 3, 4], "tangent": [5, 6, 7, 0.1], "last": [9, 10, 11, 12], "chord": 0.7)"),
      piece("rational_ringed_surface",
            R"("center": [[1, 0, 0], [2, 0, 0], [3, 0, 0], [4, 0, 0]],
               "radius": [0.1, 0.2, 0.3, 0.30000000000000004], "rotation": [[1, 0, 0, 0], [0, 1, 2, 3]])"),
  };
  for (const std::string& row : rows) {
    EXPECT_EQ(json_value(read(row)), parse_json(row, kSource));
  }
}

std::string fault(const std::string& text) {
  try {
    (void)read(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::parse_failed);
    return error.what();
  }
  return "accepted";
}

TEST(CertificatePieces, say_what_is_wrong_with_them) {
  const auto ringed = [](const std::string& numbers) { return piece("ringed_surface", numbers); };
  const auto arc = [&](const std::string& angle) {
    return ringed(
        R"("spine": {"arc": {"center": [0, 0, 0], "axis": [0, 0, 1], "start": [1, 0, 0], "angle": )" +
        angle + "}}, " + kConstant);
  };
  const auto rational = [](int points, int controls) {
    std::string center, rotation;
    for (int i = 0; i < points; ++i) {
      center += i == 0 ? "[0, 0, 0]" : ", [0, 0, 0]";
    }
    for (int i = 0; i < controls; ++i) {
      rotation += i == 0 ? "[1, 0, 0, 0]" : ", [1, 0, 0, 0]";
    }
    return piece(
        "rational_ringed_surface",
        "\"center\": [" + center + "], \"radius\": [1, 1, 1, 1], \"rotation\": [" + rotation + "]");
  };
  const std::pair<std::string, std::string> rows[] = {
      {R"({"cone": {}})", "c#: the key 'ringed_surface' is missing"},
      {"[]", "c#: must be an object, not array"},
      {"{\"ringed_surface\": {" + kEnd + ", " + kLine + "}}",
       "c#/ringed_surface: the key 'start' is missing"},
      {ringed(kLine + R"(, "radius": {"constant": [1, 2]})"),
       "c#/ringed_surface/radius/constant: must hold 1 numbers"},
      {ringed(kLine + R"(, "radius": {"cubic": [1]})"),
       "c#/ringed_surface/radius/cubic: must hold 2 numbers"},
      {ringed(kLine + R"(, "radius": {"square": [1]})"),
       "c#/ringed_surface/radius: the key 'bezier' is missing"},
      {ringed(R"("spine": {"bezier": {"points": [[1, 2]], "weights": []}}, )" + kConstant),
       "c#/ringed_surface/spine/bezier/points/0: must hold 3 numbers"},
      {arc("0"), "c#/ringed_surface/spine/arc/angle: an arc turns by more than 0 and at most 2 pi"},
      {arc("6.2832"),
       "c#/ringed_surface/spine/arc/angle: an arc turns by more than 0 and at most 2 pi"},
      {arc("6.283185307179586"), "accepted"},
      {piece("cyclide",
             R"("first": [1, 2, 3], "tangent": [1, 2, 3, 4], "last": [1, 2, 3, 4], "chord": 1)"),
       "c#/cyclide/first: must hold 4 numbers"},
      {piece("cyclide",
             R"("first": [1, 2, 3, 4], "tangent": [1, 2, 3, 4], "last": [1, 2, 3, 4], "chord": 0)"),
       "c#/cyclide/chord: must be positive"},
      {rational(4, 2), "accepted"},
      {rational(3, 2), "c#/rational_ringed_surface/center: must hold 4 points"},
      {rational(4, 1), "c#/rational_ringed_surface/rotation: must hold 2 quaternions at least"},
  };
  for (const auto& [text, message] : rows) {
    EXPECT_EQ(fault(text), message) << text;
  }
}

}  // namespace
}  // namespace dupin::json
