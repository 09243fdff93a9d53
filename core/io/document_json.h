// Document ↔ JSON text: {"format": "marrow", "version": 1, "parts": [{"id", "name",
// "stroke": {"points": [[x, y], …]}, "thickness", "color", "refine": {"simplify"}}]}.
// "lastPart" stands beside "parts" where the ids do not tell which numbers were given already.
#pragma once

#include <string>

#include "document/document.h"

namespace marrow {

/// Numbers are written so that reading them gives the same bits; fields this version does not know
/// are kept. Same document, same text.
std::string writeDocument(const Document& document);

/// Every field but "format", "version" and the strokes' points may be missing; settings out of
/// range are brought into it.
/// Errors, each with a sentence that says what and where: unreadable, newerVersion.
Result<Document> readDocument(const std::string& text);

}  // namespace marrow
