// A truth channel tells what the renderer and the path know, on the clock of the events.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "feed/feed_interval.h"
#include "saccade/v1/truth.pb.h"
#include "saccade/wire/truth_samples.h"
#include "truth/truth_config.h"

namespace saccade {

class TruthSource {
 public:
  virtual ~TruthSource() = default;
  // Returns the samples that the interval completes, in time order. Pictures and poses are those of frames,
  // see FeedInterval. Call it for every interval from some
  // interval on, in order. Times are multiples of kTimeUnitNs, and at most the interval's t1.
  virtual TruthSamples sample(const FeedInterval& interval) = 0;
};

struct TruthChannelInfo {
  std::string name, description;  // the description states the convention
  std::string unit;               // empty: a number
  v1::Layout layout;              // LAYOUT_PICTURE or LAYOUT_ROWS
  v1::Element element;
  std::vector<std::string> planes;  // names of the planes of a picture or the elements of a row
  std::unique_ptr<TruthSource> (*make)(const TruthConfig& config);
  enum class Needs {
    kScene,
    kIntensity
  } needs = Needs::kScene;  // kIntensity: also where a client sends the frames
  enum class Setting { kNone, kBias, kExposure } setting = Setting::kNone;  // what else a request may set
  bool needs_pairs = false;  // whether it compares a frame with the one that was rendered before it
};

// THE list of truth channels.
const std::vector<TruthChannelInfo>& truthTable();
const TruthChannelInfo* findTruth(const std::string& name);  // nullptr if there is none
double rowsOfFrame(const TruthConfig& config);               // on average, at most; 0: it has pictures
bool tellsObjects(const std::string& name);                  // whether the channel numbers objects, as ids
std::string truthNames();                                    // "depth, ..." for messages
std::string truthNamesOf(TruthChannelInfo::Needs needs);     // of those that need just this

}  // namespace saccade
