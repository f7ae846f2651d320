#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dupin/io/stl.h"
#include "dupin/kernel/parallel.h"
#include "formats/stl_facet.h"
#include "text/append_each.h"
#include "text/mesh_text.h"
#include "text/point_merger.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

// The shortest facet: "facet normal 0 0 0 outer loop vertex 0 0 0 (three times) endloop endfacet".
constexpr std::size_t kShortestFacet = 80;

void demand(text::TextScanner& scanner, std::string_view keyword) {
  scanner.skip_space();
  if (!scanner.take(keyword)) {
    scanner.fail("'" + std::string(keyword) + "'");
  }
}

/// Normals are not used, and writers print all kinds of non-numbers there ("-nan(ind)").
bool take_normal(text::TextScanner& scanner) {
  constexpr std::string_view kStarts = "+-.0123456789nNiI";
  for (int axis = 0; axis < 3; ++axis) {
    scanner.skip_space();
    const std::string_view token = scanner.peek();
    if (token.empty() || kStarts.find(token.front()) == std::string_view::npos) {
      return false;
    }
    (void)scanner.token();
  }
  return true;
}

Triangle read_facet(text::TextScanner& scanner, text::PointMerger& points) {
  demand(scanner, "normal");
  if (!take_normal(scanner)) {
    scanner.fail("a component of the facet's normal");
  }
  demand(scanner, "outer");
  demand(scanner, "loop");
  Triangle triangle;
  for (std::uint32_t& corner : triangle) {
    demand(scanner, "vertex");
    corner = points.index_of(scanner.vector("a coordinate"));
  }
  demand(scanner, "endloop");
  demand(scanner, "endfacet");
  return triangle;
}

/// The name of a block, or "" for the only block of a file.
std::string block_name(std::string_view rest, std::size_t block, bool more) {
  std::string name = text::clean_line(rest);
  if (name.empty() && (block > 1 || more)) {
    name = "solid " + std::to_string(block);
  }
  return name;
}

bool take_next(text::TextScanner& scanner, std::string_view keyword) {
  scanner.skip_space();
  return scanner.take(keyword);
}

/// Whether a facet begins there, and no name that only has some of its words in it.
bool is_at_facet(text::TextScanner at) {
  return at.take("facet") && take_next(at, "normal") && take_normal(at) && take_next(at, "outer") &&
         take_next(at, "loop");
}

/// Takes the name behind "solid": the rest of the line, up to a facet where one is in it.
std::string_view take_name(text::TextScanner& scanner) {
  text::TextScanner behind = scanner;
  const std::string_view line = behind.rest_of_line();
  for (text::TextScanner at = scanner; !at.at_line_end(); (void)at.token()) {
    if (is_at_facet(at)) {
      scanner = at;
      return line.substr(0, static_cast<std::size_t>(at.peek().data() - line.data()));
    }
  }
  scanner = behind;
  return line;
}

/// Takes the name behind "endsolid": the rest of the line, up to a solid where one is in it.
void skip_name(text::TextScanner& scanner) {
  text::TextScanner solid = scanner;
  for (text::TextScanner at = scanner; !at.at_line_end(); (void)at.token()) {
    if (is_at_facet(at)) {
      scanner = solid;
      return;
    }
    if (text::TextScanner next = at; next.take("solid")) {
      solid = at;
    }
  }
  (void)scanner.rest_of_line();
}

/// The points as text, one after the other, each printed once.
class PointTexts {
 public:
  explicit PointTexts(const std::vector<Vec3>& points) {
    text_.reserve(points.size() * 60);
    begins_.reserve(points.size() + 1);
    for (const Vec3& point : points) {
      begins_.push_back(text_.size());
      text::append_point(text_, point);
    }
    begins_.push_back(text_.size());
  }
  [[nodiscard]] std::string_view operator[](std::uint32_t index) const {
    return std::string_view(text_).substr(begins_[index], begins_[index + 1] - begins_[index]);
  }

 private:
  std::string text_;
  std::vector<std::size_t> begins_;
};

}  // namespace

TriMesh read_stl_ascii(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  text::TextScanner scanner(bytes, file);
  text::PointMerger points(bytes.size() / kShortestFacet / 2);
  text::LabelBuilder labels;
  TriMesh mesh;
  std::size_t block = 0;
  do {
    demand(scanner, "solid");
    const std::string_view rest = take_name(scanner);
    ++block;
    const std::size_t first = mesh.triangles.size();
    for (scanner.skip_space(); scanner.take("facet"); scanner.skip_space()) {
      mesh.triangles.push_back(read_facet(scanner, points));
    }
    if (!scanner.take("endsolid")) {
      scanner.fail("'facet' or 'endsolid'");
    }
    skip_name(scanner);
    const std::string name = block_name(rest, block, !scanner.at_end());
    if (!name.empty() && mesh.triangles.size() > first) {
      mesh.labels.resize(mesh.triangles.size(), labels.label(name));
    }
  } while (!scanner.at_end());
  mesh.points = std::move(points).take_points();
  std::move(labels).name_labels(mesh);
  return mesh;
}

std::string stl_ascii_text(const TriMesh& mesh) {
  const UsualArithmetic usual;
  const std::vector<Vec3> points = text::surface_points(mesh, Coordinates::binary32);
  const PointTexts texts(points);
  std::string text;
  text.reserve(mesh.triangles.size() * 250 + 256);
  const auto groups = text::triangles_by_label(mesh);
  const std::vector<std::string> names = text::written_names(mesh.names);
  for (std::size_t group = 0; group < groups.size(); ++group) {
    const std::string name = mesh.labels.empty() ? std::string() : names[group];
    if (groups[group].empty() && !mesh.labels.empty()) {
      continue;
    }
    text += "solid " + name + '\n';
    text::append_each(text, groups[group].size(), [&](std::string& end, std::size_t i) {
      const Triangle& triangle = mesh.triangles[groups[group][i]];
      end += "facet normal ";
      text::append_point(end, formats::facet_normal(triangle, points));
      end += "\nouter loop\n";
      for (const std::uint32_t corner : triangle) {
        end += "vertex ";
        end += texts[corner];
        end += '\n';
      }
      end += "endloop\nendfacet\n";
    });
    text += "endsolid " + name + '\n';
  }
  return text.empty() ? "solid \nendsolid \n" : text;
}

}  // namespace dupin
