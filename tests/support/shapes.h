#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "dupin/kernel/mesh.h"

/// Small closed meshes, outward oriented, with integer or given coordinates.
namespace dupin::test {

/// 12 faces, 8 points; the corners run x fastest, then y, then z.
[[nodiscard]] TriMesh box(const Vec3& low, const Vec3& high);

/// (0,0,0), (1,0,0), (0,1,0), (0,0,1) times `size`, moved by `offset`.
[[nodiscard]] TriMesh tetrahedron(const Vec3& offset = Vec3::Zero(), double size = 1);

/// A square frame about the z axis: outer side 6, inner side 2, height 2, centred in the origin.
/// Genus 1, volume 64.
[[nodiscard]] TriMesh frame();

/// A prism over the regular `segments`-gon inscribed in a circle of the radius about the z axis
/// from z = low to high; fans from the first corner at both ends.
[[nodiscard]] TriMesh tube(double radius, double low, double high, std::uint32_t segments);

/// Two pyramids with tips at (0.5, 0.5, -1) and (0.5, 0.5, 2) over a ring of points above the
/// corners of the unit square, each closing it by another diagonal: the lower one by that from
/// corner 0 to 2, the upper one by that from 1 to 3. A void remains between them if the latter runs
/// above.
[[nodiscard]] std::vector<TriMesh> pyramids(const std::array<double, 4>& heights);

/// All faces in one mesh, points not merged; labels kept where there are any.
[[nodiscard]] TriMesh joined(const std::vector<TriMesh>& meshes);

/// The same box with the other diagonal in each side: its mirror image, mirrored back.
[[nodiscard]] TriMesh cut_otherwise(TriMesh box);

/// The same surface seen from inside.
[[nodiscard]] TriMesh reversed(TriMesh mesh);

[[nodiscard]] TriMesh moved(TriMesh mesh, const Vec3& by);

/// All faces with one label.
[[nodiscard]] TriMesh labelled(TriMesh mesh, const std::string& name);

}  // namespace dupin::test
