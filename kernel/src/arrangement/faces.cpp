#include "faces.h"

#include <algorithm>

#include <tbb/enumerable_thread_specific.h>

#include "blocks.h"
#include "face_triangulator.h"

namespace dupin::detail {
namespace {

// Adds the new points of a batch to the scene; their ids, each place's first.
std::vector<PointId> add_new_points(Scene& scene, PlaceIndex& places, FacePieces& batch) {
  std::vector<PointId> ids;
  for (Triangulation::NewPoint& point : batch.new_points) {
    const PointId id = scene.points.add(std::move(point));
    const PointId first = places.first_at_place_of(id);
    if (first != id) {
      scene.points.remove_last();
    }
    ids.push_back(first);
  }
  return ids;
}

// Where the pieces of a batch go.
struct Offsets {
  std::uint32_t piece = 0, region = 0, cover = 0;
};

void copy_pieces(const FacePieces& batch, const std::vector<PointId>& new_ids,
                 const Offsets& offsets, Pieces& result) {
  const Pieces& local = batch.local;
  for (std::size_t i = 0; i < local.pieces.size(); ++i) {
    Pieces::Piece& piece = result.pieces[offsets.piece + i] = local.pieces[i];
    for (PointId& id : piece.corners) {
      id = id < Triangulation::kNewPoint ? id : new_ids[id - Triangulation::kNewPoint];
    }
    piece.region += offsets.region;
  }
  for (std::size_t i = 0; i < local.regions.size(); ++i) {
    Pieces::Region& region = result.regions[offsets.region + i] = local.regions[i];
    region.first_cover += offsets.cover;
    region.end_cover += offsets.cover;
  }
  std::copy(local.covers.begin(), local.covers.end(), result.covers.begin() + offsets.cover);
}

// Puts the batches behind one another, in order.
Pieces joined(Scene& scene, PlaceIndex& places, std::vector<FacePieces> batches) {
  std::vector<std::vector<PointId>> new_ids;
  std::vector<Offsets> offsets;
  Offsets next;
  for (FacePieces& batch : batches) {
    new_ids.push_back(add_new_points(scene, places, batch));
    offsets.push_back(next);
    next.piece += static_cast<std::uint32_t>(batch.local.pieces.size());
    next.region += static_cast<std::uint32_t>(batch.local.regions.size());
    next.cover += static_cast<std::uint32_t>(batch.local.covers.size());
  }
  Pieces result;
  result.pieces.resize(next.piece);
  result.regions.resize(next.region);
  result.covers.resize(next.cover);
  for_each_in_parallel(batches.size(), [&](std::size_t b) {
    copy_pieces(batches[b], new_ids[b], offsets[b], result);
    batches[b] = {};
  });
  return result;
}

}  // namespace

Pieces retriangulate(Scene& scene, const BooleanRule& rule, Incidences& incidences,
                     const Stage& stage) {
  constexpr std::size_t kBatch = 32;
  const std::size_t count = incidences.face_count();
  std::vector<FacePieces> batches(block_count(count, kBatch));
  tbb::enumerable_thread_specific<FaceTriangulator> triangulators(
      [&] { return FaceTriangulator(scene, rule, incidences); });
  for_each_block(
      count,
      [&](const Block& block) {
        const UpwardRounding rounding;
        FaceTriangulator& triangulator = triangulators.local();
        for (std::size_t i = block.begin; i < block.end; ++i) {
          triangulator.append(incidences.face(i), batches[block.number]);
        }
        stage.step(batches.size());
      },
      kBatch);
  Pieces pieces = joined(scene, *incidences.places, std::move(batches));
  scene.special.resize(scene.points.size(), 1);
  return pieces;
}

}  // namespace dupin::detail
