#include "figure/work.h"

#include "document/symmetry.h"
#include "figure/figure.h"
#include "io/document_json.h"

namespace marrow {

std::string figureRequest(const Document& document) { return writeDocument(document); }

Result<bool> work(const std::string& request, const WorkTeller& tell, Clock clock) {
  const double start_ms = clock();
  const auto document = readDocument(request);
  if (!document) return document.error();
  Evaluation evaluation;
  evaluation.update(*document);
  CharacterOptions options;
  options.symmetry = symmetryPlane(*document);
  bool stopped = false;
  const auto send = [&](const Character& character, bool guessed) -> Result<bool> {
    auto figure = figureOf(character, evaluation);
    if (!figure) return figure.error();
    figure->guessed = guessed;
    figure->made_ms = clock() - start_ms;
    tell.made(toBytes(*figure));
    return true;
  };
  CharacterWatch watch;
  watch.first_guess = [&](const Character& character) { send(character, true); };
  watch.progress = [&](double done) {
    stopped = !tell.progress(done);
    return !stopped;
  };
  const Character character = makeCharacter(evaluation, options, clock, watch);
  if (stopped) return {Status::meshFailed, "Stopped."};
  return send(character, false);
}

}  // namespace marrow
