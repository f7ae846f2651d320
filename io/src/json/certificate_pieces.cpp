#include "json/certificate_pieces.h"

#include <algorithm>
#include <numbers>
#include <string_view>

#include "dupin/blends/certificate.h"
#include "json/json_lists.h"
#include "json/json_value.h"
#include "json/parts/part_values.h"

namespace dupin::json {
namespace {

// A kind is a row of kReaders, with the function that reads it, and a visitor of PieceForm.
constexpr const char *kRinged = "ringed_surface", *kElliptic = "elliptic_tube",
                     *kCyclide = "cyclide", *kRational = "rational_ringed_surface";

Json json_value(const std::vector<Vec3>& points) {
  Json list = Json::array();
  for (const Vec3& point : points) {
    list.push_back(json::json_value(point));
  }
  return list;
}

struct SpineForm {
  Json operator()(const LineSpine& s) const {
    return {{"line", {{"from", json::json_value(s.from)}, {"to", json::json_value(s.to)}}}};
  }
  Json operator()(const ArcSpine& s) const {
    return {{"arc",
             {{"center", json::json_value(s.center)},
              {"axis", json::json_value(s.axis)},
              {"start", json::json_value(s.start)},
              {"angle", s.angle}}}};
  }
  Json operator()(const HermiteSpine& s) const {
    return {{"hermite",
             {{"from", json::json_value(s.from)},
              {"to", json::json_value(s.to)},
              {"start_velocity", json::json_value(s.start_velocity)},
              {"end_velocity", json::json_value(s.end_velocity)}}}};
  }
  Json operator()(const BezierSpine& s) const {
    return {{"bezier", {{"points", json_value(s.points)}, {"weights", s.weights}}}};
  }
};

struct RadiusForm {
  static Json law(const char* name, const std::vector<double>& numbers) {
    Json object = Json::object();
    object[name] = numbers;
    return object;
  }
  Json operator()(const ConstantRadius& r) const { return law("constant", {r.radius}); }
  Json operator()(const LinearRadius& r) const { return law("linear", {r.start, r.end}); }
  Json operator()(const CubicRadius& r) const { return law("cubic", {r.start, r.end}); }
  Json operator()(const CyclideRadius& r) const { return law("cyclide", {r.start, r.end}); }
  Json operator()(const BezierRadius& r) const { return law("bezier", r.coefficients); }
};

struct PieceForm {
  static Json named(const char* kind, const Ring& start, const Ring& end, const Json& more) {
    Json numbers{{"start", ring_value(start)}, {"end", ring_value(end)}};
    numbers.update(more);
    Json object = Json::object();
    object[kind] = numbers;
    return object;
  }
  Json operator()(const RingedSurface& s) const {
    return named(kRinged, s.start, s.end,
                 {{"spine", std::visit(SpineForm{}, s.spine)},
                  {"radius", std::visit(RadiusForm{}, s.radius)}});
  }
  Json operator()(const EllipticTube& s) const {
    return named(kElliptic, s.start, s.end,
                 {{"spine", std::visit(SpineForm{}, s.spine)},
                  {"first", std::visit(RadiusForm{}, s.first)},
                  {"second", std::visit(RadiusForm{}, s.second)},
                  {"turn", s.turn},
                  {"continuity", name(s.continuity)}});
  }
  Json operator()(const CyclidePiece& s) const {
    return named(kCyclide, s.start, s.end,
                 {{"first", sphere_value(s.first)},
                  {"tangent", sphere_value(s.tangent)},
                  {"last", sphere_value(s.last)},
                  {"chord", s.chord}});
  }
  Json operator()(const RationalRingedTube& s) const {
    Json points = Json::array();
    for (const Vec3& point : s.surface.center) {
      points.push_back(json::json_value(point));
    }
    return named(
        kRational, s.start, s.end,
        {{"center", points}, {"radius", s.surface.radius}, {"rotation", s.surface.rotation}});
  }
};

// Refused before any of it is computed with.
template <class Values>
Values no_more_than_limit(const JsonNode& node, Values values) {
  if (values.size() > CertificateLimits::kCoefficients) {
    node.fail("must hold at most " + std::to_string(CertificateLimits::kCoefficients) +
              " coefficients");
  }
  return values;
}

Spine spine(const JsonNode& node) {
  if (node.has("line")) {
    const JsonNode s = node.at("line");
    return LineSpine{vec3(s.at("from")), vec3(s.at("to"))};
  }
  if (node.has("arc")) {
    const JsonNode s = node.at("arc");
    const double angle = s.at("angle").number();
    if (!(angle > 0 && angle <= 2 * std::numbers::pi)) {
      s.at("angle").fail("an arc turns by more than 0 and at most 2 pi");
    }
    return ArcSpine{vec3(s.at("center")), vec3(s.at("axis")), vec3(s.at("start")), angle};
  }
  if (node.has("hermite")) {
    const JsonNode s = node.at("hermite");
    return HermiteSpine{vec3(s.at("from")), vec3(s.at("to")), vec3(s.at("start_velocity")),
                        vec3(s.at("end_velocity"))};
  }
  const JsonNode s = node.at("bezier");
  return BezierSpine{no_more_than_limit(s.at("points"), list<Vec3>(s.at("points"), vec3)),
                     no_more_than_limit(s.at("weights"), numbers(s.at("weights")))};
}

RadiusLaw radius(const JsonNode& node) {
  if (node.has("constant")) {
    return ConstantRadius{numbers<1>(node.at("constant"))[0]};
  }
  const auto ends = [&](std::string_view key) { return numbers<2>(node.at(key)); };
  if (node.has("linear")) {
    return LinearRadius{ends("linear")[0], ends("linear")[1]};
  }
  if (node.has("cubic")) {
    return CubicRadius{ends("cubic")[0], ends("cubic")[1]};
  }
  if (node.has("cyclide")) {
    return CyclideRadius{ends("cyclide")[0], ends("cyclide")[1]};
  }
  return BezierRadius{no_more_than_limit(node.at("bezier"), numbers(node.at("bezier")))};
}

RationalRingedTube read_rational(const JsonNode& node) {
  RationalRingedTube result{
      certificate_ring(node.at("start")), certificate_ring(node.at("end")), {}};
  const auto points = list<Vec3>(node.at("center"), vec3);
  if (points.size() != result.surface.center.size()) {
    node.at("center").fail("must hold 4 points");
  }
  std::copy(points.begin(), points.end(), result.surface.center.begin());
  result.surface.radius = numbers<4>(node.at("radius"));
  result.surface.rotation = list<std::array<double, 4>>(
      node.at("rotation"), [](const JsonNode& control) { return numbers<4>(control); });
  result.surface.rotation = no_more_than_limit(node.at("rotation"), result.surface.rotation);
  if (result.surface.rotation.size() < 2) {
    node.at("rotation").fail("must hold 2 quaternions at least");
  }
  return result;
}

CyclidePiece read_cyclide(const JsonNode& node) {
  if (!(node.at("chord").number() > 0)) {
    node.at("chord").fail("must be positive");
  }
  return {certificate_ring(node.at("start")),   certificate_ring(node.at("end")),
          certificate_sphere(node.at("first")), certificate_sphere(node.at("tangent")),
          certificate_sphere(node.at("last")),  node.at("chord").number()};
}

EllipticTube read_elliptic(const JsonNode& node) {
  EllipticTube result{certificate_ring(node.at("start")), certificate_ring(node.at("end")),
                      spine(node.at("spine")), radius(node.at("first")), radius(node.at("second"))};
  result.turn = node.at("turn").number();
  result.continuity = continuity(node.at("continuity"));
  return result;
}

RingedSurface read_ringed(const JsonNode& node) {
  return {certificate_ring(node.at("start")), certificate_ring(node.at("end")),
          spine(node.at("spine")), radius(node.at("radius"))};
}

template <class Kind, Kind (*read)(const JsonNode&)>
Piece piece_of(const JsonNode& node) {
  return read(node);
}

struct Reader {
  std::string_view key;
  Piece (*read)(const JsonNode&);
};

constexpr Reader kReaders[] = {{kRational, piece_of<RationalRingedTube, read_rational>},
                               {kCyclide, piece_of<CyclidePiece, read_cyclide>},
                               {kElliptic, piece_of<EllipticTube, read_elliptic>},
                               {kRinged, piece_of<RingedSurface, read_ringed>}};

}  // namespace

Json ring_value(const Ring& ring) {
  Json object{{"center", json::json_value(ring.center)},
              {"normal", json::json_value(ring.normal)},
              {"radius", ring.radius},
              {"slope", ring.slope}};
  if (ring.ellipse) {
    object["ellipse"] = {{"axis", json::json_value(ring.ellipse->axis)},
                         {"across", ring.ellipse->across},
                         {"across_slope", ring.ellipse->across_slope}};
  }
  return object;
}

Ring certificate_ring(const JsonNode& node) {
  Ring result{vec3(node.at("center")), vec3(node.at("normal")), node.at("radius").number(),
              node.at("slope").number()};
  if (node.has("ellipse")) {
    const JsonNode e = node.at("ellipse");
    result.ellipse =
        Ellipse{vec3(e.at("axis")), e.at("across").number(), e.at("across_slope").number()};
  }
  return result;
}

Json sphere_value(const PeVector& sphere) {
  return {sphere.m.x(), sphere.m.y(), sphere.m.z(), sphere.r};
}

PeVector certificate_sphere(const JsonNode& node) {
  const auto [x, y, z, r] = numbers<4>(node);
  return {Vec3(x, y, z), r};
}

Json json_value(const Piece& piece) { return std::visit(PieceForm{}, piece); }

// Without any of the keys, the last one is missed.
Piece certificate_piece(const JsonNode& node) {
  const auto* reader =
      std::find_if(std::begin(kReaders), std::end(kReaders) - 1,
                   [&](const Reader& candidate) { return node.has(candidate.key); });
  return reader->read(node.at(reader->key));
}

}  // namespace dupin::json
