#include <cmath>
#include <limits>
#include <numbers>

#include "dupin/io/assembly_json.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "dupin/kernel/printable.h"
#include "json/json_value.h"

namespace dupin {
namespace {

using json::Json;

Json vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// The degrees that are read back as this angle, bit by bit, where there are any.
double degrees(double radians) {
  const double nearest = radians / std::numbers::pi * 180;
  const auto reads_back = [&](double value) { return value / 180 * std::numbers::pi == radians; };
  double up = nearest, down = nearest;
  for (int step = 0; step < 4; ++step) {
    if (reads_back(up)) {
      return up;
    }
    if (reads_back(down)) {
      return down;
    }
    up = std::nextafter(up, std::numeric_limits<double>::infinity());
    down = std::nextafter(down, -std::numeric_limits<double>::infinity());
  }
  return nearest;
}

void put_section(Json& json, double radius, const std::optional<SectionAxes>& axes) {
  if (axes) {
    json["semi_axes"] = {radius, axes->across};
    json["axis"] = vector(axes->axis);
  } else {
    json["radius"] = radius;
  }
}

// "from" and, where it is no port, the direction and, if the part has one, the section.
Json begun(const PartStart& start, bool has_section = true) {
  Json json = Json::object();
  if (const auto* port = std::get_if<PortReference>(&start)) {
    json["from"] = to_string(*port);
    return json;
  }
  const auto& place = std::get<Place>(start);
  json["from"] = vector(place.point);
  json["direction"] = vector(place.direction);
  if (has_section) {
    put_section(json, place.radius, place.axes);
  }
  return json;
}

Json between(const PortReference& from, const PortReference& to) {
  return {{"from", to_string(from)}, {"to", to_string(to)}};
}

void put_cone_sections(Json& json, double start_radius, const std::optional<SectionAxes>& axes,
                       double end_radius, const std::optional<double>& end_across) {
  if (axes) {
    const Json start = {start_radius, axes->across},
               end = {end_radius, end_across.value_or(end_radius)};
    json["semi_axes"] = Json::array({start, end});
    json["axis"] = vector(axes->axis);
  } else {
    json["radii"] = {start_radius, end_radius};
  }
}

Json number_or_auto(const std::optional<double>& value) {
  return value ? Json(*value) : Json("auto");
}

Json written(const PipeBetween& pipe) {
  Json json = {{"from", vector(pipe.from)}, {"to", vector(pipe.to)}};
  put_section(json, pipe.radius, pipe.axes);
  return json;
}

Json written(const PipeAlong& pipe) {
  Json json = begun(pipe.from);
  json["length"] = pipe.length;
  return json;
}

Json written(const PipeTo& pipe) {
  return {{"from", to_string(pipe.from)}, {"to", vector(pipe.to)}};
}

Json written(const ConeBetween& cone) {
  Json json = {{"from", vector(cone.from)}, {"to", vector(cone.to)}};
  put_cone_sections(json, cone.start_radius, cone.start_axes, cone.end_radius, cone.end_across);
  return json;
}

Json written(const ConeAlong& cone) {
  Json json = begun(cone.from, false);
  json["length"] = cone.length;
  if (const auto* place = std::get_if<Place>(&cone.from)) {
    put_cone_sections(json, place->radius, place->axes, cone.end_radius, cone.end_across);
  } else if (cone.end_across) {
    json["end_semi_axes"] = {cone.end_radius, *cone.end_across};
    if (cone.axis) {
      json["axis"] = vector(*cone.axis);
    }
  } else {
    json["end_radius"] = cone.end_radius;
  }
  return json;
}

Json written(const ObliqueBetween& part) {
  return {{"from", vector(part.from)},
          {"to", vector(part.to)},
          {"normal", vector(part.normal)},
          {"radii", {part.start_radius, part.end_radius}}};
}

Json written(const ObliqueTo& part) {
  return {{"from", to_string(part.from)}, {"to", vector(part.to)}, {"end_radius", part.end_radius}};
}

Json written(const ElbowTurning& elbow) {
  Json json = begun(elbow.from);
  json["bend_radius"] = elbow.bend_radius;
  json["angle"] = degrees(elbow.angle);
  json["toward"] = vector(elbow.toward);
  return json;
}

Json written(const ElbowTo& elbow) {
  Json json = begun(elbow.from);
  json["to"] = vector(elbow.to);
  return json;
}

Json written(const ElbowCorner& elbow) {
  Json json = begun(elbow.from);
  json.erase("direction");  // the corner says it
  json["corner"] = vector(elbow.corner);
  json["to"] = vector(elbow.to);
  return json;
}

Json written(const SphereAt& sphere) {
  return {{"center", vector(sphere.center)}, {"radius", sphere.radius}};
}

Json waypoints(const std::vector<Waypoint>& through) {
  Json json = Json::array();
  for (const Waypoint& waypoint : through) {
    json.push_back({{"point", vector(waypoint.point)}, {"radius", waypoint.radius}});
  }
  return json;
}

Json obstacle(const Obstacle& solid) {
  if (solid.edges.empty()) {
    return {{"ball", {{"center", vector(solid.corner)}, {"radius", solid.radius}}}};
  }
  if (solid.edges.size() == 1) {
    return {{"capsule",
             {{"from", vector(solid.corner)},
              {"to", vector(solid.corner + solid.edges[0])},
              {"radius", solid.radius}}}};
  }
  Json neighbours = Json::array();
  for (const Vec3& edge : solid.edges) {
    neighbours.push_back({{"point", vector(solid.corner + edge)}});
  }
  return {{"box", {{"corner", vector(solid.corner)}, {"neighbours", neighbours}}}};
}

Json obstacle(const std::string& part) { return {{"part", part}}; }

Json obstacle(const MeshObstacle& mesh) { return {{"mesh", mesh.file}}; }

void put_avoidance(Json& json, const std::optional<Avoidance>& avoid) {
  if (!avoid) {
    return;
  }
  json["avoid"] = Json::array();
  for (const auto& one : avoid->obstacles) {
    json["avoid"].push_back(std::visit([](const auto& shape) { return obstacle(shape); }, one));
  }
  json["clearance"] = avoid->clearance;
}

Json written(const SplineBetween& spline) {
  Json json = between(spline.from, spline.to);
  json["through"] = waypoints(spline.through);
  put_avoidance(json, spline.avoid);
  return json;
}

Json written(const SplineRound& spline) {
  return {{"through", waypoints(spline.through)}, {"closed", true}};
}

Json written(const CyclicBlendBetween& blend) {
  Json json = between(blend.from, blend.to);
  json["radius_law"] = blend.options.radius_law == BlendLaw::r1 ? "R1" : "R2";
  json["k"] = number_or_auto(blend.options.k);
  json["l"] = number_or_auto(blend.options.l);
  if (blend.options.continuity == Continuity::g2) {
    json["continuity"] = "G2";
  }
  put_avoidance(json, blend.avoid);
  return json;
}

Json written(const TwoConeBlendBetween& blend) {
  Json json = between(blend.from, blend.to);
  json["reach"] = blend.reach;
  json["m"] = blend.m;
  json["w"] = blend.w;
  return json;
}

void put_contact(Json& json, const CanalContact& contact) { json["slope"] = contact.slope; }
void put_contact(Json& json, const SphereContact& contact) {
  json["sphere"] = vector(contact.center);
}
void put_contact(Json& json, const ObliqueConeContact& contact) {
  json["apex"] = vector(contact.apex);
}
void put_contact(Json& json, const ObliqueCylinderContact& contact) {
  json["ruling"] = vector(contact.ruling);
}
void put_contact(Json& json, const PlateContact& contact) {
  json["plate"] = contact.widening ? "widening" : "narrowing";
}

Json ringed_end(const RingedBlendEnd& end) {
  if (const auto* port = std::get_if<PortReference>(&end)) {
    return to_string(*port);
  }
  const auto& free = std::get<FreeEnd>(end);
  Json json = {{"center", vector(free.center)},
               {"direction", vector(free.direction)},
               {"radius", free.radius}};
  std::visit([&](const auto& contact) { put_contact(json, contact); }, free.contact);
  return json;
}

Json written(const RingedBlendBetween& blend) {
  Json json = {{"from", ringed_end(blend.from)},
               {"to", ringed_end(blend.to)},
               {"k", number_or_auto(blend.k)},
               {"l", number_or_auto(blend.l)}};
  if (blend.low_degree) {
    json["bidegree"] = {5, 2};
  }
  put_avoidance(json, blend.avoid);
  return json;
}

Json written(const CyclideBlendBetween& blend) { return between(blend.from, blend.to); }

Json pe_vector(const PeVector& vector) {
  return {vector.m.x(), vector.m.y(), vector.m.z(), vector.r};
}

Json written(const CyclideChainThrough& chain) {
  Json json = Json::object();
  if (const auto* port = std::get_if<PortReference>(&chain.from)) {
    json["from"] = to_string(*port);
  } else if (const auto* direction = std::get_if<ChainDirection>(&chain.from)) {
    json["direction"] = vector(direction->axis);
    json["slope"] = direction->slope;
  }
  json["spheres"] = Json::array();
  for (const PeVector& sphere : chain.spheres) {
    json["spheres"].push_back(pe_vector(sphere));
  }
  for (const PinnedTangent& pin : chain.tangents) {
    json["tangents"].push_back({{"sphere", pin.sphere}, {"tangent", pe_vector(pin.tangent)}});
  }
  if (chain.wall > 0) {
    json["wall"] = chain.wall;
  }
  if (chain.joints == ChainJoints::kneecaps) {
    json["joints"] = "kneecaps";
  }
  return json;
}

Json written(const FilletBetween& fillet) {
  return {{"between", fillet.between}, {"radius", fillet.radius}};
}

Json written(const CopeOfEnd& cope) { return {{"end", to_string(cope.end)}, {"to", cope.to}}; }

Json written(const JunctionOfPorts& junction) {
  Json json = {{"ends", Json::array()}};
  for (const PortReference& end : junction.ends) {
    json["ends"].push_back(to_string(end));
  }
  if (junction.options.center) {
    json["center"] = vector(*junction.options.center);
  }
  if (junction.options.radius) {
    json["radius"] = *junction.options.radius;
  }
  if (junction.options.smoothness > 0) {
    json["smoothness"] = junction.options.smoothness;
  }
  for (const double angle : junction.options.cap_angles) {
    json["cap_angles"].push_back(degrees(angle));
  }
  return json;
}

Json written(const PipeOn& pipe) {
  return {{"on", pipe.run},
          {"at", pipe.at},
          {"direction", vector(pipe.direction)},
          {"length", pipe.length},
          {"radius", pipe.radius}};
}

Json written(const FlangeAt& flange) {
  return {{"center", vector(flange.center)},
          {"normal", vector(flange.normal)},
          {"radius", flange.radius},
          {"thickness", flange.thickness}};
}

Json written(const FlangeOfEnd& flange) {
  return {{"at", to_string(flange.at)}, {"radius", flange.radius}, {"thickness", flange.thickness}};
}

Json written(const FlangeOn& flange) {
  return {{"on", flange.run},
          {"at", flange.at},
          {"radius", flange.radius},
          {"thickness", flange.thickness}};
}

Json written(const EllipsoidalHead& head) {
  Json json = begun(head.from);
  json["form"] = "ellipsoidal";
  if (head.depth) {
    json["depth"] = *head.depth;
  }
  return json;
}

Json written(const TorisphericalHead& head) {
  Json json = begun(head.from);
  if (head.form != HeadForm::free) {
    json["form"] = head.form == HeadForm::kloepper ? "kloepper" : "korbbogen";
    return json;
  }
  json["form"] = "torispherical";
  json["crown"] = head.crown;
  json["knuckle"] = head.knuckle;
  return json;
}

Json written(const CapAt& cap) { return {{"at", to_string(cap.at)}}; }

Json written(const Part& part, WallSide usual) {
  Json json = {{"name", part.name}};
  json[std::string(kind(part.shape))] =
      std::visit([](const auto& shape) { return written(shape); }, part.shape);
  if (part.wall) {
    json["wall"] = *part.wall;
  }
  if (part.wall_side && *part.wall_side != usual) {
    json["wall_side"] = name(*part.wall_side);
  }
  if (part.insulation) {
    json["insulation"] = *part.insulation;
  }
  if (part.solid) {
    json["solid"] = true;
  }
  if (!part.component.name.empty()) {
    json["component"] = {{"name", part.component.name}, {"kind", part.component.kind}};
    if (part.component.line > 0) {
      json["component"]["line"] = part.component.line;
    }
  }
  return json;
}

/// What of a value JSON has no text for, and where: it would become null, or another name.
struct Unwritable {
  std::string pointer, reason;
};

std::optional<Unwritable> unwritable_text(const Json& value) {
  try {
    (void)value.dump();
    return std::nullopt;
  } catch (const Json::type_error&) {
    return Unwritable{
        {}, "'" + printable(value.get<std::string>()) + "' is no UTF-8, as texts of JSON are"};
  }
}

std::optional<Unwritable> unwritable(const Json& value) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    return Unwritable{{}, "numbers must be finite, not " + decimal(value.get<double>())};
  }
  if (value.is_string()) {
    return unwritable_text(value);
  }
  if (!value.is_structured()) {
    return std::nullopt;
  }
  std::size_t index = 0;
  for (auto element = value.begin(); element != value.end(); ++element, ++index) {
    auto found = value.is_object() ? unwritable_text(element.key()) : std::nullopt;
    found = found ? found : unwritable(*element);
    if (found) {
      found->pointer.insert(
          0, "/" + (value.is_object() ? printable(element.key()) : std::to_string(index)));
      return found;
    }
  }
  return std::nullopt;
}

void require_writable(const Json& value, const std::string& part, const std::string& place,
                      bool has_keys) {
  if (const auto found = unwritable(value)) {
    throw Error(Errc::invalid_argument, found->reason, printable(part),
                place + (has_keys ? found->pointer : ""));
  }
}

}  // namespace

std::string document_text(const Assembly& assembly) {
  const UsualArithmetic usual;
  Json head = {{"units", symbol(assembly.unit)}, {"tolerance", assembly.tolerance}};
  if (assembly.segments) {
    head["segments"] = *assembly.segments;
  }
  if (assembly.wall) {
    head["wall"] = *assembly.wall;
  }
  if (assembly.wall_side != WallSide::inwards) {
    head["wall_side"] = name(assembly.wall_side);
  }
  if (assembly.insulation) {
    head["insulation"] = *assembly.insulation;
  }
  if (!assembly.patches.empty()) {
    head["patches"] = assembly.patches;
  }
  require_writable(head, {}, document_place(assembly, std::string_view()), !assembly.is_of_network);
  std::string text = "{\n";
  for (const auto& [key, value] : head.items()) {
    text += " \"" + key + "\": " + json::text(value) + ",\n";
  }
  text += " \"parts\": [";
  std::string_view separator = "\n";
  for (std::uint32_t i = 0; i < assembly.parts.size(); ++i) {
    const Json part = written(assembly.parts[i], assembly.wall_side);
    require_writable(part, assembly.parts[i].name, document_place(assembly, i),
                     !assembly.is_of_network);
    text += std::string(separator) + "  " + json::line_text(part);
    separator = ",\n";
  }
  return text + "\n ]\n}\n";
}

}  // namespace dupin
