#include "dupin/io/report_json.h"

#include "dupin/kernel/parallel.h"
#include "json/json_value.h"

namespace dupin {

bool is_measured(const Report& report) {
  return report.count(Defect::non_finite_point) == 0 &&
         report.count(Defect::point_out_of_range) == 0;
}

bool has_volume(const Report& report) { return report.closed() && is_measured(report); }

namespace json {
namespace {

using json::json_value;  // not hidden by the ones below

Json json_value(const Finding& finding) {
  return {{"defect", name(finding.defect)},
          {"faces", finding.faces},
          {"points", finding.points},
          {"place", json_value(finding.place)}};
}

Json json_shells(const Report& report) {
  return json_list(report.shells, [&](const ShellReport& shell) -> Json {
    return {{"first_face", shell.first_face},
            {"triangles", shell.triangles},
            {"volume", has_volume(report) ? Json(shell.volume) : Json(nullptr)},
            {"depth", shell.depth},
            {"euler_number", shell.euler_number}};
  });
}

Json json_places(const std::vector<Vec3>& places) {
  return json_list(places, [](const Vec3& place) { return json_value(place); });
}

Json json_thin_shells(const std::vector<ThinShell>& shells) {
  return json_list(shells, [](const ThinShell& shell) -> Json {
    return {
        {"place", json_value(shell.place)}, {"thickness", shell.thickness}, {"move", shell.move}};
  });
}

Json json_value(const RoundingReport& rounding) {
  return {{"coordinates", rounding.coordinates == Coordinates::binary64 ? "binary64" : "binary32"},
          {"origin", json_value(rounding.origin)},
          {"moved_points", rounding.moved},
          {"largest_move", rounding.largest_move},
          {"repair_reach", rounding.repair_reach},
          {"removed_triangles", rounding.removed_triangles},
          {"removed_shells", rounding.removed_shells},
          {"filled_slits", rounding.filled_places.size()},
          {"filled_places", json_places(rounding.filled_places)},
          {"slit_width", rounding.slit_width},
          {"snapped_places", json_places(rounding.snapped_places)},
          {"thin_shells", json_thin_shells(rounding.thin_shells)}};
}

Json json_value(const Contact& contact) {
  return {{"kind", contact.kind == Contact::Kind::vertex ? "vertex" : "edge"},
          {"from", json_value(contact.from)},
          {"to", json_value(contact.to)},
          {"names", contact.names}};
}

Json json_value(const FileRepair& repair) {
  return {{"file", repair.file},
          {"merged_points", repair.report.merged_points},
          {"degenerate_faces", repair.report.degenerate_faces},
          {"duplicate_faces", repair.report.duplicate_faces},
          {"turned_faces", repair.report.turned_faces},
          {"united_overlaps", repair.report.united_overlaps},
          {"parted_contacts", repair.report.parted_contacts},
          {"cavities", repair.report.cavities}};
}

// A difference that is not zero does not print as zero unless it is below all doubles.
Json json_value(const CrossCheck& check) {
  const bool failed = check.verdict == CrossCheck::Verdict::engine_failed;
  const mpq_class difference = check.volume - check.other_volume;
  return {{"engine", name(check.engine)},
          {"verdict", name(check.verdict)},
          {"volume", check.volume.get_d()},
          {"other_volume", failed ? Json(nullptr) : Json(check.other_volume.get_d())},
          {"volume_difference", failed ? Json(nullptr) : Json(difference.get_d())},
          {"place", check.place ? json::json_value(*check.place) : Json(nullptr)},
          {"failure", failed ? Json(check.failure) : Json(nullptr)}};
}

Json json_value(const StageTime& time) {
  return {{"stage", time.stage}, {"wall", time.wall}, {"processor", time.processor}};
}

template <class Value>
Json list(const std::vector<Value>& values) {
  return json_list(values, [](const Value& value) { return json_value(value); });
}

/// Only the defects that occur.
Json counts_json(const Report& report) {
  Json counts = Json::object();
  for (std::size_t index = 0; index < report.counts.size(); ++index) {
    if (report.counts[index] > 0) {
      counts[std::string(name(static_cast<Defect>(index)))] = report.counts[index];
    }
  }
  return counts;
}

Json json_value(const SolverMeshReport& report) {
  Json poor = Json::array();
  for (const PoorTriangle& triangle : report.surface.worst) {
    poor.push_back({{"place", json_value(triangle.place)},
                    {"angle", triangle.angle},
                    {"between_edges", triangle.is_between_edges}});
  }
  Json object{{"distance", report.asked_distance},
              {"deviation", report.surface.deviation},
              {"angle", report.asked_angle},
              {"smallest_angle", report.surface.smallest_angle},
              {"shortest_edge", report.surface.shortest_edge},
              {"longest_edge", report.surface.longest_edge},
              {"poor_triangles", report.surface.poor_triangles},
              {"poor_between_edges", report.surface.poor_between_edges},
              {"worst", poor}};
  if (report.volume) {
    object["volume"] = {{"points", report.volume->points},
                        {"tetrahedra", report.volume->tetrahedra},
                        {"smallest_dihedral_angle", report.volume->smallest_dihedral_angle}};
  }
  return object;
}

}  // namespace

Json json_value(const PlacementReport& placement) {
  return {{"exact", placement.is_exact}, {"largest_move", placement.largest_move}};
}

Json json_value(const Vec3& point) { return {point.x(), point.y(), point.z()}; }

Json json_value(const Report& report) {
  return {{"points", report.points},
          {"triangles", report.triangles},
          {"solid", report.is_solid()},
          {"watertight", report.closed()},
          {"components", report.components},
          {"euler_number", report.euler_number},
          {"genus", report.closed() ? Json(report.genus) : Json(nullptr)},
          {"volume", has_volume(report) ? Json(report.volume) : Json(nullptr)},
          {"area", is_measured(report) ? Json(report.area) : Json(nullptr)},
          {"counts", counts_json(report)},
          {"findings", list(report.findings)},
          {"shells", json_shells(report)}};
}

Json json_value(const OutputReport& report) {
  Json object{{"file", report.file},
              {"format", report.format},
              {"rounding", json_value(report.rounding)},
              {"contacts", list(report.contacts)},
              {"verified", report.verification != Verification::none},
              {"verification", name(report.verification)}};
  if (report.check) {
    object["check"] = json_value(*report.check);
  }
  if (report.simplification) {
    object["simplification"] = {{"removed_triangles", report.simplification->removed_triangles},
                                {"deviation", report.simplification->deviation}};
  }
  if (report.solver_mesh) {
    object["solver_mesh"] = json_value(*report.solver_mesh);
  }
  if (report.settled) {
    object["settled"] = {{"policy", report.settled->policy},
                         {"length", report.settled->length},
                         {"contacts", list(report.settled->contacts)}};
  }
  if (!report.repairs.empty()) {
    object["repairs"] = list(report.repairs);
  }
  if (report.placement) {
    object["placement"] = json_value(*report.placement);
  }
  if (report.cross_check) {
    object["cross_check"] = json_value(*report.cross_check);
  }
  if (!report.timing.empty()) {
    object["timing"] = list(report.timing);
  }
  return object;
}

std::string line_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace json

std::string string_json(std::string_view text) { return json::line_text(text); }

std::string_view name(Verification verification) {
  switch (verification) {
    case Verification::none:
      return "none";
    case Verification::compare:
      return "compare";
    case Verification::full:
      return "full";
  }
  return "unknown";
}

Eigen::AlignedBox3d bounding_box(const TriMesh& mesh) {
  const UsualArithmetic usual;
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.points) {
    box.extend(point);
  }
  return box;
}

std::string to_json(const Report& report) {
  const UsualArithmetic usual;
  return json::text(json::json_value(report));
}

std::string to_json(const OutputReport& report) {
  const UsualArithmetic usual;
  return json::text(json::json_value(report));
}

std::string to_json(const PlacedDocumentReport& report) {
  const UsualArithmetic usual;
  return json::text({{"file", report.file},
                     {"unit", symbol(report.unit)},
                     {"placement", json::json_value(report.placement)}});
}

std::string to_json(const MeshSummary& summary) {
  const UsualArithmetic usual;
  json::Json object{{"file", summary.file}, {"kind", "mesh"}};
  if (!summary.unit.empty()) {
    object["unit"] = summary.unit;
  }
  object["names"] = summary.mesh.names;
  if (const auto box = bounding_box(summary.mesh); !box.isEmpty()) {
    object["box"] = {json::json_value(Vec3(box.min())), json::json_value(Vec3(box.max()))};
  }
  object["check"] = json::json_value(summary.check);
  if (summary.check.is_solid()) {
    object["check"]["solid"] = nullptr;  // self-intersections were not searched for
  }
  return json::text(object);
}

std::string error_json(const Error& error, std::string_view kind, int exit_code) {
  return json::text({{"error",
                      {{"code", kind},
                       {"exit", exit_code},
                       {"message", error.message()},
                       {"part", error.part()},
                       {"where", error.where()}}}});
}

}  // namespace dupin
