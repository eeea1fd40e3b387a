// A method estimates the change of intensity between consecutive frames. It keeps its own history.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/pool_handle.h"
#include "frame/frame.h"
#include "frame/intensity_change.h"
#include "frame/point_samples.h"
#include "frame/seed_plan.h"
#include "frame/surface_frame.h"
#include "methods/stage_times.h"

namespace saccade {

class BakedLight;
class BounceGrid;

// The passes of frame t, with `spp` paths per pixel in both together: a maker of SeedPlan.
using SeedPlanner = SeedPlan (*)(std::uint64_t stream_seed, FrameIndex t, int spp);

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

class SurfaceMethod;
class RoundMethod;

class Method {
 public:
  virtual ~Method() = default;
  // Not nullptr: its frames have SurfaceSamples.
  virtual SurfaceMethod* onSurfaces() { return nullptr; }
  // Not nullptr: it says round by round which pixels get more paths. See round_method.h.
  virtual RoundMethod* inRounds() { return nullptr; }
  // Takes the first frame of a feed, which has no difference yet. Called once, before estimate().
  virtual void start(const Frame& first, const PoolHandle& pool) = 0;
  // Fills `out`, which has the size of the frames, but for t0, t1 and frame. Called from the second frame on.
  virtual void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                        StageTimes& times) = 0;
};

// A method that keeps light on surfaces. It plans the paths of each frame, the first too, and takes them in
// one pass: SeedPlan::independent.
class SurfaceMethod : public Method {
 public:
  SurfaceMethod* onSurfaces() final { return this; }
  // Reads precomputed light, and marks the points of a tile that have it: they need no paths. Features and
  // surfaces of the tile are known. Called by several threads at once, for each tile of a frame before its
  // plan().
  virtual void readBaked(Tile tile, Frame& next) = 0;
  // Whether it reads the frame's PairSamples. Called after plan(), from the second frame on. Both frames must
  // have pixels that hasUncacheable().
  virtual bool needsPairs(const FramePair&) const { return false; }
  // Sets SurfacePoint::paths of each point, about `spp` a pixel in the mean. Returns the light that ends
  // paths at their second vertex, which stays as it is until start() or estimate(); nullptr: there is none.
  virtual const BounceGrid* plan(int spp, const SurfaceFrame& next, const PoolHandle& pool,
                                 StageTimes& times) = 0;
  // Looks up light at points of times between both frames: as many as there are of `out`. Called after
  // estimate(), by several threads at once.
  virtual void readPoints(std::span<const PointSample> at, std::span<PlaceLight> out) const = 0;
};

// The setup that a method is made for.
struct MethodSetup {
  ParamValues params;  // what resolveParams() returned
  int width, height;
  int spp;                                            // paths per pixel and frame, over both passes
  std::shared_ptr<const BakedLight> baked = nullptr;  // precomputed light of this scene, if there is any
  bool refined = false;  // whether its frames must show what readPoints() finds, without a filter
};

// The traits of a view that the memory of a method grows with.
struct ViewTraits {
  double pixels;
  bool jitter;
  bool moves;  // whether objects of the scene do
};

// A row of the table of methods. seeds() too takes what resolveParams() returned.
struct MethodInfo {
  std::string name, description;
  std::vector<ParamSpec> params;
  SeedPlanner (*seeds)(const ParamValues& params);
  std::unique_ptr<Method> (*make)(const MethodSetup& setup);
  bool takes_baked = false;  // whether it makes use of a bake
  bool refines = false;      // whether it is a SurfaceMethod, which knows light between frames
  // Bytes that it takes at most for a view, beside what every method takes.
  double (*memory)(const ParamValues& params, const ViewTraits& view) = noMore;

  static double noMore(const ParamValues&, const ViewTraits&) { return 0; }
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
