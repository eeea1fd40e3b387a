// A scene at one time, as every kernel sees it. Here stands what changes over time; feeds share the rest.
#pragma once

#include <memory>

#include "render/world/render_scene.h"
#include "scene/emitter_strengths.h"

namespace saccade {

class PosedScene {
 public:
  // Shares `scene`.
  explicit PosedScene(std::shared_ptr<const RenderScene> scene, TimeNs t = TimeNs{0})
      : scene_(std::move(scene)), strengths_(scene_->description()) {
    setTime(t);
  }

  // Stream time, at least 0. Not while a kernel sees it. Allocates nothing.
  void setTime(TimeNs t) { strengths_.setTime(t); }

  const RenderScene& still() const { return *scene_; }  // what is the same at all times
  const EmitterStrengths& strengths() const { return strengths_; }

 private:
  std::shared_ptr<const RenderScene> scene_;
  EmitterStrengths strengths_;
};

}  // namespace saccade
