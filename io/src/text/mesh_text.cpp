#include "text/mesh_text.h"

#include "dupin/kernel/error.h"
#include "text/byte_order_mark.h"
#include "text/known_unit.h"

namespace dupin::text {
namespace {

void require_finite(const TriMesh& mesh) {
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!mesh.points[i].allFinite()) {
      throw Error(Errc::invalid_argument,
                  "point " + std::to_string(i) + " of the mesh is not finite");
    }
  }
}

void require_indices(const TriMesh& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t corner : mesh.triangles[i]) {
      if (corner >= mesh.points.size()) {
        throw Error(Errc::invalid_argument, "triangle " + std::to_string(i) + " names point " +
                                                std::to_string(corner) + " of a mesh with " +
                                                std::to_string(mesh.points.size()) + " points");
      }
    }
  }
}

void require_labels(const TriMesh& mesh) {
  if (!mesh.labels.empty() && mesh.labels.size() != mesh.triangles.size()) {
    throw Error(Errc::invalid_argument, "the mesh has " + std::to_string(mesh.labels.size()) +
                                            " labels for " + std::to_string(mesh.triangles.size()) +
                                            " triangles");
  }
  for (std::size_t i = 0; i < mesh.labels.size(); ++i) {
    if (mesh.labels[i] >= mesh.names.size()) {
      throw Error(Errc::invalid_argument, "triangle " + std::to_string(i) + " has label " +
                                              std::to_string(mesh.labels[i]) + " of " +
                                              std::to_string(mesh.names.size()));
    }
  }
}

/// Length of the valid UTF-8 sequence at the start of `text`, 0 if there is none (Unicode 15,
/// table 3-7).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0);
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned lead = byte(0);
  const unsigned second = byte(1);
  if (lead < 0x80) {
    return 1;
  }
  if (lead >= 0xC2 && lead <= 0xDF) {
    return continues(1) ? 2 : 0;
  }
  if (lead >= 0xE0 && lead <= 0xEF) {
    const bool overlong = lead == 0xE0 && second < 0xA0;
    const bool surrogate = lead == 0xED && second > 0x9F;
    return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const bool overlong = lead == 0xF0 && second < 0x90;
    const bool too_large = lead == 0xF4 && second > 0x8F;
    return continues(1) && continues(2) && continues(3) && !overlong && !too_large ? 4 : 0;
  }
  return 0;
}

}  // namespace

std::vector<Vec3> writable_points(const TriMesh& mesh, Coordinates coordinates) {
  require_finite(mesh);
  require_indices(mesh);
  require_labels(mesh);
  std::vector<Vec3> points;
  points.reserve(mesh.points.size());
  for (const Vec3& point : mesh.points) {
    const Vec3 held = nearest(point, coordinates);
    if (!held.allFinite()) {
      throw Error(Errc::unroundable,
                  "point " + std::to_string(points.size()) +
                      " lies beyond the numbers this format holds (3.4e38); use OFF");
    }
    points.emplace_back(held.array() + 0.0);  // -0 becomes 0
  }
  return points;
}

std::vector<Vec3> surface_points(const TriMesh& mesh, Coordinates coordinates) {
  if (mesh.triangles.empty() && !mesh.points.empty()) {
    throw Error(Errc::invalid_argument, "the mesh has " + std::to_string(mesh.points.size()) +
                                            " points and no triangle; files of meshes need some");
  }
  return writable_points(mesh, coordinates);
}

std::string clean_line(std::string_view text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
  std::string clean;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const auto byte = static_cast<unsigned char>(text.front());
    if (length == 0) {
      clean += kReplacement;
    } else if (byte < ' ' || byte == 0x7F) {
      clean += ' ';
    } else {
      clean += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  const std::size_t begin = clean.find_first_not_of(' ');
  return begin == std::string::npos ? std::string()
                                    : clean.substr(begin, clean.find_last_not_of(' ') + 1 - begin);
}

std::vector<std::string> written_names(const std::vector<std::string>& names,
                                       std::string (*line)(std::string_view)) {
  std::vector<std::string> written;
  written.reserve(names.size());
  std::map<std::string, std::string, std::less<>> name_of;  // that is written so
  for (const std::string& name : names) {
    written.push_back(line(name));
    if (written.back() == name) {
      name_of.emplace(name, name);
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string plain = written[i];
    for (int number = 2; name_of.emplace(written[i], names[i]).first->second != names[i];
         ++number) {
      written[i] = plain + (plain.empty() ? "(" : " (") + std::to_string(number) + ")";
    }
  }
  return written;
}

std::string header_lines(const MeshHeader& header, std::string_view prefix) {
  std::string text = std::string(prefix) + "dupin\n";
  if (!header.unit.empty()) {
    text += std::string(prefix) + "unit: " + clean_line(header.unit) + '\n';
  }
  if (!header.note.empty()) {
    text += std::string(prefix) + clean_line(header.note) + '\n';
  }
  return text;
}

std::string noted_unit(std::string_view bytes, std::string_view prefix) {
  constexpr std::size_t kHead = 512;  // our writers note it in the first lines
  const std::string mark = std::string(prefix) + "unit: ";
  std::string_view head = bytes.substr(byte_order_mark(bytes), kHead);
  for (std::size_t end = 0; (end = head.find_first_of("\r\n")) != std::string_view::npos;) {
    std::string_view line = head.substr(0, end);
    head.remove_prefix(end + 1);
    if (line == "end_header") {  // of PLY, behind which may be any bytes
      break;
    }
    if (line.starts_with(mark)) {
      line.remove_prefix(mark.size());
      line = line.substr(0, line.find_last_not_of(" \t") + 1);
      return metres_in(line) ? std::string(line) : std::string();
    }
  }
  return {};
}

std::string unit_behind_hash(std::string_view bytes, std::string_view /*file*/) {
  return noted_unit(bytes, "# ");
}

std::vector<std::vector<std::uint32_t>> triangles_by_label(const TriMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> groups(mesh.labels.empty() ? 1 : mesh.names.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    groups[mesh.labels.empty() ? 0 : mesh.labels[i]].push_back(i);
  }
  return groups;
}

std::uint32_t LabelBuilder::label(std::string_view name) {
  const auto found = labels_.find(name);
  if (found != labels_.end()) {
    return found->second;
  }
  const auto fresh = static_cast<std::uint32_t>(names_.size());
  names_.emplace_back(name);
  labels_.emplace(name, fresh);
  return fresh;
}

}  // namespace dupin::text
