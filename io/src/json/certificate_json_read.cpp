#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "dupin/kernel/decimal.h"
#include "dupin/kernel/parallel.h"
#include "json/certificate_motions.h"
#include "json/certificate_pieces.h"
#include "json/certificate_seal.h"
#include "json/json_document.h"
#include "json/json_lists.h"
#include "text/byte_order_mark.h"

namespace dupin {
namespace {

using json::JsonNode;
using json::list;
using json::numbers;
using json::vec3;

std::uint32_t count(const JsonNode& node, std::uint32_t limit) {
  const double number = node.number();
  if (!(number >= 0 && number < limit && number == std::floor(number))) {
    node.fail("must be a whole number below " + std::to_string(limit));
  }
  return static_cast<std::uint32_t>(number);
}

ParameterInterval interval(const JsonNode& node) {
  const auto [from, to] = numbers<2>(node);
  return {from, to};
}

bool boolean(const JsonNode& node) {
  if (!node.value().is_boolean()) {
    node.fail("must be true or false");
  }
  return node.value().get<bool>();
}

PartSurface shape(const JsonNode& node) {
  if (node.has("sphere")) {
    const JsonNode s = node.at("sphere");
    return Sphere{vec3(s.at("center")), s.at("radius").number()};
  }
  if (node.has("other_shape")) {
    return Chain();
  }
  Chain chain(list<Piece>(node.at("pieces"), json::certificate_piece), boolean(node.at("closed")));
  chain.wall = node.at("wall").number();
  if (node.has("kneecaps") && boolean(node.at("kneecaps"))) {
    chain.joints = Joints::spherical;
  }
  if (chain.pieces.empty()) {
    node.at("pieces").fail("must not be empty");
  }
  return chain;
}

CertifiedPart part(const JsonNode& node, std::uint32_t parts) {
  CertifiedPart result{node.at("name").text(), node.at("kind").text(), shape(node), {}};
  const JsonNode joined = node.at("joined");
  if (joined.require_array() != 2) {
    joined.fail("must hold what both ends are joined to");
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const JsonNode end = joined.at(i);
    if (end.value().is_null()) {
      continue;
    }
    if (end.require_array() != 2) {
      end.fail("must be null or [part, end]");
    }
    const std::string which = end.at(std::size_t(1)).text();
    if (which != "start" && which != "end") {
      end.fail("must name start or end");
    }
    result.joined.at(i) =
        EndIndex{count(end.at(std::size_t(0)), parts), which == "start" ? End::start : End::end};
  }
  return result;
}

// Of one joint, two ends of different parts say the same.
void require_joints(const JsonNode& node, const std::vector<CertifiedPart>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (const End end : {End::start, End::end}) {
      const auto& other = parts[i].joined.at(at(end));
      if (!other) {
        continue;
      }
      const JsonNode place = node.at(i).at("joined").at(std::size_t(at(end)));
      if (other->part == i) {
        place.fail("must be an end of another part, not of this one");
      }
      const auto& back = parts[other->part].joined.at(at(other->end));
      if (!back || back->part != i || back->end != end) {
        place.fail("must be an end that is joined to this one, which part " +
                   std::to_string(other->part) + " does not say");
      }
    }
  }
}

template <class Element, class Read>
std::array<Element, 2> two(const JsonNode& node, const Read& read) {
  if (node.require_array() != 2) {
    node.fail("must hold two elements");
  }
  return {read(node.at(std::size_t(0))), read(node.at(std::size_t(1)))};
}

// The rings of pipes are what their balls roll on.
CertifiedFillet fillet(const JsonNode& node, const std::vector<CertifiedPart>& parts) {
  CertifiedFillet result;
  result.name = node.at("name").text();
  result.between = two<std::uint32_t>(node.at("between"), [&](const JsonNode& part) {
    return count(part, std::uint32_t(parts.size()));
  });
  result.buried = two<std::array<bool, 2>>(
      node.at("buried"), [](const JsonNode& ends) { return two<bool>(ends, boolean); });
  result.loops = list<CanalFillet>(node.at("loops"), json::certificate_motion);
  for (CanalFillet& loop : result.loops) {
    for (std::size_t side = 0; side < 2; ++side) {
      const auto* chain = std::get_if<Chain>(&parts[result.between.at(side)].shape);
      if (chain == nullptr || chain->pieces.empty()) {
        node.at("between").fail("must be two parts with pieces");
      }
      loop.quadrics.at(side) = end_ring(*chain, End::end);
    }
  }
  return result;
}

// The place of one that is none, which whoever knows the units cannot name.
Unit unit(const JsonNode& node) {
  const std::string text = node.text();
  try {
    return unit_from(text);
  } catch (const Error& error) {
    node.fail(error.message());
  }
}

CertifiedJunction junction(const JsonNode& node, std::uint32_t parts) {
  return {
      count(node.at("hub"), parts),
      list<std::uint32_t>(node.at("arms"), [=](const JsonNode& arm) { return count(arm, parts); })};
}

Verdict verdict(const JsonNode& node) {
  const std::string text = node.text();
  for (const Verdict value : {Verdict::proved, Verdict::refuted, Verdict::undecided}) {
    if (name(value) == text) {
      return value;
    }
  }
  node.fail("must be proved, refuted or undecided");
}

DiscPairs disc_pairs(const JsonNode& node) {
  const std::vector<double> x = numbers(node);
  if (x.size() != 4 && x.size() != 7) {
    node.fail("must hold two intervals, and a direction or none");
  }
  DiscPairs result{{x[0], x[1]}, {x[2], x[3]}, {}};
  if (x.size() == 7) {
    result.direction = Vec3(x[4], x[5], x[6]);
  }
  return result;
}

std::optional<Overlap> overlap(const JsonNode& node) {
  if (node.value().is_null()) {
    return std::nullopt;
  }
  return Overlap{vec3(node.at("point")), interval(node.at("first")), interval(node.at("second"))};
}

std::optional<double> optional_number(const JsonNode& node) {
  return node.value().is_null() ? std::nullopt : std::optional(node.number());
}

RegularClaim regular_claim(const JsonNode& node) {
  return {verdict(node.at("verdict")), node.at("margin").number(),
          list<ParameterInterval>(node.at("leaves"), interval), interval(node.at("where"))};
}

EmbeddedClaim embedded_claim(const JsonNode& node) {
  return {verdict(node.at("verdict")), list<DiscPairs>(node.at("leaves"), disc_pairs),
          overlap(node.at("overlap"))};
}

std::uint32_t mesh_segments(const JsonNode& node) {
  return count(node, CertificateLimits::kSegments + 1);
}

std::optional<MeshClaim> mesh_claim(const JsonNode& node) {
  if (!node.has("mesh")) {
    return std::nullopt;
  }
  const JsonNode mesh = node.at("mesh");
  MeshClaim result{mesh_segments(mesh.at("segments")), mesh.at("grid").number(),
                   numbers(mesh.at("knots")), mesh.at("error_bound").number(),
                   mesh.has("axes") ? mesh.at("axes").number() : 0};
  if (mesh.has("inner_knots")) {
    result.inner_knots = numbers(mesh.at("inner_knots"));
  }
  if (mesh.has("kneecaps")) {
    const JsonNode knees = mesh.at("kneecaps");
    result.kneecaps = KneecapMesh{knees.at("turn").number(), knees.at("apart").number(),
                                  list<std::uint32_t>(knees.at("segments"), mesh_segments)};
  }
  return result;
}

PartClaims part_claims(const JsonNode& node) {
  PartClaims result;
  if (node.has("regular")) {
    result.regular = regular_claim(node.at("regular"));
  }
  if (node.has("embedded")) {
    result.embedded = embedded_claim(node.at("embedded"));
  }
  result.tangency = list<TangencyClaim>(node.at("tangency"), [](const JsonNode& bounds) {
    const TangencyClaim claim{optional_number(bounds.at("deviation")),
                              bounds.at("axis_angle").number(), bounds.at("offset").number(),
                              optional_number(bounds.at("curvature"))};
    return claim;
  });
  result.mesh = mesh_claim(node);
  return result;
}

std::optional<ContactClaim> contact_claim(const JsonNode& node) {
  if (node.value().is_null()) {
    return std::nullopt;
  }
  return ContactClaim{node.at("offset").number(), node.at("deviation").number()};
}

LoopClaims loop_claims(const JsonNode& node) {
  return {regular_claim(node.at("regular")), embedded_claim(node.at("embedded")),
          contact_claim(node.at("contact")), mesh_claim(node)};
}

ClearanceClaim clearance(const JsonNode& node, const char* between, std::uint32_t limit) {
  const JsonNode pair = node.at(between);
  if (pair.require_array() != 2) {
    pair.fail("must name two " + std::string(between));
  }
  return {count(pair.at(std::size_t(0)), limit),
          count(pair.at(std::size_t(1)), limit),
          verdict(node.at("verdict")),
          node.at("distance").number(),
          list<DiscPairs>(node.at("leaves"), disc_pairs),
          overlap(node.at("overlap")),
          node.has("corner") ? node.at("corner").number() : 0};
}

// Throws at the first key, in any depth, that the value as it was understood, which is as it would
// be written, has not: whatever the readers above ask for, nothing else is left to be believed.
void require_no_more_than(const json::Json& understood, const JsonNode& read) {
  if (read.value().is_object()) {
    for (const auto& [key, value] : read.value().items()) {
      if (!understood.is_object() || !understood.contains(key)) {
        read.at(key).fail("unknown key: a certificate has none that is not checked");
      }
      require_no_more_than(understood.at(key), read.at(key));
    }
  }
  for (std::size_t i = 0; read.value().is_array() && i < read.value().size(); ++i) {
    if (read.value()[i].is_structured()) {
      require_no_more_than(understood.at(i), read.at(i));
    }
  }
}

// Finds the first number whose decimals are not those of the double that is believed: what is
// proved is said of that one, and the decimals of a claim may be larger, or less.
struct DecimalsOfDoubles {
  std::string given, meant;  // empty: none

  [[nodiscard]] bool number_float(double value, const std::string& text) {
    if (text != json::Json(value).dump() && text != decimal(value)) {
      given = text;
      meant = json::Json(value).dump();
    }
    return given.empty();
  }
  static bool null() { return true; }
  static bool boolean(bool) { return true; }
  static bool number_integer(std::int64_t) { return true; }
  static bool number_unsigned(std::uint64_t) { return true; }
  static bool string(std::string&) { return true; }
  static bool binary(json::Json::binary_t&) { return true; }
  static bool start_object(std::size_t) { return true; }
  static bool key(std::string&) { return true; }
  static bool end_object() { return true; }
  static bool start_array(std::size_t) { return true; }
  static bool end_array() { return true; }
  static bool parse_error(std::size_t, const std::string&, const std::exception&) { return false; }
};

void require_decimals_of_doubles(std::string_view text, const JsonNode& root) {
  DecimalsOfDoubles numbers;
  (void)json::Json::sax_parse(text.substr(text::byte_order_mark(text)), &numbers);
  if (!numbers.given.empty()) {
    constexpr std::size_t kShown = 40;
    root.fail("the number " + numbers.given.substr(0, kShown) +
              " is not written as certify writes it, " + numbers.meant +
              ", of which alone something can be proved");
  }
}

}  // namespace

Certificate parse_certificate(std::string_view text, const std::string& source) {
  const UsualArithmetic usual;
  const json::Json json = json::parse_json(text, source);
  const JsonNode root(json, source, "");
  if (root.at("format").text() != json::kCertificateFormat) {
    root.at("format").fail("must be '" + std::string(json::kCertificateFormat) + "'");
  }
  if (!json::has_seal(text.substr(text::byte_order_mark(text)))) {
    root.at("sha256").fail("does not belong to this text: the certificate was changed");
  }
  Certificate result;
  result.document = root.at("document").text();
  result.document_sha256 = root.at("document_sha256").text();
  result.unit = unit(root.at("units"));
  result.tolerance = root.at("tolerance").number();
  const auto parts = std::uint32_t(root.at("parts").require_array());
  result.parts = list<CertifiedPart>(root.at("parts"),
                                     [=](const JsonNode& node) { return part(node, parts); });
  require_joints(root.at("parts"), result.parts);
  if (root.has("fillets")) {
    result.fillets = list<CertifiedFillet>(
        root.at("fillets"), [&](const JsonNode& node) { return fillet(node, result.parts); });
  }
  if (root.has("junctions")) {
    result.junctions = list<CertifiedJunction>(
        root.at("junctions"), [=](const JsonNode& node) { return junction(node, parts); });
  }
  if (root.at("inputs_sha256").text() != sha256(json::inputs_text(result))) {
    root.at("inputs_sha256").fail("does not belong to these inputs, as certify writes them");
  }
  result.claims = list<PartClaims>(root.at("claims"), part_claims);
  if (root.has("fillet_claims")) {
    result.fillet_claims = list<std::vector<LoopClaims>>(
        root.at("fillet_claims"),
        [](const JsonNode& node) { return list<LoopClaims>(node, loop_claims); });
  }
  if (root.has("apart")) {
    result.apart = root.at("apart").number();
    if (!(result.apart > 0)) {
      root.at("apart").fail("must be positive");
    }
    if (root.has("axes")) {
      const auto axes =
          list<Vec3>(root.at("axes"), [](const JsonNode& node) { return vec3(node); });
      result.axes.emplace();
      if (axes.size() != result.axes->size()) {
        root.at("axes").fail("must be three directions");
      }
      std::ranges::copy(axes, result.axes->begin());
    }
  }
  result.clearances = list<ClearanceClaim>(
      root.at("clearances"), [=](const JsonNode& node) { return clearance(node, "parts", parts); });
  if (root.has("fillet_clearances")) {
    auto surfaces = parts;
    for (const CertifiedFillet& fillet : result.fillets) {
      surfaces += std::uint32_t(fillet.loops.size());
    }
    result.fillet_clearances = list<ClearanceClaim>(
        root.at("fillet_clearances"),
        [=](const JsonNode& node) { return clearance(node, "surfaces", surfaces); });
  }
  require_no_more_than(json::parse_json(certificate_json(result), source), root);
  require_decimals_of_doubles(text, root);
  return result;
}

}  // namespace dupin
