#include "client/commands/reading_options.h"

#include "client/options/option_range.h"

namespace saccade::client {
namespace {

constexpr Range<std::int64_t> kSortUs{1, 1'000'000};

std::vector<std::string> wordsOf(const std::string& list) {
  std::vector<std::string> words{""};
  for (const char c : list) {
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

}  // namespace

void addColumnOptions(CLI::App& command, ColumnOptions& options) {
  command.add_option_function<std::string>(
      "--columns", [&options](const std::string& list) { options.columns = wordsOf(list); },
      "what the columns are, in the order of the file, such as x,y,p,t, with - for others; or their names in "
      "the file, for t, x, y and p");
  command.add_option_function<std::string>(
      "--unit",
      [&options](const std::string& word) {
        options.unit = parseTimeUnit(word);
        if (!options.unit)
          throw std::invalid_argument("--unit: '" + word + "' is not known; known are " + kTimeUnits);
      },
      std::string("unit of t, where the file does not tell it: ") + kTimeUnits);
}

void addSensorOptions(CLI::App& command, SensorChoice& choice) {
  command.add_option("--sensor", choice.sensor,
                     "number of the sensor in a .bag, .h5 or .mcap file of several, counted from 0");
  command.add_option("--topic", choice.topic,
                     "topic of the sensor in a .bag or .mcap file, instead of --sensor");
}

void addReadingOptions(CLI::App& command, ReadingOptions& options) {
  options.mends = true;
  addColumnOptions(command, options.columns);
  addSensorOptions(command, options.sensor);
  command.add_option("--sort", options.sort_us,
                     "put events in order that are at most this many microseconds late");
  limitTo(command, "--sort", kSortUs);
  command.add_flag("--crop", options.crop, "leave events outside of the image out, and count them");
}

}  // namespace saccade::client
