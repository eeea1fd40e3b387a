// Faulty glTF files: each is refused with the place of the fault, and what would be valid.
#include <limits>

#include "scene/files/limits.h"
#include "scene/gltf_scratch.h"

namespace saccade {
namespace {

using test::GltfArrays;

std::string faultOf(const std::vector<std::string>& parts, const GltfArrays& arrays = test::triangle()) {
  const Scratch files;
  return errorOf([&] { test::loadGltfOf(files, arrays, parts); });
}
std::string faultOfText(const std::string& text) {
  const Scratch files;
  return errorOf([&] { loadGltf(files.write("scene.gltf", text), {}); });
}
std::string faultOfPart(const std::string& part, const GltfArrays& arrays = test::triangle()) {
  return faultOf({R"("meshes":[{"primitives":[)" + part + "]}]", test::kTriangleNode}, arrays);
}
std::string faultOfMaterial(const std::string& material) {
  return faultOf({R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}])",
                  test::kTriangleNode, R"("materials":[)" + material + "]"});
}

TEST(GltfErrors, NameTheLineOfWhatIsNoJson) {
  expectContains(faultOfText("{\n\"asset\": {,}}"),
                 "scene.gltf: [json.exception.parse_error.101] parse error at line 2");
  expectContains(faultOfText("[]"), "is not an object");
  expectContains(faultOfText(std::string(100, '[')), "nested more than 64 deep");
  expectContains(faultOfText(R"({"asset":{"version":"1.0"}})"), "is glTF 1.0; only version 2.0 is read");
  expectContains(faultOfText(R"({"asset":{}})"), "scene.gltf.asset: has no version");
}

TEST(GltfErrors, NameRequiredExtensionsThatAreNotRead) {
  const std::string fault =
      faultOf({test::kTriangleMesh, test::kTriangleNode, R"("extensionsRequired":["KHR_texture_basisu"])"});
  expectContains(fault, "requires the extensions KHR_texture_basisu; supported: EXT_meshopt_compression");
}

TEST(GltfErrors, OptionalExtensionsAreTold) {
  const Scene scene = test::loadTriangle(
      {test::kTriangleNode, R"("extensionsUsed":["KHR_materials_clearcoat","KHR_lights_punctual"])"});
  EXPECT_EQ(scene.unread.at(0), "not shown are the extensions KHR_materials_clearcoat");
  for (const std::string name :
       {"anisotropy", "sheen", "iridescence", "dispersion", "diffuse_transmission"}) {
    const std::string list = R"(:["KHR_materials_)" + name + "\"]";
    expectContains(test::loadTriangle({test::kTriangleNode, "\"extensionsUsed\"" + list}).unread.at(0), name);
    expectContains(faultOf({test::kTriangleMesh, test::kTriangleNode, "\"extensionsRequired\"" + list}),
                   "requires the extensions KHR_materials_" + name);
  }
}

TEST(GltfErrors, OfNodes) {
  expectContains(faultOf({test::kTriangleMesh,
                          R"("nodes":[{"children":[1]},{"children":[0]}],"scenes":[{"nodes":[0]}])"}),
                 "nodes[0]: stands in the scene twice");
  expectContains(faultOf({test::kTriangleMesh, R"("nodes":[{"children":[7]}])"}),
                 "nodes[0].children[0]: is 7, and there are 1");
  expectContains(faultOf({test::kTriangleMesh, R"("nodes":[{"mesh":"a"}])"}),
                 "nodes[0].mesh: is not a number");
  expectContains(faultOf({test::kTriangleMesh, R"("nodes":[{"mesh":0,"rotation":[0,0,0,0]}])"}), "no length");
  expectContains(faultOf({test::kTriangleMesh, R"("nodes":[{"mesh":0,"scale":[1,1]}])"}),
                 "array of 3 numbers");
  expectContains(faultOf({test::kTriangleMesh, R"("nodes":[{}])"}), "the scene has no mesh");
  std::string deep = R"("nodes":[)";
  for (int i = 0; i <= kMaxNodeDepth; ++i) deep += R"({"children":[)" + std::to_string(i + 1) + "]},";
  expectContains(faultOf({test::kTriangleMesh, deep + R"({"mesh":0}])"}), "nested more than 256 deep");
}

TEST(GltfErrors, OfAccessors) {
  GltfArrays arrays = test::triangle();
  arrays.whole<std::uint8_t>({0, 1, 3}, 5121, "SCALAR");
  expectContains(faultOfPart(R"({"attributes":{"POSITION":0},"indices":1})", arrays),
                 "accessors[1]: an index is beyond the 3 vertices");
  expectContains(faultOfPart(R"({"attributes":{"POSITION":1}})", arrays),
                 "is of type SCALAR, where 3 numbers");
  arrays.accessor(R"("bufferView":0,"componentType":5126,"count":4,"type":"VEC3")");
  expectContains(faultOfPart(R"({"attributes":{"POSITION":2}})", arrays),
                 "reaches beyond the end of its view");
  arrays.accessor(R"("componentType":5126,"count":100000000,"type":"VEC3")");
  expectContains(faultOfPart(R"({"attributes":{"POSITION":3}})", arrays), "elements without bytes");
  arrays.accessor(R"("componentType":5126,"count":1e15,"type":"VEC3")");
  expectContains(faultOfPart(R"({"attributes":{"POSITION":4}})", arrays), "accessors[4].count: is more than");
  arrays.accessor(R"("bufferView":0,"componentType":5124,"count":3,"type":"VEC3")");
  expectContains(faultOfPart(R"({"attributes":{"POSITION":5}})", arrays),
                 "is not a type of numbers; there are: 5120");
  arrays.floats({0, 0, 0, 1, 0, 0, 0, std::numeric_limits<float>::infinity(), 0}, "VEC3");
  expectContains(faultOfPart(R"({"attributes":{"POSITION":6}})", arrays),
                 "POSITION has a number that is not finite");
  expectContains(faultOfPart(R"({"attributes":{}})"), "attributes: has no POSITION");
  expectContains(faultOfPart(R"({"attributes":{"POSITION":0},"mode":7})"), "mode must be from 0 to 6");
}

TEST(GltfErrors, OfBuffers) {
  const Scratch files;
  const std::string parts = std::string(test::kTriangleMesh) + "," + test::kTriangleNode;
  const auto fault = [&](const std::string& uri) {
    const std::string text = test::gltf({parts, test::triangle().json(uri)});
    return errorOf([&] { loadGltf(files.write("scene.gltf", text), {}); });
  };
  expectContains(fault(R"("uri":"absent.bin",)"), "buffers[0].uri: ");
  expectContains(fault(R"("uri":"data:;base64,AAAA",)"), "has less than 36 bytes");
  expectContains(fault(R"("uri":"data:,AAAA",)"), "not base64");
  expectContains(fault(""), "reaches beyond the end of its buffer");
}

// A scene of a server reads nothing outside of its folder.
TEST(GltfErrors, OfFilesThatLeadOut) {
  const Scratch files;
  files.write("data.bin", test::triangle().bytes());
  const std::string parts = std::string(test::kTriangleMesh) + "," + test::kTriangleNode;
  for (const std::string uri : {"../data.bin", "%2E%2E/data.bin"}) {
    const std::string path = files.write(
        "scenes/mine/scene.gltf", test::gltf({parts, test::triangle().json("\"uri\":\"" + uri + "\",")}));
    LoadOptions options;
    options.confined_to = {files.path("scenes")};
    files.write("scenes/data.bin", "short");
    expectContains(errorOf([&] { loadGltf(path, options); }), "has less than 36 bytes");
    options.confined_to = {files.path("scenes/mine")};
    expectContains(errorOf([&] { loadGltf(path, options); }), "leads out of the folder of the scenes");
  }
}

TEST(GltfErrors, OfMaterials) {
  expectContains(faultOfMaterial(R"({"pbrMetallicRoughness":{"roughnessFactor":2}})"), "within [0, 1]");
  expectContains(faultOfMaterial(R"({"alphaMode":"CLEAR"})"), "alphaMode is not OPAQUE, MASK or BLEND");
  expectContains(faultOfMaterial(R"({"normalTexture":{"index":0}})"), "index: is 0, and there are 0");
  expectContains(faultOfMaterial(R"({"emissiveFactor":[-1,0,0]})"), "emissiveFactor");
}

TEST(GltfErrors, OfAnimations) {
  GltfArrays arrays = test::triangle();
  arrays.floats({1, 0}, "SCALAR");
  arrays.floats({0, 0, 0}, "VEC3");
  const auto fault = [&](const std::string& channel, const std::string& sampler) {
    return faultOf({test::kTriangleMesh, test::kTriangleNode,
                    R"("animations":[{"channels":[)" + channel + R"(],"samplers":[)" + sampler + "]}]"},
                   arrays);
  };
  const std::string move = R"({"sampler":0,"target":{"node":0,"path":"translation"}})";
  expectContains(fault(move, R"({"input":1,"output":2})"), "the times of its keys must rise");
  expectContains(fault(move, R"({"input":0,"output":2})"), "accessors[0]: is of type VEC3");
  expectContains(fault(move, R"({"input":1,"output":2,"interpolation":"CUBIC"})"),
                 "is not LINEAR, STEP or CUBICSPLINE");
  expectContains(fault(R"({"sampler":1,"target":{"node":0,"path":"translation"}})", ""),
                 "is 1, and there are 0");
}

}  // namespace
}  // namespace saccade
