#include "dupin/blends/tessellate.h"

#include <algorithm>
#include <span>

#include "cyclide/require_pieces.h"
#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/error.h"
#include "dupin/kernel/parallel.h"
#include "surfaces/kneecap_chain_mesh.h"
#include "surfaces/pieces/surface_piece.h"
#include "tessellation/convex_fill.h"

namespace dupin {
namespace {

// Pieces of a chain from one polygon to another: one, or several that are swept together.
struct Run {
  std::size_t first = 0, count = 1;
};

template <class P>
Run run_from(const Chain& chain, std::size_t first, const P&) {
  Run run{first, 1};
  if constexpr (surfaces::SweptTogether<P>) {
    while (first + run.count < chain.pieces.size() &&
           std::holds_alternative<P>(chain.pieces[first + run.count])) {
      ++run.count;
    }
  }
  return run;
}

std::vector<Run> runs(const Chain& chain) {
  std::vector<Run> result;
  for (std::size_t i = 0; i < chain.pieces.size(); i += result.back().count) {
    result.push_back(
        std::visit([&](const auto& p) { return run_from(chain, i, p); }, chain.pieces[i]));
  }
  return result;
}

// What `work` makes of the run's only piece, or of all its pieces.
template <class Work>
auto of_run(const Chain& chain, const Run& run, const Work& work) {
  const auto visitor = [&]<class P>(const P& piece) {
    if constexpr (surfaces::SweptTogether<P>) {
      std::vector<P> pieces;
      for (std::size_t i = 0; i < run.count; ++i) {
        pieces.push_back(std::get<P>(chain.pieces[run.first + i]));
      }
      return work(std::span<const P>(pieces));
    } else {
      return work(piece);
    }
  };
  return std::visit(visitor, chain.pieces[run.first]);
}

struct RunMesher {
  const RingSampling& sampling;
  const TessellationOptions& options;

  template <class Pieces>
  Tessellation operator()(const Pieces& pieces) const {
    return surfaces::tessellate(pieces, sampling, options);
  }
};

struct RunSegments {
  double tolerance, grid;

  template <class Pieces>
  std::uint32_t operator()(const Pieces& pieces) const {
    return surfaces::segments_for(pieces, tolerance, grid);
  }
};

// Polygons of one ring are the same, counted from different corners: which of them is this one.
std::uint32_t corner_of(std::span<const Vec3> polygon, const Vec3& point) {
  return std::uint32_t(std::find(polygon.begin(), polygon.end(), point) - polygon.begin());
}

// The mesh's last row and the piece's first one are the same polygon, counted from different
// corners: vertices of the piece in the mesh.
std::vector<std::uint32_t> appended_vertices(TriMesh& mesh, const TriMesh& piece,
                                             std::uint32_t segments) {
  const auto row = std::uint32_t(mesh.points.size()) - segments;
  const auto offset = corner_of(std::span(piece.points).first(segments), mesh.points[row]);
  std::vector<std::uint32_t> vertices(piece.points.size());
  for (std::uint32_t i = 0; i < segments; ++i) {
    vertices[(i + offset) % segments] = row + i;
  }
  for (std::uint32_t i = segments; i < piece.points.size(); ++i) {
    vertices[i] = std::uint32_t(mesh.points.size());
    mesh.points.push_back(piece.points[i]);
  }
  return vertices;
}

// The last row's points become those of the first.
void close(TriMesh& mesh, std::uint32_t segments) {
  const auto row = std::uint32_t(mesh.points.size()) - segments;
  const auto offset = corner_of(std::span(mesh.points).first(segments), mesh.points[row]);
  for (auto& triangle : mesh.triangles) {
    for (auto& vertex : triangle) {
      vertex = vertex < row ? vertex : (vertex - row + offset) % segments;
    }
  }
  mesh.points.resize(row);
}

void append(const Tessellation& next, std::size_t first, std::uint32_t segments,
            Tessellation& result) {
  const auto vertices = appended_vertices(result.mesh, next.mesh, segments);
  for (const auto& [a, b, c] : next.mesh.triangles) {
    result.mesh.triangles.push_back({vertices[a], vertices[b], vertices[c]});
  }
  const bool has_knots = !result.knots.empty() && !next.knots.empty();
  for (std::size_t k = 1; has_knots && k < next.knots.size(); ++k) {
    result.knots.push_back(double(first) + next.knots[k]);
  }
  result.knots.resize(has_knots ? result.knots.size() : 0);
  result.bands += next.bands;
  result.error_bound = std::max(result.error_bound, next.error_bound);
  result.axes = std::max(result.axes, next.axes);
}

Tessellation skin(const Chain& chain, const RingSampling& sampling,
                  const TessellationOptions& options) {
  const std::vector<Run> all = runs(chain);
  std::vector<Tessellation> meshes(all.size());
  for_each_in_parallel(all.size(), [&](std::size_t i) {
    meshes[i] = of_run(chain, all[i], RunMesher{sampling, options});
  });
  Tessellation result = std::move(meshes.front());
  for (std::size_t i = 1; i < all.size(); ++i) {
    append(meshes[i], all[i].first, sampling.segments, result);
  }
  if (chain.closed) {
    close(result.mesh, sampling.segments);
  }
  return result;
}

// Which point of the last ring's own sample the mesh's last row begins with.
std::uint32_t last_shift(const Tessellation& skin, const Chain& chain,
                         const RingSampling& sampling) {
  return corner_of(sample(end_ring(chain, End::end), sampling),
                   skin.mesh.points[skin.mesh.points.size() - sampling.segments]);
}

// Inside out.
void append_backward(const TriMesh& mesh, TriMesh& result) {
  const auto offset = std::uint32_t(result.points.size());
  result.points.insert(result.points.end(), mesh.points.begin(), mesh.points.end());
  for (const auto& [a, b, c] : mesh.triangles) {
    result.triangles.push_back({offset + a, offset + c, offset + b});
  }
}

// The inner skin inside out and the conical rims between the two: straight rulings, so that their
// quadrilaterals are as near to the cone as the outer circle's chords to it.
//
// Point i of the outer last row faces point i + turn of the inner one.
Tessellation hollow(Tessellation outer, const Tessellation& inner, std::uint32_t segments,
                    std::uint32_t turn) {
  const auto offset = std::uint32_t(outer.mesh.points.size());
  const auto last = offset - segments;
  const auto inner_last = std::uint32_t(inner.mesh.points.size()) - segments;
  TriMesh& mesh = outer.mesh;
  append_backward(inner.mesh, mesh);
  mesh.labels.assign(mesh.triangles.size(), 0);
  const auto quadrilateral = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                                 std::uint32_t label) {
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    mesh.labels.insert(mesh.labels.end(), 2, label);
  };
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t k = (i + 1) % segments;
    quadrilateral(k, i, offset + i, offset + k, 1);
  }
  for (std::uint32_t i = 0; i < segments; ++i) {
    const std::uint32_t k = (i + 1) % segments;
    quadrilateral(last + i, last + k, offset + inner_last + (k + turn) % segments,
                  offset + inner_last + (i + turn) % segments, 2);
  }
  outer.error_bound = std::max(outer.error_bound, inner.error_bound);
  outer.bands += inner.bands;
  outer.knots.clear();  // the skins have their own
  return outer;
}

// Meshes that overlap have no common rims: each skin is closed with the inner polygons' discs, the
// outer one with the rims to these, so that one taken from the other leaves the rims.
class OverlappingWall {
 public:
  OverlappingWall(Tessellation outer, Tessellation inner, std::uint32_t segments)
      : result_(std::move(outer)), inner_(std::move(inner)), n_(segments) {}

  Tessellation closed(const Chain& chain, const Chain& inside, const RingSampling& sampling) {
    const auto shift = [&](const Tessellation& of, const Chain& skin) {
      return last_shift(of, skin, sampling);
    };
    const std::uint32_t outer_shift = shift(result_, chain), inner_shift = shift(inner_, inside);
    TriMesh& mesh = result_.mesh;
    const auto outer_last = std::uint32_t(mesh.points.size()) - n_;
    const auto inner_last = std::uint32_t(inner_.mesh.points.size()) - n_;
    mesh.labels.assign(mesh.triangles.size(), 0);
    const auto outer_end = [=, this](std::uint32_t i) {
      return outer_last + (i + n_ - outer_shift) % n_;
    };
    const auto inner_end = [=, this](std::uint32_t i) {
      return inner_last + (i + n_ - inner_shift) % n_;
    };
    // Seen from outside, the start's polygon runs clockwise.
    close([this](std::uint32_t i) { return (n_ - i) % n_; },
          [this](std::uint32_t i) { return (n_ - i) % n_; }, 1);
    close(outer_end, inner_end, 2);
    append_backward(inner_.mesh, mesh);
    mesh.labels.resize(mesh.triangles.size(), 0);
    result_.error_bound = std::max(result_.error_bound, inner_.error_bound);
    result_.bands += inner_.bands;
    return std::move(result_);
  }

 private:
  // Corner i of both polygons, counter-clockwise from outside.
  template <class Outer, class Inner>
  void close(const Outer& outer, const Inner& inner, std::uint32_t label) {
    TriMesh& mesh = result_.mesh;
    const auto disc = std::uint32_t(mesh.points.size());
    for (std::uint32_t i = 0; i < n_; ++i) {
      mesh.points.push_back(inner_.mesh.points[inner(i)]);
    }
    for (std::uint32_t i = 0; i < n_; ++i) {
      const std::uint32_t k = (i + 1) % n_;
      mesh.triangles.push_back({outer(i), outer(k), disc + k});
      mesh.triangles.push_back({outer(i), disc + k, disc + i});
    }
    std::vector<Triangle> corners;
    tessellation::fill(0, n_ - 1, corners);
    for (const auto& [a, b, c] : corners) {
      mesh.triangles.push_back({disc + a, disc + b, disc + c});
      inner_.mesh.triangles.push_back({inner(a), inner(b), inner(c)});
    }
    mesh.labels.resize(mesh.triangles.size(), label);
  }

  Tessellation result_, inner_;
  std::uint32_t n_;
};

// Pieces that overlap each other, open at the chain's ends.
Tessellation overlapping(const Chain& chain, const RingSampling& sampling,
                         const TessellationOptions& options) {
  return surfaces::kneecap_chain_mesh(end_ring(chain, End::start), end_ring(chain, End::end),
                                      cyclide_pieces(chain), sampling, options)
      .tessellation;
}

}  // namespace

std::uint32_t segments_for(const Chain& chain, double tolerance, double grid) {
  if (chain.joints == Joints::spherical) {
    return surfaces::kneecap_chain_segments(cyclide_pieces(chain), tolerance, grid);
  }
  std::uint32_t most = 0;
  for (const Run& run : runs(chain)) {
    most = std::max(most, of_run(chain, run, RunSegments{tolerance, grid}));
  }
  return most;
}

Tessellation tessellate(const Chain& chain, const RingSampling& sampling,
                        const TessellationOptions& options) {
  cyclide::require_pieces(chain);
  const bool overlaps = chain.joints == Joints::spherical;
  if (chain.wall == 0) {
    return overlaps ? overlapping(chain, sampling, options) : skin(chain, sampling, options);
  }
  const Chain inside = inner_skin(chain);
  if (overlaps) {
    return OverlappingWall(overlapping(chain, sampling, options),
                           overlapping(inside, sampling, options), sampling.segments)
        .closed(chain, inside, sampling);
  }
  Tessellation outer = skin(chain, sampling, options);
  const Tessellation inner = skin(inside, sampling, options);
  const std::uint32_t turn =
      sampling.segments + last_shift(outer, chain, sampling) - last_shift(inner, inside, sampling);
  return hollow(std::move(outer), inner, sampling.segments, turn);
}

}  // namespace dupin
