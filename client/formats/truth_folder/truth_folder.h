// The folder FILE.truth with the truth channels of a recording whose format does not hold them.
//
// Pictures: NAME/000000.exr or .png, one for each sample, and NAME/times.csv with the columns index, t_us,
// exposure_begin_us, exposure_end_us. Rows: NAME.csv with the column t_us and those of the channel, in the
// fewest digits that give the same number back.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "client/formats/common/output_file.h"
#include "saccade/v1/recording.pb.h"
#include "saccade/wire/truth_samples.h"

namespace saccade::client {

inline std::string truthFolderOf(const std::string& path) {
  return path + ".truth";
}

// Every call throws std::runtime_error with the name of the file that cannot be written.
class TruthFolder {
 public:
  explicit TruthFolder(const std::string& folder);  // replaces a folder that exists

  void add(int index, const v1::RecordedTruth& channel);  // before its samples
  bool holds(int index) const { return channels_.contains(index); }
  std::size_t size() const { return channels_.size(); }
  void write(int index, const TruthSamples& samples);  // in time order
  void close();                                        // the last call

 private:
  struct Channel {
    v1::RecordedTruth about;
    std::string folder;  // of its pictures
    std::unique_ptr<OutputFile> table;
    std::uint64_t pictures = 0;
  };
  const std::string folder_;
  std::map<int, Channel> channels_;  // by index
};

}  // namespace saccade::client
