#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "dupin/io/report_page.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/patch.h"
#include "dupin/kernel/wall_thickness.h"
#include "pages/page_parts.h"
#include "pages/page_sections.h"

namespace dupin {
namespace {

using pages::counted;
using pages::measure;

constexpr double kPlaceShare = 0.02;
constexpr std::size_t kWallsShown = 100;

PageSection overview(const MeshSummary& summary) {
  PageSection section{"Overview", "", {"", ""}};
  const Report& check = summary.check;
  const std::string& unit = summary.unit;
  const auto add = [&section](const std::string& what, const std::string& value,
                              bool is_finding = false) {
    section.rows.push_back({{what, value}, is_finding});
  };
  add("file", std::filesystem::path(summary.file).filename().string());
  add("triangles", std::to_string(check.triangles));
  add("points", std::to_string(check.points));
  add("solid", check.is_solid() ? "yes: closed, manifold, free of self-intersection" : "no",
      !check.is_solid());
  add("components", std::to_string(check.components));
  if (check.closed()) {
    add("genus", std::to_string(check.genus));
  }
  if (has_volume(check)) {
    add("volume", measure(check.volume, unit, 3));
  }
  if (is_measured(check)) {
    add("area", measure(check.area, unit, 2));
  }
  add("unit", unit.empty() ? "the file says none" : unit);
  return section;
}

PageSection patch_section(const ReportPage& page) {
  PageSection section{"Patches", "", {"patch", "triangles", "area"}};
  section.is_counted = true;
  std::map<std::string_view, std::uint32_t> label_of;
  for (std::uint32_t i = 0; i < page.mesh.names.size(); ++i) {
    label_of.emplace(page.mesh.names[i], i);
  }
  std::map<std::uint32_t, std::uint32_t> part_of;  // by label
  for (std::uint32_t i = 0; i < page.parts.size(); ++i) {
    for (const std::uint32_t label : page.parts[i].labels) {
      part_of[label] = i;
    }
  }
  for (const Patch& patch : patches_of(page.mesh)) {
    PageRow row{{patch.name.empty() ? "(no name)" : patch.name, std::to_string(patch.triangles),
                 measure(patch.area, page.unit, 2)}};
    if (const auto label = label_of.find(patch.name); label != label_of.end()) {
      const auto part = part_of.find(label->second);
      row.part = part == part_of.end() ? row.part : part->second;
    }
    section.rows.push_back(std::move(row));
  }
  return section;
}

PageSection wall_section(const ReportPage& page) {
  PageSection section{"Walls",
                      "The thinnest place that was found behind each patch, along the normals.",
                      {"patch", "thickness", "at"}};
  std::vector<WallPlace> walls = thinnest_walls(page.mesh);
  std::ranges::stable_sort(walls, {}, &WallPlace::thickness);
  walls.resize(std::min(walls.size(), kWallsShown));
  for (const WallPlace& wall : walls) {
    const Vec3 middle = (wall.from + wall.to) / 2;
    section.rows.push_back({{page.mesh.names.empty() ? "the whole" : page.mesh.names.at(wall.label),
                             measure(wall.thickness, page.unit), decimal(middle)},
                            false,
                            PagePlace{middle, 8 * wall.thickness, {{wall.from, wall.to}}}});
  }
  return section;
}

// Names up to their first dots, where several have one in common.
std::vector<PagePart> parts_of_names(const std::vector<std::string>& names) {
  std::vector<PagePart> parts;
  std::set<std::string> known;
  for (const std::string& name : names) {
    if (const std::string part = name.substr(0, name.find('.')); known.insert(part).second) {
      parts.push_back({part, ""});
    }
  }
  return parts;
}

}  // namespace

ReportPage report_page(const MeshSummary& summary) {
  const UsualArithmetic usual;
  ReportPage page;
  page.title = std::filesystem::path(summary.file).filename().string();
  page.unit = summary.unit;
  page.mesh = summary.mesh;
  page.parts = pages::page_parts(page.mesh, parts_of_names(page.mesh.names));
  page.summary = counted(page.mesh.triangles.size(), "triangle") +
                 (summary.check.is_solid() ? ", a solid" : ", no solid");
  const auto box = bounding_box(page.mesh);
  const double size = box.isEmpty() ? 1 : kPlaceShare * box.diagonal().norm();
  page.sections.push_back(overview(summary));
  if (PageSection faults = pages::fault_section(summary, size); !faults.rows.empty()) {
    page.sections.push_back(std::move(faults));
  }
  page.sections.push_back(patch_section(page));
  if (summary.check.is_solid()) {
    page.sections.push_back(wall_section(page));
  }
  return page;
}

}  // namespace dupin
