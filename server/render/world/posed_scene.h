// A scene at one time, as every kernel sees it. Here stands what changes over time; feeds share the rest.
#pragma once

#include <algorithm>
#include <memory>

#include "base/check.h"
#include "render/world/posed_bodies.h"
#include "render/world/posed_shapes.h"
#include "render/world/render_scene.h"
#include "scene/emitter_strengths.h"

namespace saccade {

class PosedScene {
 public:
  // Shares `scene`. `paths`: of its bodies, in world axes.
  explicit PosedScene(std::shared_ptr<const RenderScene> scene, const std::vector<Trajectory>& paths = {})
      : scene_(std::move(scene)), strengths_(scene_->description()) {
    SACCADE_CHECK(paths.size() == scene_->description().bodies.size());
    if (!paths.empty()) bodies_ = std::make_unique<PosedBodies>(*scene_, paths);
    setTime(TimeNs{0});
  }

  // Stream time, at least 0. Not while a kernel sees it. Allocates nothing, unless a lamp is a body.
  void setTime(TimeNs t) {
    strengths_.setTime(t);
    if (bodies_) bodies_->setTime(t);
  }

  // Adds a key to the path of a body, after its last one.
  void append(std::size_t body, const TimedPose& key) { bodies_->append(body, key); }

  const RenderScene& still() const { return *scene_; }  // what is the same at all times
  const EmitterStrengths& strengths() const { return strengths_; }
  const PosedBodies* bodies() const { return bodies_.get(); }  // nullptr where the scene has none
  const DeformedShapes* deformed() const { return bodies_ ? bodies_->deformed() : nullptr; }  // likewise
  bool posesEqual(const PosedScene& other) const { return !bodies_ || bodies_->equals(*other.bodies_); }
  // A number for the light: equal where all lamps have equal strengths, and all bodies equal poses.
  std::uint64_t state() const { return bodies_ ? bodies_->state(strengths_.state()) : strengths_.state(); }

  // Where a point of a shape is in the scene at another time, and how a direction there has turned.
  Vec3 carried(const ShapePoint& on, Vec3 point, const PosedScene& to) const {
    return on.body == kNoBody ? point : bodies_->carried(on, point, *to.bodies_);
  }
  Vec3 turned(const ShapePoint& on, Vec3 direction, const PosedScene& to) const {
    return on.body == kNoBody ? direction : bodies_->turned(on, direction, *to.bodies_);
  }

  // See RenderScene.
  PosedShapes geometry() const { return {scene_->geometry(), bodies_ ? &bodies_->all() : nullptr}; }
  PosedShapes emitters() const { return {scene_->emitters(), bodies_ ? &bodies_->emitters() : nullptr}; }
  PosedShapes straight() const { return {scene_->straight(), bodies_ ? &bodies_->straight() : nullptr}; }
  // A mesh in the form that it has, where the scene file has its body.
  const Mesh& mesh(std::uint32_t geometry) const {
    const Mesh* mesh = deformed() ? deformed()->mesh(geometry) : nullptr;
    return mesh ? *mesh : scene_->description().meshes[geometry];
  }
  const std::vector<ShapeRow>& shapeRows() const {
    return deformed() ? deformed()->rows() : scene_->shapeRows();
  }
  const Lights& lights() const { return lamps() ? lamps()->lights : scene_->lights(); }
  const DeltaLamps& deltaLamps() const { return lamps() ? lamps()->deltas : scene_->deltaLamps(); }
  const LightColumns& lightColumns() const { return lamps() ? lamps()->columns : scene_->lightColumns(); }
  const AnalyticLight& analyticLight() const { return lamps() ? lamps()->analytic : scene_->analyticLight(); }

 private:
  const PosedLamps* lamps() const { return bodies_ ? bodies_->lamps() : nullptr; }

  std::shared_ptr<const RenderScene> scene_;
  EmitterStrengths strengths_;
  std::unique_ptr<PosedBodies> bodies_;
};

}  // namespace saccade
