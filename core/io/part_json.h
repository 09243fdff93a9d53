// One part of a document ↔ JSON tree; document_json.h tells the form.
#pragma once

#include <string>

#include "document/document.h"
#include "io/json.h"
#include "io/object_reader.h"

namespace marrow {

Json partToTree(const PartSource& part);

/// id and name are empty where they are missing.
struct ReadPart {
  PartSource part;
  bool has_color = false;
};
ReadPart readPart(const Json& tree, const std::string& where, Fault& fault);

/// The thresholds that are set, and the unknown fields.
Json refinementToTree(const Refinement& refine, const Json& extra);
Refinement readRefinement(ObjectReader& reader);

Json planeToTree(const Plane& plane, const Json& extra);

/// The object that `text` holds, or an empty one.
Json extraFields(const std::string& text);
/// The unknown fields of the inner object `key`, taken out of `extra`.
Json takeInner(Json& extra, const char* key);
/// Adds those fields that `object` does not have.
void appendFields(Json& object, const Json& fields);

}  // namespace marrow
