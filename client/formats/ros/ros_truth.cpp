#include "client/formats/ros/ros_truth.h"

#include <algorithm>
#include <cstring>

#include "client/formats/common/ros_names.h"
#include "saccade/stream_views.h"

namespace saccade::client {
namespace {

std::string definition(const std::string& type, const std::string& fields) {
  return std::string(80, '=') + "\nMSG: geometry_msgs/" + type + "\n" + fields;
}

const std::string kXyz = "float64 x\nfloat64 y\nfloat64 z\n";
const std::string kQuaternion = definition("Quaternion", kXyz + "float64 w\n");
const std::string kVector = definition("Vector3", kXyz);

const RosMessage kImage{
    "sensor_msgs",
    "Image",
    "060021388200f6f0f447d0fcd9c64743",
    "uint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\nuint8[] data\n",
    "",
    ""};
const RosMessage kPose{
    "geometry_msgs",
    "PoseStamped",
    "d3812c3cbc69362b77dc0b19b345f8f5",
    "Pose pose\n",
    definition("Pose", "Point position\nQuaternion orientation\n") + definition("Point", kXyz) + kQuaternion,
    "world"};
const RosMessage kTwist{"geometry_msgs",
                        "TwistStamped",
                        "98d34b0043a2093cf9d9345ab6eef12e",
                        "Twist twist\n",
                        definition("Twist", "Vector3 linear\nVector3 angular\n") + kVector,
                        ""};
const RosMessage kImu{
    "sensor_msgs",
    "Imu",
    "6a62c6daae103f4ff57a132d6f95cec2",
    "geometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
    "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
    "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n",
    kQuaternion + kVector,
    "body"};

struct RowMessage {
  const char* channel;
  int planes;
  const RosMessage* message;
};
const RowMessage kRows[] = {{"pose", 7, &kPose}, {"velocity", 6, &kTwist}, {"imu", 6, &kImu}};

double numberAt(const v1::RecordedTruth& channel, const TruthSample& sample, std::size_t index) {
  const auto take = [&]<class T>(T value) {
    std::memcpy(&value, sample.elements.data() + index * sizeof value, sizeof value);
    return static_cast<double>(value);
  };
  return channel.info().element() == v1::ELEMENT_F64 ? take(double()) : take(float());
}

bool isReal(v1::Element element) {
  return element == v1::ELEMENT_F32 || element == v1::ELEMENT_F64;
}

// There is no orientation, which a first covariance of -1 says; the other covariances are unknown, which 0
// says.
std::vector<double> imuNumbers(const std::vector<double>& row) {
  std::vector<double> numbers(4 + 9 + 3 + 9 + 3 + 9, 0.0);
  numbers[3] = 1;   // w of the orientation
  numbers[4] = -1;  // its first covariance
  std::copy_n(row.begin() + 3, 3, numbers.begin() + 13);
  std::copy_n(row.begin(), 3, numbers.begin() + 25);
  return numbers;
}

}  // namespace

const RosMessage* rosMessageOf(const v1::RecordedTruth& channel) {
  if (isPicture(channel)) return &kImage;
  for (const RowMessage& row : kRows) {
    const bool same = channel.info().name() == row.channel && channel.info().planes_size() == row.planes;
    if (same && isReal(channel.info().element())) return row.message;
  }
  return nullptr;
}

std::string rosFrameOf(const v1::Recording& about, int channel) {
  const std::string& own = rosMessageOf(about.truth(channel))->frame_id;
  return own.empty() ? rosFrame(viewOfTruth(about, channel)) : own;
}

std::string rosEncoding(const v1::RecordedTruth& channel) {
  const auto& planes = channel.info().planes();
  const bool colours = planes.size() == 3 && planes[0] == "r" && planes[1] == "g" && planes[2] == "b";
  const std::string count = "C" + std::to_string(planes.size());
  switch (channel.info().element()) {
    case v1::ELEMENT_U8:
      return planes.size() == 1 ? "mono8" : colours ? "rgb8" : "8U" + count;
    case v1::ELEMENT_U16:
      return planes.size() == 1 ? "mono16" : colours ? "rgb16" : "16U" + count;
    case v1::ELEMENT_U32:
      return "32S" + count;  // ROS has no 32U
    case v1::ELEMENT_F64:
      return "64F" + count;
    default:
      return "32F" + count;
  }
}

std::vector<double> rosNumbers(const v1::RecordedTruth& channel, const TruthSample& sample) {
  std::vector<double> row(planesOf(channel));
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = numberAt(channel, sample, i);
  return rosMessageOf(channel) == &kImu ? imuNumbers(row) : row;
}

}  // namespace saccade::client
