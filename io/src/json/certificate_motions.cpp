#include "json/certificate_motions.h"

#include <type_traits>

#include "json/certificate_pieces.h"
#include "json/json_lists.h"
#include "json/json_value.h"

namespace dupin::json {
namespace {

// Of each kind the key, and what visits its numbers, to write or to read them.

template <class Motion, class Kind>
concept Is = std::is_same_v<std::remove_const_t<Motion>, Kind>;

void visit_axes(auto& m, const auto& visit) {
  visit("origin", m.origin);
  visit("along", m.along);
  visit("across", m.across);
  visit("up", m.up);
  visit("cosine", m.cosine);
  visit("sine", m.sine);
}

constexpr const char* key(const RollingThrough&) { return "rolling_through"; }
void visit_numbers(Is<RollingThrough> auto& m, const auto& visit) {
  visit_axes(m, visit);
  visit("distance", m.distance);
  visit("height", m.height);
  visit("below", m.below);
  visit("above", m.above);
  visit("side", m.side);
  visit("radius", m.radius);
}

constexpr const char* key(const RollingPartly&) { return "rolling_partly"; }
void visit_numbers(Is<RollingPartly> auto& m, const auto& visit) {
  visit_axes(m, visit);
  visit("distance", m.distance);
  visit("overlap", m.overlap);
  visit("first", m.first);
  visit("second", m.second);
  visit("radius", m.radius);
}

constexpr const char* key(const RollingOnCones&) { return "rolling_on_cones"; }
void visit_numbers(Is<RollingOnCones> auto& m, const auto& visit) {
  visit("first", m.first);
  visit("second", m.second);
  visit("zero", m.zero);
  visit("quarter", m.quarter);
  visit("side", m.side);
  visit("radius", m.radius);
}

constexpr const char* key(const RollingPartlyOnCones&) { return "rolling_partly_on_cones"; }
void visit_numbers(Is<RollingPartlyOnCones> auto& m, const auto& visit) {
  visit("first", m.first);
  visit("second", m.second);
  visit("zero", m.zero);
  visit("quarter", m.quarter);
  visit("width", m.width);
  visit("rest", m.rest);
  visit("radius", m.radius);
}

constexpr const char* key(const RationalCrossing&) { return "rational_crossing"; }
void visit_numbers(Is<RationalCrossing> auto& m, const auto& visit) {
  visit("origin", m.origin);
  visit("along", m.along);
  visit("across", m.across);
  visit("e3", m.e3);
  visit("e4", m.e4);
  visit("cosine", m.cosine);
  visit("sine", m.sine);
  visit("distance", m.distance);
  visit("side", m.side);
  visit("size", m.size);
}

constexpr const char* key(const RationalParallel&) { return "rational_parallel"; }
void visit_numbers(Is<RationalParallel> auto& m, const auto& visit) {
  visit("origin", m.origin);
  visit("ey", m.ey);
  visit("ez", m.ez);
  visit("nu1", m.nu1);
  visit("nu2", m.nu2);
  visit("half_distance", m.half_distance);
  visit("product", m.product);
  visit("far_squared", m.far_squared);
  visit("near_squared", m.near_squared);
}

struct Writer {
  Json& object;

  void operator()(const char* name, double x) const { object[name] = x; }
  void operator()(const char* name, const Vec3& v) const { object[name] = json_value(v); }
  template <std::size_t count>
  void operator()(const char* name, const std::array<double, count>& x) const {
    object[name] = x;
  }
  void operator()(const char* name, const PeVector& s) const { object[name] = sphere_value(s); }
  void operator()(const char* name, const Ring& ring) const { object[name] = ring_value(ring); }
};

struct Reader {
  const JsonNode& node;

  void operator()(const char* name, double& x) const { x = node.at(name).number(); }
  void operator()(const char* name, Vec3& v) const { v = vec3(node.at(name)); }
  template <std::size_t count>
  void operator()(const char* name, std::array<double, count>& x) const {
    x = numbers<count>(node.at(name));
  }
  void operator()(const char* name, PeVector& s) const { s = certificate_sphere(node.at(name)); }
  void operator()(const char* name, Ring& ring) const { ring = certificate_ring(node.at(name)); }
};

template <class Motion>
bool reads(const JsonNode& node, CanalFillet& loop) {
  Motion& motion = loop.motion.emplace<Motion>();
  if (!node.has(key(motion))) {
    return false;
  }
  const JsonNode below = node.at(key(motion));
  visit_numbers(motion, Reader{below});
  return true;
}

}  // namespace

Json motion_value(const CanalFillet& loop) {
  return std::visit(
      [](const auto& motion) {
        Json values = Json::object(), object = Json::object();
        visit_numbers(motion, Writer{values});
        object[key(motion)] = values;
        return object;
      },
      loop.motion);
}

CanalFillet certificate_motion(const JsonNode& node) {
  CanalFillet loop;
  if (!reads<RollingThrough>(node, loop) && !reads<RollingPartly>(node, loop) &&
      !reads<RollingOnCones>(node, loop) && !reads<RollingPartlyOnCones>(node, loop) &&
      !reads<RationalCrossing>(node, loop) && !reads<RationalParallel>(node, loop)) {
    node.fail("must have the key of a motion");
  }
  return loop;
}

}  // namespace dupin::json
