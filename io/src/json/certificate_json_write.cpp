#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/parallel.h"
#include "json/certificate_motions.h"
#include "json/certificate_pieces.h"
#include "json/certificate_seal.h"
#include "json/json_value.h"

namespace dupin {
namespace {

using json::Json;
using json::json_value;

Json json_value(const ParameterInterval& t) { return {t.from, t.to}; }

struct ShapeForm {
  Json operator()(const Sphere& s) const {
    return {{"sphere", {{"center", json::json_value(s.center)}, {"radius", s.radius}}}};
  }
  Json operator()(const Chain& s) const {
    if (s.pieces.empty()) {
      return {{"other_shape", Json::object()}};
    }
    Json pieces = Json::array();
    for (const Piece& piece : s.pieces) {
      pieces.push_back(json::json_value(piece));
    }
    Json object{{"pieces", pieces}, {"closed", s.closed}, {"wall", s.wall}};
    if (s.joints == Joints::spherical) {
      object["kneecaps"] = true;
    }
    return object;
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

Json json_value(const CertifiedFillet& fillet) {
  Json loops = Json::array();
  for (const CanalFillet& loop : fillet.loops) {
    loops.push_back(json::motion_value(loop));
  }
  return {{"name", fillet.name},
          {"between", fillet.between},
          {"buried", fillet.buried},
          {"loops", loops}};
}

Json json_value(const CertifiedJunction& junction) {
  return {{"hub", junction.hub}, {"arms", junction.arms}};
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

Json json_value(const MeshClaim& claim) {
  Json object{{"segments", claim.segments},
              {"grid", claim.grid},
              {"knots", claim.knots},
              {"error_bound", claim.error_bound}};
  if (claim.axes != 0) {
    object["axes"] = claim.axes;
  }
  if (!claim.inner_knots.empty()) {
    object["inner_knots"] = claim.inner_knots;
  }
  if (claim.kneecaps) {
    object["kneecaps"] = {{"turn", claim.kneecaps->turn},
                          {"apart", claim.kneecaps->apart},
                          {"segments", claim.kneecaps->segments}};
  }
  return object;
}

Json json_value(const std::optional<ContactClaim>& claim) {
  return claim ? Json{{"offset", claim->offset}, {"deviation", claim->deviation}} : Json(nullptr);
}

Json json_value(const std::vector<LoopClaims>& loops) {
  Json list = Json::array();
  for (const LoopClaims& claims : loops) {
    Json object{{"regular", json_value(claims.regular)},
                {"embedded", json_value(claims.embedded)},
                {"contact", json_value(claims.contact)}};
    if (claims.mesh) {
      object["mesh"] = json_value(*claims.mesh);
    }
    list.push_back(object);
  }
  return list;
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
    object["mesh"] = json_value(*claims.mesh);
  }
  return object;
}

Json json_value(const ClearanceClaim& claim, const char* between) {
  Json object{{between, {claim.first, claim.second}},
              {"verdict", name(claim.verdict)},
              {"distance", claim.distance},
              {"leaves", json_value(claim.leaves)},
              {"overlap", json_value(claim.overlap)}};
  if (claim.corner != 0) {
    object["corner"] = claim.corner;
  }
  return object;
}

Json json_value(const ClearanceClaim& claim) { return json_value(claim, "parts"); }

// Of parts and loops.
struct SurfacePair {
  const ClearanceClaim* claim;
};

Json json_value(const SurfacePair& pair) { return json_value(*pair.claim, "surfaces"); }

std::vector<SurfacePair> fillet_clearances(const Certificate& certificate) {
  std::vector<SurfacePair> pairs;
  for (const ClearanceClaim& claim : certificate.fillet_clearances) {
    pairs.push_back({&claim});
  }
  return pairs;
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

Json axes_value(const Directions& axes) {
  Json all = Json::array();
  for (const Vec3& axis : axes) {
    all.push_back(json::json_value(axis));
  }
  return all;
}

std::string json_text(std::string_view words) {
  return Json(words).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string json::input_text(const CertifiedPart& part) {
  return dupin::json_value(part).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string json::input_text(const CertifiedFillet& fillet) {
  return dupin::json_value(fillet).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string json::input_text(const CertifiedJunction& junction) {
  return dupin::json_value(junction).dump();
}

std::string json::inputs_text(const Certificate& certificate) {
  const auto& fillets = certificate.fillets;
  const auto& junctions = certificate.junctions;
  return "  \"units\": " + json_text(symbol(certificate.unit)) +
         ",\n  \"tolerance\": " + Json(certificate.tolerance).dump() +
         ",\n  \"parts\": " + lines(certificate.parts) +
         (fillets.empty() ? "" : ",\n  \"fillets\": " + lines(fillets)) +
         (junctions.empty() ? "" : ",\n  \"junctions\": " + lines(junctions));
}

std::string certificate_json(const Certificate& certificate) {
  const UsualArithmetic usual;
  const std::string inputs = json::inputs_text(certificate);
  return json::sealed(
      "{\n  \"format\": " + json_text(json::kCertificateFormat) +
      ",\n  \"document\": " + json_text(certificate.document) +
      ",\n  \"document_sha256\": " + json_text(certificate.document_sha256) + ",\n" + inputs +
      ",\n  \"inputs_sha256\": " + json_text(sha256(inputs)) +
      ",\n  \"claims\": " + lines(certificate.claims) +
      (certificate.fillets.empty()
           ? ""
           : ",\n  \"fillet_claims\": " + lines(certificate.fillet_claims)) +
      (certificate.apart > 0 ? ",\n  \"apart\": " + Json(certificate.apart).dump() : "") +
      (certificate.axes ? ",\n  \"axes\": " + axes_value(*certificate.axes).dump() : "") +
      ",\n  \"clearances\": " + lines(certificate.clearances) +
      (certificate.fillets.empty()
           ? ""
           : ",\n  \"fillet_clearances\": " + lines(fillet_clearances(certificate))) +
      ",\n");
}

std::string certificate_summary_json(const Certificate& certificate) {
  const UsualArithmetic usual;
  Json parts = Json::array();
  for (std::size_t i = 0; i < certificate.parts.size(); ++i) {
    const PartClaims& claims = certificate.claims[i];
    Json part{{"name", certificate.parts[i].name}, {"kind", certificate.parts[i].kind}};
    if (claims.regular && claims.embedded) {
      part["regular"] = name(claims.regular->verdict);
      part["margin"] = claims.regular->verdict == Verdict::undecided ? Json(nullptr)
                                                                     : Json(claims.regular->margin);
      part["embedded"] = name(claims.embedded->verdict);
    }
    part["error_bound"] = claims.mesh ? Json(claims.mesh->error_bound) : Json(nullptr);
    parts.push_back(part);
  }
  Json fillets = Json::array();
  for (std::size_t i = 0; i < certificate.fillets.size(); ++i) {
    for (const LoopClaims& claims : certificate.fillet_claims[i]) {
      fillets.push_back(
          {{"name", certificate.fillets[i].name},
           {"regular", name(claims.regular.verdict)},
           {"margin", claims.regular.verdict == Verdict::undecided ? Json(nullptr)
                                                                   : Json(claims.regular.margin)},
           {"embedded", name(claims.embedded.verdict)},
           {"offset", claims.contact ? Json(claims.contact->offset) : Json(nullptr)},
           {"deviation", claims.contact ? Json(claims.contact->deviation) : Json(nullptr)},
           {"error_bound", claims.mesh ? Json(claims.mesh->error_bound) : Json(nullptr)}});
    }
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
  Json fillet_clearances = Json::array();
  for (const ClearanceClaim& claim : certificate.fillet_clearances) {
    fillet_clearances.push_back(
        {{"surfaces",
          {certificate.surface_name(claim.first), certificate.surface_name(claim.second)}},
         {"verdict", name(claim.verdict)},
         {"overlap", claim.overlap.has_value()},
         {"distance", claim.distance},
         {"corner", claim.corner}});
  }
  const JointFit joints = widest_joint(certificate);
  return json::text({{"document", certificate.document},
                     {"unit", symbol(certificate.unit)},
                     {"tolerance", certificate.tolerance},
                     {"joint_offset", joints.offset},
                     {"joint_angle", joints.angle},
                     {"findings", certificate.findings()},
                     {"parts", parts},
                     {"fillets", fillets},
                     {"apart", certificate.apart},
                     {"clearances", clearances},
                     {"fillet_clearances", fillet_clearances}});
}

}  // namespace dupin
