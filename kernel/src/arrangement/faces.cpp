#include "faces.h"

#include <algorithm>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "face_triangulator.h"

namespace dupin::detail {
namespace {

// Puts the results behind one another, in order.
class Collector {
 public:
  Collector(Scene& scene, PlaceIndex& places) : scene_(scene), places_(places) {}

  void append(FacePieces&& batch) {
    std::vector<PointId> ids;
    for (Triangulation::NewPoint& point : batch.new_points) {
      const PointId id = scene_.points.add(std::move(point));
      const PointId first = places_.first_at_place_of(id);
      if (first != id) {
        scene_.points.remove_last();
      }
      ids.push_back(first);
    }
    const auto first_region = static_cast<std::uint32_t>(result_.regions.size());
    const auto first_cover = static_cast<std::uint32_t>(result_.covers.size());
    for (Pieces::Piece piece : batch.local.pieces) {
      for (PointId& id : piece.corners) {
        id = id < Triangulation::kNewPoint ? id : ids[id - Triangulation::kNewPoint];
      }
      piece.region += first_region;
      result_.pieces.push_back(piece);
    }
    for (Pieces::Region region : batch.local.regions) {
      region.first_cover += first_cover;
      region.end_cover += first_cover;
      result_.regions.push_back(region);
    }
    result_.covers.insert(result_.covers.end(), batch.local.covers.begin(),
                          batch.local.covers.end());
  }
  Pieces take() { return std::move(result_); }

 private:
  Scene& scene_;
  PlaceIndex& places_;
  Pieces result_;
};

}  // namespace

Pieces retriangulate(Scene& scene, const BooleanRule& rule, Incidences& incidences,
                     const Stage& stage) {
  constexpr std::size_t kBatch = 32;
  const std::size_t count = incidences.faces.size();
  std::vector<FacePieces> batches((count + kBatch - 1) / kBatch);
  tbb::enumerable_thread_specific<FaceTriangulator> triangulators(
      [&] { return FaceTriangulator(scene, rule, incidences); });
  tbb::parallel_for(std::size_t{0}, batches.size(), [&](std::size_t b) {
    const UpwardRounding rounding;
    FaceTriangulator& triangulator = triangulators.local();
    for (std::size_t i = b * kBatch; i < std::min((b + 1) * kBatch, count); ++i) {
      triangulator.append(incidences.faces[i], batches[b]);
    }
    stage.step(batches.size());
  });
  Collector collector(scene, *incidences.places);
  for (FacePieces& batch : batches) {
    collector.append(std::move(batch));
    batch = {};
  }
  scene.special.resize(scene.points.size(), 1);
  return collector.take();
}

}  // namespace dupin::detail
