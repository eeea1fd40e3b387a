// Reads the meshes and pictures of a scene in parallel, once its own file has been read. For a reader of any
// format.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "scene/files/load_options.h"
#include "scene/files/scene_error.h"

namespace saccade {

class FileLoads {
 public:
  // Adds the place in the scene's file to a message.
  using Locate = std::function<SceneError(const std::string& what)>;

  // `load` reads one file. It runs on any thread beside the others, so it must write what no other writes. A
  // SceneError that it throws is told as located(what).
  void add(Locate located, std::function<void()> load) {
    loads_.push_back({std::move(located), std::move(load)});
  }

  // A load calls this before it takes memory for the pixels of a picture. Throws SceneError where all
  // pictures of the scene together would have more than kMaxScenePixels.
  void takePixels(std::size_t count);

  // Runs all loads. The result does not depend on the number of threads. Throws the error of the first load
  // that failed, in the order of add(), or tells all to options.fault.
  void run(const LoadOptions& options) const;

 private:
  struct Load {
    Locate located;
    std::function<void()> run;
  };
  std::vector<Load> loads_;
  std::atomic<std::size_t> pixels_ = 0;
};

}  // namespace saccade
