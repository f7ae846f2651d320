#include "certificate_seal.h"
#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "json_forms.h"

namespace dupin {
namespace {

using json_forms::form;
using json_forms::Json;

Json form(const ParameterInterval& t) { return {t.from, t.to}; }

Json form(const std::vector<Vec3>& points) {
  Json list = Json::array();
  for (const Vec3& point : points) {
    list.push_back(form(point));
  }
  return list;
}

Json form(const Ring& ring) {
  Json object{{"center", form(ring.center)},
              {"normal", form(ring.normal)},
              {"radius", ring.radius},
              {"slope", ring.slope}};
  if (ring.ellipse) {
    object["ellipse"] = {{"axis", form(ring.ellipse->axis)},
                         {"across", ring.ellipse->across},
                         {"across_slope", ring.ellipse->across_slope}};
  }
  return object;
}

Json form(const PeVector& sphere) { return {sphere.m.x(), sphere.m.y(), sphere.m.z(), sphere.r}; }

struct SpineForm {
  Json operator()(const LineSpine& s) const {
    return {{"line", {{"from", form(s.from)}, {"to", form(s.to)}}}};
  }
  Json operator()(const ArcSpine& s) const {
    return {{"arc",
             {{"center", form(s.center)},
              {"axis", form(s.axis)},
              {"start", form(s.start)},
              {"angle", s.angle}}}};
  }
  Json operator()(const HermiteSpine& s) const {
    return {{"hermite",
             {{"from", form(s.from)},
              {"to", form(s.to)},
              {"start_velocity", form(s.start_velocity)},
              {"end_velocity", form(s.end_velocity)}}}};
  }
  Json operator()(const BezierSpine& s) const {
    return {{"bezier", {{"points", form(s.points)}, {"weights", s.weights}}}};
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
    Json numbers{{"start", form(start)}, {"end", form(end)}};
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
                 {{"first", form(s.first)},
                  {"tangent", form(s.tangent)},
                  {"last", form(s.last)},
                  {"chord", s.chord}});
  }
  Json operator()(const RingedTube& s) const {
    Json points = Json::array();
    for (const Vec3& point : s.surface.center) {
      points.push_back(form(point));
    }
    return named(
        "rational_ringed_surface", s.start, s.end,
        {{"center", points}, {"radius", s.surface.radius}, {"rotation", s.surface.rotation}});
  }
};

struct ShapeForm {
  Json operator()(const OtherShape&) const { return {{"other_shape", Json::object()}}; }
  Json operator()(const Sphere& s) const {
    return {{"sphere", {{"center", form(s.center)}, {"radius", s.radius}}}};
  }
  Json operator()(const PieceChain& s) const {
    Json pieces = Json::array();
    for (const CertifiedPiece& piece : s.pieces) {
      pieces.push_back(std::visit(PieceForm{}, piece));
    }
    return {{"pieces", pieces}, {"closed", s.closed}, {"wall", s.wall}};
  }
};

Json form(const CertifiedPart& part) {
  Json ends = Json::array();
  for (const auto& end : part.joined) {
    ends.push_back(end ? Json({end->part, name(end->end)}) : Json(nullptr));
  }
  Json object{{"name", part.name}, {"kind", part.kind}, {"joined", ends}};
  object.update(std::visit(ShapeForm{}, part.shape));
  return object;
}

Json form(const std::vector<DiscPairs>& leaves) {
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

Json form(const std::optional<Overlap>& overlap) {
  return overlap ? Json{{"point", form(overlap->point)},
                        {"first", form(overlap->first)},
                        {"second", form(overlap->second)}}
                 : Json(nullptr);
}

Json form(const RegularClaim& claim) {
  Json leaves = Json::array();
  for (const ParameterInterval& leaf : claim.leaves) {
    leaves.push_back(form(leaf));
  }
  return {{"verdict", name(claim.verdict)},
          {"margin", claim.margin},
          {"leaves", leaves},
          {"where", form(claim.where)}};
}

Json form(const EmbeddedClaim& claim) {
  return {{"verdict", name(claim.verdict)},
          {"leaves", form(claim.leaves)},
          {"overlap", form(claim.overlap)}};
}

Json form(const PartClaims& claims) {
  Json object = Json::object();
  if (claims.regular) {
    object["regular"] = form(*claims.regular);
  }
  if (claims.embedded) {
    object["embedded"] = form(*claims.embedded);
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

Json form(const ClearanceClaim& claim) {
  return {{"parts", {claim.first, claim.second}},
          {"verdict", name(claim.verdict)},
          {"distance", claim.distance},
          {"leaves", form(claim.leaves)},
          {"overlap", form(claim.overlap)}};
}

// One line per element.
template <class Element>
std::string lines(const std::vector<Element>& elements) {
  std::string text = "[";
  for (const Element& element : elements) {
    text += (text.size() > 1 ? ",\n    " : "\n    ") +
            form(element).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text + (text.size() > 1 ? "\n  ]" : "]");
}

std::string json_text(std::string_view words) {
  return Json(words).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string detail::inputs_text(const Certificate& certificate) {
  return "  \"units\": " + json_text(symbol(certificate.unit)) +
         ",\n  \"tolerance\": " + Json(certificate.tolerance).dump() +
         ",\n  \"parts\": " + lines(certificate.parts);
}

std::string certificate_json(const Certificate& certificate) {
  const std::string inputs = detail::inputs_text(certificate);
  return detail::sealed("{\n  \"format\": " + json_text(detail::kCertificateFormat) +
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
  return json_forms::text({{"document", certificate.document},
                           {"unit", symbol(certificate.unit)},
                           {"findings", certificate.findings()},
                           {"parts", parts},
                           {"clearances", clearances}});
}

}  // namespace dupin
