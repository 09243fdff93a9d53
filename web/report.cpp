#include "report.h"

#include <algorithm>
#include <cmath>

#include "io/json.h"
#include "panels/widgets.h"

namespace marrow {
namespace {

Json toJson(const Timings& timings) {
  Json json = Json::object();
  for (const auto& [stage, ms] : timings.stages_ms) json[stage] = ms;
  json["total"] = timings.total_ms;
  return json;
}

/// A part with its joints where they are in space.
Json toJson(const Part& part, const Frame& frame) {
  Json json;
  json["joints"] = Json::array();
  for (const PartSkeleton::Joint& joint : part.skeleton.joints) {
    const Vec3 at = frame.toWorld(joint.place());
    json["joints"].push_back({{"kind", toString(joint.kind)},
                              {"position", {at.x, at.y, at.z}},
                              {"radius", joint.radius * frame.scale()}});
  }
  json["bones"] = part.skeleton.bones;
  json["mesh"] = {{"vertices", part.mesh.positions.size()},
                  {"triangles", part.mesh.triangles.size()}};
  json["timings"] = toJson(part.timings);
  json["straightSkeleton"] = {{"method", toString(part.straight_skeleton.method)},
                              {"nodes", part.straight_skeleton.nodes.size()},
                              {"edges", part.straight_skeleton.edges.size()}};
  return json;
}

Json cameraJson(const UiState& ui) {
  const Camera& camera = ui.camera;
  const auto view = standardView(camera);
  Json json;
  json["target"] = {camera.target.x, camera.target.y, camera.target.z};
  json["yaw"] = camera.yaw_rad;
  json["pitch"] = camera.pitch_rad;
  json["zoom"] = camera.zoom;
  json["view"] = view ? Json(toString(*view)) : Json(nullptr);
  json["moving"] = ui.glide.running();
  return json;
}

Json widgetsJson() {
  Json json = Json::array();
  for (const WidgetPlace& place : widgetPlaces()) {
    json.push_back({{"panel", place.panel},
                    {"id", place.id},
                    {"x", place.low.x},
                    {"y", place.low.y},
                    {"width", place.high.x - place.low.x},
                    {"height", place.high.y - place.low.y}});
  }
  return json;
}

Json previewJson(const App& app) {
  const PreviewMeter& meter = app.meter().preview;
  const DrawTool& drawing = app.drawing();
  Json json;
  json["active"] = drawing.active() && drawing.isStroke();
  json["points"] = drawing.active() ? drawing.points().size() : 0;
  json["part"] = nullptr;
  if (const auto& part = app.livePart().part) {
    json["part"] = {{"joints", part->skeleton.joints.size()},
                    {"bones", part->skeleton.bones.size()},
                    {"vertices", part->mesh.positions.size()},
                    {"triangles", part->mesh.triangles.size()},
                    {"method", toString(part->straight_skeleton.method)},
                    {"timings", toJson(part->timings)}};
  }
  const size_t placed = app.evaluation().placed().size();
  const auto& connections = app.rig().connections;
  json["connections"] =
      std::count_if(connections.begin(), connections.end(),
                    [&](const Connection& connection) { return connection.child >= placed; });
  json["error"] =
      app.liveError().status == Status::ok ? Json(nullptr) : Json(app.liveError().message());
  json["frames"] = meter.count();
  json["firstMs"] = meter.first_ms();
  json["lastMs"] = meter.last_ms();
  json["maxMs"] = meter.max_ms();
  json["medianMs"] = meter.median_ms();
  json["veryFirstMs"] = app.meter().first_preview_ms;
  return json;
}

Json drawingJson(const App& app) {
  const Keeping& keeping = app.shelf().keeping;
  Json json;
  json["name"] = keeping.name();
  json["title"] = keeping.title();
  json["changed"] = keeping.changed();
  json["offered"] = keeping.offer() ? Json(keeping.offer()->slot) : Json(nullptr);
  json["recent"] = Json::array();
  for (const Recent& recent : keeping.recent()) {
    json["recent"].push_back(
        {{"slot", recent.slot}, {"name", recent.name}, {"parts", recent.parts}});
  }
  json["pictures"] = Json::array();
  for (const auto& [texture, picture] : app.shelf().pictures.all()) {
    json["pictures"].push_back(picture.broken ? "broken" : picture.pixels ? "ready" : "waiting");
  }
  json["thumbnails"] = Json::array();
  for (const Thumbnail& thumbnail : app.shelf().thumbnails.all()) {
    json["thumbnails"].push_back({{"key", thumbnail.key}, {"ready", thumbnail.ready}});
  }
  return json;
}

/// What poses are made with; joints are where they are seen.
Json posingJson(const App& app) {
  const Posing& posing = app.ui().posing;
  const FigureKeeper& keeper = app.figure();
  Json json;
  json["pose"] = app.document().findPose(posing.pose) ? Json(posing.pose) : Json(nullptr);
  json["joint"] = posing.joint;
  json["pins"] = posing.pins;
  json["ready"] = keeper.ready();
  json["done"] = keeper.done();
  json["failure"] = keeper.failure();
  json["made"] = keeper.ordered();
  json["figure"] = nullptr;
  if (const auto& figure = keeper.figure()) {
    json["figure"] = {{"vertices", figure->vertices.size()},
                      {"triangles", figure->triangles.size()},
                      {"guessed", figure->guessed},
                      {"ms", figure->made_ms}};
  }
  json["joints"] = Json::array();
  for (const Rig::Joint& joint : app.stance().posed.joints) {
    const Vec3 at = joint.position;
    const Vec2 pixel = app.ui().camera.toScreen(at, app.ui().size);
    json["joints"].push_back({{"id", joint.id},
                              {"name", joint.name},
                              {"position", {at.x, at.y, at.z}},
                              {"pixel", {pixel.x, pixel.y}}});
  }
  return json;
}

Json exportJson(const App& app) {
  const FileMaker& file = app.file();
  const FileOptions& options = app.ui().exporting.file;
  Json json;
  json["format"] = toString(options.format);
  json["pose"] = options.pose;
  json["nothing"] = shownBox(app.evaluation()).isEmpty();
  json["waiting"] = file.waiting();
  json["working"] = file.working();
  json["done"] = file.done();
  json["failure"] = file.failure();
  json["leftOut"] = file.leftOut();
  json["metresPerUnit"] = metresPerUnit(shownBox(app.evaluation()), app.ui().exporting.height_m);
  return json;
}

}  // namespace

SkinnedVertices posedFigure(const App& app) {
  const Figure& figure = *app.figure().figure();
  const bool posing = app.ui().tool == ToolKind::pose;
  const Rig& rig = posing ? app.stance().rest : app.evaluation().rig();
  const auto motions = motionsOf(figure, rig, posed(rig, posing ? app.stance().pose : Pose{}));
  return posedVertices(figure, motions, app.ui().posing.skinning);
}

std::string partsReport(const App& app) {
  Json json = Json::array();
  for (const EvaluatedPart& evaluated : app.parts()) {
    Json part;
    part["id"] = evaluated.source->id;
    part["name"] = evaluated.source->name;
    if (evaluated.part) {
      part.update(toJson(*evaluated.part, evaluated.source->frame));
    } else {
      part["error"] = evaluated.error.message();
    }
    json.push_back(std::move(part));
  }
  return toText(json);
}

std::string statsReport(const App& app) {
  const UiState& ui = app.ui();
  Json json;
  json["frames"] = app.framesDrawn();
  json["dpr"] = ui.dpr;
  json["canvas"] = {{"width", ui.size.width},
                    {"height", ui.size.height},
                    {"pixelWidth", std::lround(ui.size.width * ui.dpr)},
                    {"pixelHeight", std::lround(ui.size.height * ui.dpr)}};
  json["camera"] = cameraJson(ui);
  json["selected"] = ui.selection.empty() ? Json(nullptr) : Json(ui.selection.primary());
  json["selection"] = ui.selection.ids;
  json["branch"] = ui.selection.branch;
  json["tool"] = toString(ui.tool);
  json["symmetry"] = ui.symmetry;
  json["show"] = {{"mesh", ui.show.mesh},
                  {"wireframe", ui.show.wireframe},
                  {"bones", ui.show.bones},
                  {"straightSkeleton", ui.show.straight_skeleton},
                  {"proxy", ui.show.proxy}};
  json["evaluation"] = {{"ms", app.meter().last_evaluation_ms},
                        {"stages", toJson(app.meter().last_part)}};
  json["preview"] = previewJson(app);
  json["warm"] = {{"done", app.warmUp().done()},
                  {"runs", app.warmUp().runs()},
                  {"ms", app.warmUp().spent_ms()},
                  {"longestStepMs", app.warmUp().longest_step_ms()}};
  json["drawing"] = drawingJson(app);
  json["posing"] = posingJson(app);
  json["export"] = exportJson(app);
  json["widgets"] = widgetsJson();
  json["message"] = ui.toast ? Json(ui.toast->text) : Json(nullptr);
  return toText(json);
}

}  // namespace marrow
