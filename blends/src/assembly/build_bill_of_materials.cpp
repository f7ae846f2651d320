#include <algorithm>
#include <numbers>

#include <Eigen/Geometry>

#include "assembly/bore.h"
#include "assembly/part_context.h"
#include "assembly/part_margins.h"
#include "assembly/parts/part_kind.h"
#include "dupin/blends/build.h"
#include "dupin/blends/resolve.h"
#include "dupin/kernel/parallel.h"
#include "surfaces/pieces/piece_measures.h"

namespace dupin {
namespace {

EndSize size_of(const Ring& ring) { return {2 * ring.radius, 2 * across(ring)}; }

// The hub less the caps, and the arms.
PartMeasures measures_of(const Junction& junction) {
  std::vector<surfaces::CutPlane> caps;
  caps.reserve(junction.arms.size());
  SolidMoments arms;
  for (const JunctionArm& arm : junction.arms) {
    const Vec3 apart = cap_circle(arm).center - junction.hub.center;
    const Vec3 outward = -cap_circle(arm).normal;
    caps.push_back({outward, apart.dot(outward)});
    arms = arms + *measures(tube(arm)).solid;
  }
  return {area(junction), {}, surfaces::cut_ball(junction.hub, caps) + arms, {}};
}

class Biller {
 public:
  explicit Biller(const Assembly& assembly) : assembly_(assembly), outer_(resolve(assembly)) {
    for (const ResolvedPart& part : outer_.parts) {
      within(part.index, [&] { (void)assembly::margins(part.shape, false, part.kind); });
    }
    walls_ = assembly::walls_of(assembly_, outer_, Region::metal);
    outer_ = assembly::filled(std::move(outer_));
    buried_.emplace(outer_);
    if (walls_) {
      bore_ = assembly::bore_of(assembly_, outer_, *walls_);
    }
  }

  std::vector<BillRow> run() {
    for (std::uint32_t i = 0; i < outer_.parts.size(); ++i) {
      if (!outer_.parts[i].ends_in_hub) {
        within(outer_.parts[i].index, [&] { add_part(i); });
      }
    }
    for (const ResolvedJunction& junction : outer_.junctions) {
      within(junction.index, [&] { add_junction(junction); });
    }
    for (const ResolvedFillet& fillet : outer_.fillets) {
      add_fillet(fillet);
    }
    std::ranges::stable_sort(rows_, {}, &BillRow::index);
    return std::move(rows_);
  }

 private:
  template <typename Work>
  void within(std::uint32_t index, const Work& work) const {
    assembly::with_part_context(assembly_, index, work);
  }

  // A row with what is measured of the outer surface.
  BillRow& add_row(const std::string& name, const std::string& kind, std::uint32_t index,
                   const PartMeasures& outer) {
    BillRow& row = rows_.emplace_back();
    row.name = name;
    row.kind = kind;
    row.index = index;
    row.wall = walls_ ? (*walls_)[index] : 0;
    row.length = outer.length;
    row.area = outer.area;
    row.outer = outer.solid;
    if (!outer.solid) {
      row.remarks.push_back("volumes are not computed: " + outer.missing);
    }
    return row;
  }

  void add_part(std::uint32_t i) {
    const ResolvedPart& part = outer_.parts[i];
    BillRow& row = add_row(part.name, part.kind, part.index, measures(part.shape));
    if (const auto* ball = std::get_if<Sphere>(&part.shape)) {
      row.sizes.push_back({2 * ball->radius, 2 * ball->radius});
    }
    for (const End end : {End::start, End::end}) {
      if (const Ring* ring = port_ring(part.shape, end)) {
        row.sizes.push_back(size_of(*ring));
        note_buried({i, end}, row);
      }
    }
    add_closed_ends(part, row);
    set_bend(part.shape, row);
    const ResolvedPart* bore = row.wall > 0 ? &bore_.resolved.parts[*bore_.position[i]] : nullptr;
    if (bore != nullptr && !ends_level(part, *bore)) {
      row.remarks.emplace_back(
          "metal and fluid are not computed: the bore does not end in the planes of the ends");
    } else {
      divide(row, bore == nullptr ? std::nullopt : measures(bore->shape).solid);
    }
  }

  // The disc that a head's tip is, which is surface as the rest; a pad's faces lie on others.
  void add_closed_ends(const ResolvedPart& part, BillRow& row) const {
    if (assembly::part_kind(assembly_.parts[part.index].shape).is_pad) {
      return;
    }
    for (const End end : {End::start, End::end}) {
      const Ring* ring = port_ring(part.shape, end);
      if (row.area && ring != nullptr && part.is_closed.at(at(end))) {
        *row.area += std::numbers::pi * ring->radius * ring->radius;
      }
    }
  }

  void add_junction(const ResolvedJunction& junction) {
    BillRow& row = add_row(junction.name, "junction", junction.index, measures_of(junction.shape));
    for (const JunctionArm& arm : junction.shape.arms) {
      row.sizes.push_back(size_of(arm.end));
    }
    if (!(row.wall > 0)) {
      divide(row, {});
      return;
    }
    const auto bore =
        std::ranges::find(bore_.resolved.junctions, junction.index, &ResolvedJunction::index);
    const bool is_level = std::ranges::equal(
        junction.shape.arms, bore->shape.arms,
        [](const JunctionArm& a, const JunctionArm& b) { return a.end.center == b.end.center; });
    if (is_level) {
      divide(row, measures_of(bore->shape).solid);
    } else {
      row.remarks.emplace_back(
          "metal and fluid are not computed: the bore does not end in the planes of the ends");
    }
  }

  void add_fillet(const ResolvedFillet& fillet) {
    BillRow& row = rows_.emplace_back();
    row.name = fillet.name;
    row.kind = fillet.shape.is_cope() ? "cope" : "fillet";
    row.index = fillet.index;
    row.remarks.emplace_back(
        fillet.shape.is_cope()
            ? "nothing of its own: the part that it cuts is measured before it is cut"
            : "not computed: what it adds lies between its surface and both pipes'");
  }

  // Of hollow parts the outer solid is the other two together.
  void divide(BillRow& row, const std::optional<SolidMoments>& fluid) const {
    if (row.wall > 0 && fluid && row.outer) {
      row.fluid = fluid;
      row.metal = *row.outer - *fluid;
    } else if (row.wall == 0) {
      row.metal = row.outer;
    }
  }

  [[nodiscard]] static bool ends_level(const ResolvedPart& outer, const ResolvedPart& bore) {
    return std::ranges::all_of(std::array{End::start, End::end}, [&](End end) {
      const Ring *ring = port_ring(outer.shape, end), *inner = port_ring(bore.shape, end);
      return ring == nullptr || inner == nullptr || outer.is_closed.at(at(end)) ||
             ring->center == inner->center;
    });
  }

  void note_buried(const EndIndex& end, BillRow& row) const {
    if (buried_->contains(end)) {
      std::string remark = "its ";
      remark.append(name(end.end)).append(" lies inside another part and is not trimmed here");
      row.remarks.push_back(std::move(remark));
    }
  }

  static void set_bend(const PartSurface& shape, BillRow& row) {
    const auto* chain = std::get_if<Chain>(&shape);
    if (chain == nullptr || chain->pieces.size() != 1) {
      return;
    }
    std::visit(
        [&row](const auto& tube) {
          if constexpr (requires { tube.spine; }) {
            if (const auto* arc = std::get_if<ArcSpine>(&tube.spine)) {
              row.bend_radius = (arc->start - arc->center).norm();
              row.bend_angle = arc->angle;
            }
          }
        },
        chain->pieces.front());
  }

  const Assembly& assembly_;
  ResolvedAssembly outer_;
  std::optional<BuriedEnds> buried_;
  std::optional<std::vector<double>> walls_;
  assembly::SelectedParts bore_;
  std::vector<BillRow> rows_;
};

}  // namespace

BillOfMaterials bill_of_materials(const Assembly& assembly) {
  const UsualArithmetic usual;
  return {assembly.source, assembly.unit, Biller(assembly).run()};
}

}  // namespace dupin
