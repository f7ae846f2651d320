#include "dupin/io/off.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "dupin/kernel/parallel.h"
#include "text/append_each.h"
#include "text/mesh_text.h"
#include "text/polygon.h"
#include "text/text_scanner.h"

namespace dupin {
namespace {

constexpr std::int64_t kMostPoints = std::numeric_limits<std::uint32_t>::max();
// The shortest lines the format allows: "0 0 0" and "3 0 0 0" with a line end (the last has none).
constexpr std::size_t kShortestPoint = 6;
constexpr std::size_t kShortestFace = 8;

struct Counts {
  std::size_t points = 0;
  std::size_t faces = 0;
  std::size_t place = 0;  ///< in the file
};

constexpr std::string_view kKeyword = "OFF";

/// How many letters before "OFF" say that numbers follow the coordinates of each point; none if the
/// token is no keyword. Some writers glue the first count behind it.
std::optional<std::size_t> keyword_prefix(std::string_view token) {
  const std::size_t prefix = std::min(token.find_first_not_of("STCN"), token.size());
  if (!token.substr(prefix).starts_with(kKeyword)) {
    return std::nullopt;
  }
  const std::string_view glued = token.substr(prefix + kKeyword.size());
  return glued.find_first_not_of("0123456789") == std::string_view::npos ? std::optional(prefix)
                                                                         : std::nullopt;
}

/// The keyword; true when numbers follow the coordinates of each point. Leaves the scanner behind
/// "OFF".
bool read_keyword(text::TextScanner& scanner) {
  scanner.skip_space();
  const std::optional<std::size_t> prefix = keyword_prefix(scanner.peek());
  if (!prefix) {
    scanner.fail("the keyword OFF (or COFF, NOFF, CNOFF, STOFF)");
  }
  scanner.move_to(scanner.position() + *prefix + kKeyword.size());
  if (scanner.peek() == "BINARY") {
    scanner.fail("the text form of OFF");
  }
  return *prefix > 0;
}

Counts read_counts(text::TextScanner& scanner) {
  scanner.skip_space();
  Counts counts;
  const std::size_t place = counts.place = scanner.position();
  counts.points = static_cast<std::size_t>(
      scanner.integer(0, kMostPoints, "the number of vertices, an integer"));
  counts.faces =
      static_cast<std::size_t>(scanner.integer(0, kMostPoints, "the number of faces, an integer"));
  if (!scanner.at_line_end()) {
    (void)scanner.integer(0, std::numeric_limits<std::int64_t>::max(),
                          "the number of edges, an integer");
  }
  scanner.end_line("the end of the line behind the counts");
  if (counts.points == 0 && counts.faces > 0) {
    scanner.fail_at(place, "found " + std::to_string(counts.faces) +
                               " faces of no vertices, expected vertices");
  }
  const std::size_t least = counts.points * kShortestPoint + counts.faces * kShortestFace;
  if (least > scanner.remaining() + 1) {
    scanner.fail_at(place, "found counts of " + std::to_string(counts.points) + " vertices and " +
                               std::to_string(counts.faces) + " faces, expected at least " +
                               std::to_string(least) + " bytes after them, not " +
                               std::to_string(scanner.remaining()));
  }
  return counts;
}

/// Appends the face, cut into triangles. `corners` is room for those of one face.
void read_face(text::TextScanner& scanner, std::vector<std::uint32_t>& corners, TriMesh& mesh) {
  const std::size_t points = mesh.points.size();
  scanner.skip_space();
  if (scanner.take_triangle('3', 0, points, mesh.triangles)) {
    return;
  }
  const std::size_t place = scanner.position();
  const std::int64_t size =
      scanner.integer(3, kMostPoints, "a face: its number of vertices, an integer");
  corners.clear();
  for (std::int64_t i = 0; i < size; ++i) {
    scanner.skip_space();  // a face may run over several lines
    corners.push_back(static_cast<std::uint32_t>(scanner.integer(
        0, static_cast<std::int64_t>(points) - 1, "the index of a vertex, an integer")));
  }
  for (int colour = 0; colour < 4 && !scanner.at_line_end(); ++colour) {
    scanner.skip_number("a colour's component");
  }
  if (!scanner.at_line_end()) {
    scanner.fail_at(place, "found more than 4 numbers behind a face of " + std::to_string(size) +
                               " vertices, expected at most a colour");
  }
  text::triangulate(corners, mesh.points, mesh.triangles, [&] { return scanner.place(place); });
}

/// The lines of points and triangles of a file, cut into pieces of whole lines.
struct Lines {
  std::vector<std::size_t> begins;   ///< of pieces, and the file's end
  std::vector<std::size_t> numbers;  ///< how many lines lie before each of them
};

Lines cut_lines(std::string_view bytes, std::size_t begin) {
  constexpr std::size_t kPiece = std::size_t{1} << 18;
  Lines lines{{begin}, {0}};
  while (lines.begins.back() < bytes.size()) {
    const std::size_t end = bytes.find('\n', lines.begins.back() + kPiece);
    lines.begins.push_back(std::min(end, bytes.size() - 1) + 1);
  }
  lines.numbers.resize(lines.begins.size());
  for_each_in_parallel(lines.begins.size() - 1, [&](std::size_t i) {
    lines.numbers[i + 1] = static_cast<std::size_t>(
        std::count(bytes.begin() + static_cast<std::ptrdiff_t>(lines.begins[i]),
                   bytes.begin() + static_cast<std::ptrdiff_t>(lines.begins[i + 1]), '\n'));
  });
  std::partial_sum(lines.numbers.begin(), lines.numbers.end(), lines.numbers.begin());
  return lines;
}

Triangle read_triangle(text::TextScanner& scanner, std::size_t points,
                       std::vector<Triangle>& room) {
  room.clear();
  if (scanner.take_triangle('3', 0, points, room)) {
    return room.front();
  }
  (void)scanner.integer(3, 3, "a triangle");
  Triangle triangle;
  for (std::uint32_t& corner : triangle) {
    corner = static_cast<std::uint32_t>(
        scanner.integer(0, static_cast<std::int64_t>(points) - 1, "the index of a vertex"));
  }
  scanner.end_line("the end of the line");
  return triangle;
}

/// Reads the lines of the piece, if each is that of one point or of one triangle. May throw if not.
/// Of other lines than were counted, as a CR ends one, none is taken for one of another piece.
bool read_lines(text::TextScanner& scanner, const Lines& lines, std::size_t piece, TriMesh& mesh) {
  std::vector<Triangle> room;
  for (std::size_t number = lines.numbers[piece]; number < lines.numbers[piece + 1]; ++number) {
    if (number < mesh.points.size()) {
      mesh.points[number] = scanner.vector("a coordinate");
      scanner.end_line("the end of the line behind a vertex");
    } else {
      mesh.triangles.at(number - mesh.points.size()) =
          read_triangle(scanner, mesh.points.size(), room);
    }
  }
  return scanner.position() == lines.begins[piece + 1];
}

/// Reads points and triangles by pieces, in parallel, if each has a line of its own, as in most
/// files. False if not so.
bool read_pieces(std::string_view bytes, std::size_t begin, const Counts& counts, TriMesh& mesh) {
  constexpr std::size_t kMany = 10000;
  if (counts.points + counts.faces < kMany) {
    return false;
  }
  const Lines lines = cut_lines(bytes, begin);
  if (lines.numbers.back() != counts.points + counts.faces || bytes.back() != '\n') {
    return false;
  }
  mesh.points.resize(counts.points);
  mesh.triangles.resize(counts.faces);
  std::atomic<bool> is_regular{true};
  for_each_in_parallel(lines.numbers.size() - 1, [&](std::size_t i) {
    if (!is_regular) {
      return;
    }
    const UsualArithmetic usual;
    text::TextScanner scanner(bytes, {}, '#');
    scanner.move_to(lines.begins[i]);
    try {
      if (!read_lines(scanner, lines, i, mesh)) {
        is_regular = false;
      }
    } catch (const std::exception&) {  // reading line by line says what
      is_regular = false;
    }
  });
  return is_regular;
}

Evidence recognise(std::string_view bytes) {
  text::TextScanner scanner(bytes, {}, '#');
  scanner.skip_space();
  return keyword_prefix(scanner.peek()) ? Evidence::text_signature : Evidence::none;
}

}  // namespace

TriMesh read_off(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  text::TextScanner scanner(bytes, file, '#');
  const bool has_extras = read_keyword(scanner);
  const Counts counts = read_counts(scanner);
  TriMesh mesh;
  if (!has_extras && read_pieces(bytes, scanner.position(), counts, mesh)) {
    return mesh;
  }
  mesh = {};
  mesh.points.reserve(counts.points);
  for (std::size_t i = 0; i < counts.points; ++i) {
    scanner.skip_space();
    mesh.points.push_back(scanner.vector("a coordinate"));
    while (has_extras && !scanner.at_line_end()) {
      scanner.skip_number("a component of a normal, colour or texture coordinate");
    }
    scanner.end_line("the end of the line behind a vertex");
  }
  mesh.triangles.reserve(counts.faces);
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i < counts.faces; ++i) {
    read_face(scanner, corners, mesh);
  }
  if (!scanner.at_end()) {
    scanner.fail("the end of the file behind the last face");
  }
  if (counts.points > 0 && counts.faces == 0) {
    scanner.fail_at(counts.place, "found " + std::to_string(counts.points) +
                                      " vertices and no face, expected faces");
  }
  return mesh;
}

std::string off_text(const TriMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  const std::vector<Vec3> points = text::surface_points(mesh, Coordinates::binary64);
  std::string text = "OFF\n" + text::header_lines(header, "# ");
  text.reserve(text.size() + 64 + points.size() * 60 + mesh.triangles.size() * 26);
  text += std::to_string(points.size()) + ' ' + std::to_string(mesh.triangles.size()) + " 0\n";
  text::append_each(text, points.size(), [&](std::string& end, std::size_t i) {
    text::append_point(end, points[i]);
    end += '\n';
  });
  text::append_each(text, mesh.triangles.size(), [&](std::string& end, std::size_t i) {
    end += '3';
    for (const std::uint32_t corner : mesh.triangles[i]) {
      end += ' ';
      append_decimal(end, corner);
    }
    end += '\n';
  });
  return text;
}

constinit const MeshFormat kOff = {.key = "off",
                                   .name = "OFF",
                                   .extension = ".off",
                                   .coordinates = Coordinates::binary64,
                                   .read = read_off,
                                   .write = off_text,
                                   .recognises = recognise,
                                   .unit = text::unit_behind_hash};

}  // namespace dupin
