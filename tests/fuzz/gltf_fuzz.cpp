#include "fuzz/fuzz_target.h"
#include "scene/gltf/gltf.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

// Positions of a triangle, indices, texture coordinates, times 0 and 1, and two rotations.
constexpr const char* kBuffer =
    R"("buffers":[{"byteLength":112,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAECAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAA=="}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":4},{"buffer":0,"byteOffset":40,"byteLength":24},
{"buffer":0,"byteOffset":64,"byteLength":8},{"buffer":0,"byteOffset":72,"byteLength":32,"byteStride":16}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"},
{"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"},{"bufferView":3,"componentType":5126,"count":2,"type":"SCALAR"},
{"bufferView":4,"componentType":5126,"count":2,"type":"VEC4"},{"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,
"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}}}])";

const std::string kScene = std::string(
                               R"({"asset":{"version":"2.0","generator":"Khronos glTF Blender I/O v3.4.50"},
"extensionsUsed":["KHR_lights_punctual"],"scene":0,"scenes":[{"nodes":[0,3],"extensions":{"SACCADE_sky":{"radiance":[0,1,2],"rotation":[0,0,0,1],"picture":"a.ppm"}}}],
"nodes":[{"name":"a","children":[1,2],"rotation":[0,0,0,1],"scale":[1,2,1]},{"mesh":0,"translation":[1,0,0]},
{"camera":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,3,1]},{"extensions":{"KHR_lights_punctual":{"light":0}}}],
"cameras":[{"type":"perspective","perspective":{"yfov":0.7,"aspectRatio":1.5,"znear":0.1}}],
"meshes":[{"name":"m","primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2},"indices":1,"material":0,"mode":4},
{"attributes":{"POSITION":5},"mode":5}]}],
"materials":[{"name":"k","doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.3,"emissiveFactor":[1,0,0],
"pbrMetallicRoughness":{"baseColorFactor":[1,0.5,1,1],"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"scale":[2,2]}}},
"metallicFactor":0.5},"normalTexture":{"index":0,"scale":0.5},"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":3},
"KHR_materials_ior":{"ior":1.4},"KHR_materials_specular":{"specularFactor":0.5}}}],
"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071}],"images":[{"uri":"a.ppm"}],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","color":[1,0,1],"intensity":100,"spot":{"innerConeAngle":0.1}}]}},
"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"rotation"}}],"samplers":[{"input":3,"output":4,"interpolation":"LINEAR"}]}],
)") + kBuffer + "}";

// A triangle with a skin of one joint and a morph target, both of which move.
const std::string kForms =
    R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0,"skin":0,"weights":[0.5]},{"name":"j"}],
"skins":[{"joints":[1],"inverseBindMatrices":3}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},"targets":[{"POSITION":0}]}]}],
"animations":[{"name":"A","channels":[{"sampler":0,"target":{"node":1,"path":"rotation"}},
{"sampler":1,"target":{"node":0,"path":"weights"}}],"samplers":[{"input":4,"output":5},{"input":4,"output":6}]}],
"buffers":[{"byteLength":208,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAAAAAACAPwAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAACAPw=="}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},
{"buffer":0,"byteOffset":36,"byteLength":12},
{"buffer":0,"byteOffset":48,"byteLength":48},
{"buffer":0,"byteOffset":96,"byteLength":64},
{"buffer":0,"byteOffset":160,"byteLength":8},
{"buffer":0,"byteOffset":168,"byteLength":32},
{"buffer":0,"byteOffset":200,"byteLength":8}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5121,"count":3,"type":"VEC4"},{"bufferView":2,"componentType":5126,"count":3,"type":"VEC4"},
{"bufferView":3,"componentType":5126,"count":1,"type":"MAT4"},{"bufferView":4,"componentType":5126,"count":2,"type":"SCALAR"},
{"bufferView":5,"componentType":5126,"count":2,"type":"VEC4"},{"bufferView":6,"componentType":5126,"count":2,"type":"SCALAR"}]})";

std::string word(std::size_t n) {
  const auto v = static_cast<std::uint32_t>(n);
  return {reinterpret_cast<const char*>(&v), sizeof v};
}

// The positions in the binary part.
std::string binary() {
  std::string json =
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"buffers":[{"byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]})";
  while (json.size() % 4) json += ' ';
  const std::string bytes(36, '\1');
  return "glTF" + word(2) + word(28 + json.size() + bytes.size()) + word(json.size()) + "JSON" + json +
         word(bytes.size()) + std::string("BIN\0", 4) + bytes;
}

// The scene stands beside its picture, and may read nothing else.
bool read(std::string_view bytes) {
  static const Scratch files;
  static const std::string picture = files.write("a.ppm", "P3 1 1 255  1 2 3");
  const std::string scene = files.write("scene.gltf", std::string(bytes));
  LoadOptions options;
  options.confined_to = {scene, picture};
  options.threads = 1;
  accepts<SceneError>([&] { outlineGltf(scene, options); });
  return accepts<SceneError>([&] { loadGltf(scene, options); });
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{{kScene, kForms, binary()},
                                 {"\"mode\":6",
                                  "\"skin\":0",
                                  "\"targets\":[{\"POSITION\":0}]",
                                  "\"type\":\"MAT4\"",
                                  "\"weights\":[1]",
                                  "\"children\":[0]",
                                  "\"count\":1000000000",
                                  "\"byteStride\":1",
                                  "\"path\":\"scale\"",
                                  "\"path\":\"weights\"",
                                  "CUBICSPLINE",
                                  "STEP",
                                  "BLEND",
                                  "EXT_meshopt_compression",
                                  "KHR_draco_mesh_compression",
                                  "KHR_materials_transmission",
                                  "\"normalized\":true",
                                  "5120",
                                  "5122",
                                  "5125",
                                  "-1",
                                  "0",
                                  "1e39",
                                  "1e308",
                                  "null",
                                  "[",
                                  "]",
                                  "{",
                                  "}",
                                  ",",
                                  "\"",
                                  "../",
                                  "data:;base64,"},
                                 read,
                                 nullptr,
                                 10000};
  return target;
}

}  // namespace saccade
