#include "dupin/blends/drawing.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "assembly/bore.h"
#include "drawing/center_lines.h"
#include "drawing/contour_curves.h"
#include "drawing/linked_lines.h"
#include "drawing/polyline.h"
#include "drawing/smooth_joints.h"
#include "drawing/stretches.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/crease.h"
#include "dupin/kernel/hidden_lines.h"
#include "dupin/kernel/parallel.h"

namespace dupin {
namespace {

using Line = std::vector<Vec3>;

// Where surfaces meet at less, they count as tangent.
constexpr double kSmoothAngle = std::numbers::pi / 180;

TriMesh mesh_of(const Solid& solid) {
  return {solid.nearest_points(), solid.triangles(), solid.labels(), solid.names()};
}

// The lines of one part and kind, seen and hidden.
struct Lines {
  std::vector<Line> seen, hidden;
};

class Drawer {
 public:
  Drawer(const Assembly& assembly, const Built& built, const DrawingOptions& options)
      : options_(options),
        mesh_(mesh_of(built.solid)),
        hidden_lines_(mesh_, options.view),
        outer_(resolve(assembly)),
        is_fluid_(built.region == Region::fluid) {
    result_ = {assembly.source, assembly.unit, options.view, 0, {}};
    for (const PartReport& part : built.parts) {
      result_.error = std::max(result_.error, part.error_bound);
    }
    if (built.region == Region::insulation) {
      SmoothRegion region = smooth_region(assembly, built);
      outer_ = std::move(region.whole);
      bore_ = std::move(region.inside);
      return;
    }
    const auto walls = built.region == Region::outer
                           ? std::nullopt
                           : assembly::walls_of(assembly, outer_, built.region);
    if (!walls) {
      bore_.parts = inner_skins(outer_);
    }
    outer_ = assembly::filled(std::move(outer_));
    if (walls) {
      bore_ = assembly::bore_of(assembly, outer_, *walls).resolved;
    }
  }

  Drawing run() {
    if (!is_fluid_) {
      add_contours(drawing::contours_of(outer_, options_.view.towards, result_.error, false));
    }
    add_contours(drawing::contours_of(bore_, options_.view.towards, result_.error, !is_fluid_));
    add_edges();
    for (const drawing::PartAxis& axis : drawing::axes_of(outer_, result_.error)) {
      result_.parts.push_back(drawn_part(axis));
      if (options_.center) {
        add_center(axis);
      }
    }
    return std::move(result_);
  }

 private:
  // Of chains that have a wall of their own, and are hollow in any region.
  static std::vector<ResolvedPart> inner_skins(const ResolvedAssembly& assembly) {
    std::vector<ResolvedPart> result;
    for (const ResolvedPart& part : assembly.parts) {
      const auto* chain = std::get_if<Chain>(&part.shape);
      if (chain != nullptr && chain->wall > 0) {
        result.push_back({part.name, part.kind, part.index, inner_skin(*chain)});
      }
    }
    return result;
  }

  // Lines are moved off the surface by this, so that it does not hide them where it is a mesh's.
  [[nodiscard]] double reach() const { return 2 * result_.error; }

  static Line moved(const drawing::ZeroLine& curve, double distance) {
    Line result(curve.size());
    std::ranges::transform(curve, result.begin(), [&](const drawing::ZeroPoint& point) {
      return Vec3(point.position + distance * point.normal);
    });
    return result;
  }

  // The line is on the surface where there is none of the solid outside of it, and some inside.
  [[nodiscard]] Lines divided(const drawing::ZeroLine& curve) const {
    const Line line = moved(curve, 0);
    const auto end = static_cast<double>(line.size() - 1);
    const SeenLine outside = hidden_lines_.seen(moved(curve, reach()), reach());
    const SeenLine inside = hidden_lines_.seen(moved(curve, -reach()), reach());
    return divided(
        line, drawing::intersection(inside.inside, drawing::complement(outside.inside, end)),
        drawing::intersection(drawing::complement(outside.covered, end), convex(curve)), reach());
  }

  // Where the surface curves away from the viewer's ray; elsewhere it hides itself.
  static std::vector<Stretch> convex(const drawing::ZeroLine& curve) {
    std::vector<Stretch> result;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      const double at_start = curve[i].curvature, at_end = curve[i + 1].curvature;
      const double turn = double(i) + at_start / (at_start - at_end);
      if (at_start > 0 || at_end > 0) {
        const Stretch own{at_start > 0 ? double(i) : turn, at_end > 0 ? double(i + 1) : turn};
        if (!result.empty() && result.back().to == own.from) {
          result.back().to = own.to;
        } else {
          result.push_back(own);
        }
      }
    }
    return result;
  }

  // What of the line is on the surface, seen and not, without stretches shorter than `least`.
  [[nodiscard]] Lines divided(const Line& line, const std::vector<Stretch>& on_surface,
                              const std::vector<Stretch>& open, double least) const {
    const auto pieces = [&](const std::vector<Stretch>& stretches) {
      std::vector<Line> result;
      for (const Stretch& one : drawing::intersection(on_surface, stretches)) {
        if (Line piece = drawing::cut(line, one); drawing::length(piece) >= least) {
          result.push_back(std::move(piece));
        }
      }
      return result;
    };
    const auto end = static_cast<double>(line.size() - 1);
    return {pieces(open),
            options_.hidden ? pieces(drawing::complement(open, end)) : std::vector<Line>()};
  }

  void add_contours(const std::vector<drawing::PartContours>& parts) {
    std::vector<std::pair<const std::string*, const drawing::ZeroLine*>> all;
    for (const drawing::PartContours& part : parts) {
      for (const drawing::ZeroLine& curve : part.curves) {
        all.emplace_back(&part.part, &curve);
      }
    }
    std::vector<Lines> found(all.size());
    for_each_in_parallel(all.size(), [&](std::size_t i) { found[i] = divided(*all[i].second); });
    std::map<std::string, Lines> of_part;
    for (std::size_t i = 0; i < all.size(); ++i) {
      append(std::move(found[i]), of_part[*all[i].first]);
    }
    add(of_part, LineKind::contour);
  }

  void add_edges() {
    std::set<drawing::NamePair> smooth = drawing::smooth_joints(outer_, kSmoothAngle);
    smooth.merge(drawing::smooth_joints(bore_, kSmoothAngle));
    const std::vector<Crease> creases =
        creases_between_labels(mesh_, kSmoothAngle, [&](std::uint32_t a, std::uint32_t b) {
          return !smooth.contains(drawing::name_pair(mesh_.names[a], mesh_.names[b]));
        });
    std::vector<Lines> found(creases.size());
    for_each_in_parallel(creases.size(), [&](std::size_t i) { found[i] = divided(creases[i]); });
    std::map<std::string, Lines> of_part;
    for (std::size_t i = 0; i < creases.size(); ++i) {
      const auto [first, second] = creases[i].triangles;
      const std::uint32_t label = std::min(mesh_.labels[first], mesh_.labels[second]);
      append(std::move(found[i]), of_part[mesh_.names[label]]);
    }
    add(of_part, LineKind::edge);
  }

  // An edge between two backs is hidden, however little of the solid is before it.
  [[nodiscard]] Lines divided(const Crease& crease) const {
    const auto [a, b] = crease.points;
    const Line line{mesh_.points[a], mesh_.points[b]};
    std::vector<Stretch> open;
    if (std::ranges::any_of(crease.triangles, [&](auto one) { return shows_front(one); })) {
      const Vec3 away = reach() * crease.outward;
      open = drawing::complement(
          hidden_lines_.seen(Line{line[0] + away, line[1] + away}, 0).covered, 1);
    }
    return divided(line, {{0, 1}}, open, 0);
  }

  [[nodiscard]] bool shows_front(std::uint32_t triangle) const {
    const auto& [a, b, c] = mesh_.triangles[triangle];
    const Vec3 normal =
        (mesh_.points[b] - mesh_.points[a]).cross(mesh_.points[c] - mesh_.points[a]);
    return normal.dot(options_.view.towards) > 0;
  }

  [[nodiscard]] Eigen::Vector2d in_picture(const Vec3& point) const {
    return options_.view(point).head<2>();
  }

  // At the middle of its axis' length.
  [[nodiscard]] DrawnPart drawn_part(const drawing::PartAxis& axis) const {
    double left = drawing::length(axis.line) / 2;
    Vec3 at = axis.line.front();
    for (std::size_t i = 1; i < axis.line.size() && left > 0; ++i) {
      const Vec3 step = axis.line[i] - axis.line[i - 1];
      const double share = step.norm() > 0 ? std::min(1.0, left / step.norm()) : 1;
      at = axis.line[i - 1] + share * step;
      left -= step.norm();
    }
    return {axis.part, in_picture(at), axis.diameters};
  }

  // An axis that is seen from its end is the cross of its circle.
  void add_center(const drawing::PartAxis& axis) {
    std::vector<Eigen::Vector2d> line(axis.line.size());
    std::ranges::transform(axis.line, line.begin(),
                           [&](const Vec3& point) { return in_picture(point); });
    if (axis.line.size() > 1 && drawing::length(line) > drawing::length(axis.line) / 1000) {
      result_.lines.push_back(
          {axis.part, LineKind::center, false, drawing::simplified(line, result_.error)});
      return;
    }
    const double reach = std::ranges::max(axis.diameters) / 2;
    for (const Eigen::Vector2d& arm : {Eigen::Vector2d(reach, 0), Eigen::Vector2d(0, reach)}) {
      result_.lines.push_back(
          {axis.part, LineKind::center, false, {line.front() - arm, line.front() + arm}});
    }
  }

  static void append(Lines from, Lines& to) {
    std::ranges::move(from.seen, std::back_inserter(to.seen));
    std::ranges::move(from.hidden, std::back_inserter(to.hidden));
  }

  void add(const std::map<std::string, Lines>& of_part, LineKind kind) {
    for (const auto& [part, lines] : of_part) {
      for (const bool hidden : {false, true}) {
        for (const Line& line : drawing::linked(hidden ? lines.hidden : lines.seen)) {
          add(line, part, kind, hidden);
        }
      }
    }
  }

  void add(const Line& line, const std::string& part, LineKind kind, bool hidden) {
    std::vector<Eigen::Vector2d> flat(line.size());
    std::ranges::transform(line, flat.begin(), [&](const Vec3& point) {
      return Eigen::Vector2d(options_.view(point).head<2>());
    });
    flat = drawing::simplified(flat, result_.error);
    const auto size = [&](const Eigen::Vector2d& point) { return (point - flat[0]).norm(); };
    if (std::ranges::max(flat, {}, size) != flat[0]) {
      result_.lines.push_back({part, kind, hidden, std::move(flat)});
    }
  }

  const DrawingOptions& options_;
  TriMesh mesh_;
  HiddenLines hidden_lines_;
  ResolvedAssembly outer_, bore_;
  bool is_fluid_;
  Drawing result_;
};

}  // namespace

Drawing draw(const Assembly& assembly, const Built& built, const DrawingOptions& options) {
  const UsualArithmetic usual;
  return Drawer(assembly, built, options).run();
}

}  // namespace dupin
