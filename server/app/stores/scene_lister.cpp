#include "app/stores/scene_lister.h"

#include <spdlog/spdlog.h>

#include "app/request/refusal.h"
#include "base/text_cut.h"
#include "reply/status.h"
#include "scene/library/scene_format.h"

namespace saccade {

SceneLister::SceneLister(const SceneCache& scenes) : scenes_(scenes) {
  worker_.post([this] { index(); });
}

void SceneLister::index() const {
  const SceneLibrary& library = scenes_.library();
  try {
    if (!library.list().empty()) return;
    spdlog::warn("{} holds no scene: a scene is a folder there with one of {}", library.folder().string(),
                 sceneFileNames());
  } catch (const std::exception& fault) {
    spdlog::warn("the scenes cannot be listed: {}", fault.what());
  }
}

void SceneLister::ask(Answer answer) {
  std::lock_guard lock(mutex_);
  asked_.push_back(std::move(answer));
  if (asked_.size() == 1) worker_.post([this] { answerAll(); });
}

void SceneLister::answerAll() {
  std::vector<Answer> asked;
  {
    std::lock_guard lock(mutex_);
    asked.swap(asked_);
  }
  const v1::Reply reply = list();
  for (const Answer& answer : asked) answer(reply);
}

v1::Reply SceneLister::list() const {
  v1::Reply reply;
  try {
    v1::SceneList& list = *reply.mutable_list_scenes();
    for (const SceneEntry& entry : scenes_.library().list()) *list.add_scenes() = describe(entry);
    *reply.mutable_status() = okStatus();
  } catch (...) {
    reply.Clear();
    *reply.mutable_status() = statusOfException();
  }
  return reply;
}

v1::SceneInfo SceneLister::describe(const SceneEntry& entry) const {
  const SceneNote note = scenes_.note(entry.name);
  v1::SceneInfo scene;
  scene.set_name(entry.name);
  scene.set_description(entry.description);
  for (const auto& name : entry.trajectories) scene.add_trajectories(name);
  scene.set_unavailable(entry.unavailable.empty() ? cutText(note.failure, kMaxEntryBytes)
                                                  : entry.unavailable);
  scene.set_stats(cutText(note.stats, kMaxEntryBytes));
  for (const SceneObject& object : entry.objects) {
    v1::SceneObject& listed = *scene.add_objects();
    listed.set_name(object.name);
    listed.set_motion(object.motion);
  }
  for (const std::string& name : entry.animations) scene.add_animations(name);
  return scene;
}

}  // namespace saccade
