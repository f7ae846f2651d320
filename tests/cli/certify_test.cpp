#include "dupin/blends/certify.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/tool.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/certificate_json.h"

namespace dupin::test {
namespace {

using testing::HasSubstr;

using Certify = Tool;

TEST_F(Certify, proves_an_example_and_verify_agrees) {
  const std::string reducer = example("reducer.json");
  const auto proved = json({"certify", reducer, "-o", "a.cert.json"}, 0);
  EXPECT_EQ(proved.at("findings"), 0);
  EXPECT_EQ(proved.at("parts").size(), 3);
  EXPECT_EQ(proved.at("tolerance"), 0.05);
  EXPECT_GE(proved.at("joint_offset"), 0);
  EXPECT_LT(proved.at("joint_offset"), 1e-9);
  EXPECT_LT(proved.at("joint_angle"), 1e-9);
  EXPECT_EQ(json({"verify", "a.cert.json", reducer}, 0), proved);
  const ProcessResult text = dupin({"verify", "a.cert.json"});
  EXPECT_THAT(text.out, HasSubstr("tolerance            0.05 mm\njoints fit           within "));
  const ProcessResult other = dupin({"verify", "a.cert.json", example("u-bend.json")});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_THAT(other.err, HasSubstr("the certificate is not about this document"));
}

// Of which every smooth node is proved, and that the certificate is about the file.
// Whose certificate says it without control characters, which verify refuses in names.
TEST_F(Certify, proves_a_document_of_any_name) {
  for (const char* const name : {"a\tb.json", "a\u202eb.json"}) {
    folder_.write(name, read_file(example("reducer.json")));
    EXPECT_EQ(dupin({"certify", name, "-o", "c.json"}).exit_code, 0);
    EXPECT_EQ(dupin({"verify", "c.json"}).exit_code, 0);
    EXPECT_EQ(dupin({"verify", "c.json", name}).exit_code, 0);
  }
}

TEST_F(Certify, proves_a_graph_that_is_read_alike) {
  folder_.write("y.graph", "n 0 0 0\nn 20 0 0\nn 32 16 3\nn 32 -16 0\nc 0 1\nc 1 2\nc 1 3\n");
  const auto proved = json({"certify", "y.graph", "--radius", "1", "-o", "y.cert.json"}, 0);
  EXPECT_EQ(proved.at("findings"), 0);
  EXPECT_EQ(json({"verify", "y.cert.json", "y.graph", "--radius", "1"}, 0), proved);
  EXPECT_EQ(dupin({"verify", "y.cert.json", "y.graph", "--radius", "1.01"}).exit_code, 3);
}

// Nearly equal pipes: what is not decided, and what the bound does not prove.
TEST_F(Certify, says_why_a_claim_about_a_fillet_is_undecided) {
  folder_.write("near.json", R"({"units": "mm", "tolerance": 0.02, "parts": [
      {"name": "run", "pipe": {"from": [-200,0,0], "to": [200,0,0], "radius": 38}},
      {"name": "b", "pipe": {"from": [0,0,0], "to": [0,0,160], "radius": 37.9999999}},
      {"name": "f", "fillet": {"between": ["run", "b"], "radius": 11}}]})");
  const ProcessResult proved = dupin({"certify", "near.json", "-o", "near.cert.json"});
  EXPECT_EQ(proved.exit_code, 0);
  EXPECT_THAT(proved.out, HasSubstr(" mm, which does not prove that it keeps to the tolerance, "
                                    "0.02 mm"));
  const ProcessResult result =
      dupin({"certify", "near.json", "-o", "near.cert.json", "--margin", "0.9"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("undecided: f: embedded, no proof was found within the work "
                                    "that a certificate may take: its pipes all but touch at ("));
  for (const std::string document : {"reducer.json", "tee.json"}) {
    const ProcessResult near = dupin({"certify", example(document), "-o", "near.cert.json"});
    EXPECT_EQ(near.exit_code, 0);
    EXPECT_THAT(near.out, testing::Not(HasSubstr("does not prove"))) << document;
  }
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

TEST_F(Certify, verify_is_about_the_document_whatever_the_tolerance_was_asked_for) {
  const std::string reducer = example("reducer.json");
  EXPECT_EQ(
      dupin({"certify", "-q", reducer, "-o", "fine.cert.json", "--tolerance", "0.01mm"}).exit_code,
      0);
  EXPECT_EQ(dupin({"verify", "-q", "fine.cert.json", reducer}).exit_code, 0);
  EXPECT_EQ(
      dupin({"certify", "-q", reducer, "-o", "coarse.cert.json", "--tolerance", "0.1mm"}).exit_code,
      0);
  EXPECT_EQ(dupin({"verify", "-q", "coarse.cert.json"}).exit_code, 0);
  const ProcessResult result = dupin({"verify", "-q", "coarse.cert.json", reducer});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("its tolerance is larger"));
}

TEST_F(Certify, deep_nesting_is_an_error_with_its_place) {
  const std::string deep = "{\"parts\": " + std::string(100'000, '[');
  for (const std::string command : {"verify", "info", "build", "certify"}) {
    std::vector<std::string> arguments{command, "-"};
    if (command == "build" || command == "certify") {
      arguments.insert(arguments.end(), {"-o", "x.off"});
    }
    const ProcessResult result = dupin(arguments, deep);
    EXPECT_EQ(result.exit_code, 3) << command;
    EXPECT_THAT(result.err, HasSubstr("standard input:1:")) << command;
  }
}

TEST_F(Certify, a_claim_that_is_too_bold_is_a_finding) {
  const ProcessResult result =
      dupin({"certify", example("reducer.json"), "-o", "-", "--margin", "0.5"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("refuted: blend: margin above 0.5\n"));
  EXPECT_EQ(dupin({"verify", "-", "-q"}, result.out).exit_code, 1);
}

// What is least of all is not said of some.
TEST_F(Certify, says_of_how_many_neither_margin_nor_clearance_is_proved) {
  const std::vector<std::string> rows{
      "smallest margin      above 0.0849 (inlet), but for 1 not proved\n",
      "smallest clearance   at least 8.46073 mm (inlet and outlet)\n"};
  const ProcessResult refuted =
      dupin({"certify", example("reducer.json"), "-o", "a.cert.json", "--margin", "0.0849"});
  const ProcessResult checked = dupin({"verify", "a.cert.json"});
  for (const std::string& row : rows) {
    EXPECT_THAT(refuted.out, HasSubstr(row));
    EXPECT_THAT(checked.out, HasSubstr(row));
  }
  const ProcessResult open =
      dupin({"certify", example("hollow-tee.json"), "-o", "b.cert.json", "--margin", "0.9"});
  EXPECT_THAT(open.out, HasSubstr("smallest margin      above 0.9 (run), but for 1 not proved\n"));
  EXPECT_THAT(open.out, testing::ContainsRegex(
                            "smallest clearance   at least [0-9.]+ mm \\(run and flange\\), "
                            "but for 1 not proved\n"));
}

TEST_F(Certify, says_that_no_margin_and_no_clearance_is_proved) {
  Certificate certificate = certify(read_assembly(example("reducer.json")));
  for (PartClaims& claims : certificate.claims) {
    claims.regular->verdict = Verdict::undecided;
    claims.regular->leaves.clear();
    claims.embedded = EmbeddedClaim();
    claims.mesh.reset();
  }
  for (ClearanceClaim& claim : certificate.clearances) {
    claim = {claim.first, claim.second, Verdict::undecided, 0, {}, {}, 0};
  }
  folder_.write("open.cert.json", certificate_json(certificate));
  const ProcessResult result = dupin({"verify", "open.cert.json"});
  EXPECT_THAT(result.out, HasSubstr("smallest margin      not proved\n")) << result.err;
  EXPECT_THAT(result.out, HasSubstr("smallest clearance   not proved\n"));
}

TEST_F(Certify, says_of_a_fillet_that_nothing_is_proved_of_its_contact) {
  Certificate certificate = certify(read_assembly(example("equal-tee.json")));
  ASSERT_EQ(certificate.findings(), 0U);
  const std::size_t loops = certificate.fillet_claims.at(0).size();
  for (std::size_t open = 1; open <= loops; ++open) {
    certificate.fillet_claims[0][open - 1].contact.reset();
    folder_.write("open.cert.json", certificate_json(certificate));
    const ProcessResult result = dupin({"verify", "open.cert.json"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.out, HasSubstr(": touches its pipes, no proof was found"));
    EXPECT_THAT(result.out, HasSubstr("not proved           " + std::to_string(open) + "\n"));
    EXPECT_THAT(result.out, HasSubstr(open == loops ? "fillets touch pipes  not proved"
                                                    : ", but for 1 not proved"));
    EXPECT_TRUE(json({"verify", "open.cert.json"}, 1).at("fillets").at(0).at("offset").is_null());
  }
}

TEST_F(Certify, says_where_a_part_is_proved_to_cross_itself) {
  std::string through;
  for (const char* point :
       {"0,0,0", "10,10,0", "20,0,0", "10,-10,0", "0,0.3,0", "-10,10,0", "-20,0,0", "-10,-10,0"}) {
    through +=
        std::string(through.empty() ? "" : ", ") + R"({"point": [)" + point + R"(], "radius": 1})";
  }
  folder_.write("eight.json", R"({"units": "mm", "tolerance": 0.05, "parts": [{"name": "eight",
      "spline": {"closed": true, "through": [)" +
                                  through + "]}}]}");
  const ProcessResult result = dupin({"certify", "eight.json", "-o", "eight.cert.json"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("refuted: eight: embedded, crosses itself at (0."));
}

// On one of the processors that it may use, and on all. Blends beside each other take all the work
// that searches may take together, so that two pairs of them are undecided.
TEST_F(Certify, writes_the_same_certificate_whatever_the_number_of_threads) {
  folder_.write("near.json", R"({"units": "mm", "tolerance": 0.05, "parts": [
      {"name": "ai", "pipe": {"from": [-10, 0.0, 0], "to": [0, 0.0, 0], "radius": 2}},
      {"name": "ao", "pipe": {"from": [30, 7.128, 0.0], "direction": [1, 0.162, -0.08], "length": 8, "radius": 2.03}},
      {"name": "a", "cyclic_blend": {"from": "ai.end", "to": "ao.start", "radius_law": "R2", "k": 60, "l": 20}},
      {"name": "bi", "pipe": {"from": [-10, 3.5, 0], "to": [0, 3.5, 0], "radius": 2}},
      {"name": "bo", "pipe": {"from": [30, 12.375, 1.179], "direction": [1, 0.004, -0.186], "length": 8, "radius": 1.174}},
      {"name": "b", "cyclic_blend": {"from": "bi.end", "to": "bo.start", "radius_law": "R2", "k": 20, "l": 20}}]})");
  const auto certify_with = [&](const std::string& command, const std::string& document,
                                const std::string& output) {
    return shell(command + tool_path() + " -q certify " + document + " -o " + output).exit_code;
  };
  const std::string one =
      "taskset -c $(awk '/Cpus_allowed_list/ { split($2, numbers, \"/[,-]/\"); "
      "print numbers[1] }' /proc/self/status) ";
  for (const std::string& document :
       {std::string("near.json"), example("skew-cross.json"), example("junction.json")}) {
    const int undecided = document == "near.json" ? 1 : 0;
    EXPECT_EQ(certify_with("", document, "all.json"), undecided) << document;
    EXPECT_EQ(certify_with(one, document, "one.json"), undecided) << document;
    EXPECT_EQ(folder_.read("all.json"), folder_.read("one.json")) << document;
  }
}

}  // namespace
}  // namespace dupin::test
