// A trained network of an ONNX file, which ONNX Runtime runs.
#pragma once

#include <onnxruntime_c_api.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace saccade {

// From planes of a picture to one plane: (1, planes, height, width) to (1, 1, height, width), float32.
// Several threads may run it at once, each run on its caller's thread.
class OnnxSession {
 public:
  // Throws std::runtime_error, which names the file, if it has no such network with this many planes.
  OnnxSession(const std::string& file, int planes);

  // Throws std::runtime_error if the network fails.
  void run(std::span<const float> in, std::span<float> out, int width, int height) const;

 private:
  struct Release {
    void operator()(OrtEnv* env) const;
    void operator()(OrtSession* session) const;
    void operator()(OrtMemoryInfo* memory) const;
    void operator()(OrtValue* value) const;
  };
  template <class T>
  using Owned = std::unique_ptr<T, Release>;

  Owned<OrtValue> tensor(float* values, int planes, int width, int height) const;

  std::string file_;
  int planes_;
  Owned<OrtEnv> env_;
  Owned<OrtMemoryInfo> memory_;
  Owned<OrtSession> session_;
};

}  // namespace saccade
