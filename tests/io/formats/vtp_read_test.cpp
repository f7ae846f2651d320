#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dupin/io/vtp.h"
#include "dupin/kernel/error.h"
#include "support/sample_meshes.h"

namespace dupin {
namespace {

std::string file(const std::string& data, const std::string& more = "byte_order=\"LittleEndian\"") {
  return "<VTKFile type=\"PolyData\" version=\"0.1\" " + more + "><PolyData>" + data +
         "</PolyData></VTKFile>";
}

std::string piece(const std::string& counts, const std::string& data) {
  return "<Piece " + counts + ">" + data + "</Piece>";
}

const std::string kPoints =
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0  1 0 "
    "0\n0 "
    "1 0 0 0 1</DataArray></Points>";

std::string polygons(const std::string& corners, const std::string& offsets) {
  return "<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" + corners +
         "<InformationKey name=\"x\"><Value>7 8</Value></InformationKey></DataArray>"
         "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" +
         offsets + "</DataArray></Polys>";
}

TEST(VtpRead, takes_text_pieces_polygons_and_what_others_put_beside_them) {
  const std::string one =
      piece("NumberOfPoints=\"4\" NumberOfPolys=\"4\"",
            "<PointData/>" + kPoints + polygons("0 2 1 0 1 3 0 3 2 1 2 3", "3 6 9 12"));
  EXPECT_TRUE(test::identical(read_vtp(file(one), "x"), test::tetrahedron()));
  EXPECT_EQ(read_vtp(file(one + one), "x").points.size(), 8);
  const std::string square = piece(
      "NumberOfPoints=\"4\" NumberOfPolys=\"1\" NumberOfLines=\"1\"",
      "<CellData><DataArray type=\"Int8\" Name=\"label\" format=\"ascii\">9 "
      "1</DataArray></CellData>" +
          kPoints +
          "<Lines><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1</DataArray>"
          "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">2</DataArray></Lines>" +
          polygons("0 1 2 3", "4"));
  const TriMesh mesh = read_vtp(file(square), "x");
  EXPECT_EQ(mesh.triangles.size(), 2);
  EXPECT_EQ(mesh.names, std::vector<std::string>{"label 1"});
}

TEST(VtpRead, takes_binary_data_with_short_headers) {
  // 0 2 1, behind a size of 12 in four bytes.
  const std::string corners = "DAAAAAAAAAACAAAAAQAAAA==";
  const std::string data = piece(
      "NumberOfPoints=\"4\" NumberOfPolys=\"1\"",
      kPoints + "<Polys><DataArray type=\"Int32\" Name=\"connectivity\" format=\"binary\">\n" +
          corners +
          "\n</DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
          "format=\"ascii\">3</DataArray></Polys>");
  EXPECT_EQ(read_vtp(file(data), "x").triangles, (std::vector<Triangle>{{0, 2, 1}}));
}

std::string labelled_piece(const std::string& labels) {
  return piece("NumberOfPoints=\"4\" NumberOfPolys=\"1\"",
               "<CellData>" + labels + "</CellData>" + kPoints + polygons("0 2 1", "3"));
}

std::string labels(const std::string& type, const std::string& numbers) {
  return "<DataArray type=\"" + type + "\" Name=\"label\" format=\"ascii\">" + numbers +
         "</DataArray>";
}

TEST(VtpRead, pieces_without_labels_have_none_of_another_one) {
  const std::string names =
      "<FieldData><Array type=\"String\" Name=\"label_names\" format=\"ascii\">97 0</Array>"
      "</FieldData>";
  const TriMesh mesh = read_vtp(
      file(names + labelled_piece("") + labelled_piece(labels("Int32", "0")) + labelled_piece("")),
      "x");
  EXPECT_EQ(mesh.names, (std::vector<std::string>{"default", "a"}));
  EXPECT_EQ(mesh.labels, (std::vector<std::uint32_t>{0, 1, 0}));
}

// Somebody else's.
TEST(VtpRead, labels_that_are_no_integers_are_none) {
  for (const std::string& data :
       {labels("Float32", "0.5"), labels("String", "97 0"),
        std::string("<DataArray type=\"Int32\" NumberOfComponents=\"2\" Name=\"label\" "
                    "format=\"ascii\">1 2</DataArray>")}) {
    EXPECT_TRUE(read_vtp(file(labelled_piece(data)), "x").labels.empty()) << data;
  }
}

TEST(VtpRead, a_unit_that_there_is_not_is_none) {
  const auto unit = [](const std::string& bytes) {
    return unit_of_vtp(file("<FieldData><Array type=\"String\" Name=\"unit\" format=\"ascii\">" +
                            bytes + "</Array></FieldData>"),
                       "x");
  };
  EXPECT_EQ(unit("109 109 0"), "mm");
  EXPECT_EQ(unit("75 0"), "");
  // "mm" and a zero, behind a size of 3 in four bytes.
  EXPECT_EQ(unit_of_vtp(file("<FieldData><Array type=\"String\" Name=\"unit\" format=\"binary\">"
                             "AwAAAG1tAA==</Array></FieldData>"),
                        "x"),
            "mm");
}

TEST(VtpRead, takes_numbers_as_programs_print_them_and_any_order_of_bytes_of_text) {
  const std::string points =
      "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">\n+0 1e-400 "
      "-0.0 +1e0 0 0 0 1 0 0 0 1</DataArray></Points>";
  const std::string one = piece("NumberOfPoints=\"4\" NumberOfPolys=\"4\"",
                                points + polygons("0 2.0 1 0 1e0 3 +0 3 2 1 2 3", "3 6 9 12"));
  EXPECT_TRUE(
      test::identical(read_vtp(file(one, "byte_order=\"BigEndian\""), "x"), test::tetrahedron()));
}

TEST(VtpRead, refuses_what_it_does_not_know_with_its_line) {
  const std::string counts = "NumberOfPoints=\"4\" NumberOfPolys=\"1\"";
  const std::vector<std::pair<std::string, std::string>> table = {
      {"<VTKFile type=\"UnstructuredGrid\"/>", "x:1: found a VTK file of type 'UnstructuredGrid'"},
      {"<VTKFile type=\"PolyData\"/>", "expected an element PolyData"},
      {file("<AppendedData encoding=\"raw\">"), "found appended data"},
      {file(piece("NumberOfPoints=\"-4\"", "")), "found '-4' as NumberOfPoints"},
      {file(piece("NumberOfPoints=\"0\" NumberOfStrips=\"1\"", "")), "found triangle strips"},
      {file(piece(counts, kPoints)), "found 0 offsets, expected one for each of 1 polygons"},
      {file(piece(counts, polygons("0 1 2", "3"))), "found 0 coordinates"},
      {file(piece(counts, kPoints + polygons("0 1 2", "2"))), "found the offset 2 behind 0"},
      {file(piece(counts, kPoints + polygons("0 1 2", "4"))), "found the offset 4 behind 0"},
      {file(piece(counts, kPoints + polygons("0 1 4", "3"))), "found the corner 4"},
      {file(piece(counts, kPoints + polygons("0 1 2.5", "3"))), "found '2.5' in the array"},
      {file(piece(counts,
                  "<Points><DataArray type=\"Float64\" format=\"ascii\">1e400 0 0"
                  "</DataArray></Points>")),
       "found '1e400' in the array"},
      {file(piece("",
                  "<Points><DataArray type=\"Float64\" format=\"binary\">AAAAAA=="
                  "</DataArray></Points>"),
            "byte_order=\"BigEndian\""),
       "found another order of bytes in the array"},
      {file(piece(counts, kPoints + polygons("0 1 x", "3"))),
       "found 'x' in the array 'connectivity'"},
      {file(piece(counts, kPoints + polygons("0 1 2", "3") +
                              "<CellData><DataArray Name=\"label\" "
                              "type=\"Int8\">1 2</DataArray></CellData>")),
       "found 2 labels, expected one for each of 1 cells"},
      {file(piece(counts,
                  "<Points><DataArray type=\"Float64\" format=\"binary\">!!</DataArray></Points>")),
       "found no base64"},
      {file(piece(
           counts,
           "<Points><DataArray type=\"Float64\" format=\"binary\">CAAAAAAA</DataArray></Points>")),
       "found 2 bytes in the array '', expected the 8 that it says"},
      {file(piece(
           counts,
           "<Points><DataArray type=\"Float64\" format=\"binary\">AgAAAAAA</DataArray></Points>")),
       "expected a multiple of 8"},
      {file(piece(
           counts,
           "<Points><DataArray type=\"bit\" format=\"binary\">AAAAAA==</DataArray></Points>")),
       "found the type 'bit'"},
      {file(piece(
           counts,
           "<Points><DataArray type=\"Float64\" format=\"appended\" offset=\"0\"/></Points>")),
       "in the format 'appended'"},
      {file(piece(counts,
                  "<Points><DataArray type=\"Float64\" "
                  "format=\"binary\">AAAAAA==</DataArray></Points>"),
            "compressor=\"vtkZLibDataCompressor\""),
       "compressed"},
      {file(piece("NumberOfPoints=\"4\"", kPoints)), "found 4 points and no polygon"},
      {"<VTKFile", "found faulty XML"}};
  for (const auto& [text, what] : table) {
    try {
      (void)read_vtp(text, "x");
      ADD_FAILURE() << "accepted, expected: " << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), Errc::parse_failed) << error.what();
      EXPECT_THAT(error.what(), testing::HasSubstr(what));
      EXPECT_THAT(error.what(), testing::StartsWith("x"));
    }
  }
}

}  // namespace
}  // namespace dupin
