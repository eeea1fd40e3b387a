#include "scene/camera/pose_columns.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <span>
#include <string>

#include "base/text_cut.h"
#include "scene/files/scene_error.h"

namespace saccade {
namespace {

constexpr std::string_view kValid =
    "valid are t (time, timestamp, with _ns, _us, _ms or _s), x y z (tx, p_x, pos_x, p_RS_R_x), qx qy qz qw "
    "(q_x, quat_x, rot_x, q_RS_x); velocities v_x, angular velocities w_x, accelerations a_x and biases "
    "b_w_x "
    "and b_a_x are not read";

constexpr std::array<std::string_view, PoseColumns::kValues> kValueNames{"t",  "x",  "y",  "z",
                                                                         "qx", "qy", "qz", "qw"};
constexpr std::array<std::string_view, 4> kTimes{"t", "time", "timestamp", "stamp"};
constexpr std::array<std::string_view, 8> kPositions{"",   "t",    "t_",        "p",
                                                     "p_", "pos_", "position_", "p_rs_r_"};
constexpr std::array<std::string_view, 7> kRotations{"q",    "q_",        "q_rs_",       "quat_",
                                                     "rot_", "rotation_", "orientation_"};
constexpr std::array<std::string_view, 13> kUnread{
    "v", "v_", "v_rs_r_", "w", "w_", "a", "a_", "bw_", "b_w_", "b_w_rs_s_", "ba_", "b_a_", "b_a_rs_s_"};

struct TimeUnit {
  std::string_view name;
  double nanoseconds;
};
constexpr std::array<TimeUnit, 4> kTimeUnits{{{"ns", 1}, {"us", 1e3}, {"ms", 1e6}, {"s", 1e9}}};

bool holds(std::span<const std::string_view> list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

struct Column {
  std::string_view name, unit;
};

constexpr std::string_view kBetween = " \t\r,";

// Takes a name and the unit in brackets that may follow it. The name is empty at the end.
Column takeColumn(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBetween), text.size()));
  Column column{text.substr(0, text.find_first_of(" \t\r,[", 1)), ""};
  text.remove_prefix(column.name.size());
  const std::size_t next = text.find_first_not_of(" \t");
  if (next == text.npos || text[next] != '[') return column;
  const std::size_t end = std::min(text.find(']', next), text.size());
  column.unit = text.substr(next + 1, end - next - 1);
  text.remove_prefix(std::min(end + 1, text.size()));
  return column;
}

// A name in small letters; a long one is none.
std::string lowered(std::string_view name) {
  std::string low(name.substr(0, 32));
  std::transform(low.begin(), low.end(), low.begin(), [](unsigned char c) { return std::tolower(c); });
  return low;
}

// Nanoseconds of a unit of time; 0 for no unit, none for an unknown one.
std::optional<double> nanosecondsOf(std::string_view unit) {
  if (unit.empty()) return 0;
  for (const TimeUnit& known : kTimeUnits)
    if (known.name == unit) return known.nanoseconds;
  return {};
}

// "t_ns" is the time in nanoseconds, and "t" has no unit. None for another name.
std::optional<double> timeUnitOf(std::string_view name) {
  const std::size_t cut = std::min(name.rfind('_'), name.size());
  if (!holds(kTimes, name.substr(0, cut))) return {};
  return nanosecondsOf(name.substr(std::min(cut + 1, name.size())));
}

constexpr std::size_t kMissing = PoseColumns::kMost, kUnreadValue = PoseColumns::kValues;

// The value's index in PoseColumns::at, kUnreadValue, or none for an unknown name.
std::optional<std::size_t> valueOf(const std::string& name) {
  if (timeUnitOf(name)) return 0;
  if (name.empty()) return {};
  const std::string_view prefix = std::string_view(name).substr(0, name.size() - 1);
  const std::size_t axis = std::string_view("xyzw").find(name.back());
  if (axis < 4 && holds(kRotations, prefix)) return 4 + axis;
  if (axis < 3 && holds(kPositions, prefix)) return 1 + axis;
  if (axis < 3 && holds(kUnread, prefix)) return kUnreadValue;
  return {};
}

std::string quoted(std::string_view text) {
  return "'" + cutText(text, 40) + "'";
}

void checkUnit(const Column& column, bool understood, const std::string& valid) {
  if (understood) return;
  throw SceneError("the heading gives " + quoted(column.name) + " the unit " + quoted(column.unit) +
                   "; valid are " + valid);
}

void setTime(const Column& column, const std::string& name, PoseColumns& columns) {
  const auto unit = nanosecondsOf(column.unit);
  checkUnit(column, unit.has_value(), "ns, us, ms, s");
  columns.time_unit = *unit > 0 ? *unit : *timeUnitOf(name);
}

bool complete(const PoseColumns& columns) {
  return std::count(columns.at.begin(), columns.at.end(), kMissing) == 0;
}

// The next field of a line is that of `column`.
void addField(const Column& column, PoseColumns& columns) {
  const std::string name = lowered(column.name);
  const std::optional<std::size_t> value = valueOf(name);
  if (!value)
    throw SceneError("the heading names a column " + quoted(column.name) + "; " + std::string(kValid));
  if (columns.fields == PoseColumns::kMost) throw SceneError("the heading names more than 64 columns");
  const std::size_t field = columns.fields++;
  if (*value == kUnreadValue) return;
  if (columns.at[*value] != kMissing)
    throw SceneError("the heading names " + std::string(kValueNames[*value]) + " twice");
  columns.at[*value] = field;
  if (*value == 0) return setTime(column, name, columns);
  if (*value < 4) return checkUnit(column, column.unit.empty() || column.unit == "m", "m");
  checkUnit(column, column.unit.empty(), "none");
}

// The part of a line that may name columns: not the '#', nor the words before a colon.
std::string_view namesOf(std::string_view line) {
  const std::size_t colon = line.rfind(':');
  if (colon != line.npos) return line.substr(colon + 1);
  return line.substr(std::min(line.find_first_not_of(" \t#"), line.size()));
}

}  // namespace

bool namesColumns(std::string_view comment) {
  std::string_view rest = namesOf(comment);
  bool begins_with_time = false;
  std::size_t count = 0;
  for (Column column = takeColumn(rest); !column.name.empty(); column = takeColumn(rest), ++count) {
    const std::optional<std::size_t> value = valueOf(lowered(column.name));
    if (value && *value >= 4 && *value < kUnreadValue) return true;
    if (count == 0) begins_with_time = value == std::size_t{0};
  }
  return begins_with_time && count >= PoseColumns::kValues;
}

PoseColumns readColumns(std::string_view heading) {
  PoseColumns columns;
  columns.fields = 0;
  columns.at.fill(kMissing);
  const bool comment = heading.find_first_not_of(" \t") == heading.find('#');
  std::string_view rest = namesOf(heading);
  for (Column column = takeColumn(rest); !column.name.empty(); column = takeColumn(rest)) {
    if (comment && complete(columns) && !valueOf(lowered(column.name))) break;
    addField(column, columns);
  }
  for (std::size_t value = 0; value < columns.at.size(); ++value)
    if (columns.at[value] == kMissing)
      throw SceneError("the heading names no column for " + std::string(kValueNames[value]) + "; " +
                       std::string(kValid));
  return columns;
}

}  // namespace saccade
