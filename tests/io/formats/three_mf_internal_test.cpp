#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dupin/io/three_mf.h"
#include "dupin/kernel/error.h"
#include "files/zip_package.h"
#include "formats/three_mf_model.h"
#include "support/malformed.h"
#include "support/mutation.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

const std::string kModel = "3D/3dmodel.model";

TriMesh read_model(std::string_view xml, std::string_view place) {
  return formats::read_3mf_model("root", [&](const std::string&) {
    return formats::ModelText{std::string(xml), std::string(place)};
  });
}

std::string model_xml(const TriMesh& mesh, const MeshHeader& header = {}) {
  return files::unzip(three_mf_bytes(mesh, header), kModel, "x.3mf");
}

TEST(ThreeMf, reads_back_bit_for_bit_what_it_writes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const TriMesh mesh = test::scattered_mesh(seed, 300, true);
    EXPECT_TRUE(test::identical(read_3mf(three_mf_bytes(mesh), "x.3mf"), mesh));
  }
  TriMesh labelled = test::labelled_tetrahedron();
  labelled.names[1] = "<\"R&D\">";
  EXPECT_TRUE(test::identical(read_3mf(three_mf_bytes(labelled), "x.3mf"), labelled));
  EXPECT_TRUE(test::identical(read_3mf(three_mf_bytes({}), "x.3mf"), {})) << "the empty set";
}

TEST(ThreeMf, reads_the_parts_of_a_package_that_the_root_names) {
  const std::string good = three_mf_bytes(test::tetrahedron());
  const std::string root =
      "<model xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">"
      "<build><item objectid=\"1\" p:path=\"/3D/Objects/a.model\"/></build></model>";
  const auto package = [&](const std::string& name) {
    return files::zip_archive({{"_rels/.rels", files::unzip(good, "_rels/.rels", "")},
                               {kModel, root},
                               {name, files::unzip(good, kModel, "")}});
  };
  EXPECT_TRUE(
      test::identical(read_3mf(package("3D/Objects/a.model"), "x.3mf"), test::tetrahedron()));
  test::expect_refused(
      read_3mf, "x.3mf",
      {{package("3D/Objects/b.model"),
        "x.3mf: found no entry '3D/Objects/a.model' in the ZIP archive, expected one"}});
}

TEST(ThreeMf, the_model_tells_unit_names_and_note) {
  const std::string xml = model_xml(test::labelled_tetrahedron(), {"in", "a < b"});
  for (const std::string part :
       {"<model unit=\"inch\" ", "<metadata name=\"Description\">a &lt; b</metadata>",
        "<base name=\"the blend\" displaycolor=\"#", "<vertex x=\"1\" y=\"0\" z=\"0\"/>",
        "<triangle v1=\"1\" v2=\"2\" v3=\"3\" pid=\"2\" p1=\"1\"/>"}) {
    EXPECT_NE(xml.find(part), std::string::npos) << part;
  }
}

TEST(ThreeMf, an_unknown_unit_is_refused) {
  try {
    (void)three_mf_bytes(test::tetrahedron(), {"ell", ""});
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "3MF has no unit 'ell'; it has um, mm, cm, m, in and ft");
  }
}

TEST(ThreeMf, malformed_packages_are_refused) {
  const std::string good = three_mf_bytes(test::tetrahedron());
  const std::string relationships = "_rels/.rels";
  std::string twice = files::unzip(good, relationships, "");
  const std::size_t one = twice.find("<Relationship "), end = twice.find("</Relationships>");
  twice.insert(end, twice.substr(one, end - one));
  test::expect_refused(
      read_3mf, "x.3mf",
      {
          {"PK\x03\x04", "x.3mf: found no ZIP archive (Not a zip archive), expected a 3MF package"},
          {good.substr(0, good.size() - 30),
           "x.3mf: found no ZIP archive (Not a zip archive), expected a 3MF package"},
          {files::zip_archive({{"a", "b"}}),
           "x.3mf: found no entry '_rels/.rels' in the ZIP archive, expected one"},
          {files::zip_archive({{relationships, "<a/>"}}),
           "x.3mf:_rels/.rels: found no relationship to a 3D model, expected one"},
          {files::zip_archive({{relationships, twice}}),
           "x.3mf:_rels/.rels: found 2 relationships to a 3D model, expected one"},
          {files::zip_archive({{relationships, files::unzip(good, relationships, "")}}),
           "x.3mf: found no entry '3D/3dmodel.model' in the ZIP archive, expected one"},
          {files::zip_archive(
               {{relationships, files::unzip(good, relationships, "")}, {kModel, "<model>"}}),
           "x.3mf:3D/3dmodel.model:1: found faulty XML (no element found), expected valid XML"},
      });
}

TEST(ThreeMf, a_package_that_expands_without_measure_is_refused) {
  const std::string bomb =
      files::zip_archive({{"_rels/.rels", std::string(std::size_t{65} << 20, ' ')}});
  try {
    (void)read_3mf(bomb, "x.3mf");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Errc::limit_exceeded) << error.what();
  }
}

TEST(ThreeMf, mutated_models_are_read_or_refused) {
  const std::string good = model_xml(test::labelled_tetrahedron());
  std::mt19937_64 random(20000);
  std::size_t refused = 0;
  for (int i = 0; i < 20000; ++i) {
    try {
      (void)three_mf_bytes(read_model(test::mutated(good, random), "m"));
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 2000U);
  EXPECT_LT(refused, 20000U);
}

}  // namespace
}  // namespace dupin
