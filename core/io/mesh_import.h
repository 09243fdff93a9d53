// Meshes of other programs: OBJ, STL, PLY and GLB, made solids.
#pragma once

#include <optional>
#include <string>

#include "base/result.h"
#include "document/document.h"
#include "surface/mesh.h"

namespace marrow {

enum class MeshFormat { obj, stl, ply, glb };

/// By what the file begins with, else by its name's ending; nothing for anything else.
std::optional<MeshFormat> meshFormatOf(const std::string& bytes, const std::string& file_name);

/// Why a file that is no mesh cannot be a drawing either; nothing where it may be one. Errors:
/// unreadable.
std::optional<Error> unknownFile(const std::string& bytes, const std::string& file_name);

/// Limits that keep a hostile file from costing more than a moment.
constexpr size_t kLargestMeshFile = 64u << 20;  // bytes
constexpr size_t kMostReadTriangles = 200'000;
constexpr size_t kMostReadVertices = 600'000;
/// More would be slow to merge and to weight, and nothing is simplified unasked: what a reduction
/// may lose, the program that made the mesh knows better.
constexpr size_t kMostTriangles = PartSource::kMostTriangles;

/// The triangles of the file as they are, in its units; faces with more corners are cut. No
/// pictures, no colours. Errors, in a sentence: unreadable, tooMany.
/// - OBJ: v and f lines, all objects as one.
/// - STL: ASCII and binary. z is up there nearly always, so it is turned: y is up here.
/// - PLY: ASCII and binary little-endian.
/// - GLB: the triangles of all meshes of the scene, as its nodes and its joints place them, at
/// rest;
///   only what is in the file itself, uncompressed.
Result<Mesh> readMesh(const std::string& bytes, MeshFormat format);

struct ImportedMesh {
  Mesh mesh;            // a closed, outward solid about the origin whose longest side is 1
  size_t left_out = 0;  // pieces that could not be closed (see closeMost)
};
/// At most kMostTriangles. Errors: those of readMesh and closeMost.
Result<ImportedMesh> importModel(const std::string& bytes, MeshFormat format);
/// The same, without a word about what is left out.
Result<Mesh> importMesh(const std::string& bytes, MeshFormat format);

/// The text of the document that a GLB of ours holds (glb.h); nothing where it holds none, or other
/// bytes in its place.
std::optional<std::string> documentInGlb(const std::string& bytes);

}  // namespace marrow
