#include "cli/files.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "cli/commands.h"
#include "io/document_json.h"
#include "io/mesh_import.h"

namespace marrow {
namespace {

namespace fs = std::filesystem;

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
File open(const std::string& path, const char* mode) {
  return {std::fopen(path.c_str(), mode), [](std::FILE* file) { return std::fclose(file); }};
}

Error cannotWrite(const std::string& path, const std::string& why) {
  return {Status::unreadable, path + ": cannot be written: " + why + "."};
}

/// False when not every byte reached the file.
bool write(File file, const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  return (std::fclose(file.release()) == 0) && written;
}

struct Place {
  const OutputFile* file;
  std::string target;     // with links followed
  std::string temporary;  // beside it; empty where the text goes to the target directly
};

void removeTemporaries(const std::vector<Place>& places) {
  std::error_code ignored;
  for (const Place& place : places) {
    if (!place.temporary.empty()) fs::remove(place.temporary, ignored);
  }
}

/// Finds out where the text goes, and whether it may, without touching the target.
Result<Place> prepare(const OutputFile& file) {
  std::error_code failure;
  const fs::file_status status = fs::status(file.path, failure);
  Place place{&file, file.path, {}};
  if (fs::is_directory(status)) return cannotWrite(file.path, "it is a directory");
  if (fs::exists(status)) {
    if (!fs::is_regular_file(status)) return place;
    if (!open(file.path, "ab")) return cannotWrite(file.path, "permission denied");
    const fs::path real = fs::canonical(file.path, failure);
    if (!failure) place.target = real.string();
  }
  // A name that is free: opening it fails where it exists already.
  for (int i = 0; i < 100; ++i) {
    place.temporary = place.target + ".new" + std::to_string(i);
    if (File temporary = open(place.temporary, "wbx")) {
      if (write(std::move(temporary), file.text)) return place;
      fs::remove(place.temporary, failure);
      return cannotWrite(file.path, "the disk refuses");
    }
    if (!fs::exists(fs::symlink_status(place.temporary, failure))) break;
  }
  return cannotWrite(file.path, "its directory is missing or closed to writing");
}

}  // namespace

std::optional<Error> writeAll(const std::vector<OutputFile>& files) {
  std::vector<Place> places;
  for (const OutputFile& file : files) {
    auto place = prepare(file);
    if (!place) {
      removeTemporaries(places);
      return place.error();
    }
    places.push_back(std::move(*place));
  }

  for (const Place& place : places) {
    if (place.temporary.empty()) continue;
    std::error_code failure;
    fs::rename(place.temporary, place.target, failure);
    if (failure) {
      removeTemporaries(places);
      return cannotWrite(place.file->path, failure.message());
    }
  }
  for (const Place& place : places) {
    if (!place.temporary.empty()) continue;
    File file = open(place.target, "wb");
    if (!file || !write(std::move(file), place.file->text)) {
      return cannotWrite(place.file->path, "it does not take the text");
    }
  }
  return std::nullopt;
}

Result<std::string> readAll(const std::string& path, size_t largest) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) return {Status::unreadable, "There is no such file."};
  if (fs::is_directory(status)) return {Status::unreadable, "It is a directory."};
  File file = open(path, "rb");
  if (!file) return {Status::unreadable, "It cannot be read."};
  std::string text;
  char chunk[1 << 16];
  while (const size_t size = std::fread(chunk, 1, sizeof chunk, file.get())) {
    text.append(chunk, size);
    if (text.size() > largest) return {Status::unreadable, "It is too large."};
  }
  if (std::ferror(file.get())) return {Status::unreadable, "It cannot be read."};
  return text;
}

bool sameFile(const std::string& a, const std::string& b) {
  std::error_code failure;
  const fs::path real_a = fs::absolute(fs::weakly_canonical(a, failure), failure);
  const fs::path real_b = fs::absolute(fs::weakly_canonical(b, failure), failure);
  const fs::file_status status = fs::status(real_a, failure);
  if (fs::exists(status) && !fs::is_regular_file(status)) return false;
  return real_a == real_b || fs::equivalent(real_a, real_b, failure);
}

Result<Document> openDocument(const std::string& path) {
  const auto text = readAll(path, kLargestFile);
  if (!text) return {text.status(), path + ": " + text.message()};
  const bool is_glb = text->compare(0, 4, "glTF") == 0;
  const auto inside = is_glb ? documentInGlb(*text) : std::nullopt;
  if (is_glb && !inside)
    return {Status::unreadable, path + ": It is a GLB without a drawing in it."};
  auto document = readDocument(inside ? *inside : *text);
  if (!document) return {document.status(), path + ": " + document.message()};
  return document;
}

std::string fileName(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

std::string printable(std::string words) {
  for (char& c : words) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  }
  return words;
}

}  // namespace marrow
