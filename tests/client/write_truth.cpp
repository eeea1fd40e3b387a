// Writes events and truth channels whose numbers follow a formula: write_truth FILE [partial]. The tests of
// files in Python know the formula. With `partial` the recording is interrupted after the last sample.
#include <algorithm>
#include <cstring>

#include "client/recording/recording_file.h"

namespace saccade::client {
namespace {

constexpr std::uint32_t kWidth = 5, kHeight = 3;
constexpr std::int64_t kMs = 1'000'000;

void addChannel(v1::Recording& about, const std::string& name, v1::Layout layout, v1::Element element,
                const std::vector<std::string>& planes) {
  v1::RecordedTruth& channel = *about.add_truth();
  channel.set_name(name);
  channel.set_width(kWidth), channel.set_height(kHeight);
  channel.mutable_info()->set_name(name);
  channel.mutable_info()->set_unit("unit of " + name);
  channel.mutable_info()->set_description("what " + name + " is");
  channel.mutable_info()->set_layout(layout);
  channel.mutable_info()->set_element(element);
  channel.mutable_info()->mutable_planes()->Assign(planes.begin(), planes.end());
}

// The events are of view 0, whose lens is radial-tangential. View 1 has a fisheye lens and a channel alone.
void addRequest(v1::Recording& about) {
  v1::OpenStream& request = *about.mutable_request();
  request.add_sensors();
  for (v1::View* view : {request.mutable_view(), request.add_further_views()}) {
    view->set_width(kWidth), view->set_height(kHeight);
    v1::Intrinsics& k = *view->mutable_intrinsics();
    k.set_fx(40), k.set_fy(41), k.set_cx(2.25), k.set_cy(1.5);
  }
  request.mutable_view()->mutable_distortion()->set_model(v1::DISTORTION_MODEL_RADTAN);
  request.mutable_further_views(0)->mutable_distortion()->set_model(v1::DISTORTION_MODEL_EQUIDISTANT);
  for (const double k : {-0.1, 0.02, 0.001, -0.002}) {
    request.mutable_view()->mutable_distortion()->add_coefficients(k);
    request.mutable_further_views(0)->mutable_distortion()->add_coefficients(k);
  }
  for (const v1::RecordedTruth& channel : about.truth()) request.add_truth()->set_name(channel.info().name());
  request.mutable_truth(request.truth_size() - 1)->set_view(1);
}

v1::Recording describe() {
  v1::Recording about;
  about.set_width(kWidth), about.set_height(kHeight);
  constexpr auto kPicture = v1::LAYOUT_PICTURE, kRows = v1::LAYOUT_ROWS;
  addChannel(about, "depth", kPicture, v1::ELEMENT_F32, {"z"});
  addChannel(about, "flow", kPicture, v1::ELEMENT_F32, {"x", "y", "valid"});
  addChannel(about, "frame", kPicture, v1::ELEMENT_U8, {"value"});
  addChannel(about, "frame16", kPicture, v1::ELEMENT_U16, {"value"});
  addChannel(about, "colour", kPicture, v1::ELEMENT_U8, {"r", "g", "b", "a"});
  addChannel(about, "ids", kPicture, v1::ELEMENT_U32, {"object", "material"});
  addChannel(about, "pose", kRows, v1::ELEMENT_F64, {"x", "y", "z", "qx", "qy", "qz", "qw"});
  addChannel(about, "velocity", kRows, v1::ELEMENT_F32, {"vx", "vy", "vz", "wx", "wy", "wz"});
  addChannel(about, "imu", kRows, v1::ELEMENT_F64, {"ax", "ay", "az", "gx", "gy", "gz"});
  addChannel(about, "other", kRows, v1::ELEMENT_U16, {"a", "b"});
  addChannel(about, "depth_view1", kPicture, v1::ELEMENT_F32, {"z"});
  about.mutable_truth(about.truth_size() - 1)->mutable_info()->set_name("depth");
  addRequest(about);
  return about;
}

template <class T>
void append(std::string& bytes, std::size_t number) {
  const T value = static_cast<T>(number);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// Element i of sample n is 40 n + i, modulo 256.
std::string elementsOf(const v1::RecordedTruth& channel, std::size_t sample) {
  const bool picture = channel.info().layout() == v1::LAYOUT_PICTURE;
  const std::size_t count = channel.info().planes_size() * (picture ? kWidth * kHeight : 1);
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t number = (40 * sample + i) % 256;
    switch (channel.info().element()) {
      case v1::ELEMENT_U8:
        append<std::uint8_t>(bytes, number);
        break;
      case v1::ELEMENT_U16:
        append<std::uint16_t>(bytes, number);
        break;
      case v1::ELEMENT_U32:
        append<std::uint32_t>(bytes, number);
        break;
      case v1::ELEMENT_F64:
        append<double>(bytes, number);
        break;
      default:
        append<float>(bytes, number);
    }
  }
  return bytes;
}

// Sample n of a picture is at n * 10 ms and was exposed for 2 ms before; row n is at n ms.
TruthSample sampleOf(const v1::RecordedTruth& channel, std::size_t n) {
  const bool picture = channel.info().layout() == v1::LAYOUT_PICTURE;
  const std::int64_t t_ns = static_cast<std::int64_t>(n) * (picture ? 10 : 1) * kMs;
  const std::int64_t begin_ns = picture ? std::max<std::int64_t>(0, t_ns - 2 * kMs) : 0;
  return {t_ns, elementsOf(channel, n), begin_ns, picture ? t_ns : 0};
}

void run(const std::string& path, bool partial) {
  RecordingFile recording(path, writerFor(path), {describe()});
  RecordedSensor& file = recording.sensor(0);
  for (std::size_t step = 0; step < 4; ++step) {
    const std::int64_t t0_ns = static_cast<std::int64_t>(step) * 10 * kMs;
    file.write({{t0_ns, 1, 2, 1}, {t0_ns + 7 * kMs, 4, 0, 0}}, t0_ns, t0_ns + 10 * kMs);
    for (int i = 0; i < file.about().truth_size(); ++i) {
      const v1::RecordedTruth& channel = file.about().truth(i);
      const bool picture = channel.info().layout() == v1::LAYOUT_PICTURE;
      TruthSamples samples;
      for (std::size_t n = 0; n < (picture ? 1 : 10); ++n)
        samples.push_back(sampleOf(channel, picture ? step : step * 10 + n));
      file.writeTruth(i, samples);
    }
  }
  if (partial) return;
  recording.close();
  recording.commit();
}

}  // namespace
}  // namespace saccade::client

int main(int argc, char** argv) {
  saccade::client::run(argv[1], argc > 2);
}
