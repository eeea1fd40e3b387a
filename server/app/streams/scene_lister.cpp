#include "app/streams/scene_lister.h"

#include "app/request/refusal.h"
#include "stream/status.h"

namespace saccade {

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
    for (const SceneEntry& entry : scenes_.library().list()) {
      v1::SceneInfo& scene = *list.add_scenes();
      scene.set_name(entry.name);
      scene.set_description(entry.description);
      for (const auto& name : entry.trajectories) scene.add_trajectories(name);
      scene.set_unavailable(entry.unavailable);
      scene.set_stats(scenes_.stats(entry.name));
    }
    *reply.mutable_status() = okStatus();
  } catch (...) {
    reply.Clear();
    *reply.mutable_status() = statusOfException();
  }
  return reply;
}

}  // namespace saccade
