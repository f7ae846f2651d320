#include "arrangement/faces/subdivision.h"

#include <algorithm>

#include <tbb/enumerable_thread_specific.h>

#include "arrangement/faces/face_outlines.h"
#include "arrangement/faces/face_triangulator.h"
#include "support/blocks.h"

namespace dupin::arrangement {
namespace {

// Adds the new points of a batch to the input; their ids, or those of points they coincide with.
std::vector<PointId> add_new_points(ArrangementInput& input, CoincidentPointIndex& coincident,
                                    FaceSubdivision& batch) {
  std::vector<PointId> ids;
  for (ConstrainedTriangulation::NewPoint& point : batch.new_points) {
    const PointId id = input.points.add(std::move(point));
    const PointId first = coincident.first_coincident(id);
    if (first != id) {
      input.points.remove_last();
    }
    ids.push_back(first);
  }
  return ids;
}

// Where the sub-triangles of a batch go.
struct Offsets {
  std::uint32_t triangle = 0, region = 0, cover = 0, outline = 0, corner = 0;
};

void copy_regions(const FaceSubdivision& batch, const std::vector<PointId>& new_ids,
                  const Offsets& offsets, Subdivision& result) {
  const Subdivision& local = batch.local;
  for (std::size_t i = 0; i < local.triangles.size(); ++i) {
    Subdivision::SubTriangle& triangle = result.triangles[offsets.triangle + i] =
        local.triangles[i];
    for (PointId& id : triangle.corners) {
      id = id < ConstrainedTriangulation::kNewPoint
               ? id
               : new_ids[id - ConstrainedTriangulation::kNewPoint];
    }
    triangle.region += offsets.region;
  }
  for (std::size_t i = 0; i < local.regions.size(); ++i) {
    Subdivision::Region& region = result.regions[offsets.region + i] = local.regions[i];
    region.first_cover += offsets.cover;
    region.end_cover += offsets.cover;
  }
  std::copy(local.covers.begin(), local.covers.end(), result.covers.begin() + offsets.cover);
  for (std::size_t i = 0; i < local.outlines.size(); ++i) {
    const auto& [region, begin, end] = local.outlines[i];
    result.outlines[offsets.outline + i] = {region + offsets.region, begin + offsets.corner,
                                            end + offsets.corner};
  }
  std::copy(local.outline_corners.begin(), local.outline_corners.end(),
            result.outline_corners.begin() + offsets.corner);
}

// Puts the batches behind one another, in order.
Subdivision joined(ArrangementInput& input, CoincidentPointIndex& coincident,
                   std::vector<FaceSubdivision> batches) {
  std::vector<std::vector<PointId>> new_ids;
  std::vector<Offsets> offsets;
  Offsets next;
  for (FaceSubdivision& batch : batches) {
    new_ids.push_back(add_new_points(input, coincident, batch));
    offsets.push_back(next);
    next.triangle += static_cast<std::uint32_t>(batch.local.triangles.size());
    next.region += static_cast<std::uint32_t>(batch.local.regions.size());
    next.cover += static_cast<std::uint32_t>(batch.local.covers.size());
    next.outline += static_cast<std::uint32_t>(batch.local.outlines.size());
    next.corner += static_cast<std::uint32_t>(batch.local.outline_corners.size());
  }
  Subdivision result;
  result.triangles.resize(next.triangle);
  result.regions.resize(next.region);
  result.covers.resize(next.cover);
  result.outlines.resize(next.outline);
  result.outline_corners.resize(next.corner);
  support::for_each_in_parallel(batches.size(), [&](std::size_t b) {
    copy_regions(batches[b], new_ids[b], offsets[b], result);
    batches[b] = {};
  });
  return result;
}

std::vector<FaceSubdivision> subdivided(const ArrangementInput& input, const BooleanRule& rule,
                                        const Constraints& constraints,
                                        const support::ProgressStage& stage) {
  constexpr std::size_t kBatch = 32;
  const std::size_t count = constraints.face_count();
  std::vector<FaceSubdivision> batches(support::block_count(count, kBatch));
  tbb::enumerable_thread_specific<FaceTriangulator> triangulators(
      [&] { return FaceTriangulator(input, rule, constraints); });
  support::for_each_block(
      count,
      [&](const support::Block& block) {
        const UpwardRounding rounding;
        FaceTriangulator& triangulator = triangulators.local();
        for (std::size_t i = block.begin; i < block.end; ++i) {
          triangulator.append(constraints.face(i), batches[block.number]);
        }
        stage.step(batches.size());
      },
      kBatch);
  return batches;
}

}  // namespace

Subdivision retriangulate(ArrangementInput& input, const BooleanRule& rule, Constraints constraints,
                          const support::ProgressStage& stage) {
  std::vector<FaceSubdivision> batches = subdivided(input, rule, constraints, stage);
  std::optional coincident = std::move(constraints.coincident_points);
  std::vector<std::uint8_t> touched = std::move(constraints.touched);
  constraints = {};  // to make room
  Subdivision subdivision = joined(input, *coincident, std::move(batches));
  subdivision.touched = std::move(touched);
  input.special.resize(input.points.size(), 1);
  return subdivision;
}

void triangulate_outlines(const ArrangementInput& input,
                          const std::function<bool(std::uint32_t)>& is_kept,
                          Subdivision& subdivision) {
  constexpr std::size_t kBatch = 128;
  std::vector<std::vector<Subdivision::SubTriangle>> parts(
      support::block_count(subdivision.outlines.size(), kBatch));
  tbb::enumerable_thread_specific<OutlineTriangulator> triangulators(
      [&] { return OutlineTriangulator(input); });
  support::for_each_block(
      subdivision.outlines.size(),
      [&](const support::Block& block) {
        const UpwardRounding rounding;
        OutlineTriangulator& triangulator = triangulators.local();
        for (std::size_t i = block.begin; i < block.end; ++i) {
          const Subdivision::Outline& outline = subdivision.outlines[i];
          if (is_kept(outline.region)) {
            triangulator.append(subdivision, outline, parts[block.number]);
          }
        }
      },
      kBatch);
  std::vector<std::size_t> begin(parts.size() + 1, subdivision.triangles.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    begin[i + 1] = begin[i] + parts[i].size();
  }
  subdivision.triangles.resize(begin.back());
  support::for_each_in_parallel(parts.size(), [&](std::size_t i) {
    std::ranges::copy(parts[i],
                      subdivision.triangles.begin() + static_cast<std::ptrdiff_t>(begin[i]));
  });
}

}  // namespace dupin::arrangement
