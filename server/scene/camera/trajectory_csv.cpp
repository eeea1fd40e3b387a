#include <algorithm>
#include <array>
#include <cmath>

#include "base/text_cut.h"
#include "scene/camera/pose_columns.h"
#include "scene/camera/trajectory.h"
#include "scene/files/scene_error.h"
#include "scene/files/text.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxPoses = 1'000'000;
constexpr double kMaxSeconds = 9e9, kNsPerSecond = 1e9;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

class CsvReader {
 public:
  explicit CsvReader(const std::string& name) : name_(name) {}
  PoseText read(std::string_view csv);

 private:
  using Fields = std::array<std::string_view, PoseColumns::kMost>;

  void readLine(std::string_view line);
  void readHeading(std::string_view line);
  PoseColumns columnsOf(std::string_view heading) const;
  Fields split(std::string_view line) const;
  double number(std::string_view field) const;
  TimeNs readTime(std::string_view field);
  TimeNs readNanoseconds(std::string_view field);
  Pose readPose(const Fields& fields) const;
  [[noreturn]] void fail(const std::string& what) const {
    if (name_.empty()) throw SceneError("line " + std::to_string(line_) + ": " + what);
    throw SceneError(name_, line_, what);
  }

  const std::string& name_;
  long line_ = 0;
  PoseColumns columns_;
  bool heading_seen_ = false;
  bool commas_ = false;    // as in the first pose; else blanks
  double first_time_ = 0;  // nanoseconds
  TimeNs begin_{0};        // the same
  std::vector<TimedPose> keys_;
};

PoseText CsvReader::read(std::string_view csv) {
  if (csv.starts_with(kByteOrderMark)) csv.remove_prefix(kByteOrderMark.size());
  while (!csv.empty()) {
    ++line_;
    readLine(takeLine(csv));
  }
  if (keys_.empty()) fail("no pose in the text; expected lines of t x y z qx qy qz qw");
  return {std::move(keys_), begin_};
}

std::string_view trimmed(std::string_view cell) {
  const std::size_t first = cell.find_first_not_of(" \t"), last = cell.find_last_not_of(" \t");
  return first == cell.npos ? std::string_view{} : cell.substr(first, last + 1 - first);
}

bool hasNumber(std::string_view line) {
  for (auto word = takeWord(line, ","); !word.empty(); word = takeWord(line, ","))
    if (parseNumber(word)) return true;
  return false;
}

PoseColumns CsvReader::columnsOf(std::string_view heading) const {
  try {
    return readColumns(heading);
  } catch (const SceneError& fault) {
    fail(fault.what());
  }
}

void CsvReader::readHeading(std::string_view line) {
  const PoseColumns columns = columnsOf(line);
  if (heading_seen_ && columns != columns_) fail("a second heading, with other columns");
  columns_ = columns;
  heading_seen_ = true;
}

void CsvReader::readLine(std::string_view line) {
  auto rest = line;
  const auto first = takeWord(rest);
  if (first.empty()) return;
  const bool comment = first[0] == '#';
  if (keys_.empty() && (comment ? namesColumns(line) : !hasNumber(line))) return readHeading(line);
  if (comment) return;
  if (keys_.size() == kMaxPoses) fail("more than 1000000 poses");
  if (keys_.empty()) commas_ = line.find(',') != line.npos;
  const Fields fields = split(line);
  const TimedPose key{readTime(fields[columns_.at[0]]), readPose(fields)};
  if (!keys_.empty() && key.time <= keys_.back().time)
    fail("the time is not later than that of the pose before");
  keys_.push_back(key);
}

CsvReader::Fields CsvReader::split(std::string_view line) const {
  Fields fields;
  std::size_t count = 0;
  if (commas_) {
    count = static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
    for (std::size_t i = 0; i < std::min(count, fields.size()); ++i) {
      const std::string_view cell = line.substr(0, line.find(','));
      line.remove_prefix(std::min(cell.size() + 1, line.size()));
      fields[i] = trimmed(cell);
    }
  } else {
    for (auto word = takeWord(line); !word.empty(); word = takeWord(line), ++count)
      if (count < fields.size()) fields[count] = word;
  }
  if (count == columns_.fields) return fields;
  const std::string expected = heading_seen_ ? ", as the heading names"
                               : commas_     ? ": t_ns,x,y,z,qx,qy,qz,qw"
                                             : ": t x y z qx qy qz qw";
  fail("a line of " + std::to_string(count) + " fields; expected " + std::to_string(columns_.fields) +
       expected);
}

double CsvReader::number(std::string_view field) const {
  const auto value = parseNumber(field);
  if (!value) fail("'" + cutText(field, 40) + "' is not a finite number");
  return *value;
}

// A whole number, which may be written as a float: "40000000.0", "1e7".
std::optional<long long> parseWhole(std::string_view word) {
  const std::size_t point = word.find('.');
  if (point != word.npos && word.find_first_not_of('0', point + 1) == word.npos) word = word.substr(0, point);
  if (const auto whole = parseInteger(word)) return whole;
  const auto value = parseNumber(word);
  if (!value || *value != std::floor(*value) || std::abs(*value) > kNsPerSecond * kMaxSeconds) return {};
  return static_cast<long long>(*value);
}

TimeNs CsvReader::readNanoseconds(std::string_view field) {
  const auto t = parseWhole(field);
  if (!t || std::abs(static_cast<double>(*t)) > 1e9 * kMaxSeconds / 2)
    fail(
        "'" + cutText(field, 40) +
        "' is not a time in whole nanoseconds, as lines with commas have it; with blanks, times are seconds; "
        "a heading may name another unit, as in t_s,x,y,z,qx,qy,qz,qw");
  if (keys_.empty()) begin_ = TimeNs{*t};
  return TimeNs{*t} - begin_;
}

// A number without an exponent, times 10 to the power of `digits`, to the nearest whole one. A double has not
// enough digits for Unix time.
std::optional<long long> shifted(std::string_view word, std::size_t digits) {
  const std::size_t point = std::min(word.find('.'), word.size());
  std::string part(word.substr(std::min(point + 1, word.size())));
  if (part.find_first_not_of("0123456789") != part.npos) return {};
  const int up = part.size() > digits && part[digits] >= '5' ? 1 : 0;
  part.resize(digits, '0');
  const auto whole = parseInteger(std::string(word.substr(0, point)) + part);
  if (!whole) return {};
  return *whole + (word.starts_with('-') ? -up : up);
}

TimeNs CsvReader::readTime(std::string_view field) {
  const double unit = columns_.time_unit > 0 ? columns_.time_unit : commas_ ? 1 : kNsPerSecond;
  if (unit == 1) return readNanoseconds(field);
  constexpr double kMost = kNsPerSecond * kMaxSeconds;
  const double t = number(field) * unit;
  if (keys_.empty()) first_time_ = t;
  if (std::abs(first_time_) > kMost) fail("a time beyond 9e9 s");
  if (std::abs(t) > kMost || std::abs(t - first_time_) > kMost)
    fail("a time too far from the first, by more than 9e9 s");
  const auto digits = static_cast<std::size_t>(std::lround(std::log10(unit)));
  const TimeNs time{shifted(field, digits).value_or(std::llround(t))};
  if (keys_.empty()) begin_ = time;
  return time - begin_;
}

Pose CsvReader::readPose(const Fields& fields) const {
  std::array<double, PoseColumns::kValues> v{};
  for (std::size_t i = 1; i < v.size(); ++i) v[i] = number(fields[columns_.at[i]]);
  if (std::max({std::abs(v[1]), std::abs(v[2]), std::abs(v[3])}) > kMaxDistance)
    fail("a position beyond 1e9 along an axis");
  const Quaternion q{v[4], v[5], v[6], v[7]};
  if (!isRotation(q)) fail("a quaternion whose length is near 0 or far from 1");
  return {{v[1], v[2], v[3]}, unitNear(q, keys_.empty() ? q : keys_.back().pose.rotation)};
}

}  // namespace

PoseText readPoses(std::string_view csv, const std::string& name) {
  return CsvReader(name).read(csv);
}

Trajectory parseTrajectory(std::string_view csv, const std::string& name) {
  return Trajectory(readPoses(csv, name).poses);
}

}  // namespace saccade
