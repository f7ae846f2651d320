#include "dupin/io/pcf.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/kernel/error.h"
#include "support/malformed.h"

namespace dupin::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kUnits = "UNITS-BORE MM\nUNITS-CO-ORDS MM\n";

// A pipe of this bore along x from line 3 on.
std::string pipe(const std::string& bore) {
  return kUnits + "PIPE\n    END-POINT 0 0 0 " + bore + "\n    END-POINT 100 0 0 " + bore + "\n";
}

double radius(const PcfFile& file) { return *file.line.components[0].ports[0].radius; }

TEST(Pcf, reads_components_with_their_places) {
  const PcfFile file = parse_pcf(
      kUnits +
          "ELBOW\n    END-POINT 1 2 3 100\n    END-POINT 4 5 6 100\n    CENTRE-POINT 7 8 -0\n"
          "    BEND-RADIUS 152.4\nTEE\n    END-POINT 0 0 0 100\n    END-POINT 9 0 0 100\n"
          "    CENTRE-POINT 4 0 0\n    BRANCH1-POINT 4 3 0 50\n    R2_WALL_THK 3.6\n",
      "a.pcf");
  ASSERT_EQ(file.line.components.size(), 2);
  const PipingComponent &elbow = file.line.components[0], &tee = file.line.components[1];
  EXPECT_EQ(elbow.name, "elbow-3");
  EXPECT_EQ(elbow.shape, PipingShape::bend);
  EXPECT_EQ(elbow.ports[1].center, Vec3(4, 5, 6));
  EXPECT_EQ(elbow.ports[1].line, 5);
  EXPECT_EQ(*elbow.center, Vec3(7, 8, 0));
  EXPECT_FALSE(std::signbit(elbow.center->z()));
  EXPECT_EQ(elbow.bend_radius, 152.4);
  EXPECT_EQ(tee.shape, PipingShape::fitting);
  ASSERT_EQ(tee.ports.size(), 3);
  EXPECT_EQ(tee.ports[2].center, Vec3(4, 3, 0));
  EXPECT_EQ(tee.ports[2].radius, 60.3 / 2);
  EXPECT_EQ(tee.wall, 3.6);
  EXPECT_EQ(file.kinds.at("TEE"), 1);
}

TEST(Pcf, takes_bores_for_what_they_are) {
  EXPECT_EQ(radius(parse_pcf(pipe("100"))), 114.3 / 2);        // DN
  EXPECT_EQ(radius(parse_pcf(pipe("203.2"))), 219.1 / 2);      // NPS in millimetres
  EXPECT_EQ(radius(parse_pcf(pipe("168.3"))), 168.3 / 2);      // an outside diameter
  EXPECT_EQ(radius(parse_pcf(pipe("102.375"))), 102.375 / 2);  // none of them
  EXPECT_EQ(radius(parse_pcf(pipe("100"), {}, BoreMeaning::outside)), 50);
  EXPECT_EQ(radius(parse_pcf(pipe("88.9"), {}, BoreMeaning::nominal)), 101.6 / 2);
  EXPECT_THAT(parse_pcf(pipe("100")).notes.at(0).text,
              "bore 100: outside diameter 114.3 mm (NPS 4, DN 100, ASME B36.10M)");
  EXPECT_TRUE(parse_pcf(pipe("168.3")).notes.empty());
}

// 88.9 mm is the outside diameter of DN 80, and the name of NPS 3 1/2 in millimetres.
TEST(Pcf, takes_doubtful_bores_as_most_of_the_file) {
  const std::string doubtful = pipe("88.9");
  EXPECT_EQ(radius(parse_pcf(doubtful)), 88.9 / 2);
  EXPECT_EQ(
      radius(parse_pcf(doubtful + "PIPE\n  END-POINT 0 9 0 168.3\n  END-POINT 1 9 0 168.3\n")),
      88.9 / 2);
  EXPECT_EQ(
      radius(parse_pcf(doubtful + "PIPE\n  END-POINT 0 9 0 152.4\n  END-POINT 1 9 0 152.4\n")),
      101.6 / 2);
}

TEST(Pcf, reads_inches_and_mixtures) {
  const std::string body = "PIPE\n END-POINT 0 0 0 4\n END-POINT 10 0 0 4\n    R2_OUTER_DIAM 0\n";
  const PcfFile inches = parse_pcf("UNITS-BORE INCH\nUNITS-CO-ORDS INCH\n" + body);
  EXPECT_EQ(radius(inches), 114.3 / 2);
  EXPECT_EQ(inches.line.components[0].ports[1].center, Vec3(254, 0, 0));
  const PcfFile mixed = parse_pcf("UNITS-BORE INCH\nUNITS-CO-ORDS MM\n" + body);
  EXPECT_EQ(mixed.line.components[0].ports[1].center, Vec3(10, 0, 0));
  EXPECT_EQ(radius(parse_pcf("UNITS-BORE INCH\nUNITS-CO-ORDS MM\nPIPE\n END-POINT 0 0 0 4.5\n"
                             " END-POINT 1 0 0 4.5\n")),
            4.5 * 25.4 / 2);
}

TEST(Pcf, takes_a_diameter_of_its_own_before_the_bore) {
  EXPECT_EQ(radius(parse_pcf(pipe("100") + "    R2_OUTER_DIAM 108\n")), 54);
}

TEST(Pcf, takes_ends_without_a_bore) {
  const PcfFile file = parse_pcf(kUnits +
                                 "PIPE\n    END-POINT 0 0 0\n    END-POINT 1 0 0 BW\nPIPE\n"
                                 "    END-POINT 5 0 0 0\n    END-POINT 6 0 0 50 PL\n");
  EXPECT_FALSE(file.line.components[0].ports[0].radius);
  EXPECT_FALSE(file.line.components[0].ports[1].radius);
  EXPECT_FALSE(file.line.components[1].ports[0].radius);
  EXPECT_EQ(file.line.components[1].ports[1].radius, 60.3 / 2);
}

TEST(Pcf, gives_families_their_shapes) {
  const auto shape = [](const std::string& kind, const std::string& rest) {
    return parse_pcf(kUnits + kind + "\n    END-POINT 0 0 0 100\n" + rest).line.components[0].shape;
  };
  const std::string second = "    END-POINT 9 0 0 100\n", center = "    CENTRE-POINT 9 0 9\n";
  EXPECT_EQ(shape("VALVE", second), PipingShape::straight);
  EXPECT_EQ(shape("VALVE-ANGLE", second + center), PipingShape::fitting);
  EXPECT_EQ(shape("INSTRUMENT", second), PipingShape::straight);
  EXPECT_EQ(shape("INSTRUMENT-DIAL", ""), PipingShape::closure);
  EXPECT_EQ(shape("CAP", second), PipingShape::closure);
  EXPECT_EQ(shape("FLANGE-BLIND", second), PipingShape::closure);
  EXPECT_EQ(shape("FLANGE", second), PipingShape::straight);
  EXPECT_EQ(shape("BEND", second + center), PipingShape::bend);
  EXPECT_EQ(shape("CROSS", second + center), PipingShape::fitting);
  EXPECT_EQ(shape("GASKET", second), PipingShape::straight);
}

TEST(Pcf, notes_bends_whose_angle_is_not_that_of_their_points) {
  const auto notes = [](const std::string& angle, const std::string& kind = "ELBOW") {
    const PcfFile file =
        parse_pcf(kUnits + kind + "\n    END-POINT 0 0 0 100\n    END-POINT 150 150 0 100\n" +
                  "    CENTRE-POINT 150 0 0\n    ANGLE " + angle + "\n");
    return file.line.notes.empty() ? "" : file.line.notes.at(0).text;
  };
  EXPECT_THAT(notes("4500"), HasSubstr("elbow-3: turns by 90 degrees, as its points say; its "
                                       "angle says 45"));
  EXPECT_THAT(notes("-9000"), HasSubstr("its angle says -90"));
  for (const char* angle : {"9000", "9000.00 deg", "8950", "90", "0", "", "none", "nan", "1e999"}) {
    EXPECT_EQ(notes(angle), "") << angle;
  }
  EXPECT_EQ(notes("4500", "TEE"), "") << "that of its branch";
}

TEST(Pcf, takes_half_couplings_and_teed_reducers_for_fittings) {
  const auto shape = [](const std::string& text) {
    return parse_pcf(kUnits + text).line.components[0].shape;
  };
  EXPECT_EQ(shape("COUPLING\n    CENTRE-POINT 0 0 0\n    BRANCH1-POINT 0 0 80 25\n"),
            PipingShape::fitting);
  EXPECT_EQ(shape("REDUCER-CONCENTRIC-TEED\n    END-POINT 0 0 0 100\n    END-POINT 90 0 0 80\n"
                  "    CENTRE-POINT 45 0 0\n    BRANCH1-POINT 45 0 80 25\n"),
            PipingShape::fitting);
}

TEST(Pcf, makes_nothing_of_instruments_that_are_only_drawn) {
  const PcfFile file = parse_pcf(pipe("100") + "INSTRUMENT-BALLOON\n    CO-ORDS 1 2 3\n");
  EXPECT_EQ(file.line.components.size(), 1);
  EXPECT_EQ(file.skipped.at("INSTRUMENT-BALLOON"), 1);
  EXPECT_THAT(file.unknown.at(0).text,
              HasSubstr("instrument-balloon-6 has no end in space; nothing is made of it"));
}

TEST(Pcf, lists_what_it_does_not_understand_and_counts_what_it_skips) {
  const PcfFile file = parse_pcf(pipe("100") +
                                 "    FROBNICATE 1\n    FROBNICATE 2\nHYPERSPACE-DUCT\n"
                                 "    END-POINT 0 0 0 1\nSUPPORT\n    CO-ORDS 1 2 3\nSUPPORT\n"
                                 "MESSAGE-SQUARE\nany \xE9 words\n");
  ASSERT_EQ(file.unknown.size(), 2);
  EXPECT_EQ(file.unknown[0].line, 6);
  EXPECT_THAT(file.unknown[0].text, HasSubstr("FROBNICATE"));
  EXPECT_THAT(file.unknown[0].text, HasSubstr("1 other line"));
  EXPECT_EQ(file.unknown[1].line, 8);
  EXPECT_EQ(file.skipped.at("SUPPORT"), 2);
  EXPECT_EQ(file.skipped.at("MESSAGE-SQUARE"), 1);
}

TEST(Pcf, leaves_out_what_is_there_twice) {
  const std::string twice =
      pipe("100") + "PIPE\n    END-POINT 0 0 0 100\n    END-POINT 100 0 0 100\n";
  const PcfFile file = parse_pcf(twice);
  EXPECT_EQ(file.line.components.size(), 1);
  EXPECT_EQ(file.line.notes.at(0).line, 6);
  EXPECT_EQ(file.line.notes.at(0).text, "pipe-6: repeats the one at line 3; it is left out");
}

TEST(Pcf, says_what_differs_of_what_is_there_twice) {
  const PcfFile file =
      parse_pcf(pipe("100") + "PIPE\n    END-POINT 0 0 0 80\n    END-POINT 100 0 0 80\n" +
                "PIPE\n    END-POINT 0 0 0 100\n    END-POINT 100 0 0 100\n    WALL-THICKNESS 5\n" +
                "    OUTSIDE-DIAMETER 110\n");
  EXPECT_EQ(file.line.components.size(), 1);
  ASSERT_EQ(file.line.notes.size(), 2);
  EXPECT_EQ(
      file.line.notes[0].text,
      "pipe-6: lies between the same points as the one at line 3, and has another bore; it is "
      "left out");
  EXPECT_THAT(file.line.notes[1].text, HasSubstr("has another bore and another wall;"));
}

TEST(Pcf, refuses_components_that_contradict_themselves) {
  for (const auto& [one, other] : {std::pair("CENTRE-POINT 300 0 0", "CENTRE-POINT 0 300 0"),
                                   std::pair("OUTSIDE-DIAMETER 120", "R2_OUTER_DIAM 130"),
                                   std::pair("WALL-THICKNESS 5", "WALL-THICKNESS 6"),
                                   std::pair("BEND-RADIUS 300", "BEND-RADIUS 310")}) {
    const std::string text = pipe("100") + "    " + one + "\n    " + other + "\n";
    try {
      (void)parse_pcf(text, "a.pcf");
      ADD_FAILURE() << other;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::parse_failed);
      EXPECT_EQ(error.where(), "a.pcf:7");
      EXPECT_THAT(error.message(), HasSubstr("but line 6 says"));
    }
    EXPECT_EQ(parse_pcf(pipe("100") + "    " + one + "\n    " + one + "\n").line.components.size(),
              1);
  }
  EXPECT_EQ(parse_pcf(pipe("100") + "    WALL-THICKNESS 5\n    WALL-THICKNESS 0\n")
                .line.components.front()
                .wall,
            5)
      << "0 is none";
}

TEST(Pcf, keeps_steps_without_length_that_follow_each_other) {
  const auto step = [](const std::string& from, const std::string& to) {
    return "REDUCER-CONCENTRIC\n    END-POINT 100 0 0 " + from + "\n    END-POINT 100 0 0 " + to +
           "\n";
  };
  const PcfFile file =
      parse_pcf(pipe("100") + step("200", "150") + step("150", "100") + step("150", "200"));
  EXPECT_EQ(file.line.components.size(), 3);
  EXPECT_THAT(file.line.notes.at(0).text,
              HasSubstr("reducer-concentric-12: repeats the one at line 6"));
}

TEST(Pcf, leaves_out_what_is_there_twice_the_other_way_round) {
  const PcfFile pipes =
      parse_pcf(pipe("100") + "PIPE\n    END-POINT 100 0 0 100\n    END-POINT 0 0 0 100\n");
  EXPECT_EQ(pipes.line.components.size(), 1);
  EXPECT_THAT(pipes.line.notes.at(0).text, HasSubstr("pipe-6: repeats the one at line 3"));
  const std::string tee = "TEE\n    CENTRE-POINT 4 0 0\n    END-POINT 9 0 0 100\n";
  const PcfFile tees =
      parse_pcf(kUnits + tee + "    END-POINT 0 0 0 100\n    BRANCH1-POINT 4 9 0 100\n" + tee +
                "    END-POINT 4 9 0 100\n    BRANCH1-POINT 0 0 0 100\n");
  EXPECT_EQ(tees.line.components.size(), 1);
}

TEST(Pcf, has_one_unit_of_each_kind) {
  EXPECT_EQ(parse_pcf("UNITS-CO-ORDS mm\n" + pipe("100")).line.components.size(), 1);
  expect_refused(
      [](const std::string& bytes, const std::string& file) { return parse_pcf(bytes, file); },
      "a.pcf",
      {{pipe("100") + "UNITS-CO-ORDS INCH\n",
        "a.pcf:6: found UNITS-CO-ORDS 'INCH', but line 2 says 'MM'; expected one unit for the "
        "whole "
        "file"},
       {"UNITS-BORE INCH\n" + pipe("100"),
        "a.pcf:2: found UNITS-BORE 'MM', but line 1 says 'INCH'; expected one unit for the whole "
        "file"}});
}

TEST(Pcf, reads_no_component_out_of_messages) {
  const PcfFile file = parse_pcf(pipe("100") +
                                 "MESSAGE-SQUARE\n    TEXT PIPE\n    PIPE TO BE FIELD "
                                 "CUT\n    VALVE BY OTHERS\nMESSAGE-CIRCLE\n");
  EXPECT_EQ(file.line.components.size(), 1);
  EXPECT_EQ(file.skipped.at("MESSAGE-SQUARE"), 1);
  EXPECT_TRUE(file.unknown.empty());
}

TEST(Pcf, refuses_what_is_malformed) {
  const std::string pipe_head = kUnits + "PIPE\n";
  expect_refused(
      [](const std::string& bytes, const std::string& file) { return parse_pcf(bytes, file); },
      "a.pcf",
      {
          {"",
           "a.pcf: the line UNITS-CO-ORDS is missing; it says MM or INCH, or MM-HUNDREDTH or "
           "INCH-SIXTEENTH of these"},
          {"UNITS-CO-ORDS MM\nPIPE\n",
           "a.pcf: the line UNITS-BORE is missing; it says MM or INCH, or MM-HUNDREDTH or "
           "INCH-SIXTEENTH of these"},
          {"UNITS-CO-ORDS FURLONG\n",
           "a.pcf:1: found 'FURLONG', expected the unit MM or INCH, or MM-HUNDREDTH or "
           "INCH-SIXTEENTH of these"},
          {kUnits, "a.pcf: there is no piping component in it, such as PIPE or ELBOW"},
          {pipe_head + "    END-POINT 1 x 3 100\n", "a.pcf:4: found 'x', expected a coordinate"},
          {pipe_head + "    END-POINT 1 2\n",
           "a.pcf:4: found the end of the line, expected a coordinate"},
          {pipe_head + "    END-POINT 1 nan 3 100\n",
           "a.pcf:4: found 'nan', expected a coordinate that is finite"},
          {pipe_head + "    END-POINT 1e9 2 3 100\n",
           "a.pcf:4: found 1e+09, expected a coordinate of at most 1e+08"},
          {pipe_head + "    END-POINT 100000000.1 2 3 100\n",
           "a.pcf:4: found 1.00001e+08, expected a coordinate of at most 1e+08"},
          {pipe_head + "    END-POINT -100000000.1 2 3 100\n",
           "a.pcf:4: found -1.00001e+08, expected a coordinate of at most 1e+08"},
          {pipe_head + "    END-POINT 1 2 3 0.0099999999\n",
           "a.pcf:4: found the bore 0.00999999, expected 0 for none, or at least 0.01"},
          {pipe_head + "    END-POINT 1 2 3 1,5\n", "a.pcf:4: found '1,5', expected a bore"},
          {pipe_head + "    END-POINT 1 2 3 -5\n",
           "a.pcf:4: found the bore -5, expected 0 for none, or at least 0.01"},
          {pipe_head + "    END-POINT 1 2 3 1e7\n",
           "a.pcf:4: found 1e+07, expected a bore of at most 100000"},
          {kUnits + "BEND\n    BEND-RADIUS -1\n",
           "a.pcf:4: found -1, expected a bend radius that is not negative"},
      });
}

// What can be read, but no solid be made of.
TEST(Pcf, refuses_what_is_cut_off_when_it_is_made) {
  const auto made = [](const std::string& bytes, const std::string& file) {
    return assembly_of(parse_pcf(bytes, file).line);
  };
  expect_refused(
      made, "a.pcf",
      {
          {kUnits + "PIPE",
           "a.pcf:3: 'pipe-3': it has no end in space; --keep-going leaves it out"},
          {kUnits + "PIPE\n    END-POINT 0 0 0 100\n    END-PO",
           "a.pcf:3: 'pipe-3': it has one end instead of two; --keep-going leaves it out"},
          {kUnits + "ELBOW\n    END-POINT 0 0 0 100\n    END-POINT 9 9 0 100\n",
           "a.pcf:3: 'elbow-3': it has no centre point; --keep-going leaves it out"},
          {kUnits + "PIPE\n    END-POINT 0 0 0\n    END-POINT 9 0 0\n",
           "a.pcf:3: 'pipe-3': it has no bore, and nothing that it is joined to has one; "
           "--keep-going leaves it out"},
          {kUnits + "PIPE\n    END-POINT 0 0 0 100\n    END-POINT 0 0 0.01 100\n",
           "a.pcf:3: no component is left of which a part could be made: pipe-3: has no length "
           "beyond the snap tolerance; nothing is made of it"},
      },
      Errc::invalid_argument);
  expect_refused(made, "a.pcf",
                 {{kUnits + "BEND\n    END-POINT 0 0 0 100\n    END-POINT 50 50 0 100\n"
                            "    CENTRE-POINT 50 0 0\n",
                   "a.pcf:3: 'bend-3': its bend radius of 50 is not larger than its pipe's radius "
                   "of 57.15; --keep-going leaves it out"}},
                 Errc::irregular_surface);
}

TEST(Pcf, reads_hundredths_and_sixteenths) {
  const std::string body =
      "PIPE\n    END-POINT 0 0 0 64\n    END-POINT 100000 0 0 64\n    R2_WALL_THK 4\n";
  const PcfFile file = parse_pcf("UNITS-BORE INCH-SIXTEENTH\nUNITS-CO-ORDS MM-HUNDREDTHS\n" + body);
  EXPECT_EQ(radius(file), 114.3 / 2);
  EXPECT_EQ(file.line.components[0].ports[1].center, Vec3(1000, 0, 0));
  EXPECT_EQ(file.line.components[0].wall, 0.25 * 25.4);
  EXPECT_EQ(parse_pcf("UNITS-BORE INCH\nUNITS-CO-ORDS INCH-SIXTEENTH\n" + body)
                .line.components[0]
                .ports[1]
                .center,
            Vec3(100000 * 25.4 / 16, 0, 0));
}

TEST(Pcf, is_told_by_a_line_of_units) {
  EXPECT_TRUE(is_pcf_text("ISOGEN-FILES x\n  units-bore MM\n"));
  EXPECT_TRUE(is_pcf_text("\xEF\xBB\xBFUNITS-BORE MM\n"));
  EXPECT_FALSE(is_pcf_text("{\"units\": \"UNITS-BORE\"}"));
  EXPECT_FALSE(is_pcf_text("\xEF\xBB\xBF{\nUNITS-BORE\n"));
  EXPECT_FALSE(is_pcf_text("solid UNITS-BORE\n"));
  EXPECT_FALSE(is_pcf_text(""));
}

TEST(Pcf, takes_a_hundred_thousand_lines) {
  std::string text = kUnits;
  for (int i = 0; i < 25000; ++i) {
    const std::string y = std::to_string(500 * (i % 250));
    const auto point = [&](int x) {
      return "    END-POINT " + std::to_string(x) + " " + y + " 0 100\n";
    };
    text += "PIPE\n" + point(1000 * (i / 250)) + point(1000 * (i / 250) + 1000) + "    SKEY PIPW\n";
  }
  const PcfFile file = parse_pcf(text);
  EXPECT_EQ(file.line.components.size(), 25000);
  EXPECT_EQ(assembly_of(file.line).joints.size(), 25000 - 250);
}

TEST(Pcf, is_told_by_its_extension) {
  EXPECT_TRUE(is_pcf_file("a/b.PCF"));
  EXPECT_FALSE(is_pcf_file("a.pcf.json"));
}

TEST(Pcf, counts_findings) {
  PcfReport report;
  EXPECT_EQ(report.findings(), 0);
  report.file.unknown.push_back({3, "x", false});
  EXPECT_EQ(report.findings(), 0);
  report.is_strict = true;
  EXPECT_EQ(report.findings(), 1);
  report.network.notes = {{1, "a", true}, {2, "b", false}};
  report.network.joints.resize(2);
  report.network.joints[0].state = JointState::met;
  EXPECT_EQ(report.findings(), 3);
}

TEST(Pcf, takes_walls_of_a_schedule_where_the_file_says_none) {
  PcfFile file = parse_pcf(kUnits +
                           "PIPE\n END-POINT 0 0 0 100\n END-POINT 9 0 0 100\n"
                           "PIPE\n END-POINT 9 0 0 100\n END-POINT 19 0 0 100\n R2_WALL_THK 3\n"
                           "REDUCER-CONCENTRIC\n END-POINT 19 0 0 100\n END-POINT 30 0 0 150\n"
                           "PIPE\n END-POINT 30 0 0 77\n END-POINT 40 0 0 77\n");
  const std::size_t before = file.notes.size();
  give_walls(file, "40");
  EXPECT_EQ(file.line.components[0].wall, 6.02);
  EXPECT_EQ(file.line.components[1].wall, 3);
  EXPECT_EQ(file.line.components[2].wall, 7.11);  // of its thicker end
  EXPECT_FALSE(file.line.components[3].wall);
  ASSERT_EQ(file.notes.size(), before + 1);
  EXPECT_EQ(file.notes.back().text,
            "outside diameter 77 mm is not made in schedule 40 of ASME B36.10M");
  PcfFile odd = parse_pcf(kUnits + "PIPE\n END-POINT 0 0 0 77\n END-POINT 9 0 0 77\n");
  EXPECT_THROW(give_walls(odd, "40"), Error);
  EXPECT_THROW(give_walls(file, "forty"), Error);
}

}  // namespace
}  // namespace dupin::test
