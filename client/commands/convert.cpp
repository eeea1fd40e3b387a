// saccade convert: reads a file of events and writes it in another format.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "client/commands/commands.h"
#include "client/commands/source_file.h"
#include "client/commands/summary.h"
#include "client/formats/common/units.h"
#include "client/options/output_options.h"
#include "client/recording/recording_file.h"
#include "client/terminal/console.h"
#include "client/terminal/interrupt.h"
#include "client/terminal/progress.h"

namespace saccade::client {
namespace {

struct ConvertOptions {
  std::string input, size;
  ReadingOptions reading;
  OutputOptions output;
};

// Facts about the events that are known before the first is read.
v1::Recording aboutEvents(const SourceFile& source, const WriterInfo& format) {
  const bool labels = source.facts().labels && format.labels;
  const bool objects = source.facts().object_ids && format.objects;
  v1::Recording about = source.recording().value_or(v1::Recording());
  about.clear_begin_ns();
  about.clear_end_ns();
  about.clear_events();
  about.clear_truth();  // SourceFile says that it is left out
  about.clear_truth_places();
  if (!objects) about.clear_id_names();
  about.set_labels(labels);
  about.set_object_ids(objects);
  if (about.has_request())  // so that a replay can write the new format
    for (v1::Sensor& sensor : *about.mutable_request()->mutable_sensors()) {
      if (!labels) sensor.clear_labels();
      if (!objects) sensor.clear_object_ids();
    }
  about.set_width(source.size().width);
  about.set_height(source.size().height);
  return about;
}

void copyEvents(SourceFile& source, RecordedSensor& file, Progress& progress) {
  const auto& recording = source.recording();
  std::int64_t t0_ns = recording ? recording->begin_ns() : 0;
  std::int64_t end_ns = recording ? recording->end_ns() : 0;
  for (Events events; source.read(events);) {
    throwIfInterrupted();
    if (events.empty()) continue;
    file.write(events, t0_ns, events.back().t_ns);  // more events may have the time of the last
    t0_ns = events.back().t_ns;
    end_ns = std::max(end_ns, t0_ns + kNsPerUs);
    const double stream_s = secondsOf(t0_ns);
    progress.update(stream_s, stream_s, file.about().events());
  }
  file.write({}, t0_ns, end_ns);
}

void checkDigest(const SourceFile& source, const RecordedSensor& file) {
  if (!source.recording() || source.recording()->digest() == file.about().digest()) return;
  throw std::runtime_error(source.path() + ": the events are not those that " + source.description() +
                           " describes; remove that file if it is of another recording");
}

void runConvert(const ConvertOptions& options) {
  const WriterInfo& format = options.output.writer();
  checkOutputs(options.output, 1);
  watchInterrupt();
  SourceFile source(options.input, options.size, {format.labels, format.objects}, options.reading);
  RecordingFile file(options.output.path, format, {aboutEvents(source, format)});
  Progress progress(source.recording() ? secondsOf(source.recording()->end_ns()) : 0);
  try {
    copyEvents(source, file.sensor(0), progress);
    file.close();
  } catch (const std::system_error& fault) {
    progress.finish();
    throw std::runtime_error(fault.what() + ("; " + std::to_string(file.salvage())) + " events are kept in " +
                             file.name());
  }
  progress.finish();
  checkDigest(source, file.sensor(0));
  file.commit();
  std::FILE* out = options.output.path == kStandardOutput ? stderr : stdout;
  printFiles(out, {file.name()}, "");
  print(out, "%llu events\n%s", static_cast<unsigned long long>(file.sensor(0).about().events()),
        source.changes().c_str());
}

}  // namespace

void addConvertCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("convert", "write a file of events in another format");
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("input", options->input, "file to read: " + readerNames())->required();
  addOutputOptions(*command, options->output, "output");
  command->add_option("--size", options->size,
                      "WIDTHxHEIGHT in pixels, where neither the input nor INPUT.json tells it");
  addReadingOptions(*command, options->reading);
  command->callback([options] { runConvert(*options); });
}

}  // namespace saccade::client
