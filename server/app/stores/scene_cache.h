// The scenes in memory, and their variants. Each version of a scene is built once and shared. A scene that
// nobody uses makes room for others; the least recently used goes first.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/admission/limits.h"
#include "base/shared_build.h"
#include "log/limited_log.h"
#include "render/features/simplify.h"
#include "scene/library/scene_library.h"

namespace saccade {

class RenderScene;

// Counted since the server started.
struct SceneLoads {
  std::atomic<std::uint64_t> done = 0, failed = 0, evicted = 0;
  std::atomic<std::int64_t> ns = 0;  // wall time of those that are done
};

// Facts about a scene since its file last changed. Both are empty until it was loaded.
struct SceneNote {
  std::string stats;    // triangles, materials, lights, memory, and warnings, for people
  std::string failure;  // why the last attempt to load it failed
};

// The scenes that somebody uses, so that they cannot make room for others.
struct SceneUse {
  std::uint64_t bytes = 0;  // those being built included
  int variants = 0;
};

// The choice and the changes of a stream.
struct SceneVariant {
  SceneFeatures disabled = {};
  std::vector<std::string> bodies = {};  // names of shapes, sorted
  std::vector<std::string> rigid = {};   // those of them that keep their form
  std::string animation = {};            // see LoadOptions

  // Whether it is as its file describes it.
  bool isWhole() const { return disabled.empty() && bodies.empty(); }
  friend auto operator<=>(const SceneVariant&, const SceneVariant&) = default;
};

// All members may be called from any thread. No lock is held while a scene is made ready for tracing.
class SceneCache {
 public:
  using ScenePtr = std::shared_ptr<const RenderScene>;

  explicit SceneCache(const std::string& folder, const Limits& limits = {},
                      const std::string& meshes = kDefaultMeshes)
      : library_(folder, meshes),
        most_variants_(static_cast<std::size_t>(limits[Limit::kReducedScenes])),
        most_bytes_(limits.bytes(Limit::kScenes)) {}

  const SceneLibrary& library() const { return library_; }
  const SceneLoads& loads() const { return loads_; }
  std::uint64_t bytes() const;  // of all scenes in memory
  SceneUse inUse() const;
  SceneNote note(const std::string& name) const;

  // The scene as its file now describes it, with one of its animations, see LoadOptions. Loads it, or waits
  // for a load that others have asked for; `progress` is then told the share of files that are read. Throws
  // SceneError, and LimitReached where there is no room; the next call tries again. Throws Cancelled as soon
  // as `stop` is requested.
  ScenePtr get(const std::string& name, const std::stop_token& stop = {},
               const std::function<void(double)>& progress = {}, const std::string& animation = {});
  // `whole`, which get() returned for the variant's animation, with a change. It has shapes of the names of
  // the bodies. Throws LimitReached where too many variants are in use, or there is no room, and Cancelled.
  ScenePtr vary(const std::string& name, const ScenePtr& whole, const SceneVariant& variant,
                const std::stop_token& stop = {});

 private:
  using FileTime = std::filesystem::file_time_type;
  using Key = std::pair<std::string, SceneVariant>;
  // The source of an entry: the scene's file as of a time, or a whole scene.
  struct Version {
    FileTime changed = {};
    std::weak_ptr<const RenderScene> whole = {};
    bool operator<(const Version& other) const;
    bool operator==(const Version& other) const { return !(*this < other) && !(other < *this); }
  };
  struct Entry {
    Version version;
    ScenePtr scene;          // null while it is being built
    std::uint64_t used = 0;  // the value of uses_ at the last use
  };
  struct Counted {
    std::weak_ptr<const void> scene;
    std::uint64_t bytes;
  };
  struct Noted {
    FileTime changed;
    SceneNote note;
  };
  using Builds = SharedBuild<std::pair<Key, Version>, RenderScene>;

  ScenePtr getOrBuild(const Key& key, const Version& version, const std::stop_token& stop,
                      const Builds::Build& make, const Builds::Progress& progress = {});
  ScenePtr build(const Key& key, const Version& version, const std::function<ScenePtr()>& make);
  ScenePtr find(const Key& key, const Version& version);
  void enter(const Key& key, const Version& version);
  void keep(const Key& key, const Version& version, const ScenePtr& scene);
  ScenePtr load(const std::string& name, const std::string& animation, FileTime changed,
                const BuildContext& context);
  ScenePtr read(const std::string& name, const std::string& animation, const BuildContext& context);
  ScenePtr prepare(const std::string& name, Scene scene);
  void count(const std::string& name, std::weak_ptr<const void> scene, std::uint64_t bytes);
  void makeRoom(const std::string& name, std::uint64_t bytes);
  std::uint64_t countBytes() const;
  bool evictOne(bool variants_only);
  void remember(const std::string& name, FileTime changed, SceneNote note);

  const SceneLibrary library_;
  const std::size_t most_variants_;
  const std::uint64_t most_bytes_;
  SceneLoads loads_;
  LimitedLog log_;
  std::mutex reading_;  // the size of a scene is known once it is read, so one is read at a time
  mutable std::mutex mutex_;
  std::map<Key, Entry> entries_;
  std::uint64_t uses_ = 0;
  std::vector<Counted> counted_;  // the scenes in memory, and some that are gone
  std::map<std::string, Noted> notes_;
  Builds builds_;  // last: its threads use all others
};

}  // namespace saccade
