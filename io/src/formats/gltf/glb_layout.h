#pragma once

#include <cstddef>
#include <cstdint>

namespace dupin::formats {

// Numbers of the glTF 2.0 specification that the reader and the writer share.
inline constexpr std::uint32_t kGlbMagic = 0x46546C67;  // "glTF"
inline constexpr std::uint32_t kGlbVersion = 2;
inline constexpr std::uint32_t kGlbJsonChunk = 0x4E4F534A;   // "JSON"
inline constexpr std::uint32_t kGlbBytesChunk = 0x004E4942;  // "BIN"
inline constexpr std::size_t kGlbHeader = 12;
inline constexpr std::size_t kGlbChunkHeader = 8;

/// asset.generator of our own files.
inline constexpr char kGlbGenerator[] = "dupin";
/// The sine of half a quarter turn: about x, it makes z, upward here, glTF's y.
inline constexpr double kGlbHalfTurn = 0x1.6a09e667f3bcdp-1;

/// The member of asset.extras of our own files that is the accessor of copied points.
inline constexpr char kGlbCopies[] = "copies";

inline constexpr int kGltfUint8 = 5121;
inline constexpr int kGltfUint16 = 5123;
inline constexpr int kGltfUint32 = 5125;
inline constexpr int kGltfFloat = 5126;
inline constexpr int kGltfTriangles = 4;  // less are points and lines
inline constexpr int kGltfStrip = 5;
inline constexpr int kGltfFan = 6;
inline constexpr int kGltfPointsBuffer = 34962;
inline constexpr int kGltfIndicesBuffer = 34963;

}  // namespace dupin::formats
