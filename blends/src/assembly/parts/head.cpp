#include "assembly/parts/head_surface.h"
#include "assembly/parts/part_checks.h"
#include "assembly/parts/part_rules.h"
#include "assembly/parts/start_ring.h"
#include "dupin/kernel/decimal.h"
#include "surfaces/least_wall.h"

namespace dupin::assembly {
namespace {

HeadProfile profile(const EllipsoidalHead& head, double radius) {
  return EllipsoidProfile{head.depth.value_or(radius / 2)};
}

HeadProfile profile(const TorisphericalHead& head, double radius) {
  switch (head.form) {
    case HeadForm::kloepper:
      return TorisphereProfile{2 * radius, 0.2 * radius};
    case HeadForm::korbbogen:
      return TorisphereProfile{1.6 * radius, 0.308 * radius};
    case HeadForm::free:
      break;
  }
  return TorisphereProfile{head.crown, head.knuckle};
}

}  // namespace

template <>
struct PartRules<"head"> {
  static constexpr std::array<bool, 2> kClosedEnds{false, true};
  static constexpr bool kHasBore = true;

  static References references(const auto& head) { return from_port(head.from); }

  static PartSurface geometry(const PartContext& context, const EllipsoidalHead& head) {
    if (head.depth) {
      check_positive(context, *head.depth, "depth");
    }
    const Ring start = round_start(context, head.from);
    return head_surface(start, profile(head, start.radius));
  }

  static PartSurface geometry(const PartContext& context, const TorisphericalHead& head) {
    if (head.form == HeadForm::free) {
      check_positive(context, head.crown, "crown");
      check_positive(context, head.knuckle, "knuckle");
    }
    const Ring start = round_start(context, head.from);
    const auto own = std::get<TorisphereProfile>(profile(head, start.radius));
    if (!(own.knuckle < start.radius && own.crown > start.radius)) {
      fail(context, own.crown > start.radius ? "knuckle" : "crown",
           "the knuckle's radius must be less than the pipe's, " +
               decimal(start.radius, kMessageDigits) + ", and the crown's larger");
    }
    return head_surface(start, own);
  }

  static PartSurface bore(const auto& head, const PartSurface& surface, double wall) {
    const Ring& start = *port_ring(surface, End::start);
    return inner_head(start, profile(head, start.radius), wall);
  }

  // Of a torisphere the bore is parallel; both are as near to their profiles as head_surface says.
  static double least_wall(const auto& head, const PartSurface& surface, double wall) {
    const double radius = port_ring(surface, End::start)->radius;
    const HeadProfile own = profile(head, radius);
    const auto* ellipsoid = std::get_if<EllipsoidProfile>(&own);
    return (ellipsoid == nullptr ? wall : surfaces::ellipse_wall(radius, ellipsoid->depth, wall)) -
           2 * kHeadDeviation * radius;
  }

 private:
  static Ring round_start(const PartContext& context, const PartStart& from) {
    Ring start = origin(context, from, kSection);
    if (start.ellipse) {
      fail(context, "from", "a head closes a circle, not an ellipse");
    }
    return start;
  }
};
template const PartKind& part_kind<"head">();

}  // namespace dupin::assembly
