#include "base/result.h"

namespace marrow {

const char* toSentence(Status status) {
  switch (status) {
    case Status::ok:
      return "All is well.";
    case Status::tooFewPoints:
      return "The stroke has fewer than three different points.";
    case Status::noArea:
      return "The stroke encloses no area.";
    case Status::notAPolygon:
      return "The outline is not a simple polygon.";
    case Status::skeletonFailed:
      return "No skeleton could be found in this outline.";
    case Status::meshFailed:
      return "This outline could not be inflated.";
    case Status::unreadable:
      return "This is not a Marrow drawing.";
    case Status::newerVersion:
      return "This drawing was made with a newer version of Marrow.";
    case Status::notFound:
      return "There is nothing there.";
    case Status::locked:
      return "It is locked. Unlock it to change it.";
    case Status::tooMany:
      return "This is more than a drawing holds.";
    case Status::notSolid:
      return "This surface is not closed.";
    case Status::notDrawn:
      return "It was not drawn, so it has no outline to change.";
  }
  return "Something went wrong.";
}

}  // namespace marrow
