#include "render/ground_shadow.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

constexpr GLsizei kSize = 128;          // of the picture, texels
constexpr float kBlurShare = 0.30f;     // room for the blur around the bodies, of their size
constexpr float kGapShare = 0.06f;      // between the lowest point and the ground
constexpr float kLean = 0.30f;          // how far the ground leans to a viewer at its height
constexpr float kHighestShare = 0.14f;  // of the bodies' height, that the shadow may rise by
constexpr Rgba kColor{0.20f, 0.20f, 0.34f, 0.34f};

struct Box {
  float x, z, half_width, half_depth;
};

Box shadowBox(const Scene& scene) {
  const float half_width = 0.5f * (scene.high.x - scene.low.x);
  const float half_depth = 0.5f * (scene.high.z - scene.low.z);
  const float margin = kBlurShare * std::max(std::min(half_width, half_depth * 3), half_depth);
  return {0.5f * (scene.high.x + scene.low.x), 0.5f * (scene.high.z + scene.low.z),
          half_width + margin, half_depth + margin};
}

}  // namespace

GroundShadow::GroundShadow()
    : cast_("shadow_cast.vert", "flat.frag"),
      blur_("background.vert", "blur.frag"),
      ground_("ground.vert", "ground.frag"),
      nothing_(makeVertexArray()) {
  for (int i = 0; i < 2; ++i) {
    pictures_[i] = makeTexture(kSize, kSize, nullptr, false);
    framebuffers_[i] = makeFramebuffer();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[i].name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, pictures_[i].name(),
                           0);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void GroundShadow::makePicture(const Scene& scene, GpuCache& cache, const Follows& follows) {
  const Box box = shadowBox(scene);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glViewport(0, 0, kSize, kSize);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0].name());
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  cast_.use();
  cast_.set("u_box", box.x, box.z, box.half_width, box.half_depth);
  cast_.set("u_color", Rgba{1, 1, 1, 1});
  follows.set(cast_, scene.figure ? &*scene.figure : nullptr);
  const auto cast = [&](const GpuMesh& mesh, const Frame& frame) {
    setPlace(cast_, frame, mesh.origin, {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}},
             scene.camera.target);
    glBindVertexArray(mesh.vertex_array.name());
    glDrawElements(GL_TRIANGLES, mesh.triangle_indices, GL_UNSIGNED_INT, nullptr);
  };
  if (scene.figure) {
    cast(cache.mesh(scene.figure->mesh_id, *scene.figure->figure), Frame{});
  } else {
    for (const Scene::Body& body : scene.bodies) {
      cast(cache.mesh(body.mesh_id, *body.part), body.frame);
    }
  }
  blur_.use();
  blur_.set("u_picture", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindVertexArray(nothing_.name());
  // The blur is as wide on the ground in both directions, whatever the picture's shape.
  const float reach = 0.35f * std::min(box.half_width, box.half_depth) / 8;
  for (int pass = 0; pass < 2; ++pass) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1 - pass].name());
    glBindTexture(GL_TEXTURE_2D, pictures_[pass].name());
    blur_.set("u_step", pass == 0 ? reach / (2 * box.half_width) : 0,
              pass == 1 ? reach / (2 * box.half_depth) : 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

void GroundShadow::draw(const Scene& scene, GpuCache& cache, const Follows& follows,
                        Float3 clip_scale, GLuint framebuffer) {
  if (scene.bodies.empty() || !(scene.high.x > scene.low.x)) return;
  uint64_t now = 1;
  for (const Scene::Body& body : scene.bodies) {
    now = fingerprint(&body.mesh_id, sizeof body.mesh_id, now);
    now = fingerprint(&body.frame, sizeof body.frame, now);
  }
  if (scene.figure) {
    const auto& joints = scene.figure->joints;
    now = fingerprint(joints.data(), joints.size() * sizeof joints[0], scene.figure->mesh_id);
    now = fingerprint(&scene.figure->skinning, sizeof scene.figure->skinning, now);
  }
  if (now != fingerprint_) {
    makePicture(scene, cache, follows);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    setViewport(scene);
    fingerprint_ = now;
  }
  const Box box = shadowBox(scene);
  const Vec3 back = scene.camera.axes()[2];
  // Only as much as keeps the shadow below the bodies; in between the standard views the ground can
  // be seen as it is.
  const double along = std::max(std::abs(back.x), std::abs(back.z));
  const double extent = std::abs(back.x) * box.half_width + std::abs(back.z) * box.half_depth;
  const double most = kHighestShare * (scene.high.y - scene.low.y) / std::max(extent, 1e-9);
  const double lean = std::min<double>(kLean, most) * std::pow(along, 6);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  ground_.use();
  ground_.set("u_picture", 0);
  ground_.set("u_color", kColor);
  ground_.set("u_box", box.x, box.z, box.half_width, box.half_depth);
  ground_.set("u_height", scene.low.y - kGapShare * std::max(scene.high.y - scene.low.y,
                                                             scene.high.z - scene.low.z));
  ground_.set("u_towards", static_cast<float>(back.x * lean), static_cast<float>(back.z * lean));
  ground_.set("u_scale", clip_scale);
  ground_.setRotation("u_rotation", scene.camera.axes());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, pictures_[0].name());
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
}

}  // namespace marrow
