#include "platform/desktop_pictures.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/base64.h"

namespace marrow {
namespace {

constexpr int kMostPixels = 1 << 28;
constexpr int kJpegQuality = 90;

std::optional<Pixels> decoded(const std::vector<uint8_t>& file) {
  const int size = static_cast<int>(std::min<size_t>(file.size(), 1u << 30));
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(file.data(), size, &width, &height, &channels)) return std::nullopt;
  if (width <= 0 || height <= 0 || width > kMostPixels / height) return std::nullopt;
  stbi_uc* data = stbi_load_from_memory(file.data(), size, &width, &height, &channels, 4);
  if (!data) return std::nullopt;
  Pixels pixels{width, height, width, height, {}};
  pixels.rgba.assign(data, data + static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
  stbi_image_free(data);
  return pixels;
}

/// The mean of the pixels that each new one covers.
Pixels shrunk(const Pixels& from, int width, int height) {
  Pixels to{width, height, from.natural_width, from.natural_height, {}};
  to.rgba.resize(static_cast<size_t>(width) * static_cast<size_t>(height) * 4);
  const auto bound = [](int i, int count, int whole) {
    return static_cast<int>(static_cast<int64_t>(i) * whole / count);
  };
  for (int y = 0; y < height; ++y) {
    const int top = bound(y, height, from.height);
    const int bottom = std::max(top + 1, bound(y + 1, height, from.height));
    for (int x = 0; x < width; ++x) {
      const int left = bound(x, width, from.width);
      const int right = std::max(left + 1, bound(x + 1, width, from.width));
      unsigned sum[4] = {0, 0, 0, 0};
      for (int v = top; v < bottom; ++v) {
        for (int u = left; u < right; ++u) {
          const uint8_t* p = &from.rgba[(static_cast<size_t>(v) * from.width + u) * 4];
          for (int k = 0; k < 4; ++k) sum[k] += p[k];
        }
      }
      const auto count = static_cast<unsigned>((bottom - top) * (right - left));
      for (int k = 0; k < 4; ++k) {
        to.rgba[(static_cast<size_t>(y) * width + x) * 4 + k] =
            static_cast<uint8_t>((sum[k] + count / 2) / count);
      }
    }
  }
  return to;
}

Pixels fitting(Pixels pixels) {
  const int longest = std::max(pixels.width, pixels.height);
  if (longest <= PictureText::kLargestSide) return pixels;
  const double factor = static_cast<double>(PictureText::kLargestSide) / longest;
  return shrunk(pixels, std::max(1, static_cast<int>(std::lround(pixels.width * factor))),
                std::max(1, static_cast<int>(std::lround(pixels.height * factor))));
}

void append(void* bytes, void* data, int size) {
  const auto* from = static_cast<const uint8_t*>(data);
  auto& to = *static_cast<std::vector<uint8_t>*>(bytes);
  to.insert(to.end(), from, from + size);
}

}  // namespace

std::optional<PictureText> pictureText(const std::vector<uint8_t>& file) {
  const auto whole = decoded(file);
  if (!whole) return std::nullopt;
  const bool jpeg = file[0] == 0xFF;
  const Pixels pixels = fitting(*whole);
  if (pixels.width == whole->width && file.size() <= PictureText::kLargestFile) {
    return PictureText{
        std::string("data:image/") + (jpeg ? "jpeg" : "png") + ";base64," + toBase64(file),
        pixels.width, pixels.height};
  }
  bool opaque = true;
  for (size_t i = 3; i < pixels.rgba.size(); i += 4) opaque &= pixels.rgba[i] == 255;
  std::vector<uint8_t> written;
  if (opaque) {
    stbi_write_jpg_to_func(append, &written, pixels.width, pixels.height, 4, pixels.rgba.data(),
                           kJpegQuality);
  } else {
    stbi_flip_vertically_on_write(0);
    stbi_write_png_to_func(append, &written, pixels.width, pixels.height, 4, pixels.rgba.data(),
                           pixels.width * 4);
  }
  return PictureText{
      std::string("data:image/") + (opaque ? "jpeg" : "png") + ";base64," + toBase64(written),
      pixels.width, pixels.height};
}

std::optional<Pixels> pixelsOf(const std::string& image) {
  const size_t comma = image.find(',');
  if (image.rfind("data:image/", 0) != 0 || comma == std::string::npos) return std::nullopt;
  const auto file = fromBase64(image.substr(comma + 1));
  if (!file || file->empty()) return std::nullopt;
  auto pixels = decoded(*file);
  if (!pixels) return std::nullopt;
  return fitting(std::move(*pixels));
}

}  // namespace marrow
