#include "dupin/blends/tessellate.h"

#include <algorithm>
#include <span>

#include "dupin/blends/cyclide_tube.h"
#include "dupin/kernel/error.h"
#include "surfaces/kneecap_chain_mesh.h"
#include "surfaces/surface_piece.h"

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
}

Tessellation skin(const Chain& chain, const RingSampling& sampling,
                  const TessellationOptions& options) {
  Tessellation result;
  for (const Run& run : runs(chain)) {
    Tessellation next = of_run(chain, run, RunMesher{sampling, options});
    if (run.first == 0) {
      result = std::move(next);
    } else {
      append(next, run.first, sampling.segments, result);
    }
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
  mesh.points.insert(mesh.points.end(), inner.mesh.points.begin(), inner.mesh.points.end());
  for (const auto& [a, b, c] : inner.mesh.triangles) {
    mesh.triangles.push_back({offset + a, offset + c, offset + b});
  }
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
  if (chain.joints == Joints::spherical && chain.wall == 0) {
    return surfaces::kneecap_chain_mesh(end_ring(chain, End::start), end_ring(chain, End::end),
                                        cyclide_pieces(chain), sampling, options);
  }
  if (chain.wall == 0) {
    return skin(chain, sampling, options);
  }
  const Chain inside = inner_skin(chain);
  Tessellation outer = skin(chain, sampling, options);
  const Tessellation inner = skin(inside, sampling, options);
  const std::uint32_t turn =
      sampling.segments + last_shift(outer, chain, sampling) - last_shift(inner, inside, sampling);
  return hollow(std::move(outer), inner, sampling.segments, turn);
}

}  // namespace dupin
