// Limits on the size of a scene. A file beyond them causes a SceneError before memory is taken for it.
#pragma once

#include <cstddef>

namespace saccade {

inline constexpr std::size_t kMaxXmlBytes = std::size_t{64} << 20;  // of a file, and of all that it includes
inline constexpr int kMaxIncludes = 1000;
inline constexpr std::size_t kMaxIncludeDepth = 16;                         // files within files
inline constexpr std::size_t kMaxSubstitutedBytes = std::size_t{16} << 20;  // of all values with a $name
inline constexpr int kMaxXmlDepth = 64;                                     // elements within elements
inline constexpr std::size_t kMaxGltfJsonBytes = std::size_t{256} << 20;
inline constexpr int kMaxNodeDepth = 256;   // nodes of glTF within nodes
inline constexpr int kMaxBsdfDepth = 16;    // bsdfs within bsdfs, through <ref>
inline constexpr int kMaxFilmEdge = 16384;  // pixels

inline constexpr std::size_t kMaxMeshBytes = std::size_t{4} << 30;  // of a file
inline constexpr std::size_t kMaxMeshBytesPerByte = 200;            // of its compressed data
inline constexpr std::size_t kMaxTriangles = 100'000'000;           // of a mesh, and of all meshes together

inline constexpr std::size_t kMaxMtlBytes = std::size_t{16} << 20;  // of a file of materials
inline constexpr std::size_t kMaxMtlFiles = 64;                     // of an OBJ file
inline constexpr std::size_t kMaxObjMaterials = 65536;              // that an OBJ file uses

inline constexpr int kMaxPictureEdge = 16384;                           // pixels
inline constexpr std::size_t kMaxPicturePixels = std::size_t{1} << 27;  // of a picture: 1.5 GiB as floats
inline constexpr std::size_t kMaxScenePixels = 2 * kMaxPicturePixels;   // of all pictures of a scene together

inline constexpr int kMaxPicturePixelsPerByte = 10'000;  // of its file, as compression goes

inline constexpr std::size_t kMaxTrajectoryBytes = std::size_t{256} << 20;

inline constexpr float kMaxRadiance = 1e18f;  // of any light: its products and the power of lamps stay finite

}  // namespace saccade
