#include "render/renderer.h"

#include <cmath>

#include "render/textures.h"

namespace marrow {
namespace {

constexpr Float3 kBackgroundTop{0.985f, 0.980f, 0.968f};
constexpr Float3 kBackgroundBottom{0.925f, 0.918f, 0.905f};
constexpr Float3 kBoneEdge{0.16f, 0.20f, 0.27f};
constexpr Rgba kSelectedOutline{0.93f, 0.42f, 0.10f, 1};
constexpr Rgba kWire{0.10f, 0.12f, 0.20f, 0.42f};
constexpr float kOutline_px = 1.6f, kSelectedOutline_px = 3.0f;

// View coordinates, model units → clip space.
Float3 clipScale(const Camera& camera, const Scene& scene) {
  return {static_cast<float>(2 * camera.zoom / scene.size.width),
          static_cast<float>(2 * camera.zoom / scene.size.height), -1 / scene.depth};
}

/// What lies at `v` from the target, or a direction.
Float3 inView(const Camera& camera, Float3 v) {
  const auto [right, up, back] = camera.axes();
  const Vec3 p{v.x, v.y, v.z};
  return {static_cast<float>(dot(right, p)), static_cast<float>(dot(up, p)),
          static_cast<float>(dot(back, p))};
}

Rgba darker(Rgba color) { return {color.r * 0.42f, color.g * 0.40f, color.b * 0.46f, color.a}; }

}  // namespace

Renderer::Renderer()
    : background_("background.vert", "background.frag"),
      part_("part.vert", "part.frag"),
      wire_("part.vert", "flat.frag"),
      sheet_("sheet.vert", "sheet.frag"),
      picture_("sheet.vert", "picture.frag"),
      segment_("segment.vert", "segment.frag"),
      bone_("bone.vert", "bone.frag"),
      ball_("ball.vert", "round.frag"),
      cone_("cone.vert", "round.frag"),
      segments_(segmentShape(), {3, 3, 1, 4}),
      octahedra_(octahedronShape(), {3, 3, 1, 4}),
      balls_(sphereShape(), {3, 1, 4}),
      tubes_(tubeShape(), {3, 3, 2, 4}),
      nothing_(makeVertexArray()) {}

std::string Renderer::log() const {
  return background_.log() + part_.log() + wire_.log() + sheet_.log() + picture_.log() +
         segment_.log() + bone_.log() + ball_.log() + cone_.log() + shadow_.log();
}

void Renderer::draw(const Scene& scene, const Textures& textures, GLuint framebuffer) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  setViewport(scene);
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glClear(GL_DEPTH_BUFFER_BIT);
  if (scene.figure) follows_.update(scene.figure->joints);
  drawBackground();
  drawPictures(scene, textures);
  if (scene.show_shadow) {
    shadow_.draw(scene, cache_, follows_, clipScale(scene.camera, scene), framebuffer);
  }
  if (scene.show_mesh) drawBodies(scene);
  if (scene.show_wireframe) drawWireframe(scene);
  drawSheets(scene);
  drawProxy(scene);
  drawSegments(scene.overlay, scene.camera, scene);
  drawBones(scene);
  drawSegments(scene.ink, scene.ink_camera, scene);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glBindVertexArray(0);
  cache_.endFrame();
}

void Renderer::drawBackground() {
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  background_.use();
  background_.set("u_top", kBackgroundTop);
  background_.set("u_bottom", kBackgroundBottom);
  glBindVertexArray(nothing_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::drawPictures(const Scene& scene, const Textures& textures) {
  if (scene.pictures.empty()) return;
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  picture_.use();
  Float3 scale = clipScale(scene.camera, scene);
  scale.z = 0;  // however far away its plane is
  picture_.set("u_scale", scale);
  picture_.set("u_picture", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindVertexArray(nothing_.name());
  for (const Scene::Picture& picture : scene.pictures) {
    const GLuint texture = textures.find(picture.texture);
    if (texture == 0) continue;
    glBindTexture(GL_TEXTURE_2D, texture);
    picture_.set("u_center", inView(scene.camera, picture.center));
    picture_.set("u_x", inView(scene.camera, picture.x));
    picture_.set("u_y", inView(scene.camera, picture.y));
    picture_.set("u_opacity", picture.opacity);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

void Renderer::setView(const Program& program, const Camera& camera, const Scene& scene) const {
  program.use();
  program.setRotation("u_rotation", camera.axes());
  program.set("u_scale", clipScale(camera, scene));
  program.set("u_pixel", static_cast<float>(2 / scene.size.width),
              static_cast<float>(2 / scene.size.height));
  program.set("u_dpr", static_cast<float>(scene.dpr));
}

void Renderer::drawBodies(const Scene& scene) {
  const auto axes = scene.camera.axes();
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glEnable(GL_CULL_FACE);
  // The surfaces lie a little deeper, so that edges and outlines win.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  setView(part_, scene.camera, scene);
  part_.set("u_outline_px", 0.0f);
  glCullFace(GL_BACK);
  if (scene.figure) {
    drawFigure(part_, scene,
               [&](size_t stretch) { part_.set("u_color", scene.figure->colors[stretch]); });
  } else {
    follows_.set(part_, nullptr);
    for (const Scene::Body& body : scene.bodies) {
      const GpuMesh& mesh = cache_.mesh(body.mesh_id, *body.part);
      setPlace(part_, body.frame, mesh.origin, axes, scene.camera.target);
      part_.set("u_color", body.color);
      glBindVertexArray(mesh.vertex_array.name());
      glDrawElements(GL_TRIANGLES, mesh.triangle_indices, GL_UNSIGNED_INT, nullptr);
    }
  }
  glDisable(GL_POLYGON_OFFSET_FILL);

  setView(wire_, scene.camera, scene);
  glCullFace(GL_FRONT);
  if (scene.figure) {
    wire_.set("u_outline_px", kOutline_px);
    drawFigure(wire_, scene, [&](size_t stretch) {
      wire_.set("u_color", darker(scene.figure->colors[stretch]));
    });
  } else {
    follows_.set(wire_, nullptr);
    for (const Scene::Body& body : scene.bodies) {
      const GpuMesh& mesh = cache_.mesh(body.mesh_id, *body.part);
      setPlace(wire_, body.frame, mesh.origin, axes, scene.camera.target);
      wire_.set("u_outline_px", body.selected ? kSelectedOutline_px : kOutline_px);
      wire_.set("u_color", body.selected ? kSelectedOutline : darker(body.color));
      glBindVertexArray(mesh.vertex_array.name());
      glDrawElements(GL_TRIANGLES, mesh.triangle_indices, GL_UNSIGNED_INT, nullptr);
    }
  }
  glCullFace(GL_BACK);
}

/// prepare: called with the index of each stretch before it is drawn.
template <typename Prepare>
void Renderer::drawFigure(const Program& program, const Scene& scene, const Prepare& prepare) {
  const Scene::PosedFigure& posed = *scene.figure;
  const GpuMesh& mesh = cache_.mesh(posed.mesh_id, *posed.figure);
  follows_.set(program, &posed);
  setPlace(program, Frame{}, mesh.origin, scene.camera.axes(), scene.camera.target);
  glBindVertexArray(mesh.vertex_array.name());
  for (size_t i = 0; i < posed.colors.size(); ++i) {
    const Figure::Stretch& stretch = posed.figure->stretches[i];
    prepare(i);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(stretch.count * 3), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(stretch.first * 3 * sizeof(uint32_t)));
  }
}

void Renderer::drawWireframe(const Scene& scene) {
  const auto axes = scene.camera.axes();
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  setView(wire_, scene.camera, scene);
  wire_.set("u_outline_px", 0.0f);
  wire_.set("u_color", kWire);
  follows_.set(wire_, scene.figure ? &*scene.figure : nullptr);
  const auto draw = [&](const GpuMesh& mesh, const Frame& frame) {
    setPlace(wire_, frame, mesh.origin, axes, scene.camera.target);
    glBindVertexArray(mesh.edge_array.name());
    glDrawElements(GL_LINES, mesh.edge_indices, GL_UNSIGNED_INT, nullptr);
  };
  if (scene.figure) {
    draw(cache_.meshWithEdges(scene.figure->mesh_id, *scene.figure->figure), Frame{});
    return;
  }
  for (const Scene::Body& body : scene.bodies) {
    draw(cache_.meshWithEdges(body.mesh_id, *body.part), body.frame);
  }
}

void Renderer::drawSheets(const Scene& scene) {
  if (scene.sheets.empty()) return;
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  sheet_.use();
  sheet_.set("u_scale", clipScale(scene.camera, scene));
  glBindVertexArray(nothing_.name());
  for (const Scene::Sheet& sheet : scene.sheets) {
    sheet_.set("u_center", inView(scene.camera, sheet.center));
    sheet_.set("u_x", inView(scene.camera, sheet.x));
    sheet_.set("u_y", inView(scene.camera, sheet.y));
    sheet_.set("u_color", sheet.color);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glDepthMask(GL_TRUE);
}

void Renderer::drawProxy(const Scene& scene) {
  if (scene.proxy_balls.empty()) return;
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glEnable(GL_CULL_FACE);
  // Depth first, then colour: only what is in front shows through once.
  for (const bool color : {false, true}) {
    const GLboolean mask = color ? GL_TRUE : GL_FALSE;
    glColorMask(mask, mask, mask, mask);
    for (const Program* program : {&ball_, &cone_}) {
      setView(*program, scene.camera, scene);
      program->set("u_edge_color", Float3{0.05f, 0.32f, 0.36f});
      program->set("u_edge", 0.86f);
      if (program == &ball_) {
        balls_.draw(scene.proxy_balls);
      } else {
        tubes_.draw(scene.proxy_cones);
      }
    }
  }
}

void Renderer::drawBones(const Scene& scene) {
  if (scene.bones.empty() && scene.joints.empty()) return;
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  setView(bone_, scene.camera, scene);
  bone_.set("u_edge_color", kBoneEdge);
  octahedra_.draw(scene.bones);
  setView(ball_, scene.camera, scene);
  ball_.set("u_edge_color", kBoneEdge);
  ball_.set("u_edge", 0.72f);
  balls_.draw(scene.joints);
}

void Renderer::drawSegments(const std::vector<Scene::Segment>& segments, const Camera& camera,
                            const Scene& scene) {
  if (segments.empty()) return;
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  setView(segment_, camera, scene);
  segments_.draw(segments);
}

}  // namespace marrow
