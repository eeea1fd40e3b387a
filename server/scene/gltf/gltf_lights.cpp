#include "scene/gltf/gltf_lights.h"

#include <cmath>
#include <numbers>

#include "scene/files/limits.h"

namespace saccade {
namespace {

constexpr const char* kExtension = "KHR_lights_punctual";
constexpr double kBlenderLumensPerWatt = 683;

double unitOf(const JsonNode& root) {
  const bool blender = root.at("asset").text("generator").starts_with("Khronos glTF Blender I/O");
  return blender ? 1 / kBlenderLumensPerWatt : 1;
}

Rgb lightOf(const JsonNode& root, const JsonNode& light) {
  const auto color = light.numbers<3>("color", {1, 1, 1});
  const double intensity = light.number("intensity", 1) * unitOf(root);
  return checkedLight(light, {color[0] * intensity, color[1] * intensity, color[2] * intensity});
}

SpotLight spotOf(const JsonNode& light, Vec3 position, Vec3 axis, Rgb intensity, const std::string& name) {
  const JsonNode spot = light.object("spot");
  const double inner = spot.number("innerConeAngle", 0);
  const double outer = spot.number("outerConeAngle", std::numbers::pi / 4);
  if (!(inner >= 0 && inner <= outer && outer <= std::numbers::pi / 2 + 1e-6))
    throw light.error("the angles of the cone must rise from 0 to pi / 2 at most");
  return {position, axis, intensity, static_cast<float>(inner), static_cast<float>(outer), name};
}

}  // namespace

Rgb checkedLight(const JsonNode& of, Vec3d light) {
  for (const double part : {light.x, light.y, light.z})
    if (!(part >= 0 && part <= kMaxRadiance)) throw of.error("the light must be within [0, 1e18]");
  return toFloat(light);
}

bool addLight(const JsonNode& root, const JsonNode& node, const GltfLamp& lamp, Scene& scene) {
  const auto extension = node.extension(kExtension);
  if (!extension) return false;
  const auto lights = root.extension(kExtension);
  if (!lights) throw extension->error("the file has no lamps");
  const JsonNode light = lights->entry("lights", extension->at("light").index(lights->count("lights")));
  const Rgb intensity = lightOf(root, light);
  const Vec3 position = toFloat(lamp.to_world.translation - scene.origin);
  const Vec3d along = -lamp.to_world.z;
  if (!(length(along) > 0 && std::isfinite(length(along)) && std::isfinite(dot(position, position))))
    throw node.error("the lamp has no direction, or is too far away for float numbers");
  const Vec3 axis = toFloat(normalize(along));
  const std::string type = light.at("type").text();
  if (type == "point")
    scene.point_lights.push_back({position, intensity, lamp.name});
  else if (type == "spot")
    scene.spot_lights.push_back(spotOf(light, position, axis, intensity, lamp.name));
  else if (type == "directional")
    scene.directional_lights.push_back({axis, intensity, lamp.name});
  else
    throw light.error("the type is not point, spot or directional");
  return true;
}

}  // namespace saccade
