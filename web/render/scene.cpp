#include "render/scene.h"

#include <cstring>

namespace marrow {
namespace {

template <typename T>
uint64_t mixed(uint64_t seed, const T& value) {
  static_assert(std::is_arithmetic_v<T>);
  return fingerprint(&value, sizeof value, seed);
}

// Only for types made of floats alone: padding has no defined bytes.
template <typename T>
uint64_t mixedFloats(uint64_t seed, const std::vector<T>& items) {
  static_assert(sizeof(T) % sizeof(float) == 0 && std::is_trivially_copyable_v<T>);
  return fingerprint(items.data(), items.size() * sizeof(T), mixed(seed, items.size()));
}

uint64_t mixedCamera(uint64_t seed, const Camera& camera) {
  const double values[] = {camera.target.x, camera.target.y,  camera.target.z,
                           camera.yaw_rad,  camera.pitch_rad, camera.zoom};
  return fingerprint(values, sizeof values, seed);
}

}  // namespace

uint64_t fingerprint(const void* data, size_t bytes, uint64_t seed) {
  constexpr uint64_t kPrime = 0x9E3779B97F4A7C15u;
  const auto* p = static_cast<const unsigned char*>(data);
  uint64_t hash = seed ^ (bytes * kPrime);
  for (; bytes >= 8; bytes -= 8, p += 8) {
    uint64_t word;
    std::memcpy(&word, p, 8);
    hash = (hash ^ word) * kPrime;
    hash ^= hash >> 29;
  }
  uint64_t rest = 0;
  std::memcpy(&rest, p, bytes);
  hash = (hash ^ rest) * kPrime;
  return hash ^ (hash >> 32);
}

uint64_t fingerprint(const Scene& scene) {
  uint64_t hash = mixedCamera(1, scene.camera);
  hash = mixed(mixed(hash, scene.size.width), scene.size.height);
  hash = mixed(mixed(hash, scene.dpr), scene.depth);
  hash = mixed(hash, (scene.show_mesh ? 1 : 0) + (scene.show_wireframe ? 2 : 0) +
                         (scene.show_shadow ? 4 : 0));
  for (const Scene::Body& body : scene.bodies) {
    hash = mixed(mixed(hash, body.mesh_id), body.selected ? 1 : 0);
    hash = fingerprint(&body.frame, sizeof body.frame, hash);
    hash = fingerprint(&body.color, sizeof body.color, hash);
  }
  if (scene.figure) {
    const Scene::PosedFigure& figure = *scene.figure;
    hash = mixed(mixed(hash, figure.mesh_id), static_cast<int>(figure.skinning));
    hash = mixedFloats(mixed(hash, static_cast<int>(figure.show)), figure.joints);
    hash = mixedFloats(hash, figure.colors);
  }
  for (const Scene::Picture& picture : scene.pictures) {
    hash = mixed(mixed(hash, picture.texture), picture.opacity);
    hash = fingerprint(&picture.center, 3 * sizeof picture.center, hash);
  }
  hash = mixedFloats(hash, scene.sheets);
  hash = mixedFloats(hash, scene.overlay);
  hash = mixedFloats(hash, scene.proxy_balls);
  hash = mixedFloats(hash, scene.proxy_cones);
  hash = mixedFloats(hash, scene.bones);
  hash = mixedFloats(hash, scene.joints);
  hash = mixedFloats(hash, scene.ink);
  return scene.ink.empty() ? hash : mixedCamera(hash, scene.ink_camera);
}

}  // namespace marrow
