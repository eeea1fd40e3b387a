#include "methods/onnx_session.h"

#include <array>
#include <stdexcept>
#include <vector>

namespace saccade {
namespace {

constexpr const char *kInput = "planes", *kOutput = "light";

const OrtApi& ort() {
  static const OrtApi* api = OrtGetApiBase()->GetApi(ORT_API_VERSION);
  if (!api) throw std::runtime_error("ONNX Runtime is older than the headers of the build");
  return *api;
}

void check(OrtStatus* status, const std::string& file) {
  if (!status) return;
  const std::string why = ort().GetErrorMessage(status);
  ort().ReleaseStatus(status);
  throw std::runtime_error(file + ": " + why);
}

// One thread, in the order of the graph: equal frames give equal light.
OrtSession* open(const OrtEnv* env, const std::string& file) {
  OrtSessionOptions* options = nullptr;
  OrtSession* session = nullptr;
  check(ort().CreateSessionOptions(&options), file);
  const std::unique_ptr<OrtSessionOptions, void (*)(OrtSessionOptions*)> owned(options,
                                                                               ort().ReleaseSessionOptions);
  check(ort().SetIntraOpNumThreads(options, 1), file);
  check(ort().SetSessionExecutionMode(options, ORT_SEQUENTIAL), file);
  // An arena keeps up to twice what the largest picture needs.
  check(ort().DisableCpuMemArena(options), file);
  check(ort().CreateSession(env, file.c_str(), options, &session), file);
  return session;
}

}  // namespace

void OnnxSession::Release::operator()(OrtEnv* env) const {
  ort().ReleaseEnv(env);
}
void OnnxSession::Release::operator()(OrtSession* session) const {
  ort().ReleaseSession(session);
}
void OnnxSession::Release::operator()(OrtMemoryInfo* memory) const {
  ort().ReleaseMemoryInfo(memory);
}
void OnnxSession::Release::operator()(OrtValue* value) const {
  ort().ReleaseValue(value);
}

OnnxSession::OnnxSession(const std::string& file, int planes) : file_(file), planes_(planes) {
  OrtEnv* env = nullptr;
  check(ort().CreateEnv(ORT_LOGGING_LEVEL_ERROR, "saccade", &env), file);
  env_.reset(env);
  OrtMemoryInfo* memory = nullptr;
  check(ort().CreateCpuMemoryInfo(OrtDeviceAllocator, OrtMemTypeDefault, &memory), file);
  memory_.reset(memory);
  session_.reset(open(env_.get(), file));
  constexpr int kEdge = 8;  // a small picture shows whether names and shapes are right
  std::vector<float> in(static_cast<std::size_t>(planes) * kEdge * kEdge), out(kEdge * kEdge);
  run(in, out, kEdge, kEdge);
}

OnnxSession::Owned<OrtValue> OnnxSession::tensor(float* values, int planes, int w, int h) const {
  const std::array<std::int64_t, 4> shape{1, planes, h, w};
  const auto bytes = sizeof(float) * static_cast<std::size_t>(planes) * static_cast<std::size_t>(w) *
                     static_cast<std::size_t>(h);
  OrtValue* value = nullptr;
  check(ort().CreateTensorWithDataAsOrtValue(memory_.get(), values, bytes, shape.data(), shape.size(),
                                             ONNX_TENSOR_ELEMENT_DATA_TYPE_FLOAT, &value),
        file_);
  return Owned<OrtValue>(value);
}

void OnnxSession::run(std::span<const float> in, std::span<float> out, int w, int h) const {
  const Owned<OrtValue> from = tensor(const_cast<float*>(in.data()), planes_, w, h);
  const Owned<OrtValue> to = tensor(out.data(), 1, w, h);
  const OrtValue* from_value = from.get();
  OrtValue* to_value = to.get();
  check(ort().Run(session_.get(), nullptr, &kInput, &from_value, 1, &kOutput, 1, &to_value), file_);
}

}  // namespace saccade
