#include "scene/motion/own_motions.h"

#include <algorithm>
#include <cmath>

#include "base/names.h"
#include "base/text_cut.h"
#include "scene/files/confinement.h"
#include "scene/files/plain_file.h"
#include "scene/files/toml_file.h"
#include "scene/motion/object_motion.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileBytes = 1 << 20, kMaxPoseBytes = 8 << 20;
constexpr double kMaxPeriod = 1e9;  // seconds
constexpr std::string_view kAnimation = "animation";

// Reads one table of the file.
class TableReader {
 public:
  TableReader(fs::path file, std::string name, const toml::node& node, const LoadOptions& options)
      : file_(std::move(file)), name_(std::move(name)), node_(node), options_(options) {}

  OwnMotion read(const std::set<std::string>& shapes) const {
    const toml::table* table = node_.as_table();
    if (!table) fail(node_, "stands before any table; each object has one, such as [turntable]");
    if (!shapes.contains(name_))
      fail(node_, "the scene has no object '" + cutText(name_, kMaxEcho) +
                      "'; it has: " + cutText(joinNames(shapes), kMostNames));
    for (const auto& [key, value] : *table)
      if (key != "motion" && key != "poses" && key != "period")
        fail(value,
             "there is no key '" + cutText(key.str(), kMaxEcho) + "'; there are: motion, poses, period");
    const toml::node *motion = table->get("motion"), *poses = table->get("poses");
    if (!motion == !poses) fail(node_, "[" + name_ + "] needs either motion or poses");
    if (motion && table->get("period"))
      fail(*table->get("period"), "a motion has no other period than its own");
    return motion ? ofKind(*motion) : ofPoses(*poses, table->get("period"));
  }

 private:
  [[noreturn]] void fail(const toml::node& at, const std::string& what) const {
    throw SceneError(file_.string() + ":" + std::to_string(at.source().begin.line) + ": " + what);
  }

  std::string text(const toml::node& node, const char* key) const {
    if (const auto value = node.value_exact<std::string>()) return *value;
    fail(node, std::string(key) + " is not a text in quotes");
  }

  OwnMotion ofKind(const toml::node& node) const {
    const std::string given = text(node, "motion");
    try {
      if (parseObjectMotion(given)) return {name_, given};
    } catch (const SceneError& fault) {
      fail(node, fault.what());
    }
    fail(node, "'" + cutText(given, kMaxEcho) + "' is not KIND:SPEED, such as spin:90, with KIND one of " +
                   joinNames(objectMotionKinds()));
  }

  OwnMotion ofPoses(const toml::node& node, const toml::node* period) const {
    const std::string given = text(node, "poses");
    const fs::path path = file_.parent_path() / given;
    if (!mayRead(path, {file_.parent_path()})) fail(node, given + " leads out of the folder of the scene");
    if (!mayRead(path, options_.confined_to)) fail(node, given + " leads out of the folder of the scenes");
    try {
      std::vector<TimedPose> keys = readPoses(readFile(path.string(), kMaxPoseBytes), path.string()).poses;
      if (period) keys.push_back({periodOf(*period, keys.back().time), keys.front().pose});
      const std::size_t poses = keys.size();
      return {name_, given, period ? Trajectory::periodic(std::move(keys)) : Trajectory(std::move(keys)),
              poses};
    } catch (const SceneError& fault) {
      fail(node, fault.what());
    }
  }

  TimeNs periodOf(const toml::node& node, TimeNs last) const {
    const double period = node.value<double>().value_or(0);
    if (!node.is_number() || !(period > seconds(last)) || !(period <= kMaxPeriod))
      throw SceneError("period must be a number of seconds after the last pose, which is at " +
                       std::to_string(seconds(last)) + ", and at most 1e9");
    return TimeNs{std::llround(period * 1e9)};
  }

  const fs::path file_;
  const std::string name_;
  const toml::node& node_;
  const LoadOptions& options_;
};

}  // namespace

std::vector<OwnMotion> readOwnMotions(const fs::path& scene_file, const std::set<std::string>& shapes,
                                      const LoadOptions& options) {
  const fs::path file = scene_file.parent_path() / kMotionFile;
  const auto tables = readToml(file, kMaxFileBytes, options);
  if (!tables) return {};
  if (tables->size() > kMostOwnMotions)
    throw SceneError(file.string() + ": more than " + std::to_string(kMostOwnMotions) + " objects move");
  std::vector<OwnMotion> motions;
  for (const auto& [name, node] : *tables)
    if (name != kAnimation || node.is_table())
      motions.push_back(TableReader(file, std::string(name.str()), node, options).read(shapes));
  std::ranges::sort(motions, {}, &OwnMotion::name);
  return motions;
}

std::optional<ChosenAnimation> chosenAnimation(const fs::path& scene_file, const LoadOptions& options) {
  if (!options.animation.empty()) return ChosenAnimation{options.animation, scene_file.string()};
  const fs::path file = scene_file.parent_path() / kMotionFile;
  const auto tables = readToml(file, kMaxFileBytes, options);
  const toml::node* node = tables ? tables->get(kAnimation) : nullptr;
  if (!node || node->is_table()) return {};
  ChosenAnimation chosen{{}, file.string() + ":" + std::to_string(node->source().begin.line)};
  const auto name = node->value_exact<std::string>();
  if (!name) throw chosen.error("animation is not a text in quotes");
  chosen.name = *name;
  return chosen;
}

const OwnMotion* ownMotion(const Scene& scene, const std::string& name) {
  return findRow(scene.motions, name);
}

Trajectory makeOwnMotion(const OwnMotion& motion, const Scene& scene, const Body& body) {
  return motion.path ? *motion.path : makeObjectMotion(*parseObjectMotion(motion.text), scene, body);
}

}  // namespace saccade
