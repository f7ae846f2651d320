#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "json/certificate_seal.h"
#include "json/json_value.h"

namespace dupin {
namespace {

using json::Json;
using json::json_value;

Json json_value(const ParameterInterval& t) { return {t.from, t.to}; }

Json json_value(const std::vector<Vec3>& points) {
  Json list = Json::array();
  for (const Vec3& point : points) {
    list.push_back(json::json_value(point));
  }
  return list;
}

Json json_value(const Ring& ring) {
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

Json json_value(const PeVector& sphere) {
  return {sphere.m.x(), sphere.m.y(), sphere.m.z(), sphere.r};
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
    Json numbers{{"start", json_value(start)}, {"end", json_value(end)}};
    numbers.update(more);
    Json object = Json::object();
    object[kind] = numbers;
    return object;
  }
  Json operator()(const RingedSurface& s) const {
    return named("ringed_surface", s.start, s.end,
                 {{"spine", std::visit(SpineForm{}, s.spine)},
                  {"radius", std::visit(RadiusForm{}, s.radius)}});
  }
  Json operator()(const EllipticTube& s) const {
    return named("elliptic_tube", s.start, s.end,
                 {{"spine", std::visit(SpineForm{}, s.spine)},
                  {"first", std::visit(RadiusForm{}, s.first)},
                  {"second", std::visit(RadiusForm{}, s.second)}});
  }
  Json operator()(const CyclidePiece& s) const {
    return named("cyclide", s.start, s.end,
                 {{"first", json_value(s.first)},
                  {"tangent", json_value(s.tangent)},
                  {"last", json_value(s.last)},
                  {"chord", s.chord}});
  }
  Json operator()(const RationalRingedTube& s) const {
    Json points = Json::array();
    for (const Vec3& point : s.surface.center) {
      points.push_back(json::json_value(point));
    }
    return named(
        "rational_ringed_surface", s.start, s.end,
        {{"center", points}, {"radius", s.surface.radius}, {"rotation", s.surface.rotation}});
  }
};

struct ShapeForm {
  Json operator()(const OtherShape&) const { return {{"other_shape", Json::object()}}; }
  Json operator()(const Sphere& s) const {
    return {{"sphere", {{"center", json::json_value(s.center)}, {"radius", s.radius}}}};
  }
  Json operator()(const PieceChain& s) const {
    Json pieces = Json::array();
    for (const CertifiedPiece& piece : s.pieces) {
      pieces.push_back(std::visit(PieceForm{}, piece));
    }
    return {{"pieces", pieces}, {"closed", s.closed}, {"wall", s.wall}};
  }
};

Json json_value(const CertifiedPart& part) {
  Json ends = Json::array();
  for (const auto& end : part.joined) {
    ends.push_back(end ? Json({end->part, name(end->end)}) : Json(nullptr));
  }
  Json object{{"name", part.name}, {"kind", part.kind}, {"joined", ends}};
  object.update(std::visit(ShapeForm{}, part.shape));
  return object;
}

Json json_value(const std::vector<DiscPairs>& leaves) {
  Json list = Json::array();
  for (const DiscPairs& leaf : leaves) {
    Json numbers{leaf.first.from, leaf.first.to, leaf.second.from, leaf.second.to};
    if (leaf.direction) {
      for (const double x : *leaf.direction) {
        numbers.push_back(x);
      }
    }
    list.push_back(numbers);
  }
  return list;
}

Json json_value(const std::optional<Overlap>& overlap) {
  return overlap ? Json{{"point", json::json_value(overlap->point)},
                        {"first", json_value(overlap->first)},
                        {"second", json_value(overlap->second)}}
                 : Json(nullptr);
}

Json json_value(const RegularClaim& claim) {
  Json leaves = Json::array();
  for (const ParameterInterval& leaf : claim.leaves) {
    leaves.push_back(json_value(leaf));
  }
  return {{"verdict", name(claim.verdict)},
          {"margin", claim.margin},
          {"leaves", leaves},
          {"where", json_value(claim.where)}};
}

Json json_value(const EmbeddedClaim& claim) {
  return {{"verdict", name(claim.verdict)},
          {"leaves", json_value(claim.leaves)},
          {"overlap", json_value(claim.overlap)}};
}

Json json_value(const PartClaims& claims) {
  Json object = Json::object();
  if (claims.regular) {
    object["regular"] = json_value(*claims.regular);
  }
  if (claims.embedded) {
    object["embedded"] = json_value(*claims.embedded);
  }
  object["tangency"] = Json::array();
  for (const TangencyClaim& claim : claims.tangency) {
    object["tangency"].push_back(
        {{"deviation", claim.deviation ? Json(*claim.deviation) : Json()},
         {"axis_angle", claim.axis_angle},
         {"offset", claim.offset},
         {"curvature", claim.curvature ? Json(*claim.curvature) : Json()}});
  }
  if (claims.mesh) {
    object["mesh"] = {{"segments", claims.mesh->segments},
                      {"grid", claims.mesh->grid},
                      {"knots", claims.mesh->knots},
                      {"error_bound", claims.mesh->error_bound}};
  }
  return object;
}

Json json_value(const ClearanceClaim& claim) {
  return {{"parts", {claim.first, claim.second}},
          {"verdict", name(claim.verdict)},
          {"distance", claim.distance},
          {"leaves", json_value(claim.leaves)},
          {"overlap", json_value(claim.overlap)}};
}

// One line per element.
template <class Element>
std::string lines(const std::vector<Element>& elements) {
  std::string text = "[";
  for (const Element& element : elements) {
    text += (text.size() > 1 ? ",\n    " : "\n    ") +
            json_value(element).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text + (text.size() > 1 ? "\n  ]" : "]");
}

std::string json_text(std::string_view words) {
  return Json(words).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string json::inputs_text(const Certificate& certificate) {
  return "  \"units\": " + json_text(symbol(certificate.unit)) +
         ",\n  \"tolerance\": " + Json(certificate.tolerance).dump() +
         ",\n  \"parts\": " + lines(certificate.parts);
}

std::string certificate_json(const Certificate& certificate) {
  const std::string inputs = json::inputs_text(certificate);
  return json::sealed("{\n  \"format\": " + json_text(json::kCertificateFormat) +
                      ",\n  \"document\": " + json_text(certificate.document) +
                      ",\n  \"document_sha256\": " + json_text(certificate.document_sha256) +
                      ",\n" + inputs + ",\n  \"inputs_sha256\": " + json_text(sha256(inputs)) +
                      ",\n  \"claims\": " + lines(certificate.claims) +
                      ",\n  \"clearances\": " + lines(certificate.clearances) + ",\n");
}

std::string certificate_summary_json(const Certificate& certificate) {
  Json parts = Json::array();
  for (std::size_t i = 0; i < certificate.parts.size(); ++i) {
    const PartClaims& claims = certificate.claims[i];
    Json part{{"name", certificate.parts[i].name}, {"kind", certificate.parts[i].kind}};
    if (claims.regular && claims.embedded) {
      part["regular"] = name(claims.regular->verdict);
      part["margin"] = claims.regular->margin;
      part["embedded"] = name(claims.embedded->verdict);
    }
    part["error_bound"] = claims.mesh ? Json(claims.mesh->error_bound) : Json(nullptr);
    parts.push_back(part);
  }
  Json clearances = Json::array();
  for (const ClearanceClaim& claim : certificate.clearances) {
    clearances.push_back(
        {{"parts", {certificate.parts[claim.first].name, certificate.parts[claim.second].name}},
         {"verdict", name(claim.verdict)},
         {"joined", certificate.joined(claim)},
         {"overlap", claim.overlap.has_value()},
         {"distance", claim.distance}});
  }
  return json::text({{"document", certificate.document},
                     {"unit", symbol(certificate.unit)},
                     {"findings", certificate.findings()},
                     {"parts", parts},
                     {"clearances", clearances}});
}

}  // namespace dupin
