#include "truth/object_numbers.h"

namespace saccade {
namespace {

// Calls `take` with the place and the body of each shape.
void forEachShape(const Scene& scene, const auto& take) {
  std::uint32_t place = 0;
  for (const Mesh& mesh : scene.meshes) take(place++, mesh.body);
  for (const Sphere& sphere : scene.spheres) take(place++, sphere.body);
}

}  // namespace

std::vector<std::uint32_t> bodyNumbers(const Scene& scene) {
  std::vector<std::uint32_t> numbers(scene.bodies.size());  // 0: not seen yet
  std::uint32_t last = 0;
  forEachShape(scene, [&](std::uint32_t place, int body) {
    last = place + 1;
    if (body != kStands && numbers[static_cast<std::size_t>(body)] == 0)
      numbers[static_cast<std::size_t>(body)] = last;
  });
  for (std::uint32_t& number : numbers)
    if (number == 0) number = ++last;
  return numbers;
}

std::vector<std::uint32_t> objectNumbers(const Scene& scene) {
  const std::vector<std::uint32_t> of_bodies = bodyNumbers(scene);
  std::vector<std::uint32_t> numbers;
  forEachShape(scene, [&](std::uint32_t place, int body) {
    numbers.push_back(body == kStands ? place + 1 : of_bodies[static_cast<std::size_t>(body)]);
  });
  return numbers;
}

}  // namespace saccade
