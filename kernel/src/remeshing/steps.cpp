#include "remeshing/steps.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "remeshing/batch.h"
#include "support/sequences.h"

namespace dupin::remeshing {
namespace {

/// Edges are split above, and collapsed below, these multiples of the wanted length [Botsch and
/// Kobbelt 2004].
constexpr double kTooLong = 4.0 / 3, kTooShort = 4.0 / 5;
/// What an edge may be made as long as by a collapse that a poor triangle asks for.
constexpr double kStretched = 2;
/// The share of the distance that the edges of curves may take.
constexpr double kCurveShare = 0.8;
constexpr int kMostRounds = 12;
/// Rounds end when they make fewer edits than one for so many triangles: later passes make the
/// rest.
constexpr std::size_t kFew = 300;

template <class Kind>
std::size_t run(Workshop& shop, const Kind& kind, int rounds = kMostRounds) {
  const std::size_t least = shop.mesh.alive_count() / kFew;
  Pass pass(shop.mesh);
  std::size_t all = 0, made = 0;
  do {
    made = pass.round(kind());
    all += made;
  } while (made > least && --rounds > 0);
  return all;
}

const Curve& curve_of(const Workshop& shop, const Span& span) {
  return shop.features.curves[span.curve];
}

bool is_near_curve(const Workshop& shop, const Span& span, const Vec3& a, const Vec3& b) {
  return curve_of(shop, span).deviation(span.from, span.to, a, b) <=
         kCurveShare * shop.limits.distance;
}

/// The two faces at an edge from a to b, and their far corners.
struct EdgeSides {
  std::uint32_t left, right;
  int at_a, at_b;  // a's place in the left one, b's in the right one
  std::uint32_t c, d;
};

EdgeSides sides_of(const WorkingMesh& mesh, std::uint32_t a, std::uint32_t b) {
  const WorkingMesh::Side left = *mesh.side(a, b), right = *mesh.side(b, a);
  return {left.face,
          right.face,
          left.corner,
          right.corner,
          mesh.face(left.face).corners[(left.corner + 2) % 3],
          mesh.face(right.face).corners[(right.corner + 2) % 3]};
}

// ---- splits

Edit split_at(const Workshop& shop, std::uint32_t a, std::uint32_t b, const WorkingPoint& added,
              double length) {
  const EdgeSides at = sides_of(shop.mesh, a, b);
  Edit edit{{at.left, at.right}, {}, added, {}};
  for (const auto& [number, corner] : {std::pair(at.left, at.at_a), std::pair(at.right, at.at_b)}) {
    const Face& face = shop.mesh.face(number);
    const Span& span = face.spans[corner];
    const Span toward{span.curve, span.from, length}, away{span.curve, length, span.to};
    const std::uint32_t u = face.corners[corner], v = face.corners[(corner + 1) % 3],
                        w = face.corners[(corner + 2) % 3];
    edit.after.push_back(
        {{u, kAdded, w}, {toward, {}, face.spans[(corner + 2) % 3]}, face.region, face.parent});
    edit.after.push_back(
        {{kAdded, v, w}, {away, face.spans[(corner + 1) % 3], {}}, face.region, face.parent});
  }
  return edit;
}

/// Splits a sharp edge at a length along its curve.
std::optional<Edit> split_curve(const Workshop& shop, std::uint32_t a, std::uint32_t b,
                                const Span& span, double length) {
  const WorkingMesh& mesh = shop.mesh;
  WorkingPoint added;
  added.freedom = Freedom::curve;
  added.place = curve_of(shop, span).at(length);
  added.wish = shop.field.on_curve(added.place, span.curve, length);
  added.size = std::min(added.wish, std::max(mesh.point(a).size, mesh.point(b).size));
  Edit edit = split_at(shop, a, b, added, length);
  if (added.place == mesh.place(a) || added.place == mesh.place(b) ||
      !EditCheck(shop, edit).keeps_sides()) {
    return std::nullopt;
  }
  return edit;
}

std::optional<Edit> split_smooth(const Workshop& shop, std::uint32_t a, std::uint32_t b) {
  const WorkingMesh& mesh = shop.mesh;
  const Face& face = mesh.face(mesh.side(a, b)->face);
  const Vec3 middle = (mesh.place(a) + mesh.place(b)) / 2;
  const auto [p, q, r] = mesh.places(face.corners);
  WorkingPoint added;
  added.place = middle;
  const auto nearest = shop.reference.nearest(middle, face.region, (q - p).cross(r - p),
                                              shop.limits.distance, 2 * mesh.length(a, b));
  if (nearest) {
    added.place = nearest->point;
  }
  added.wish = shop.field.in_region(added.place, face.region);
  added.size = std::min(added.wish, std::max(mesh.point(a).size, mesh.point(b).size));
  Edit edit = split_at(shop, a, b, added, 0);
  for (Face& part : edit.after) {
    for (Span& span : part.spans) {
      if (!span.is_sharp()) {
        span = {};
      }
    }
  }
  if (!EditCheck(shop, edit).keeps_sides()) {
    edit.added->place = middle;
  }
  return edit;
}

std::optional<Edit> build_split(const Workshop& shop, std::uint32_t a, std::uint32_t b) {
  const WorkingMesh::Side side = *shop.mesh.side(a, b);
  const Span& span = shop.mesh.face(side.face).spans[side.corner];
  return span.is_sharp() ? split_curve(shop, a, b, span, (span.from + span.to) / 2)
                         : split_smooth(shop, a, b);
}

// ---- collapses

/// Whether contracting the edge keeps a manifold: the ends have two neighbours in common, and do
/// not make up a tetrahedron with them [DEGN99].
bool is_linked(const WorkingMesh& mesh, std::uint32_t from, std::uint32_t to) {
  const auto mine = mesh.neighbours(from), others = mesh.neighbours(to);
  std::vector<std::uint32_t> common;
  std::set_intersection(mine.begin(), mine.end(), others.begin(), others.end(),
                        std::back_inserter(common));
  return common.size() == 2 && !(mine.size() == 3 && others.size() == 3);
}

/// The edit that puts a point on its neighbour; none if sharp edges or the surface's kind forbid
/// it.
class Collapse {
 public:
  Collapse(const Workshop& shop, std::uint32_t from, std::uint32_t to)
      : shop_(shop), mesh_(shop.mesh), from_(from), to_(to), edge_(mesh_.side(from, to)) {}

  [[nodiscard]] std::optional<Edit> edit() {
    if (!edge_) {
      return std::nullopt;
    }
    const Freedom freedom = mesh_.point(from_).freedom;
    along_ = mesh_.face(edge_->face).spans[edge_->corner];
    if (freedom == Freedom::none || (freedom == Freedom::curve && !along_.is_sharp()) ||
        !is_linked(mesh_, from_, to_)) {
      return std::nullopt;
    }
    Edit edit;
    edit.before.assign(mesh_.around(from_).begin(), mesh_.around(from_).end());
    for (const std::uint32_t f : edit.before) {
      const Face& face = mesh_.face(f);
      if (face.corner(to_) >= 0) {
        continue;
      }
      const auto replaced = without_from(face);
      if (!replaced) {
        return std::nullopt;
      }
      edit.after.push_back(*replaced);
    }
    return edit;
  }

 private:
  [[nodiscard]] std::optional<Face> without_from(Face face) const {
    const int i = face.corner(from_);
    face.corners[i] = to_;
    for (const int k : {i, (i + 2) % 3}) {  // the edges that leave and enter the point
      const bool leaves = k == i;
      const std::uint32_t other = face.corners[leaves ? (i + 1) % 3 : (i + 2) % 3];
      // Of the face that vanishes, if there is one between.
      const auto gone = leaves ? mesh_.side(other, from_) : mesh_.side(from_, other);
      const Face& beside = mesh_.face(gone->face);
      Span taken;
      if (const int at = beside.corner(to_); at >= 0) {
        taken = leaves ? beside.spans[at] : beside.spans[(at + 2) % 3];
      }
      if (face.spans[k].is_sharp()) {
        if (beside.corner(to_) >= 0) {
          return std::nullopt;  // an ear between two sharp edges
        }
        const Span merged = leaves ? Span{along_.curve, along_.to, face.spans[k].to}
                                   : Span{along_.curve, face.spans[k].from, along_.to};
        const Vec3 &p = mesh_.place(to_), &q = mesh_.place(other);
        if (face.spans[k].curve != along_.curve ||
            !is_near_curve(shop_, merged, leaves ? p : q, leaves ? q : p)) {
          return std::nullopt;
        }
        taken = merged;
      }
      face.spans[k] = taken;
    }
    return face;
  }

  const Workshop& shop_;
  const WorkingMesh& mesh_;
  std::uint32_t from_, to_;
  std::optional<WorkingMesh::Side> edge_;
  Span along_;
};

std::optional<Edit> build_collapse(const Workshop& shop, std::uint32_t from, std::uint32_t to,
                                   double longest, double least_sine) {
  auto edit = Collapse(shop, from, to).edit();
  if (!edit) {
    return std::nullopt;
  }
  const EditCheck check(shop, *edit);
  if (check.smallest_sine() < least_sine ||
      check.longest_edge_ratio() > std::max(longest, check.longest_edge_ratio_before()) ||
      !check.keeps_sides() || !check.stays_near()) {
    return std::nullopt;
  }
  return edit;
}

Claim collapse_claim(const WorkingMesh& mesh, std::uint32_t from) {
  Claim claim{{}, mesh.neighbours(from), {}};
  claim.faces.assign(mesh.around(from).begin(), mesh.around(from).end());
  claim.needs.push_back(from);
  claim.marks = claim.needs;
  return claim;
}

Claim edge_claim(const WorkingMesh& mesh, std::uint32_t a, std::uint32_t b) {
  return {{mesh.side(a, b)->face, mesh.side(b, a)->face}, {}, {}};
}

// ---- flips

/// By how much the flip of an edge, looked at from its lower end, makes the smallest sine smaller;
/// none if it does not make it larger.
std::optional<double> loss_by_flip(const WorkingMesh& mesh, std::uint32_t f, int i) {
  const Face& face = mesh.face(f);
  const std::uint32_t a = face.corners[i], b = face.corners[(i + 1) % 3];
  if (a > b || face.spans[i].is_sharp()) {
    return std::nullopt;
  }
  const EdgeSides at = sides_of(mesh, a, b);
  const Vec3 &pa = mesh.place(a), &pb = mesh.place(b), &pc = mesh.place(at.c),
             &pd = mesh.place(at.d);
  const double before = std::min(smallest_sine({pa, pb, pc}), smallest_sine({pb, pa, pd}));
  const double after = std::min(smallest_sine({pa, pd, pc}), smallest_sine({pd, pb, pc}));
  if (at.c == at.d || !(after > before * 1.001)) {
    return std::nullopt;
  }
  return before - after;
}

std::optional<Edit> build_flip(const Workshop& shop, std::uint32_t a, std::uint32_t b) {
  const WorkingMesh& mesh = shop.mesh;
  const EdgeSides at = sides_of(mesh, a, b);
  if (at.c == at.d || mesh.side(at.c, at.d) || mesh.side(at.d, at.c)) {
    return std::nullopt;
  }
  const Face &left = mesh.face(at.left), &right = mesh.face(at.right);
  const auto span = [](const Face& face, int corner) { return face.spans[corner % 3]; };
  Edit edit{{at.left, at.right}, {}, {}, {}};
  edit.after.push_back({{a, at.d, at.c},
                        {span(right, at.at_b + 1), {}, span(left, at.at_a + 2)},
                        left.region,
                        left.parent});
  edit.after.push_back({{at.d, b, at.c},
                        {span(right, at.at_b + 2), span(left, at.at_a + 1), {}},
                        right.region,
                        right.parent});
  const EditCheck check(shop, edit);
  if (!check.keeps_sides() || !check.stays_near()) {
    return std::nullopt;
  }
  return edit;
}

bool is_poor(const Workshop& shop, std::uint32_t f) {
  return shop.mesh.alive(f) && smallest_sine(shop.mesh, f) < shop.least_sine;
}

int longest_edge(const WorkingMesh& mesh, const Face& face) {
  int longest = 0;
  for (int i = 1; i < 3; ++i) {
    if (mesh.length(face.corners[i], face.corners[(i + 1) % 3]) >
        mesh.length(face.corners[longest], face.corners[(longest + 1) % 3])) {
      longest = i;
    }
  }
  return longest;
}

}  // namespace

std::size_t split_long_edges(Workshop& shop) {
  const WorkingMesh& mesh = shop.mesh;
  return run(
      shop,
      [&] {
        EditKind kind;
        kind.collect = [&](std::uint32_t f, std::vector<Candidate>& found) {
          for (int i = 0; mesh.alive(f) && i < 3; ++i) {
            const std::uint32_t a = mesh.face(f).corners[i], b = mesh.face(f).corners[(i + 1) % 3];
            const double ratio = mesh.length(a, b) / mesh.wanted_length(a, b);
            if (a < b && ratio > kTooLong) {
              found.push_back({-ratio, a, b});
            }
          }
        };
        kind.claim = [&](const Candidate& at) { return edge_claim(mesh, at.from, at.to); };
        kind.build = [&](const Candidate& at) { return build_split(shop, at.from, at.to); };
        return kind;
      },
      2);
}

std::size_t collapse_short_edges(Workshop& shop) {
  const WorkingMesh& mesh = shop.mesh;
  return run(shop, [&] {
    EditKind kind;
    kind.collect = [&](std::uint32_t f, std::vector<Candidate>& found) {
      for (int i = 0; mesh.alive(f) && i < 3; ++i) {
        const std::uint32_t a = mesh.face(f).corners[i], b = mesh.face(f).corners[(i + 1) % 3];
        const double ratio = mesh.length(a, b) / mesh.wanted_length(a, b);
        const Freedom mine = mesh.point(a).freedom;
        if (ratio < kTooShort && (mine == Freedom::region ||
                                  (mine == Freedom::curve && mesh.face(f).spans[i].is_sharp()))) {
          // The freer end goes.
          const double rank = mine > mesh.point(b).freedom ? 1 : 0;
          found.push_back({ratio + rank, a, b});
        }
      }
    };
    kind.claim = [&](const Candidate& at) { return collapse_claim(mesh, at.from); };
    kind.build = [&](const Candidate& at) {
      const double before = smallest_sine_around(mesh, at.from);
      return build_collapse(shop, at.from, at.to, kTooLong, std::min(0.3 * before, 0.1));
    };
    return kind;
  });
}

std::size_t flip_edges(Workshop& shop) {
  const WorkingMesh& mesh = shop.mesh;
  return run(
      shop,
      [&] {
        EditKind kind;
        kind.collect = [&](std::uint32_t f, std::vector<Candidate>& found) {
          for (int i = 0; mesh.alive(f) && i < 3; ++i) {
            if (const auto flip = loss_by_flip(mesh, f, i)) {
              found.push_back({*flip, mesh.face(f).corners[i], mesh.face(f).corners[(i + 1) % 3]});
            }
          }
        };
        kind.claim = [&](const Candidate& at) {
          Claim claim = edge_claim(mesh, at.from, at.to);
          const EdgeSides sides = sides_of(mesh, at.from, at.to);
          claim.needs = claim.marks = {at.from, at.to, sides.c, sides.d};
          return claim;
        };
        kind.build = [&](const Candidate& at) { return build_flip(shop, at.from, at.to); };
        return kind;
      },
      12);
}

std::size_t collapse_poor(Workshop& shop) {
  const WorkingMesh& mesh = shop.mesh;
  return run(shop, [&] {
    EditKind kind;
    kind.collect = [&](std::uint32_t f, std::vector<Candidate>& found) {
      if (!is_poor(shop, f)) {
        return;
      }
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t a = mesh.face(f).corners[i], b = mesh.face(f).corners[(i + 1) % 3];
        const double ratio = mesh.length(a, b) / mesh.wanted_length(a, b);
        found.push_back({ratio, a, b});
        found.push_back({ratio, b, a});
      }
    };
    kind.claim = [&](const Candidate& at) { return collapse_claim(mesh, at.from); };
    kind.build = [&](const Candidate& at) {
      const double before = smallest_sine_around(mesh, at.from);
      return build_collapse(shop, at.from, at.to, kStretched,
                            std::min(before * 1.01, shop.least_sine));
    };
    return kind;
  });
}

std::size_t split_below_poor(Workshop& shop) {
  const WorkingMesh& mesh = shop.mesh;
  return run(
      shop,
      [&] {
        EditKind kind;
        kind.collect = [&](std::uint32_t f, std::vector<Candidate>& found) {
          if (!is_poor(shop, f)) {
            return;
          }
          const Face& face = mesh.face(f);
          const int i = longest_edge(mesh, face);
          const std::uint32_t a = face.corners[i], b = face.corners[(i + 1) % 3];
          if (face.spans[i].is_sharp()) {
            found.push_back({smallest_sine(mesh, f), a, b});
          }
        };
        kind.claim = [&](const Candidate& at) { return edge_claim(mesh, at.from, at.to); };
        kind.build = [&](const Candidate& at) -> std::optional<Edit> {
          const WorkingMesh::Side side = *mesh.side(at.from, at.to);
          const Face& face = mesh.face(side.face);
          const Span& span = face.spans[side.corner];
          const Vec3 &a = mesh.place(at.from), &b = mesh.place(at.to),
                     &apex = mesh.place(face.corners[(side.corner + 2) % 3]);
          const double share = (apex - a).dot(b - a) / (b - a).squaredNorm();
          if (!(share > 0.1 && share < 0.9) ||
              mesh.length(at.from, at.to) < 2 * shop.limits.smallest) {
            return std::nullopt;
          }
          return split_curve(shop, at.from, at.to, span, span.from + share * (span.to - span.from));
        };
        return kind;
      },
      1);
}

}  // namespace dupin::remeshing
