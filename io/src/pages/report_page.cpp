#include "dupin/io/report_page.h"

#include <algorithm>
#include <utility>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "pages/packed_mesh.h"
#include "pages/page_files.h"
#include "text/base64.h"
#include "text/json_type.h"
#include "text/mesh_text.h"

namespace dupin {
namespace {

using text::Json;

Json vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json place_json(const PagePlace& place) {
  Json json = {{"at", vector_json(place.at)}, {"size", place.size}};
  if (place.is_marked) {
    json["marked"] = true;
  }
  for (const std::vector<Vec3>& line : place.lines) {
    Json points = Json::array();
    for (const Vec3& point : line) {
      points.push_back(vector_json(point));
    }
    json["lines"].push_back(std::move(points));
  }
  return json;
}

Json section_json(const PageSection& section) {
  Json rows = Json::array();
  for (const PageRow& row : section.rows) {
    Json json = {{"cells", row.cells}};
    if (row.is_finding) {
      json["finding"] = true;
    }
    if (row.place) {
      json["place"] = place_json(*row.place);
    }
    if (row.part) {
      json["part"] = *row.part;
    }
    rows.push_back(std::move(json));
  }
  return {{"title", section.title},
          {"note", section.note},
          {"counted", section.is_counted},
          {"columns", section.columns},
          {"rows", std::move(rows)}};
}

Json part_json(const PagePart& part) {
  Json json = {{"name", part.name}, {"kind", part.kind}, {"labels", part.labels}};
  if (!part.colour.empty()) {
    json["colour"] = part.colour;
  }
  if (!part.values.empty()) {
    json["values"] = part.values;
  }
  return json;
}

Json page_json(const ReportPage& page, const pages::PackedMesh& mesh) {
  Json parts = Json::array(), sections = Json::array();
  std::ranges::transform(page.parts, std::back_inserter(parts), part_json);
  std::ranges::transform(page.sections, std::back_inserter(sections), section_json);
  const bool has_names = !page.mesh.names.empty();
  return {{"title", page.title},
          {"summary", page.summary},
          {"unit", page.unit},
          {"labels", has_names ? Json(page.mesh.names) : Json::array({""})},
          {"parts", std::move(parts)},
          {"sections", std::move(sections)},
          {"mesh",
           {{"points", mesh.points},
            {"triangles", mesh.triangles},
            {"center", vector_json(mesh.center)},
            {"step", mesh.step},
            {"runs", mesh.runs}}}};
}

// In a script element nothing ends the text but "</script" and "<!--".
std::string script_text(std::string text) {
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; at += 6) {
    text.replace(at, 1, "\\u003c");
  }
  return text;
}

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  }
  return result;
}

// Of the library and of our own: a "</script" in their strings would end them.
std::string code_text(std::string_view code) {
  std::string result(code);
  for (std::size_t at = 0; (at = result.find("</", at)) != std::string::npos; at += 3) {
    result.insert(at + 1, 1, '\\');
  }
  return result;
}

void check_labels(const ReportPage& page) {
  std::vector<int> owners(std::max<std::size_t>(1, page.mesh.names.size()), 0);
  for (const PagePart& part : page.parts) {
    for (const std::uint32_t label : part.labels) {
      if (label >= owners.size() || ++owners[label] > 1) {
        throw Error(Errc::invalid_argument,
                    "label " + std::to_string(label) + " is none of the mesh, or two parts' own",
                    part.name);
      }
    }
  }
  for (std::size_t label = 0; label < owners.size(); ++label) {
    if (owners[label] == 0) {
      throw Error(Errc::invalid_argument, "label " + std::to_string(label) + " is no part's");
    }
  }
}

// The page's text with every {{name}} in it replaced, once: what comes in is not looked at again.
std::string filled_in(std::string_view page,
                      const std::map<std::string, std::string, std::less<>>& values) {
  std::string result;
  std::size_t at = 0;
  for (std::size_t open; (open = page.find("{{", at)) != std::string_view::npos;) {
    const std::size_t close = page.find("}}", open);
    result += page.substr(at, open - at);
    result += values.at(std::string(page.substr(open + 2, close - open - 2)));
    at = close + 2;
  }
  return result.append(page.substr(at));
}

}  // namespace

bool has_page_viewer() { return !pages::page_files().library.empty(); }

std::string report_page_html(const ReportPage& page) {
  const UsualArithmetic usual;
  const pages::PageFiles files = pages::page_files();
  if (files.library.empty()) {
    throw Error(Errc::invalid_argument,
                "this build makes no report pages: three.js was not there when it was made "
                "(Debian: libjs-three)");
  }
  check_labels(page);
  // Refuses what has no picture: points that are not finite, indices out of range.
  (void)text::writable_points(page.mesh, Coordinates::binary64);
  const pages::PackedMesh mesh = pages::packed(page.mesh);
  const std::string data =
      page_json(page, mesh).dump(-1, ' ', false, Json::error_handler_t::replace);
  return filled_in(files.page, {{"title", html_text(text::clean_line(page.title))},
                                {"style", std::string(files.style)},
                                {"version", std::string(files.version)},
                                {"licence", html_text(files.library_licence)},
                                {"data", script_text(data)},
                                {"geometry", text::base64(mesh.bytes)},
                                {"library", code_text(files.library)},
                                {"script", code_text(files.script)}});
}

std::string page_report_json(const std::string& file, std::size_t findings) {
  return Json{{"file", file}, {"findings", findings}}.dump(2, ' ', false,
                                                           Json::error_handler_t::replace);
}

}  // namespace dupin
