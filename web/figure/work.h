// What takes longer than a frame, done somewhere else: a text goes in, bytes come out. The platform
// runs it in a thread or a worker of its own.
#pragma once

#include <functional>
#include <string>

#include "base/result.h"
#include "base/timing.h"
#include "document/document.h"

namespace marrow {

struct WorkTeller {
  /// What has been made; may come again, better.
  std::function<void(std::string bytes)> made;
  /// 0 … 1; whether to go on.
  std::function<bool(double done)> progress;
};

/// Asks for the Figure of a document.
std::string figureRequest(const Document& document);

/// Does what was asked for. Errors: what could not be made, and why.
Result<bool> work(const std::string& request, const WorkTeller& tell, Clock clock);

}  // namespace marrow
