// What takes longer than a frame, done somewhere else: a text goes in, bytes come out. The platform
// has a workshop in a thread or a worker of its own.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/result.h"
#include "base/timing.h"
#include "character/painting.h"
#include "document/document.h"
#include "figure/file_options.h"

namespace marrow {

struct WorkTeller {
  /// What has been made; may come again, better.
  std::function<void(std::string bytes)> made;
  /// 0 … 1; whether to go on.
  std::function<bool(double done)> progress;
};

/// Asks for the Figure of a document; without what it shows nothing of: pictures and poses.
std::string figureRequest(const Document& document);
/// Asks for a MadeFile.
std::string fileRequest(const Document& document, const FileOptions& options);

/// The bytes a file travels in; only for the same build of the app.
std::string toBytes(const MadeFile& file);
/// Errors: unreadable.
Result<MadeFile> fileFromBytes(const std::string& bytes);

class Workshop {
 public:
  /// Does what was asked for. What was made for the document before is used again where it still
  /// fits: other strokes of the brush, or a file after a figure, take no new weights. Errors: what
  /// could not be made, and why.
  Result<bool> work(const std::string& request, const WorkTeller& tell, Clock clock);

 private:
  Result<bool> makeFigure(const Document& document, const WorkTeller& tell, Clock clock);
  Result<bool> makeFile(const Document& document, const FileOptions& options,
                        const WorkTeller& tell, Clock clock);
  /// Whether there is one; else it was told to stop.
  bool makeBody(const Document& document, const CharacterWatch& watch, Clock clock);

  Evaluation evaluation_;
  uint64_t made_of_ = 0;                // bodyKey of what the body is made of; 0: there is none
  Character body_;                      // merged, with weights
  std::unique_ptr<Painting> painting_;  // on the body
};

/// Of the parts that are shown and where they are; 0 where nothing is.
uint64_t partsKey(const Evaluation& evaluation);
/// Of all that a merged body is made of, but for its weights; 0 where nothing is shown.
uint64_t meshKey(const Document& document, const Evaluation& evaluation);
/// Of that, and of what the weights depend on before they are painted over.
uint64_t bodyKey(const Document& document, const Evaluation& evaluation);
/// Of what is painted over them.
uint64_t strokesKey(const Document& document);

}  // namespace marrow
