// Document ↔ JSON text:
// {"format": "marrow", "version": 1,
//  "parts": [{"id", "name", "stroke": {"points": [[x, y], …]}, "mesh": {"positions", "triangles"},
//             "frame": {"origin": [x, y, z], "x": [x, y, z], "y": [x, y, z]}, "thickness",
//             "mirror": null or {"plane": [nx, ny, nz, d]}, "skeleton", "color", "visible",
//             "locked", "root", "refine": {…, "branches": {key: simplify}},
//             "attachment": {"part", "at": [x, y]}}],
//  "refine": {"simplify", "merge", "prune", "collapse"}, "symmetry": {"plane"},
//  "references": [{"view", "image", "opacity", "position": [x, y], "scale"}],
//  "poses": [{"name", "joints": {id: {"rotation", "move"}}}], "blend",
//  "weightStrokes": [{"kind", "part", "joint", "radius", "strength", "points"}], "lastPart"}
// public/document.schema.json says what each field is. "lastPart" is there where the ids do not
// tell which numbers were given already.
#pragma once

#include <string>

#include "document/document.h"

namespace marrow {

/// Numbers are written so that reading them gives the same bits; fields this version does not know
/// are kept. Same document, same text.
std::string writeDocument(const Document& document);

/// Every field but "format", "version", a pose's name and the strokes' points may be missing, and
/// the image of a reference; settings out of range are brought into it. Frames whose x and y are
/// not orthogonal or not equally long are made so, and the stroke is brought along; planes get a
/// unit normal. What was written is read as the identical document. Errors, each with a sentence
/// that says what and where: unreadable, newerVersion.
Result<Document> readDocument(const std::string& text);

}  // namespace marrow
