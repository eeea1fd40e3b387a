// A scene that is ready for tracing: geometry in Embree, lights, and tables of materials. Any number of feeds
// can share it.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "frame/obstacles.h"
#include "render/lights/analytic_light.h"
#include "render/lights/delta_lamps.h"
#include "render/lights/light_columns.h"
#include "render/lights/lights.h"
#include "render/surface/surface.h"
#include "render/world/embree_scene.h"
#include "render/world/shape_rows.h"
#include "scene/scene.h"

namespace saccade {

// A body's own trees, where the scene file has it. All bodies share a device.
struct BodyShapes {
  EmbreeScene all, emitters, straight;
};

// The trees hold what stands. PosedScene adds the bodies.
class RenderScene : public Obstacles {
 public:
  explicit RenderScene(Scene scene);

  const Scene& description() const { return scene_; }
  // A pose of the world in the scene's own axes: that of every Camera that looks at it.
  Pose inScene(const Pose& T_world_camera) const {
    return {T_world_camera.position - scene_.origin, T_world_camera.rotation};
  }
  const EmbreeScene& geometry() const { return geometry_; }
  const Lights& lights() const { return lights_; }
  // The shapes that emit, alone: rays that meet none of them find no light, unless it may be anywhere.
  const EmbreeScene& emitters() const { return emitters_; }
  // The shapes that let light straight through, alone.
  const EmbreeScene& straight() const { return straight_; }
  // Of Scene::bodies, in their order.
  const std::vector<std::unique_ptr<BodyShapes>>& bodies() const { return bodies_; }
  const std::shared_ptr<EmbreeDevice>& deviceOfBodies() const { return device_of_bodies_; }
  bool lightMayBeAnywhere() const { return scene_.environment.has_value(); }
  const LightColumns& lightColumns() const { return light_columns_; }
  const std::vector<ShapeRow>& shapeRows() const { return shape_rows_; }
  const AnalyticLight& analyticLight() const { return analytic_light_; }
  const DeltaLamps& deltaLamps() const { return delta_lamps_; }
  Shading shading() const { return shading_; }  // what the scene has
  int channels() const { return channels_; }
  Hits find(const ProbeRays& rays) const override;
  std::uint64_t digest() const;  // hashScene() of the description, which is computed once
  std::size_t bytes() const;     // nearly all of its memory: geometry, Embree's tree, textures

  // Whether some surface lets shadow rays through.
  bool hasStraightTransmission() const { return has_straight_transmission_; }

  // The tables of a material.
  const BsdfTables& tables(int material) const { return tables_[material]; }

 private:
  void addBodies();

  Scene scene_;
  EmbreeScene geometry_, emitters_, straight_;
  std::shared_ptr<EmbreeDevice> device_of_bodies_;  // nullptr without any
  std::vector<std::unique_ptr<BodyShapes>> bodies_;
  Lights lights_;
  AnalyticLight analytic_light_;
  DeltaLamps delta_lamps_;
  LightColumns light_columns_;
  std::vector<ShapeRow> shape_rows_;
  Shading shading_;
  int channels_;
  bool has_straight_transmission_;
  std::vector<BsdfTables> tables_;  // by material
  mutable std::once_flag hashed_;
  mutable std::uint64_t digest_ = 0;
};

}  // namespace saccade
