#include "client/options/truth_option.h"

#include <filesystem>
#include <stdexcept>

#include "client/formats/truth_folder/truth_folder.h"
#include "client/options/request_text.h"
#include "client/recording/recorder.h"
#include "saccade/stream_views.h"

namespace saccade::client {

void addTruthOption(CLI::App& command, std::vector<std::string>& channels) {
  command
      .add_option(
          "--truth", channels,
          "NAME or NAME:EVERY, a truth channel that `saccade info` lists, of every EVERY-th frame; may be "
          "given again, or several with commas. Files .h5, .npz, .bag and .mcap hold it; else the folder "
          "FILE.truth does")
      ->allow_extra_args(false)
      ->delimiter(',')
      ->group("Truth");
}

void requestTruth(const std::vector<std::string>& channels, v1::OpenStream& request) {
  for (const std::string& channel : channels) {
    const auto [name, number] = splitAt(channel, ':');
    const auto every = name == channel ? 1 : parseNumber<std::uint32_t>(number).value_or(0);
    if (name.empty() || every == 0)
      throw std::invalid_argument("--truth: '" + channel +
                                  "' is neither NAME nor NAME:EVERY, such as depth:10");
    const std::uint32_t views = name == "imu" ? 1 : viewsOf(request);  // an IMU is in the body
    for (std::uint32_t view = 0; view < views; ++view) {
      v1::Truth& truth = *request.add_truth();
      truth.set_name(name);
      truth.set_every(every);
      truth.set_view(view);
    }
  }
}

void checkTruthOutput(const OutputOptions& options, const v1::OpenStream& request) {
  if (request.truth_size() == 0) return;
  if (options.path == kStandardOutput)
    throw std::invalid_argument("--truth: standard output takes events only");
  const auto places = recordingPlaces(options.path, options.writer(), request.sensors_size());
  for (int i = 0; i < request.truth_size(); ++i) {
    const std::string folder = truthFolderOf(places.at(sensorOfTruth(request, i)).name);
    if (std::filesystem::exists(folder) && !options.force)
      throw std::invalid_argument("--output: '" + folder + "' exists; --force replaces it");
  }
}

}  // namespace saccade::client
