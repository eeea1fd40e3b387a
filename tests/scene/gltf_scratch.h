// Small glTF files for the tests of their reader.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/gltf/gltf.h"
#include "scene/scratch.h"

namespace saccade::test {

// Arrays of numbers for a glTF file, in one buffer.
class GltfArrays {
 public:
  // Each returns the index of the accessor.
  int floats(const std::vector<float>& v, const std::string& type) {
    return add(v, 5126, type, v.size() / numbersOf(type));
  }
  template <class T>
  int whole(const std::vector<T>& v, int component, const std::string& type, const std::string& more = {}) {
    return add(v, component, type, v.size() / numbersOf(type), more);
  }
  // Elements of `bytes` that lie as they are; `view` has further properties of the view.
  int raw(const std::string& bytes, int component, const std::string& type, std::size_t count,
          const std::string& view = {}) {
    while (bytes_.size() % 4) bytes_ += '\0';
    views_ += std::string(views_.empty() ? "" : ",") + R"({"buffer":0,"byteOffset":)" +
              std::to_string(bytes_.size()) + R"(,"byteLength":)" + std::to_string(bytes.size()) + view + "}";
    bytes_ += bytes;
    return accessor(R"("bufferView":)" + std::to_string(view_count_++) + R"(,"componentType":)" +
                    std::to_string(component) + R"(,"count":)" + std::to_string(count) + R"(,"type":")" +
                    type + '"');
  }
  int accessor(const std::string& json) {
    accessors_ += std::string(accessors_.empty() ? "" : ",") + "{" + json + "}";
    return accessor_count_++;
  }
  int lastView() const { return view_count_ - 1; }

  const std::string& bytes() const { return bytes_; }
  // "buffers", "bufferViews" and "accessors" of a file beside "data.bin"; without `uri` of a .glb.
  std::string json(const std::string& uri = R"("uri":"data.bin",)") const {
    return R"("buffers":[{)" + uri + R"("byteLength":)" + std::to_string(bytes_.size()) +
           R"(}],"bufferViews":[)" + views_ + R"(],"accessors":[)" + accessors_ + "]";
  }

 private:
  static std::size_t numbersOf(const std::string& type) {
    if (type == "MAT4") return 16;
    return type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
  }
  template <class T>
  int add(const std::vector<T>& v, int component, const std::string& type, std::size_t count,
          const std::string& more = {}) {
    const std::string bytes(reinterpret_cast<const char*>(v.data()), v.size() * sizeof(T));
    const int index = raw(bytes, component, type, count);
    if (!more.empty()) accessors_.insert(accessors_.size() - 1, more);
    return index;
  }

  std::string bytes_, views_, accessors_;
  int view_count_ = 0, accessor_count_ = 0;
};

// The triangle (0,0,0), (1,0,0), (0,1,0) as the accessor 0.
inline GltfArrays triangle() {
  GltfArrays arrays;
  arrays.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  return arrays;
}
inline constexpr const char* kTriangleMesh = R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";
inline constexpr const char* kTriangleNode = R"("nodes":[{"mesh":0,"name":"it"}])";

// A file of these parts. It has the asset besides.
inline std::string gltf(const std::vector<std::string>& parts) {
  std::string text = R"({"asset":{"version":"2.0"})";
  for (const std::string& part : parts) text += "," + part;
  return text + "}";
}

// The path of a .gltf of these parts, beside its buffer.
inline std::string writeGltf(const Scratch& files, const GltfArrays& arrays, std::vector<std::string> parts,
                             const std::string& name = "scene.gltf") {
  files.write("data.bin", arrays.bytes());
  parts.push_back(arrays.json());
  return files.write(name, gltf(parts));
}
inline Scene loadGltfOf(const Scratch& files, const GltfArrays& arrays,
                        const std::vector<std::string>& parts) {
  return loadGltf(writeGltf(files, arrays, parts), {});
}
// Of the triangle at one node.
inline Scene loadTriangle(const std::vector<std::string>& parts) {
  const Scratch files;
  std::vector<std::string> all = parts;
  all.push_back(kTriangleMesh);
  return loadGltfOf(files, triangle(), all);
}

}  // namespace saccade::test
