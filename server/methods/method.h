// A method turns pairs of frames into the change of intensity. Its history lives in it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/tile_pool.h"
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

// A parameter as users meet it. Whole numbers and switches (0 or 1) are doubles too.
struct ParamSpec {
  std::string name;
  double min, max, fallback;
  bool whole;          // only whole numbers
  std::string what;    // meaning and unit
  std::string source;  // "paper 5.1", "Falcor", "[ours] why"
};
using ParamValues = std::map<std::string, double>;

class Method {
 public:
  virtual ~Method() = default;
  virtual SeedReuse seedReuse() const = 0;
  // The first frame of a feed: there is no difference yet. Called once, before estimate().
  virtual void start(const Frame& first, TilePool& pool) = 0;
  // From the second frame on. `out` is as large as the frames; t0, t1 and frame are filled by the caller.
  virtual void estimate(const FramePair& frames, TilePool& pool, IntensityChange& out, StageTimes& times) = 0;
};

struct MethodInfo {
  std::string name, description;
  std::vector<ParamSpec> params;
  std::unique_ptr<Method> (*make)(const ParamValues& params, int width,
                                  int height);  // params: checked and whole
};

// THE list of methods, method_table.cpp. The first is the default.
const std::vector<MethodInfo>& methodTable();
const MethodInfo* findMethod(const std::string& name);  // nullptr if there is none
std::string methodNames();                              // "event_svgf, pt, ..." for messages

// Fills in defaults. Returns what is wrong with `given` (a name that is not a parameter, a value that is out
// of range or not finite, naming the valid ones), or an empty text. `bad_name` receives the offending name.
std::string resolveParams(const MethodInfo& method, const ParamValues& given, ParamValues& resolved,
                          std::string& bad_name);

// Whether `spp` paths can be split over the passes: two passes need an even number.
bool takesSpp(const MethodInfo& method, const ParamValues& resolved, int spp);

}  // namespace saccade
