#include <algorithm>
#include <array>
#include <cmath>

#include "base/text_cut.h"
#include "scene/camera/trajectory.h"
#include "scene/files/scene_error.h"
#include "scene/files/text.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxPoses = 1'000'000;
constexpr double kMaxSeconds = 9e9;
constexpr std::size_t kFields = 8;

class CsvReader {
 public:
  explicit CsvReader(const std::string& name) : name_(name) {}
  std::vector<TimedPose> read(std::string_view csv);

 private:
  using Fields = std::array<std::string_view, kFields>;

  void readLine(std::string_view line);
  Fields split(std::string_view line) const;
  double number(std::string_view field) const;
  TimeNs readTime(std::string_view field);
  Pose readPose(const Fields& fields) const;
  [[noreturn]] void fail(const std::string& what) const {
    if (name_.empty()) throw SceneError("line " + std::to_string(line_) + ": " + what);
    throw SceneError(name_, line_, what);
  }

  const std::string& name_;
  long line_ = 0;
  bool header_seen_ = false;
  bool esim_ = false;                // as the first pose; else TUM
  double first_seconds_ = 0;         // TUM
  long long first_nanoseconds_ = 0;  // ESIM
  std::vector<TimedPose> keys_;
};

std::vector<TimedPose> CsvReader::read(std::string_view csv) {
  while (!csv.empty()) {
    ++line_;
    readLine(takeLine(csv));
  }
  if (keys_.empty()) fail("no pose in the text; expected lines of t x y z qx qy qz qw");
  return std::move(keys_);
}

std::string_view trimmed(std::string_view cell) {
  const std::size_t first = cell.find_first_not_of(" \t"), last = cell.find_last_not_of(" \t");
  return first == cell.npos ? std::string_view{} : cell.substr(first, last + 1 - first);
}

// A heading is a line without a number.
bool isHeader(std::string_view line) {
  for (auto word = takeWord(line, ","); !word.empty(); word = takeWord(line, ","))
    if (parseNumber(word)) return false;
  return true;
}

void CsvReader::readLine(std::string_view line) {
  auto rest = line;
  const auto first = takeWord(rest);
  if (first.empty() || first[0] == '#') return;
  if (keys_.empty() && !header_seen_ && isHeader(line)) {
    header_seen_ = true;
    return;
  }
  if (keys_.size() == kMaxPoses) fail("more than 1000000 poses");
  if (keys_.empty()) esim_ = line.find(',') != line.npos;
  const Fields fields = split(line);
  const TimedPose key{readTime(fields[0]), readPose(fields)};
  if (!keys_.empty() && key.time <= keys_.back().time)
    fail("the time is not later than that of the pose before");
  keys_.push_back(key);
}

CsvReader::Fields CsvReader::split(std::string_view line) const {
  Fields fields;
  std::size_t count = 0;
  if (esim_) {
    count = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
    for (std::size_t i = 0; i < std::min(count, kFields); ++i) {
      const std::string_view cell = line.substr(0, line.find(','));
      line.remove_prefix(std::min(cell.size() + 1, line.size()));
      fields[i] = trimmed(cell);
    }
  } else {
    for (auto word = takeWord(line); !word.empty(); word = takeWord(line), ++count)
      if (count < kFields) fields[count] = word;
  }
  if (count != kFields)
    fail("a line of " + std::to_string(count) +
         " fields; expected 8: " + (esim_ ? "t_ns,x,y,z,qx,qy,qz,qw" : "t x y z qx qy qz qw"));
  return fields;
}

double CsvReader::number(std::string_view field) const {
  const auto value = parseNumber(field);
  if (!value) fail("'" + cutText(field, 40) + "' is not a finite number");
  return *value;
}

TimeNs CsvReader::readTime(std::string_view field) {
  if (esim_) {
    const auto t = parseInteger(field);
    if (!t || std::abs(static_cast<double>(*t)) > 1e9 * kMaxSeconds / 2)
      fail("'" + cutText(field, 40) +
           "' is not a time in whole nanoseconds, as lines with commas have it; with blanks, times are "
           "seconds");
    if (keys_.empty()) first_nanoseconds_ = *t;
    return TimeNs{*t - first_nanoseconds_};
  }
  const double t = number(field);
  if (keys_.empty()) first_seconds_ = t;
  const double since_first = t - first_seconds_;
  if (std::abs(since_first) > kMaxSeconds) fail("a time too far from the first, by more than 9e9 s");
  return TimeNs{std::llround(since_first * 1e9)};
}

Pose CsvReader::readPose(const Fields& fields) const {
  std::array<double, kFields> v{};
  for (std::size_t i = 1; i < kFields; ++i) v[i] = number(fields[i]);
  if (std::max({std::abs(v[1]), std::abs(v[2]), std::abs(v[3])}) > kMaxDistance)
    fail("a position beyond 1e9 along an axis");
  const Quaternion q{v[4], v[5], v[6], v[7]};
  if (!isRotation(q)) fail("a quaternion whose length is near 0 or far from 1");
  return {{v[1], v[2], v[3]}, unitNear(q, keys_.empty() ? q : keys_.back().pose.rotation)};
}

}  // namespace

Trajectory parseTrajectory(std::string_view csv, const std::string& name) {
  return Trajectory(CsvReader(name).read(csv));
}

}  // namespace saccade
