// Small pictures of drawings: samples and kept ones. Made bit by bit, so that no frame waits.
#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <string>

#include "document/evaluation.h"
#include "render/scene.h"

namespace marrow {

/// What a texture is drawn by in a panel: thumbnails and pictures. 0 is the fonts'.
using TextureId = uint32_t;

struct Thumbnail {
  static constexpr ViewSize kSize{192, 144};  // CSS pixels

  std::string key;
  TextureId texture = 0;
  bool ready = false;  // `scene` can be drawn
  bool broken = false;
  Scene scene;
};

class Thumbnails {
 public:
  static constexpr TextureId kFirst = 1;
  static constexpr size_t kMost = 48;

  explicit Thumbnails(Clock clock) : clock_(clock) {}

  /// The picture made for a key, or null: nobody asked for it yet.
  const Thumbnail* find(const std::string& key) const;
  /// Asks for a picture of the document in `text`. The same key again does nothing.
  void want(const std::string& key, const std::string& text);
  /// Goes on for about `budget_ms`, at least by one part; whether one became ready.
  bool work(double budget_ms);
  bool busy() const;
  const std::list<Thumbnail>& all() const { return thumbnails_; }

 private:
  struct Making {
    Thumbnail* thumbnail = nullptr;
    Document document;
    size_t parts = 0;  // evaluated so far
    std::unique_ptr<Evaluation> evaluation;
  };
  void step(Making& making);

  Clock clock_;
  std::list<Thumbnail> thumbnails_;
  std::list<Making> making_;
  TextureId next_ = kFirst;
};

}  // namespace marrow
