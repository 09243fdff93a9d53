// A whole character as text: JSON with its rig, OBJ with its meshes and bones, SVG to look at.
#pragma once

#include <string>
#include <vector>

#include "character/character.h"
#include "document/evaluation.h"
#include "io/json.h"

namespace marrow {

/// {"joints": [{"id", "name", "part", "parent": id or null, "position": [x, y, z], "radius",
///              "kind"}…],
///  "bones": [[parent id, child id]…],
///  "connections": [{"child": part, "parent": part, "event": "split"|"connect",
///                   "test": "joint"|"overlap"|"user"}…],
///  "roots": [joint id…],
///  "carried": [{"part", "joint": id or null}…],   parts without bones, and what they move with
///  "unattached": [part…],                         see unattachedParts
///  "errors": [{"part", "message"}…],              parts of which no shape came
///  "timings": {stage: ms…, "subSkeletons", "total"}}
/// Parts are named by the id of a placed part, such as "part-3:twin". "subSkeletons" is outline to
/// joints; times are those of the last update.
Json rigToTree(const Evaluation& character);
/// The same as text, each field on a line of its own.
std::string rigToJson(const Evaluation& character);

/// Adds "merged": {"vertices", "triangles", "closed", "manifold", "selfIntersections", "volume"},
/// "leftOut": [{"part", "why"}…], where there are any, "weights": {"bones", "maxSumError", "min",
/// "max"}, where they were asked for, or "noWeights", a sentence that says why there are none, and
/// the stages' times.
void addCharacter(Json& tree, const Character& made);

/// Placed parts at which a tree of its own begins, though the most parts are in another one.
std::vector<uint32_t> unattachedParts(const Evaluation& character);

/// The visible parts where they are in space, an object each, then the bones as lines.
std::string rigToObj(const Evaluation& character);
/// From three sides: silhouettes of the visible parts, bones, joints by kind.
std::string rigToSvg(const std::string& name, const Evaluation& character);

}  // namespace marrow
