#include "document/reference_image.h"

namespace marrow {
namespace {

bool isBase64(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '+' ||
         c == '/';
}

}  // namespace

bool isReferenceImage(const std::string& data_url) {
  if (data_url.size() > kLargestImage) return false;
  size_t at = 0;
  for (const char* kind : {"png", "jpeg", "webp"}) {
    const std::string prefix = std::string("data:image/") + kind + ";base64,";
    if (data_url.compare(0, prefix.size(), prefix) == 0) at = prefix.size();
  }
  size_t end = data_url.size();
  if (at == 0 || at == end || (end - at) % 4 != 0) return false;
  for (int padding = 0; padding < 2 && data_url[end - 1] == '='; ++padding) --end;
  while (at < end && isBase64(data_url[at])) ++at;
  return at == end;
}

}  // namespace marrow
