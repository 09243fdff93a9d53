// The pictures that a document may hold.
#pragma once

#include <string>

namespace marrow {

constexpr size_t kLargestImage = 16u << 20;  // bytes of a data URL

/// A data URL of a PNG, JPEG or WebP in base64, not larger than the largest image. What the bytes
/// hold is not looked at.
bool isReferenceImage(const std::string& data_url);

}  // namespace marrow
