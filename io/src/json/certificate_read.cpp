#include <algorithm>
#include <cmath>
#include <numbers>

#include "dupin/io/certificate_json.h"
#include "dupin/io/sha256.h"
#include "json/certificate_seal.h"
#include "json/json_document.h"

namespace dupin {
namespace {

using json::JsonNode;

template <class Value, class Read>
std::vector<Value> list(const JsonNode& node, const Read& read) {
  std::vector<Value> result;
  const std::size_t size = node.require_array();
  for (std::size_t i = 0; i < size; ++i) {
    result.push_back(read(node.at(i)));
  }
  return result;
}

std::vector<double> numbers(const JsonNode& node) {
  return list<double>(node, [](const JsonNode& element) { return element.number(); });
}

template <std::size_t count>
std::array<double, count> numbers(const JsonNode& node) {
  const std::vector<double> values = numbers(node);
  if (values.size() != count) {
    node.fail("must hold " + std::to_string(count) + " numbers");
  }
  std::array<double, count> result = {};
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

std::uint32_t count(const JsonNode& node, std::uint32_t limit) {
  const double number = node.number();
  if (!(number >= 0 && number < limit && number == std::floor(number))) {
    node.fail("must be a whole number below " + std::to_string(limit));
  }
  return static_cast<std::uint32_t>(number);
}

Vec3 vector(const JsonNode& node) {
  const auto [x, y, z] = numbers<3>(node);
  return {x, y, z};
}

ParameterInterval interval(const JsonNode& node) {
  const auto [from, to] = numbers<2>(node);
  return {from, to};
}

Ring ring(const JsonNode& node) {
  Ring result{vector(node.at("center")), vector(node.at("normal")), node.at("radius").number(),
              node.at("slope").number()};
  if (node.has("ellipse")) {
    const JsonNode e = node.at("ellipse");
    result.ellipse =
        Ellipse{vector(e.at("axis")), e.at("across").number(), e.at("across_slope").number()};
  }
  return result;
}

PeVector sphere(const JsonNode& node) {
  const auto [x, y, z, r] = numbers<4>(node);
  return {Vec3(x, y, z), r};
}

Spine spine(const JsonNode& node) {
  if (node.has("line")) {
    const JsonNode s = node.at("line");
    return LineSpine{vector(s.at("from")), vector(s.at("to"))};
  }
  if (node.has("arc")) {
    const JsonNode s = node.at("arc");
    const double angle = s.at("angle").number();
    if (!(angle > 0 && angle <= 2 * std::numbers::pi)) {
      s.at("angle").fail("an arc turns by more than 0 and at most 2 pi");
    }
    return ArcSpine{vector(s.at("center")), vector(s.at("axis")), vector(s.at("start")), angle};
  }
  if (node.has("hermite")) {
    const JsonNode s = node.at("hermite");
    return HermiteSpine{vector(s.at("from")), vector(s.at("to")), vector(s.at("start_velocity")),
                        vector(s.at("end_velocity"))};
  }
  const JsonNode s = node.at("bezier");
  return BezierSpine{list<Vec3>(s.at("points"), vector), numbers(s.at("weights"))};
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
  return BezierRadius{numbers(node.at("bezier"))};
}

RationalRingedTube rational_ringed_surface(const JsonNode& node) {
  RationalRingedTube result{ring(node.at("start")), ring(node.at("end")), {}};
  const auto points = list<Vec3>(node.at("center"), vector);
  if (points.size() != result.surface.center.size()) {
    node.at("center").fail("must hold 4 points");
  }
  std::copy(points.begin(), points.end(), result.surface.center.begin());
  result.surface.radius = numbers<4>(node.at("radius"));
  result.surface.rotation = list<std::array<double, 4>>(
      node.at("rotation"), [](const JsonNode& control) { return numbers<4>(control); });
  if (result.surface.rotation.size() < 2) {
    node.at("rotation").fail("must hold 2 quaternions at least");
  }
  return result;
}

CyclidePiece cyclide(const JsonNode& node) {
  if (!(node.at("chord").number() > 0)) {
    node.at("chord").fail("must be positive");
  }
  return {ring(node.at("start")),     ring(node.at("end")),    sphere(node.at("first")),
          sphere(node.at("tangent")), sphere(node.at("last")), node.at("chord").number()};
}

EllipticTube elliptic_tube(const JsonNode& node) {
  return {ring(node.at("start")), ring(node.at("end")), spine(node.at("spine")),
          radius(node.at("first")), radius(node.at("second"))};
}

RingedSurface ringed_surface(const JsonNode& node) {
  return {ring(node.at("start")), ring(node.at("end")), spine(node.at("spine")),
          radius(node.at("radius"))};
}

template <class Kind, Kind (*read)(const JsonNode&)>
Piece piece_of(const JsonNode& node) {
  return read(node);
}

Piece piece(const JsonNode& node) {
  struct Reader {
    std::string_view key;
    Piece (*read)(const JsonNode&);
  };
  constexpr Reader kReaders[] = {
      {"rational_ringed_surface", piece_of<RationalRingedTube, rational_ringed_surface>},
      {"cyclide", piece_of<CyclidePiece, cyclide>},
      {"elliptic_tube", piece_of<EllipticTube, elliptic_tube>}};
  for (const auto& [key, read] : kReaders) {
    if (node.has(key)) {
      return read(node.at(key));
    }
  }
  return ringed_surface(node.at("ringed_surface"));
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
    return Sphere{vector(s.at("center")), s.at("radius").number()};
  }
  if (node.has("other_shape")) {
    Chain unknown;
    unknown.joints = Joints::spherical;
    return unknown;
  }
  Chain chain(list<Piece>(node.at("pieces"), piece), boolean(node.at("closed")));
  chain.wall = node.at("wall").number();
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
  return Overlap{vector(node.at("point")), interval(node.at("first")), interval(node.at("second"))};
}

std::optional<double> optional_number(const JsonNode& node) {
  return node.value().is_null() ? std::nullopt : std::optional(node.number());
}

PartClaims part_claims(const JsonNode& node) {
  PartClaims result;
  if (node.has("regular")) {
    const JsonNode claim = node.at("regular");
    result.regular = {verdict(claim.at("verdict")), claim.at("margin").number(),
                      list<ParameterInterval>(claim.at("leaves"), interval),
                      interval(claim.at("where"))};
  }
  if (node.has("embedded")) {
    const JsonNode claim = node.at("embedded");
    result.embedded = {verdict(claim.at("verdict")),
                       list<DiscPairs>(claim.at("leaves"), disc_pairs),
                       overlap(claim.at("overlap"))};
  }
  result.tangency = list<TangencyClaim>(node.at("tangency"), [](const JsonNode& bounds) {
    const TangencyClaim claim{optional_number(bounds.at("deviation")),
                              bounds.at("axis_angle").number(), bounds.at("offset").number(),
                              optional_number(bounds.at("curvature"))};
    return claim;
  });
  if (node.has("mesh")) {
    const JsonNode mesh = node.at("mesh");
    constexpr std::uint32_t kMostSegments = 2'000'000;  // more than any tessellation has
    result.mesh = {count(mesh.at("segments"), kMostSegments), mesh.at("grid").number(),
                   numbers(mesh.at("knots")), mesh.at("error_bound").number()};
  }
  return result;
}

ClearanceClaim clearance(const JsonNode& node, std::uint32_t parts) {
  const JsonNode pair = node.at("parts");
  if (pair.require_array() != 2) {
    pair.fail("must name two parts");
  }
  return {count(pair.at(std::size_t(0)), parts),
          count(pair.at(std::size_t(1)), parts),
          verdict(node.at("verdict")),
          node.at("distance").number(),
          list<DiscPairs>(node.at("leaves"), disc_pairs),
          overlap(node.at("overlap"))};
}

}  // namespace

Certificate parse_certificate(std::string_view text, const std::string& source) {
  const json::Json json = json::parse_json(text, source);
  const JsonNode root(json, source, "");
  if (root.at("format").text() != json::kCertificateFormat) {
    root.at("format").fail("must be '" + std::string(json::kCertificateFormat) + "'");
  }
  if (!json::has_seal(text)) {
    root.at("sha256").fail("does not belong to this text: the certificate was changed");
  }
  Certificate result;
  result.document = root.at("document").text();
  result.document_sha256 = root.at("document_sha256").text();
  result.unit = unit_from(root.at("units").text());
  result.tolerance = root.at("tolerance").number();
  const auto parts = std::uint32_t(root.at("parts").require_array());
  result.parts = list<CertifiedPart>(root.at("parts"),
                                     [=](const JsonNode& node) { return part(node, parts); });
  if (root.at("inputs_sha256").text() != sha256(json::inputs_text(result))) {
    root.at("inputs_sha256").fail("does not belong to these inputs");
  }
  result.claims = list<PartClaims>(root.at("claims"), part_claims);
  result.clearances = list<ClearanceClaim>(
      root.at("clearances"), [=](const JsonNode& node) { return clearance(node, parts); });
  return result;
}

}  // namespace dupin
