// A method estimates the change of intensity between consecutive frames. It keeps its own history.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/pool_handle.h"
#include "frame/frame.h"
#include "frame/intensity_change.h"
#include "methods/stage_times.h"

namespace saccade {

// How the two passes of a frame are seeded (paper, 4.3).
enum class SeedReuse {
  kIndependent,       // one pass, fresh seeds: spp paths
  kIndependentPairs,  // two passes of spp/2 paths, both with fresh seeds (ablation of Fig. 9 A)
  kCorrelated,        // two passes of spp/2 paths, pass 1 with the seeds of the previous frame [E (8)]
};

// What a method needs from the renderer.
struct SampleRequest {
  SeedReuse reuse;
  bool on_surfaces = false;  // SurfaceSamples too, which take kIndependent
};

// A parameter as users meet it. Whole numbers and switches (0 or 1) are doubles too.
struct ParamSpec {
  std::string name;
  double min, max, fallback;
  bool whole;          // only whole numbers
  std::string what;    // meaning and unit
  std::string source;  // "paper 5.1", "Falcor", "[ours] why"
  std::string former;  // the name that it had in an earlier version, which is refused; empty: none
};
using ParamValues = std::map<std::string, double>;

class Method {
 public:
  virtual ~Method() = default;
  // Takes the first frame of a feed, which has no difference yet. Called once, before estimate().
  virtual void start(const Frame& first, const PoolHandle& pool) = 0;
  // Marks the points of a tile whose light is known ahead, with the tile's features and surfaces known: they
  // need no paths. Called by several threads at once, for each tile of a frame before its plan().
  virtual void look(Tile /*tile*/, Frame& /*next*/) {}
  // Says how many paths each pixel of a frame gets, about `spp` in the mean: fills next.surfaces->paths, with
  // the frame's features and surfaces known. Called for each frame, the first too, if the method takes
  // samples on surfaces.
  virtual void plan(int /*spp*/, const PoolHandle& /*pool*/, Frame& /*next*/, StageTimes& /*times*/) {}
  // Fills `out`, which has the size of the frames, but for t0, t1 and frame. Called from the second frame on.
  virtual void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                        StageTimes& times) = 0;
};

class BakedLight;

// What a method is made for.
struct MethodSetup {
  ParamValues params;  // what resolveParams() returned
  int width, height;
  std::shared_ptr<const BakedLight> baked = nullptr;  // light of this scene that is known ahead, if any is
};

// A row of the table of methods. samples() too takes what resolveParams() returned.
struct MethodInfo {
  std::string name, description;
  std::vector<ParamSpec> params;
  SampleRequest (*samples)(const ParamValues& params);
  std::unique_ptr<Method> (*make)(const MethodSetup& setup);
  bool takes_baked = false;  // whether it makes use of a bake
  // Bytes that it takes at most for a view, beside what every method takes.
  double (*memory)(const ParamValues& params, double pixels, bool jitter) = noMore;

  static double noMore(const ParamValues&, double, bool) { return 0; }
};

// THE list of methods, method_table.cpp. The first is the default for scenes whose light is steady.
const std::vector<MethodInfo>& methodTable();
const MethodInfo& defaultMethod(bool steady_light);
const MethodInfo* findMethod(const std::string& name);  // nullptr if there is none
std::string methodNames();                              // "event_svgf, pt, ..." for messages

// Copies `given` to `resolved` and adds the defaults. Returns an empty text, or the error: an unknown name or
// a value out of range, with what is valid. `bad_name` then receives the name.
std::string resolveParams(const MethodInfo& method, const ParamValues& given, ParamValues& resolved,
                          std::string& bad_name);

// Whether the method's passes can share `spp` paths: two passes need an even number.
bool takesSpp(const MethodInfo& method, const ParamValues& resolved, int spp);

}  // namespace saccade
