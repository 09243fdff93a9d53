// What the app does with drawings as a whole: begins, opens, saves and keeps them.
#include <algorithm>
#include <cctype>
#include <utility>

#include "app.h"
#include "importing.h"
#include "io/document_json.h"
#include "samples.h"
#include "solid/close.h"

namespace marrow {
namespace {

constexpr double kThumbnailBudget_ms = 10;  // of a frame

/// "dog.json cannot be opened: it is empty."
std::string cannot(const char* done, const std::string& what, const Error& error) {
  std::string why = error.message();
  for (const char* start : {"It ", "Its ", "More ", "The ", "This "}) {
    if (why.rfind(start, 0) == 0) why[0] = static_cast<char>(std::tolower(why[0]));
  }
  return (what.empty() ? "This drawing" : what) + " cannot be " + done + ": " + why;
}

}  // namespace

void App::replace(Document document, const Origin& origin, const std::string& step) {
  closeEdit();
  tools_.cancelGesture();
  hand_.cancel(ui_);
  document.drawing = shelf_.keeping.add(document, origin);
  apply(ReplaceDocument{std::move(document), step});
  ui_.selection.clear();
  ui_.posing.forgetCharacter();
  ui_.exporting.forgetCharacter();
  file_.forgetLast();
  shelf_.keeping.withdrawOffer();
  update();
  shelf_.keeping.update(this->document(), ui_.now_ms, false);
}

Result<uint64_t> App::open(const std::string& text, const std::string& file, const Origin& origin) {
  auto opened = readDocument(text);
  if (!opened) {
    say(cannot("opened", file, opened.error()));
    return opened.error();
  }
  const std::string name = origin.name.empty() ? nameIn(*opened) : origin.name;
  replace(std::move(*opened), origin, name.empty() ? "Open" : "Open " + name);
  ui_.glide.stop();
  ui_.camera.yaw_rad = 0;
  ui_.camera.pitch_rad = 0;
  frame_all_next_ = true;
  return document().drawing;
}

Result<App::Opened> App::openFile(const std::string& bytes, const std::string& file,
                                  const Origin& origin) {
  const auto format = meshFormatOf(bytes, file);
  if (!format) {
    if (const auto error = unknownFile(bytes, file)) {
      say(cannot("opened", file, *error));
      return *error;
    }
    const auto drawing = open(bytes, file, origin);
    if (!drawing) return drawing.error();
    return Opened{*drawing, true};
  }
  const auto text = *format == MeshFormat::glb ? documentInGlb(bytes) : std::nullopt;
  if (text) {
    Origin inside = origin;
    inside.place.clear();
    const auto drawing = open(*text, file, inside);
    if (!drawing) return drawing.error();
    return Opened{*drawing, false};
  }
  const auto imported = importFile(bytes, file, *format);
  if (!imported) return imported.error();
  return Opened{document().drawing, false};
}

Result<bool> App::importFile(const std::string& bytes, const std::string& file, MeshFormat format) {
  const auto model = importModel(bytes, format);
  if (!model) {
    say(cannot("imported", file, model.error()));
    return model.error();
  }
  closeEdit();
  tools_.cancelGesture();
  hand_.cancel(ui_);
  const Camera camera = ui_.glide.running() ? ui_.glide.destination() : ui_.camera;
  ImportPart command = asSeen(model->mesh, camera, ui_.size, pivot());
  command.name = nameOfFile(file);
  const auto next = marrow::apply(document(), command);
  if (!next) {
    say(cannot("imported", file, next.error()));
    return next.error();
  }
  apply(command);
  std::string said;
  if (model->left_out > 0) {
    const std::string count = std::to_string(model->left_out);
    said = model->left_out == 1
               ? "A piece of " + file + " is open, so it was left out."
               : count + " pieces of " + file + " are open, so they were left out.";
  }
  if (crossesItself(*command.mesh)) {
    said += (said.empty() ? file + " passes" : " The rest passes") +
            " through itself, so it cannot become one body with other parts.";
  }
  if (!said.empty()) say(said);
  redraw();
  return true;
}

void App::addPicture(const std::string& image, int width, int height) {
  Reference reference;
  const Camera camera = ui_.glide.running() ? ui_.glide.destination() : ui_.camera;
  reference.view = nearestView(camera);
  reference.image = std::make_shared<const std::string>(image);
  if (const Reference* before = referenceIn(document(), reference.view)) {
    reference.opacity = before->opacity;
  }
  closeEdit();
  apply(SetReference{fitted(reference, width, height, camera, ui_.size)});
  // It is seen in its own view alone.
  show(static_cast<StandardView>(reference.view));
  ui_.openOnly(&PanelsOpen::picture);
  redraw();
}

void App::peeked(const std::string& slot, const std::string& text) {
  for (const Recent& recent : shelf_.keeping.recent()) {
    if (recent.slot == slot) shelf_.thumbnails.want(recent.key(), text);
  }
  frames_to_settle_ = std::max(frames_to_settle_, 1);
}

void App::keepNow() {
  shelf_.keeping.update(document(), ui_.now_ms, false);
  shelf_.keeping.keepNow();
}

void App::act(const FileAction& action) {
  Keeping& keeping = shelf_.keeping;
  switch (action.kind) {
    case FileAction::Kind::begin:
      replace({}, {}, "New drawing");
      break;
    case FileAction::Kind::open:
      keeping.askOpen(action.what);
      break;
    case FileAction::Kind::save:
    case FileAction::Kind::save_as:
      keeping.update(document(), ui_.now_ms, false);
      keeping.askSave(action.kind == FileAction::Kind::save_as, action.what);
      break;
    case FileAction::Kind::sample:
    case FileAction::Kind::thumbnail:
      for (const Sample& sample : samples()) {
        if (sample.file != action.what) continue;
        if (action.kind == FileAction::Kind::sample) {
          Origin origin;
          origin.known = true;
          open(std::string(sample.text), action.what, origin);
        } else {
          shelf_.thumbnails.want(action.what, std::string(sample.text));
        }
      }
      break;
    case FileAction::Kind::list:
      keeping.ask(Job::Kind::list);
      break;
    case FileAction::Kind::peek:
      keeping.ask(Job::Kind::peek, action.what);
      break;
    case FileAction::Kind::restore:
      keeping.ask(Job::Kind::restore, action.what);
      break;
    case FileAction::Kind::dismiss:
      keeping.withdrawOffer();
      keeping.ask(Job::Kind::dismiss, action.what);
      break;
    case FileAction::Kind::rename:
      keeping.rename(action.what);
      break;
    case FileAction::Kind::picture:
      keeping.ask(Job::Kind::picture);
      break;
    case FileAction::Kind::make:
      makeFile(action.what);
      break;
    case FileAction::Kind::give_up:
      file_.giveUp();
      say("No file was made.");
      break;
  }
}

bool App::handleFileKey(Key key) {
  if (key != Key::open && key != Key::save && key != Key::save_as) return false;
  if (tools_.drawing().active()) return true;
  if (!shelf_.keeping.dialogs && (key != Key::save || shelf_.keeping.place().empty())) {
    ui_.openOnly(&PanelsOpen::file);  // the path is asked for there
    say(key == Key::open ? "Type which file to open, then press Open."
                         : "Type where to save it, then press Save.");
    return true;
  }
  act({key == Key::open   ? FileAction::Kind::open
       : key == Key::save ? FileAction::Kind::save
                          : FileAction::Kind::save_as,
       {}});
  return true;
}

void App::updateShelf(FrameResult& result) {
  const bool busy = tools_.drawing().active() || ui_.edit;
  Keeping& keeping = shelf_.keeping;
  keeping.update(document(), ui_.now_ms, busy);
  if (busy || !keeping.empty()) keeping.withdrawOffer();
  result.wake_after_ms = std::min(result.wake_after_ms, keeping.due_ms() - ui_.now_ms);

  for (const Picture* picture : shelf_.pictures.update(shown_)) {
    Job job;
    job.kind = Job::Kind::decode;
    job.drawing = picture->texture;
    job.text = *picture->image;
    keeping.ask(std::move(job));
  }
  // Not while a hand draws: then the frames belong to it.
  if (!busy && shelf_.thumbnails.busy()) {
    shelf_.thumbnails.work(kThumbnailBudget_ms);
    result.again = true;
    frames_to_settle_ = std::max(frames_to_settle_, 1);
  }
}

}  // namespace marrow
