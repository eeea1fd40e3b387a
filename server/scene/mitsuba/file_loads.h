// The meshes and pictures of a scene file: found while it is read, read together afterwards.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

#include "scene/mitsuba/xml_file.h"

namespace saccade {

class FileLoads {
 public:
  // `load` reads a file that `at` names and writes what no other load writes: it runs in any thread, among
  // the others.
  void add(pugi::xml_node at, std::function<void()> load) { loads_.push_back({at, std::move(load)}); }

  // A load calls it before it takes memory for the pixels of a picture. Throws SceneError where all of the
  // scene's would be more than kMaxScenePixels.
  void takePixels(std::size_t count);

  // Runs all. What they give does not depend on the number of threads. Throws SceneError: what the first of
  // those that fail, in the order of add(), throws, with its place in `file`.
  void run(const XmlFile& file, const LoadOptions& options) const;

 private:
  struct Load {
    pugi::xml_node at;
    std::function<void()> run;
  };
  std::vector<Load> loads_;
  std::atomic<std::size_t> pixels_ = 0;
};

}  // namespace saccade
