#include "dupin/io/three_mf.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "files/xml_events.h"
#include "files/zip_package.h"
#include "formats/placed_mesh.h"
#include "formats/three_mf_model.h"
#include "text/append_each.h"
#include "text/label_colour.h"
#include "text/mesh_text.h"
#include "text/xml_text.h"

// Written with libzip and read with libzip and expat, not with lib3mf: its version 1.8 prints
// coordinates with six decimals and gives every object a new random UUID.

namespace dupin {
namespace {

// The symbols of MeshHeader::unit and their names in 3MF.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kUnits = {
    {{"mm", "millimeter"},
     {"cm", "centimeter"},
     {"m", "meter"},
     {"in", "inch"},
     {"ft", "foot"},
     {"um", "micron"}}};

constexpr std::string_view kModelType =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
constexpr std::string_view kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr std::string_view kRelationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type=")";

std::string_view unit_name(std::string_view unit) {
  for (const auto& [symbol, unit_in_3mf] : kUnits) {
    if (symbol == unit || unit.empty()) {
      return unit_in_3mf;
    }
  }
  throw Error(Errc::invalid_argument,
              "3MF has no unit '" + std::string(unit) + "'; it has um, mm, cm, m, in and ft");
}

void append_attribute(std::string& text, std::string_view name, auto value) {
  text += name;
  append_decimal(text, value);
  text += '"';
}

void append_materials(std::string& text, const TriMesh& mesh, const MeshHeader& header) {
  const std::vector<text::Colour> colours = text::label_colours(mesh.names, header.colours);
  const std::vector<std::string> names = text::written_names(mesh.names, text::xml_line);
  text += "<basematerials id=\"2\">\n";
  for (std::size_t label = 0; label < mesh.names.size(); ++label) {
    text += "<base name=\"" + text::xml_escaped(names[label]) + "\" displaycolor=\"" +
            text::colour_code(colours[label]) + "\"/>\n";
  }
  text += "</basematerials>\n";
}

void append_object(std::string& text, const TriMesh& mesh, const std::string& name) {
  const std::vector<Vec3> points = text::surface_points(mesh, Coordinates::binary32);
  text.reserve(text.size() + points.size() * 80 + mesh.triangles.size() * 64);
  text += "<object id=\"1\" type=\"model\"";
  if (mesh.triangles.empty()) {
    text += " name=\"" + std::string(formats::kEmptySet) + '"';
  } else if (!name.empty()) {
    text += " name=\"" + text::xml_escaped(name) + '"';
  }
  text += mesh.labels.empty() ? ">" : " pid=\"2\" pindex=\"0\">";
  text += "\n<mesh>\n<vertices>\n";
  text::append_each(text, points.size(), [&](std::string& end, std::size_t i) {
    append_attribute(end, "<vertex x=\"", points[i].x());
    append_attribute(end, " y=\"", points[i].y());
    append_attribute(end, " z=\"", points[i].z());
    end += "/>\n";
  });
  text += "</vertices>\n<triangles>\n";
  text::append_each(text, mesh.triangles.size(), [&](std::string& end, std::size_t i) {
    append_attribute(end, "<triangle v1=\"", mesh.triangles[i][0]);
    append_attribute(end, " v2=\"", mesh.triangles[i][1]);
    append_attribute(end, " v3=\"", mesh.triangles[i][2]);
    if (!mesh.labels.empty()) {
      append_attribute(end, " pid=\"2\" p1=\"", mesh.labels[i]);
    }
    end += "/>\n";
  });
  text += "</triangles>\n</mesh>\n</object>\n";
}

std::string model_text(const TriMesh& mesh, const MeshHeader& header) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"";
  text += unit_name(header.unit);
  text +=
      "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<metadata name=\"Application\">dupin</metadata>\n";
  if (!header.note.empty()) {
    text += "<metadata name=\"Description\">" + text::xml_escaped(header.note) + "</metadata>\n";
  }
  text += "<resources>\n";
  if (!mesh.labels.empty()) {
    append_materials(text, mesh, header);
  }
  append_object(text, mesh, header.name);
  return text + "</resources>\n<build>\n<item objectid=\"1\"/>\n</build>\n</model>\n";
}

/// The entry that holds the model, as the package's relationships tell it.
std::string model_entry(files::ZipPackage& package, std::string_view file) {
  std::vector<std::string> targets;
  const std::string relationships = package.read("_rels/.rels");
  files::read_xml(relationships, std::string(file) + ":_rels/.rels",
                  {[&](std::string_view element, const files::XmlAttributes& attributes) {
                     if (element == "Relationship" && attributes.find("Type") == kModelType) {
                       targets.emplace_back(attributes.find("Target").value_or(""));
                     }
                     return true;
                   },
                   [](std::string_view) {}});
  if (targets.size() != 1 || files::part_name(targets.front()).empty()) {
    const std::string found =
        targets.size() > 1 ? std::to_string(targets.size()) + " relationships" : "no relationship";
    throw Error(Errc::parse_failed, "found " + found + " to a 3D model, expected one", {},
                std::string(file) + ":_rels/.rels");
  }
  return files::part_name(targets.front());
}

Evidence recognise(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") ? Evidence::signature : Evidence::none;
}

}  // namespace

TriMesh read_3mf(std::string_view bytes, std::string_view file) {
  const UsualArithmetic usual;
  files::ZipPackage package(bytes, file);
  const std::string root = model_entry(package, file);
  return formats::read_3mf_model(root, [&](const std::string& part) {
    return formats::ModelText{package.read(part), std::string(file) + ":" + text::clean_line(part)};
  });
}

std::string unit_of_3mf(std::string_view bytes, std::string_view file) {
  std::string unit = "mm";  // what a model without the attribute is in
  files::ZipPackage package(bytes, file);
  const std::string model = package.read(model_entry(package, file));
  files::read_xml(model, std::string(file),
                  {[&](std::string_view, const files::XmlAttributes& attributes) {
                     for (const auto& [symbol, unit_in_3mf] : kUnits) {
                       unit = attributes.find("unit") == unit_in_3mf ? symbol : unit;
                     }
                     return false;
                   },
                   [](std::string_view) {}});
  return unit;
}

std::string three_mf_bytes(const TriMesh& mesh, const MeshHeader& header) {
  const UsualArithmetic usual;
  return files::zip_archive({{"[Content_Types].xml", std::string(kContentTypes)},
                             {"_rels/.rels", std::string(kRelationships) + std::string(kModelType) +
                                                 "\"/>\n</Relationships>\n"},
                             {"3D/3dmodel.model", model_text(mesh, header)}});
}

constinit const MeshFormat kThreeMf = {.key = "3mf",
                                       .name = "3MF",
                                       .extension = ".3mf",
                                       .coordinates = Coordinates::binary32,
                                       .read = read_3mf,
                                       .write = three_mf_bytes,
                                       .recognises = recognise,
                                       .unit = unit_of_3mf};

}  // namespace dupin
