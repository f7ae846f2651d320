#include "exchange/bodies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "dupin/blends/cyclide_piece.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/error.h"
#include "text/label_colour.h"

namespace dupin::exchange {
namespace {

// Parts by the body that they belong to.
class Groups {
 public:
  explicit Groups(std::size_t count) : leader_(count) {
    std::iota(leader_.begin(), leader_.end(), std::size_t{0});
  }
  [[nodiscard]] std::size_t leader(std::size_t i) const {
    while (leader_[i] != i) {
      i = leader_[i];
    }
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    const std::size_t a = leader(i), b = leader(j);
    leader_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> leader_;
};

class BodyMaker {
 public:
  BodyMaker(const ResolvedAssembly& resolved, double tolerance, Labels& labels, SurfaceCount& count)
      : resolved_(resolved),
        buried_(resolved),
        tolerance_(tolerance),
        labels_(labels),
        count_(count) {}

  Body body(const std::vector<std::uint32_t>& parts) {
    body_ = {};
    rings_.clear();
    is_member_.assign(resolved_.parts.size(), false);
    for (const std::uint32_t part : parts) {
      is_member_[part] = true;
    }
    const std::string &first = resolved_.parts[parts.front()].name,
                      &last = resolved_.parts[parts.back()].name;
    body_.name = parts.size() == 1 ? first : first + " to " + last;
    for (const std::uint32_t part : parts) {
      try {
        append(part);
      } catch (const Error& error) {
        throw error.in_part(resolved_.parts[part].name);
      }
    }
    for (const ResolvedJunction& junction : resolved_.junctions) {
      if (is_member_[junction.arms.front()]) {
        append_hub(junction);
      }
    }
    return std::move(body_);
  }

 private:
  [[nodiscard]] bool is_joined(const EndIndex& end) const {
    const auto& other = resolved_.parts[end.part].joined.at(at(end.end));
    return other && is_member_[other->part];
  }

  // Both ends at a shared ring have the same.
  std::size_t ring_of(const EndIndex& end) {
    const auto key = [](const EndIndex& e) { return std::pair(e.part, at(e.end)); };
    const auto own = key(end);
    const auto shared = is_joined(end)
                            ? std::min(own, key(*resolved_.parts[end.part].joined.at(at(end.end))))
                            : own;
    const auto [entry, is_new] = rings_.try_emplace(shared, body_.rings.size());
    if (is_new) {
      body_.rings.push_back(ring_curve(*port_ring(resolved_.parts[end.part].shape, end.end)));
    }
    return entry->second;
  }

  std::size_t new_ring(const Ring& ring) {
    body_.rings.push_back(ring_curve(ring));
    return body_.rings.size() - 1;
  }

  void append(std::uint32_t index) {
    const ResolvedPart& part = resolved_.parts[index];
    const std::uint32_t label = labels_.label(part.name);
    if (const auto* ball = std::get_if<Sphere>(&part.shape)) {
      body_.hubs.push_back({label, ball->center, ball->radius, {}});
      ++count_.exact;
      return;
    }
    const auto& chain = std::get<Chain>(part.shape);
    if (chain.wall > 0 && !chain.closed) {
      append_hollow(index, chain);
      return;
    }
    const bool is_open = !chain.closed && port_ring(part.shape, End::start) != nullptr;
    append_pieces(chain, label, is_open ? std::optional(index) : std::nullopt, false);
    if (chain.wall > 0) {
      append_pieces(inner_skin(chain), label, std::nullopt, true);
    }
    if (is_open) {
      close(index, End::start);
      close(index, End::end);
    }
  }

  // Of a part whose ends others may share, or of none; returns the rings at both ends.
  std::pair<std::size_t, std::size_t> append_pieces(const Chain& chain, std::uint32_t label,
                                                    std::optional<std::uint32_t> part,
                                                    bool is_inside_out) {
    const std::size_t first =
        part ? ring_of({*part, End::start}) : new_ring(end_ring(chain, End::start));
    std::size_t last = first;
    for (std::size_t i = 0; i < chain.pieces.size(); ++i) {
      const bool is_last = i + 1 == chain.pieces.size();
      if (chain.joints == Joints::spherical && i > 0) {
        last = append_joint(std::get<CyclidePiece>(chain.pieces[i - 1]),
                            std::get<CyclidePiece>(chain.pieces[i]), label, last);
      }
      std::vector<PieceSurface> surfaces = piece_surfaces(chain.pieces[i], tolerance_, count_);
      for (std::size_t k = 0; k + 1 < surfaces.size(); ++k) {
        body_.rings.push_back(end_circle(std::get<NurbsSurface>(surfaces[k])));
        const std::size_t between = body_.rings.size() - 1;
        body_.tubes.push_back({label, last, between, std::move(surfaces[k]), is_inside_out});
        last = between;
      }
      const std::size_t next = is_last && chain.closed ? first
                               : is_last && part       ? ring_of({*part, End::end})
                                                 : new_ring(end_ring(chain.pieces[i], End::end));
      body_.tubes.push_back({label, last, next, std::move(surfaces.back()), is_inside_out});
      last = next;
    }
    return {first, last};
  }

  // What there is in the ball between two pieces, `first` being the ring at the end of the first.
  // Returns the ring where the second one starts.
  std::size_t append_joint(const CyclidePiece& before, const CyclidePiece& after,
                           std::uint32_t label, std::size_t first) {
    const SphericalJoint joint = spherical_joint(arc_of(before), arc_of(after));
    const Ring &end = before.end, &start = after.start;
    if (circle_distance(end, start) <= tolerance_) {
      return first;
    }
    body_.discs.push_back({label, first, end.normal});
    const std::size_t second = new_ring(start);
    body_.discs.push_back({label, second, start.normal});
    const bool is_hidden = joint.between <= std::abs(joint.before - joint.after) ||
                           joint.between + joint.before + joint.after >= 2 * std::numbers::pi;
    if (!is_hidden) {
      append_sector(joint, end, start, label);
    }
    return second;
  }

  // Beyond the ring of one piece's end and before that of the next one's start. Readers of STEP
  // take a lune that has a pole or crosses the seam for the rest of its sphere.
  void append_sector(const SphericalJoint& joint, const Ring& end, const Ring& start,
                     std::uint32_t label) {
    // The normals of rings at ends point out of their pieces.
    const Vec3 from = -end.normal, to = -start.normal;
    BallSector sector{label,
                      joint.sphere.m,
                      joint.sphere.r,
                      {ring_curve(Ring{end.center, from, end.radius}),
                       ring_curve(Ring{start.center, to, start.radius})},
                      from,
                      reference_axis(end)};
    if (!joint.is_clean()) {
      sector.seam = (from + to).normalized();
      sector.pole = sector.seam.cross(from.cross(to)).normalized();
    }
    body_.sectors.push_back(std::move(sector));
    ++count_.exact;
  }

  // Outside and inside, with conical rims.
  void append_hollow(std::uint32_t index, const Chain& chain) {
    const ResolvedPart& part = resolved_.parts[index];
    const std::uint32_t label = labels_.label(part.name);
    const auto outer = append_pieces(chain, label, std::nullopt, false);
    const auto inner = append_pieces(inner_skin(chain), label, std::nullopt, true);
    body_.tubes.push_back({labels_.label(part.end_names[0]), outer.first, inner.first,
                           Rim{end_ring(chain, End::start).normal}});
    body_.tubes.push_back({labels_.label(part.end_names[1]), outer.second, inner.second,
                           Rim{end_ring(chain, End::end).normal}});
    count_.exact += 2;
  }

  // Ends that are joined to a part of another body vanish in the union and need no name.
  void close(std::uint32_t index, End end) {
    const ResolvedPart& part = resolved_.parts[index];
    if (is_joined({index, end}) || (part.ends_in_hub && end == End::end)) {
      return;
    }
    const bool is_end = !part.joined.at(at(end)) && !buried_.contains({index, end});
    body_.discs.push_back({labels_.label(is_end ? part.end_names.at(at(end)) : part.name),
                           ring_of({index, end}), port_ring(part.shape, end)->normal});
    ++count_.exact;
  }

  void append_hub(const ResolvedJunction& junction) {
    HubFace hub{
        labels_.label(junction.name), junction.shape.hub.center, junction.shape.hub.radius, {}};
    for (const std::uint32_t arm : junction.arms) {
      hub.rings.push_back(ring_of({arm, End::end}));
    }
    body_.hubs.push_back(std::move(hub));
    ++count_.exact;
  }

  const ResolvedAssembly& resolved_;
  BuriedEnds buried_;
  double tolerance_;
  Labels& labels_;
  SurfaceCount& count_;
  Body body_;
  std::vector<bool> is_member_;
  std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> rings_;
};

bool has_constant_radius(const CanalFillet& loop) {
  return !std::holds_alternative<RationalCrossing>(loop.motion) &&
         !std::holds_alternative<RationalParallel>(loop.motion);
}

// Rolls along all edges between the two, as the fillets of a document do.
std::optional<RollingBall> rolling_ball(const Assembly& assembly, const ResolvedAssembly& resolved,
                                        const ResolvedFillet& fillet, double tolerance,
                                        Labels& labels, SurfaceCount& count) {
  if (fillet.shape.is_cope()) {
    return std::nullopt;
  }
  RollingBall ball{fillet.name,
                   labels.label(fillet.name),
                   {labels.label(resolved.parts[fillet.between[0]].name),
                    labels.label(resolved.parts[fillet.between[1]].name)},
                   {}};
  if (std::ranges::all_of(fillet.shape.loops, has_constant_radius)) {
    ball.radius = fillet.shape.radius;
  }
  for (const CanalFillet& loop : fillet.shape.loops) {
    try {
      const NurbsForm form = nurbs(loop, tolerance);
      ball.surfaces.insert(ball.surfaces.end(), form.surfaces.begin(), form.surfaces.end());
      (form.error_bound > 0 ? count.lofted : count.exact) += form.surfaces.size();
      ball.error = std::max(ball.error, form.error_bound);
    } catch (const Error& error) {
      throw Error(error.code(), error.message(), fillet.name,
                  document_place(assembly, fillet.index));
    }
  }
  count.error = std::max(count.error, ball.error);
  return ball;
}

}  // namespace

std::uint32_t Labels::label(const std::string& name) {
  const auto [known, is_new] = numbers_.try_emplace(name, std::uint32_t(names_.size()));
  if (is_new) {
    names_.push_back(name);
  }
  return known->second;
}

std::vector<Label> Labels::coloured(const std::map<std::string, std::string>& chosen,
                                    const std::map<std::string, std::string>& others) const {
  const std::vector<text::Colour> colours = text::label_colours(names_, chosen);
  std::vector<Label> labels;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const auto other = others.find(names_[i]);
    labels.push_back({other == others.end() ? names_[i] : other->second, colours[i]});
  }
  return labels;
}

BodyUnion bodies_of(const Assembly& assembly, const ResolvedAssembly& resolved, double tolerance,
                    bool is_by_part, Labels& labels, SurfaceCount& count) {
  Groups groups(resolved.parts.size());
  for (std::uint32_t i = 0; i < resolved.parts.size(); ++i) {
    for (const auto& other : resolved.parts[i].joined) {
      if (other && !is_by_part) {
        groups.join(i, other->part);
      }
    }
  }
  for (const ResolvedJunction& junction : resolved.junctions) {
    for (const std::uint32_t arm : junction.arms) {
      groups.join(junction.arms.front(), arm);
    }
  }
  std::map<std::size_t, std::vector<std::uint32_t>> members;
  for (std::uint32_t i = 0; i < resolved.parts.size(); ++i) {
    members[groups.leader(i)].push_back(i);
  }
  BodyUnion result;
  BodyMaker maker(resolved, tolerance, labels, count);
  for (const auto& [leader, parts] : members) {
    result.bodies.push_back(maker.body(parts));
  }
  for (const ResolvedFillet& fillet : resolved.fillets) {
    if (auto ball = rolling_ball(assembly, resolved, fillet, tolerance, labels, count)) {
      result.fillets.push_back(std::move(*ball));
    }
  }
  return result;
}

void scale(NurbsSurface& surface, double factor) {
  for (auto& row : surface.net) {
    for (auto& point : row) {
      for (std::size_t i = 0; i < 3; ++i) {
        point.at(i) *= factor;
      }
    }
  }
}

void scale(BodyUnion& bodies, double factor) {
  const auto scale_ring = [&](RingCurve& ring) {
    ring.center *= factor;
    ring.first *= factor;
    ring.second *= factor;
  };
  for (Body& body : bodies.bodies) {
    std::ranges::for_each(body.rings, scale_ring);
    for (TubeFace& tube : body.tubes) {
      if (auto* nurbs = std::get_if<NurbsSurface>(&tube.surface)) {
        scale(*nurbs, factor);
      } else if (auto* torus = std::get_if<TorusArc>(&tube.surface)) {
        torus->center *= factor;
      }
    }
    for (HubFace& hub : body.hubs) {
      hub.center *= factor;
      hub.radius *= factor;
    }
    for (BallSector& sector : body.sectors) {
      sector.center *= factor;
      sector.radius *= factor;
      std::ranges::for_each(sector.cuts, scale_ring);
    }
  }
  for (RollingBall& ball : bodies.fillets) {
    ball.radius = ball.radius ? std::optional(*ball.radius * factor) : std::nullopt;
    ball.error *= factor;
    for (NurbsSurface& surface : ball.surfaces) {
      scale(surface, factor);
    }
  }
}

}  // namespace dupin::exchange
