#include <cfenv>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

#include <gtest/gtest.h>

#include "dupin/blends/certify.h"
#include "dupin/blends/drawing.h"
#include "dupin/io/assembly_json.h"
#include "dupin/io/atomic_file.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/document.h"
#include "dupin/io/drawing_page.h"
#include "dupin/io/edit_json.h"
#include "dupin/io/exchange.h"
#include "dupin/io/graph_file.h"
#include "dupin/io/mesh_file.h"
#include "dupin/io/nurbs_json.h"
#include "dupin/io/patches_json.h"
#include "dupin/io/place_json.h"
#include "dupin/io/report_page.h"
#include "dupin/io/stl_stream.h"
#include "dupin/io/streamed_format.h"
#include "dupin/io/volume_file.h"
#include "dupin/kernel/error.h"
#include "support/sample_meshes.h"
#include "support/scratch_directory.h"
#include "support/shapes.h"
#include "support/source_folder.h"

namespace dupin {
namespace {

namespace fs = std::filesystem;

/// What a caller has set for his own arithmetic. Made with nothing, it is the usual one.
struct Caller {
  std::string name;
  std::function<void()> set = [] {};
};

std::vector<Caller> callers() {
  std::vector<Caller> result{{"upward", [] { std::fesetround(FE_UPWARD); }},
                             {"downward", [] { std::fesetround(FE_DOWNWARD); }}};
#ifdef __SSE2__
  result.push_back({"without denormals", [] { _mm_setcsr(_mm_getcsr() | 0x8040U); }});
#endif
  return result;
}

/// The bytes of all that one caller had made, by what they are.
class Made {
 public:
  explicit Made(Caller caller) : caller_(std::move(caller)) {}

  /// What `make` gives in the caller's arithmetic; `bytes` tells it, in the usual one.
  template <class Make, class Bytes>
  auto operator()(const std::string& what, const Make& make, const Bytes& bytes) {
    std::fenv_t before;
    std::fegetenv(&before);
    caller_.set();
    auto value = make();
    std::fesetenv(&before);
    made_.emplace(what, bytes(value));
    return value;
  }
  std::string operator()(const std::string& what, const std::function<std::string()>& make) {
    const auto made_or_said = [&] {
      try {
        return make();
      } catch (const Error& error) {
        return std::string(error.what());
      }
    };
    return (*this)(what, made_or_said, [](const std::string& text) { return text; });
  }
  [[nodiscard]] const std::map<std::string, std::string>& all() const { return made_; }

 private:
  Caller caller_;
  std::map<std::string, std::string> made_;
};

template <class Make>
void expect_usual(const Make& make) {
  Made usual({"usual"});
  make(usual);
  for (const Caller& caller : callers()) {
    Made made(caller);
    make(made);
    for (const auto& [what, bytes] : usual.all()) {
      EXPECT_TRUE(made.all().at(what) == bytes) << caller.name << ": " << what;
    }
  }
}

std::string bits(const std::vector<Vec3>& points) {
  std::string bytes;
  for (const Vec3& point : points) {
    bytes.append(reinterpret_cast<const char*>(point.data()), 3 * sizeof(double));
  }
  return bytes;
}

std::string bits(const TriMesh& mesh) {
  return bits(mesh.points) + std::to_string(mesh.triangles.size());
}

std::string bits(const VolumeMesh& mesh) { return bits(mesh.surface) + bits(mesh.inner_points); }

/// Has points between the numbers of binary32, and below the least normal one of binary64.
TriMesh awkward() {
  TriMesh mesh = test::labelled_tetrahedron();
  mesh.points[0] = {1e-310, 1e-40, .1 / 3};
  mesh.points[1] = {1.1, 1e-320, -1e-309};
  return mesh;
}

const MeshHeader kHeader{.unit = "in", .note = "off by (0.1, 0.2, 0.3)"};

TEST(UsualArithmeticOfFiles, meshes) {
  expect_usual([](Made& made) {
    for (const MeshFormat& format : mesh_formats()) {
      const std::string key(format.key);
      const std::string bytes =
          made("write " + key, [&] { return format.write(awkward(), kHeader); });
      const auto read = [&] { return format.read(bytes, "a"); };
      (void)made("read " + key, read, [](const TriMesh& mesh) { return bits(mesh); });
    }
    VolumeMesh volume{.surface = awkward(), .inner_points = {{1e-310, .1 / 3, .2}}};
    volume.tetrahedra = {{4, 0, 2, 1}, {4, 0, 1, 3}, {4, 0, 3, 2}, {4, 1, 2, 3}};
    for (const VolumeFormat& format : volume_formats()) {
      const std::string key(format.key);
      const std::string bytes = made("write " + key, [&] { return format.write(volume, kHeader); });
      const auto read = [&] { return format.read(bytes, "a"); };
      (void)made("read " + key, read, [](const VolumeMesh& mesh) { return bits(mesh); });
    }
  });
}

// Decimals that lie between doubles, of as many digits as need slow reading.
TEST(UsualArithmeticOfFiles, decimals_of_meshes) {
  const std::string a = "0.1 0.30000000000000000001 1e-310", b = "1.123456789012345678 3 4.9e-324",
                    c = "0.7 1e22 8.5e-5";
  const std::map<std::string, std::string> texts{
      {"off", "OFF\n3 1 0\n" + a + "\n" + b + "\n" + c + "\n3 0 1 2\n"},
      {"obj", "v " + a + "\nv " + b + "\nv " + c + "\nf 1 2 3\n"},
      {"stl-ascii", "solid s\nfacet normal 0 0 0\nouter loop\nvertex " + a + "\nvertex " + b +
                        "\nvertex " + c + "\nendloop\nendfacet\nendsolid s\n"},
      {"ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
       "property double z\nelement face 1\nproperty list uchar int vertex_indices\n"
       "end_header\n" +
           a + "\n" + b + "\n" + c + "\n3 0 1 2\n"}};
  expect_usual([&](Made& made) {
    for (const auto& [key, text] : texts) {
      (void)made(
          key, [&text = text, &key = key] { return find_mesh_format(key)->read(text, "a"); },
          [](const TriMesh& mesh) { return bits(mesh); });
    }
  });
}

using UsualArithmeticOfStreams = test::ScratchDirectory;

TEST_F(UsualArithmeticOfStreams, are_the_usual_bytes) {
  expect_usual([&](Made& made) {
    const Rounded solid =
        to_mesh(Solid::from(test::box({.1, .1, .1}, {.7, 1. / 3, 2})), Coordinates::binary32);
    for (const std::string key : {"stl", "ply"}) {
      const MeshFormat& format = *find_mesh_format(key);
      const fs::path file = path("a." + key);
      (void)made("stream " + key, [&] {
        const auto stream = mesh_stream(file, format);
        stream->append(mesh_piece(solid, format, "a"), 0);
        stream->commit(kHeader, {});
        return read_file(file);
      });
    }
    const StlFile file(path("a.stl"));
    (void)made(
        "mesh of tiles", [&] { return file.mesh(); },
        [](const TriMesh& mesh) { return bits(mesh); });
    (void)made("patches", [&] { return patches_json(solid, "a", kHeader); });
  });
}

const std::string kGraph = "n 0.1 0.3 1e-310 0.7\nn 9 0.33333333333333333333 0 1.1\nc 0 1\n";
const std::string kSwc = "1 1 0.1 0.3 0 0.7 -1\n2 1 9.33333333333333333333 0.3 0 0.7 1\n";
const std::string kLine =
    "UNITS-BORE INCH\nUNITS-CO-ORDS INCH\nPIPE\n    END-POINT 0.1 0.3 0 2\n"
    "    END-POINT 10.33333333333333333333 0.3 0 2\n";

TEST(UsualArithmeticOfFiles, documents_of_every_example) {
  std::size_t count = 0;
  expect_usual([&](Made& made) {
    for (const auto& entry : fs::directory_iterator(test::source_folder() / "examples")) {
      const fs::path path = entry.path();
      if (path.extension() != ".json") {
        continue;
      }
      ++count;
      const std::string name = path.filename().string(), text = read_file(path);
      const Document document = made(
          "read " + name, [&] { return document_of(text, name, document_kind(path)); },
          [](const Document& read) { return document_text(read.assembly); });
      (void)made("write " + name, [&] { return document_text(document.assembly); });
      (void)made("report " + name, [&] { return to_json(document.assembly); });
      (void)made("gaps " + name, [&] { return to_json(gap_summary(document)); });
      (void)made("place " + name, [&] {
        Placement placement;
        placement.scale(1, 3);
        return placed_document(text, name, placement).text;
      });
    }
  });
  EXPECT_GT(count, 30U);
}

TEST(UsualArithmeticOfFiles, graphs_and_piping) {
  const std::map<std::string, DocumentKind> texts{
      {kGraph, DocumentKind::graph}, {kSwc, DocumentKind::graph}, {kLine, DocumentKind::piping}};
  expect_usual([&](Made& made) {
    for (const auto& [text, kind] : texts) {
      const auto read = [&text = text, &kind = kind] { return document_of(text, "a", kind); };
      const Document document = made("read " + text, read, [](const Document& made_of) {
        return document_text(made_of.assembly);
      });
      (void)made("bill " + text, [&] {
        const BillReport report = bill_report(document);
        return to_json(report) + to_csv(report);
      });
      (void)made("gaps " + text, [&] { return to_json(gap_summary(document)); });
    }
    (void)made("gaps of piping", [] { return to_json(piping_gap_summary(kLine, "a")); });
    (void)made(
        "graph", [] { return parse_graph_file(kGraph, "a"); },
        [](const PipeGraph& graph) { return bits({graph.nodes[1].center}); });
  });
}

TEST(UsualArithmeticOfFiles, certificates_drawings_and_pages) {
  const std::string name = "reducer.json";
  const std::string text = read_file(test::source_folder() / "examples" / name);
  const Assembly assembly = parse_assembly(text, name);
  const Built built = build(assembly);
  const Certificate certificate = certify(assembly);
  const Drawing drawing = draw(assembly, built, {.view = view_along({-1, -2, -1}), .center = true});
  const TriMesh mesh = to_mesh(built.solid).mesh();
  expect_usual([&](Made& made) {
    const std::string json = made("certificate", [&] { return certificate_json(certificate); });
    (void)made(
        "read certificate", [&] { return parse_certificate(json, name); },
        [](const Certificate& read) { return certificate_json(read); });
    (void)made("summary", [&] { return certificate_summary_json(certificate); });
    const auto scale = made(
        "scale", [&] { return fitting_scale(drawing); },
        [](const DrawingScale& fitting) { return to_string(fitting); });
    const SheetOptions options{.names = true, .dimensions = true};
    (void)made(
        "drawing",
        [&] {
          return draw(assembly, built, {.view = view_along({-3, 1, -2})});
        },
        [&](const Drawing& drawn) { return drawing_svg(drawn, scale, options); });
    (void)made(
        "normals", [&] { return smooth_normals(assembly, built, mesh, 0); },
        [](const CornerNormals& normals) {
          std::vector<Vec3> all;
          for (const auto& corners : normals) {
            for (const auto& normal : corners) {
              all.emplace_back(normal[0], normal[1], normal[2]);
            }
          }
          return bits(all);
        });
    (void)made("svg", [&] { return drawing_svg(drawing, scale, options); });
    (void)made("svg report", [&] { return drawing_report_json(drawing, scale, "a", options); });
    if (can_draw_pages()) {
      (void)made("png", [&] { return drawing_png(drawing, scale, options); });
    }
    const auto nurbs = made(
        "nurbs", [&] { return named_nurbs(assembly, .01); },
        [](const auto& forms) { return nurbs_json(forms, Unit::inch); });
    (void)made("nurbs in JSON", [&] { return nurbs_json(nurbs, Unit::inch); });
    if (has_page_viewer()) {
      const BuildReport report;
      (void)made("page", [&] { return report_page_html(report_page({assembly, report}, mesh)); });
    }
  });
}

TEST(UsualArithmeticOfFiles, edits_and_lengths) {
  const std::string text = read_file(test::source_folder() / "examples/ucct-arm.json");
  const Assembly assembly = parse_assembly(text, "a");
  const auto chain = std::get<CyclideChainThrough>(assembly.parts[0].shape);
  expect_usual([&](Made& made) {
    (void)made("chain", [&] { return with_chain(text, "a", 0, chain); });
    for (const std::string length : {"0.1", "0.30000000000000000001mm", "1.1ft"}) {
      (void)made(
          length, [&] { return parse_length(length, Unit::inch); },
          [](double value) { return bits({Vec3::Constant(value)}); });
    }
  });
}

}  // namespace
}  // namespace dupin
