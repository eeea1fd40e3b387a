// Answers list_scenes on a thread of its own, because the folder of the scenes may be slow to read.
#pragma once

#include <functional>
#include <mutex>
#include <vector>

#include "app/stores/scene_cache.h"
#include "base/worker.h"
#include "saccade/v1/control.pb.h"

namespace saccade {

class SceneLister {
 public:
  using Answer = std::function<void(v1::Reply)>;

  // Keeps the reference. Begins to index the scenes, and warns in the log where there are none.
  explicit SceneLister(const SceneCache& scenes);

  // Does not block. `answer` is called once, on another thread; all who wait share one look at the folder.
  void ask(Answer answer);

 private:
  void index() const;
  void answerAll();
  v1::Reply list() const;
  v1::SceneInfo describe(const SceneEntry& entry) const;

  const SceneCache& scenes_;
  std::mutex mutex_;
  std::vector<Answer> asked_;
  Worker worker_;
};

}  // namespace saccade
