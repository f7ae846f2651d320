#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "dupin/blends/certify.h"
#include "dupin/io/report_page.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/wall_thickness.h"
#include "pages/page_parts.h"
#include "pages/page_sections.h"

namespace dupin {
namespace {

using pages::at_most;
using pages::counted;
using pages::measure;

// Of the mesh's diagonal: what is looked at around a place that has no size.
constexpr double kPlaceShare = 0.02;

class BuiltPage {
 public:
  BuiltPage(const BuiltDocument& built, TriMesh mesh)
      : built_(built), report_(built.report), unit_(symbol(built.assembly.unit)) {
    page_.title = built.assembly.source.empty()
                      ? "assembly"
                      : std::filesystem::path(built.assembly.source).filename().string();
    page_.unit = unit_;
    page_.mesh = std::move(mesh);
    for (const PartReport& part : report_.parts) {
      PagePart named{part.name, part.kind};
      if (part.margin_lower) {
        named.values["margin"] = *part.margin_lower;
      }
      named_.push_back(std::move(named));
    }
    for (PagePart& part : named_) {
      if (const auto colour = built.colours.find(part.name); colour != built.colours.end()) {
        part.colour = colour->second;
      }
    }
    for (const Part& part : built_.assembly.parts) {
      others_.emplace(part.name, kind(part.shape));
    }
  }

  ReportPage page() && {
    page_.parts = pages::page_parts(page_.mesh, named_);
    for (std::size_t i = named_.size(); i < page_.parts.size(); ++i) {
      const auto other = others_.find(page_.parts[i].name);
      page_.parts[i].kind = other == others_.end() ? "" : other->second;
    }
    for (std::uint32_t i = 0; i < page_.parts.size(); ++i) {
      index_.emplace(page_.parts[i].name, i);
    }
    const double size = kPlaceShare * diagonal();
    std::vector<PageSection> sections;
    sections.push_back(parts_section());
    sections.push_back(pages::gap_section(report_.gaps));
    add_if_any(sections, pages::note_section(report_, built_.line, built_.graph));
    if (report_.piping) {
      add_if_any(sections, pages::joint_section(*report_.piping, built_.line));
    }
    add_if_any(sections, pages::contact_section(report_.output.contacts, report_.output.settled,
                                                unit_, size));
    add_if_any(sections, margin_section());
    if (report_.volumes && report_.region == Region::metal) {
      add_if_any(sections, wall_section());
    }
    add_if_any(sections, pages::rounding_section(report_.output.rounding, unit_, size));
    sections.push_back(volume_section());
    if (built_.certificate != nullptr) {
      sections.push_back(claims_section());
    }
    sections.insert(sections.begin(), overview());
    page_.sections = std::move(sections);
    page_.summary = counted(report_.parts.size(), "part") + ", " +
                    counted(page_.mesh.triangles.size(), "triangle") +
                    (report_.findings() == 0 ? "" : ", " + counted(report_.findings(), "finding"));
    return std::move(page_);
  }

 private:
  static void add_if_any(std::vector<PageSection>& sections, PageSection section) {
    if (!section.rows.empty()) {
      sections.push_back(std::move(section));
    }
  }

  [[nodiscard]] double diagonal() const {
    const auto box = bounding_box(page_.mesh);
    return box.isEmpty() ? 1 : box.diagonal().norm();
  }

  [[nodiscard]] std::optional<std::uint32_t> index_of(const std::string& part) const {
    const auto found = index_.find(part);
    return found == index_.end() || page_.parts[found->second].labels.empty()
               ? std::nullopt
               : std::optional(found->second);
  }

  [[nodiscard]] PageSection overview() const {
    PageSection section{"Overview", "", {"", ""}};
    const auto add = [&section](const std::string& what, const std::string& value,
                                bool is_finding = false) {
      section.rows.push_back({{what, value}, is_finding});
    };
    const OutputReport& output = report_.output;
    add("document", page_.title);
    if (!output.file.empty()) {
      add("written", output.file + ", " + output.format);
    }
    add("parts",
        counted(report_.parts.size(), "part") + ", welded in " + counted(report_.runs, "run"));
    add("triangles", std::to_string(page_.mesh.triangles.size()));
    if (output.check) {
      const Report& check = *output.check;
      add("solid", check.is_solid() ? "yes: closed, manifold, free of self-intersection" : "no",
          !check.is_solid());
      add("components",
          std::to_string(check.components) + ", genus " + std::to_string(check.genus));
      add("volume", measure(check.volume, unit_, 3));
      add("area", measure(check.area, unit_, 2));
    }
    if (report_.volumes) {
      add("region", std::string(name(report_.region)));
    }
    double error = 0;
    for (const PartReport& part : report_.parts) {
      error = std::max(error, part.error_bound);
    }
    add("mesh error", at_most(error, unit_));
    add("rounding", output.rounding.moved == 0
                        ? "none"
                        : counted(output.rounding.moved, "point") + " moved, " +
                              at_most(output.rounding.largest_move, unit_));
    add("gaps", report_.gaps.findings() == 0 ? "none" : std::to_string(report_.gaps.findings()),
        report_.gaps.findings() > 0);
    add("contacts", contacts_text());
    add_least(section);
    if (report_.source_findings() > 0) {
      add("left out", std::to_string(report_.source_findings()), true);
    }
    if (built_.certificate != nullptr) {
      const std::size_t findings = built_.certificate->findings();
      add("certificate",
          findings == 0 ? "all claims proved" : std::to_string(findings) + " claims not proved",
          findings > 0);
    }
    return section;
  }

  [[nodiscard]] std::string contacts_text() const {
    const OutputReport& output = report_.output;
    std::string text = output.contacts.empty() ? "" : std::to_string(output.contacts.size());
    if (output.settled && !output.settled->contacts.empty()) {
      text += (text.empty() ? "" : ", ") + std::to_string(output.settled->contacts.size()) +
              (output.settled->policy == "bridge" ? " bridged" : " separated");
    }
    return text.empty() ? "none" : text;
  }

  // Of walls and margins what is proved, and of which part.
  void add_least(PageSection& section) const {
    const auto add = [&](const std::string& what, auto value_of, auto text_of) {
      const PartReport* least = nullptr;
      for (const PartReport& part : report_.parts) {
        if (value_of(part) && (least == nullptr || *value_of(part) < *value_of(*least))) {
          least = &part;
        }
      }
      if (least != nullptr) {
        section.rows.push_back({{what, text_of(*value_of(*least)) + ", " + least->name}});
        section.rows.back().part = index_of(least->name);
      }
    };
    const auto unproved = std::ranges::count_if(
        report_.parts, [](const PartReport& part) { return part.is_hollow && !part.least_wall; });
    add(
        "least wall", [](const PartReport& part) { return part.least_wall; },
        [&](double wall) {
          return "proved, at least " + decimal_at_least(wall) + (unit_.empty() ? "" : " " + unit_) +
                 (unproved > 0 ? ", but for " + std::to_string(unproved) + " not proved" : "");
        });
    add(
        "smallest margin", [](const PartReport& part) { return part.margin_lower; },
        [](double margin) { return "proved, at least " + decimal_at_least(margin); });
  }

  // Every claim that is about one part leads to it.
  [[nodiscard]] PageSection claims_section() const {
    PageSection section = pages::certificate_section(*built_.certificate);
    for (PageRow& row : section.rows) {
      row.part = index_of(row.cells.at(2));
    }
    return section;
  }

  [[nodiscard]] PageSection parts_section() const {
    PageSection section{"Parts", "", {"part", "kind", "mesh error", "triangles", "remarks"}};
    section.is_counted = true;
    for (const PartReport& part : report_.parts) {
      std::string remarks = part.construction;
      for (const auto* list : {&part.rejected, &part.warnings}) {
        for (const std::string& text : *list) {
          remarks += (remarks.empty() ? "" : "; ") + text;
        }
      }
      PageRow row{{part.name, part.kind,
                   decimal_at_most(part.error_bound) + (unit_.empty() ? "" : " " + unit_),
                   std::to_string(part.triangles), remarks}};
      row.part = index_of(part.name);
      section.rows.push_back(std::move(row));
    }
    return section;
  }

  [[nodiscard]] PageSection margin_section() const {
    PageSection section{"Margins",
                        "How far the smooth surfaces are from folding: min(1 \u2212 \u03baR), "
                        "proved from below, and where that is. 1 is a straight pipe.",
                        {"part", "at least", "at most"}};
    std::map<std::string, MarginPlace> places;
    for (MarginPlace& place : margin_places(built_.assembly)) {
      places.emplace(place.part, place);
    }
    std::vector<const PartReport*> parts;
    for (const PartReport& part : report_.parts) {
      if (part.margin_lower) {
        parts.push_back(&part);
      }
    }
    std::ranges::stable_sort(parts, {}, [](const PartReport* part) { return *part->margin_lower; });
    for (const PartReport* part : parts) {
      PageRow row{{part->name, decimal_at_least(*part->margin_lower),
                   part->margin_upper ? decimal_at_most(*part->margin_upper) : ""}};
      if (const auto place = places.find(part->name); place != places.end()) {
        row.place = PagePlace{place->second.center, 2 * place->second.radius};
      }
      row.part = index_of(part->name);
      section.rows.push_back(std::move(row));
    }
    return section;
  }

  PageSection wall_section() {
    PageSection section{
        "Walls",
        "The thinnest place that was found behind each patch, along the normals of the mesh.",
        {"patch", "thickness", "at"}};
    std::vector<WallPlace> walls = thinnest_walls(page_.mesh);
    std::ranges::stable_sort(walls, {}, &WallPlace::thickness);
    for (const WallPlace& wall : walls) {
      const std::string& patch = page_.mesh.names.at(wall.label);
      const Vec3 middle = (wall.from + wall.to) / 2;
      PagePlace place{middle, 8 * wall.thickness, {{wall.from, wall.to}}};
      section.rows.push_back(
          {{patch, measure(wall.thickness, unit_), decimal(middle)}, false, std::move(place)});
      for (PagePart& part : page_.parts) {
        if (std::ranges::find(part.labels, wall.label) != part.labels.end()) {
          part.values.emplace("wall", wall.thickness);  // the thinnest comes first
        }
      }
    }
    return section;
  }

  [[nodiscard]] PageSection volume_section() const {
    PageSection section{
        "Volumes",
        "Of the smooth surfaces, part by part; what lies in two parts counts twice.",
        {"part", "length", "area", "volume", "metal", "fluid"}};
    if (report_.volumes) {
      section.rows.push_back(
          {{"the whole, of the mesh", "", "", measure(report_.volumes->outer, unit_, 3),
            measure(report_.volumes->metal, unit_, 3), measure(report_.volumes->fluid, unit_, 3)}});
    } else if (report_.output.check) {
      // Without walls all of it is metal, as bom has it.
      const bool is_solid = report_.region == Region::outer;
      const std::string volume = measure(report_.output.check->volume, unit_, 3);
      section.rows.push_back(
          {{"the whole, of the mesh", "", measure(report_.output.check->area, unit_, 2), volume,
            is_solid ? volume : "", is_solid ? measure(0, unit_, 3) : ""}});
    }
    try {
      for (const BillRow& row : bill_of_materials(built_.assembly).rows) {
        const auto volume = [this](const std::optional<SolidMoments>& solid) {
          return solid ? measure(solid->volume, unit_, 3) : "";
        };
        PageRow cells{{row.name, row.length ? measure(*row.length, unit_) : "",
                       row.area ? measure(*row.area, unit_, 2) : "", volume(row.outer),
                       volume(row.metal), volume(row.fluid)}};
        cells.part = index_of(row.name);
        section.rows.push_back(std::move(cells));
      }
    } catch (const Error& error) {
      section.note = std::string("Of parts there are no volumes: ") + error.what();
    }
    return section;
  }

  const BuiltDocument& built_;
  const BuildReport& report_;
  std::string unit_;
  ReportPage page_;
  std::vector<PagePart> named_;
  std::map<std::string, std::string> others_;  // caps, and what else has no report
  std::map<std::string, std::uint32_t> index_;
};

}  // namespace

ReportPage report_page(const BuiltDocument& built, TriMesh mesh) {
  const UsualArithmetic usual;
  return BuiltPage(built, std::move(mesh)).page();
}

}  // namespace dupin
