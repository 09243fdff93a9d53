// Files read whole, and written all or none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "document/document.h"

namespace marrow {

struct OutputFile {
  std::string path;
  std::string text;
};

/// Writes each text beside its place first and moves them there when all are written, so that a
/// failure leaves every place as it was. What is not an ordinary file (a pipe, a terminal) is
/// written to directly, last. Nothing when all went well, else an error that names the file.
std::optional<Error> writeAll(const std::vector<OutputFile>& files);

/// largest: bytes. Errors: unreadable, with what is wrong.
Result<std::string> readAll(const std::string& path, size_t largest);

/// A file that holds a document: its text, or a GLB that Marrow wrote. Errors: with the path in
/// front.
Result<Document> openDocument(const std::string& path);

/// The last piece of a path.
std::string fileName(const std::string& path);
/// Without control characters, which would change what a terminal shows.
std::string printable(std::string words);

/// Whether both paths lead to one ordinary file, which need not be there yet.
bool sameFile(const std::string& a, const std::string& b);

}  // namespace marrow
