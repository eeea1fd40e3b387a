// The production denoiser Open Image Denoise, which the EventSVGF paper's OptiX stands for: its filter "RT".
#include <OpenImageDenoise/oidn.h>

#include <stdexcept>
#include <string>

#include "methods/learned_denoiser.h"
#include "methods/optional_method.h"

namespace saccade {
namespace {

constexpr int kScratchMib = 256;  // of a filter; the library takes tiles of larger pictures
constexpr double kWeightBytes = 64. * (1 << 20);

struct Release {
  void operator()(OIDNDevice device) const { oidnReleaseDevice(device); }
  void operator()(OIDNFilter filter) const { oidnReleaseFilter(filter); }
};
template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release>;

class Oidn final : public PictureDenoiser {
 public:
  Oidn(int width, int height);
  void denoise(const Frame& frame, ImageF& I) override;

 private:
  void setPlane(const char* name, const ImageF& plane);
  void setNormals(const GBuffer& g);
  void check() const;

  Owned<OIDNDevice> device_;
  Owned<OIDNFilter> filter_;
  std::vector<float> normals_;  // x, y, z of each pixel
};

Oidn::Oidn(int w, int h)
    : device_(oidnNewDevice(OIDN_DEVICE_TYPE_CPU)),
      normals_(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {
  check();
  oidnSetDeviceInt(device_.get(), "numThreads", 1);
  oidnSetDeviceBool(device_.get(), "setAffinity", false);
  oidnCommitDevice(device_.get());
  filter_.reset(oidnNewFilter(device_.get(), "RT"));
  check();
  oidnSetFilterBool(filter_.get(), "hdr", true);
  oidnSetFilterBool(filter_.get(), "cleanAux", true);  // features are those of pixel centres
  oidnSetFilterInt(filter_.get(), "maxMemoryMB", kScratchMib);
}

// The device is null where it was not made.
void Oidn::check() const {
  const char* why = nullptr;
  if (oidnGetDeviceError(device_.get(), &why) != OIDN_ERROR_NONE)
    throw std::runtime_error(std::string("Open Image Denoise: ") + (why ? why : "unknown error"));
}

// One channel, which the library reads and writes where it lies.
void Oidn::setPlane(const char* name, const ImageF& plane) {
  oidnSetSharedFilterImage(filter_.get(), name, const_cast<float*>(plane.row(0)), OIDN_FORMAT_FLOAT,
                           static_cast<std::size_t>(plane.width()), static_cast<std::size_t>(plane.height()),
                           0, sizeof(float), static_cast<std::size_t>(plane.stride()) * sizeof(float));
}

void Oidn::setNormals(const GBuffer& g) {
  float* to = normals_.data();
  for (int y = 0; y < g.nx.height(); ++y) {
    for (int x = 0; x < g.nx.width(); ++x)
      *to++ = g.nx.at(x, y), *to++ = g.ny.at(x, y), *to++ = g.nz.at(x, y);
  }
  oidnSetSharedFilterImage(filter_.get(), "normal", normals_.data(), OIDN_FORMAT_FLOAT3,
                           static_cast<std::size_t>(g.nx.width()), static_cast<std::size_t>(g.nx.height()), 0,
                           0, 0);
}

// The planes of frames take turns, so that each call names them again.
void Oidn::denoise(const Frame& frame, ImageF& I) {
  setPlane("color", frame.samples.I2);
  setPlane("albedo", frame.g.albedo);
  setNormals(frame.g);
  setPlane("output", I);
  oidnCommitFilter(filter_.get());
  oidnExecuteFilter(filter_.get());
  check();
}

}  // namespace

OptionalMethod oidnMethod() {
  MethodInfo info{"oidn",
                  "Open Image Denoise: filters each frame by itself, then takes the difference",
                  {},
                  [](const ParamValues&) -> SeedPlanner { return SeedPlan::independent; },
                  [](const MethodSetup& setup) -> std::unique_ptr<Method> {
                    return std::make_unique<LearnedDenoiser>(
                        std::make_unique<Oidn>(setup.width, setup.height), setup.width, setup.height);
                  }};
  info.memory = [](const ParamValues&, const ViewTraits& view) {
    return kScratchMib * (1 << 20) + kWeightBytes + 3 * sizeof(float) * view.pixels;
  };
  return {info, ""};
}

}  // namespace saccade
