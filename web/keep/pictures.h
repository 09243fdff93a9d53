// The pixels of the document's reference pictures, decoded by the platform.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "camera.h"
#include "document/document.h"
#include "keep/thumbnails.h"

namespace marrow {

struct Pixels {
  int width = 0, height = 0;
  int natural_width = 0, natural_height = 0;  // of the picture, which may be larger
  std::vector<uint8_t> rgba;                  // rows from the top
};

struct Picture {
  TextureId texture = 0;
  std::shared_ptr<const std::string> image;  // as in Reference
  std::shared_ptr<const Pixels> pixels;      // null: not decoded yet
  bool broken = false;
};

class Pictures {
 public:
  static constexpr TextureId kFirst = 1u << 20;

  /// Finds pictures that are new in the document; their decoding is to be asked for.
  std::vector<const Picture*> update(const Document& document);
  void decoded(TextureId texture, Pixels pixels);
  void broken(TextureId texture);
  const Picture* find(const Reference& reference) const;
  /// The document's pictures as the camera sees them.
  std::vector<Scene::Picture> seen(const Document& document, const Camera& camera) const;
  const std::map<TextureId, Picture>& all() const { return pictures_; }

 private:
  std::map<TextureId, Picture> pictures_;
  TextureId next_ = kFirst;
};

/// The camera's nearest standard view.
Reference::View nearestView(const Camera& camera);
const char* toString(Reference::View view);
/// Right, up and towards the viewer, in that view.
std::array<Vec3, 3> axesOf(Reference::View view);
/// How much of a picture in this view is seen by the camera: 1 in the view itself, 0 from
/// elsewhere.
double presence(Reference::View view, const Camera& camera);
const Reference* referenceIn(const Document& document, Reference::View view);
/// Placed in the middle of what the camera sees, as large as that allows.
Reference fitted(Reference reference, int width, int height, const Camera& camera, ViewSize size);

}  // namespace marrow
