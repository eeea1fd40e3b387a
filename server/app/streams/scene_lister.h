// Answers list_scenes, away from the control thread: the folder may take long to read.
#pragma once

#include <functional>
#include <mutex>
#include <vector>

#include "app/streams/scene_cache.h"
#include "base/worker.h"
#include "saccade/v1/control.pb.h"

namespace saccade {

class SceneLister {
 public:
  using Answer = std::function<void(v1::Reply)>;
  explicit SceneLister(const SceneCache& scenes) : scenes_(scenes) {}  // keeps a reference

  // `answer` is called once, from another thread. The folder is read once for all who wait.
  void ask(Answer answer);

 private:
  void answerAll();
  v1::Reply list() const;

  const SceneCache& scenes_;
  std::mutex mutex_;
  std::vector<Answer> asked_;
  Worker worker_;
};

}  // namespace saccade
