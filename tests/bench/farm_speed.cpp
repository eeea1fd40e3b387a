// The CPU time of sequences of a data set, over that of their frames and events alone:
//   build/dev/bin/farm_speed [SEQUENCES WIDTHxHEIGHT SECONDS [SCENE [OUTPUT]...]]
// A worker reads the options of each sequence, renders it on one thread, writes and digests its files, and
// publishes them. The frames alone are those of `saccade-eval frames`, on one thread, with their path and
// their sensor. Both take turns, sequence by sequence. Without arguments: 200 of 0.1 s at 64x48, and 5 of 2 s
// at 346x260, of cornell-box with EVT3 and HDF5. Prints CPU times, their ratio, and the most memory.
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "app/sequence/stream_rig.h"
#include "base/thread_time.h"
#include "base/units.h"
#include "events/sensor.h"
#include "farm/dataset/json_file.h"
#include "farm/worker/make_sequence.h"
#include "farm/worker/record_words.h"
#include "scene/library/find_scenes.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

struct Setting {
  int sequences;
  std::string size, seconds, scene = "cornell-box";
  std::vector<std::string> outputs = {"events.raw", "events.h5"};
};

double cpuSeconds() {
  return seconds(processCpuTime());
}

double mostMemoryMiB() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024;
}

v1::DataSetSequence sequenceOf(const Setting& setting, int number) {
  v1::DataSetSequence sequence;
  sequence.set_number(static_cast<std::uint64_t>(number));
  for (const std::string& word : std::vector<std::string>{
           setting.scene, "--motion=random:0.5px", "--motion-seed=" + std::to_string(number), "--rate=500",
           "--size=" + setting.size, "--duration=" + setting.seconds})
    sequence.add_options(word);
  return sequence;
}

// The frames of a sequence and their events. Returns how many events there are.
std::uint64_t renderAlone(const StreamPlan& plan, const Trajectory& body, TilePool& pool) {
  Feed feed(plan.scene, body, plan.resolved.feed, pool);
  const CameraModel& camera = plan.resolved.feed.camera;
  Sensor sensor(plan.resolved.sensors.front(), camera.width, camera.height);
  SensorOutput output;
  std::uint64_t events = 0;
  for (FrameIndex frame = 0; frame < plan.resolved.frames; ++frame) {
    sensor.generate(feed.step(pool), output);
    events += output.events.size();
  }
  return events;
}

v1::DataSetPlan planOf(const Setting& setting) {
  v1::DataSetPlan plan;
  plan.set_name("speed");
  plan.set_sequences(static_cast<std::uint64_t>(setting.sequences));
  plan.set_shards(1);
  for (const std::string& output : setting.outputs) plan.add_outputs(output);
  return plan;
}

void measure(const Setting& setting, const fs::path& folder) {
  fs::create_directories(folder / "partial");
  writeJson(folder / kPlanFile, planOf(setting));
  const DataSet set(folder);
  SequenceRenderer renderer(
      {.scenes = findScenes(), .meshes = kDefaultMeshes, .bakes = {}, .accuracy = {}, .simplification = {}},
      1);
  TilePool pool(1);
  double alone_s = 0, farm_s = 0;
  std::uint64_t events = 0;
  for (int i = -1; i < setting.sequences; ++i) {  // the first one warms up
    const v1::DataSetSequence sequence = sequenceOf(setting, std::max(i, 0));
    StreamPlan plan = renderer.plan(jobsOf(sequence, setting.outputs, folder).front().request);
    const double begin = cpuSeconds();
    const std::uint64_t found = renderAlone(plan, renderer.load(plan), pool);
    const double between = cpuSeconds();
    tryToMake(set, sequence, "speed.0", renderer);
    if (i < 0) continue;
    alone_s += between - begin, farm_s += cpuSeconds() - between, events += found;
  }
  std::printf(
      "%s, %d sequences of %s s at %s, %.3g events: frames and events %.2f s of CPU, worker %.2f s; ratio "
      "%.3f; at most %.0f MiB\n",
      setting.scene.c_str(), setting.sequences, setting.seconds.c_str(), setting.size.c_str(),
      static_cast<double>(events), alone_s, farm_s, farm_s / alone_s, mostMemoryMiB());
  fs::remove_all(folder);
}

void measureAll(const std::vector<Setting>& settings) {
  std::string folder = fs::temp_directory_path() / "farm-speed-XXXXXX";
  if (!mkdtemp(folder.data())) throw std::runtime_error(folder + " cannot be made");
  for (const Setting& setting : settings) measure(setting, folder);
}

}  // namespace
}  // namespace saccade::farm

int main(int argc, char** argv) {
  using saccade::farm::Setting;
  std::vector<Setting> settings{{200, "64x48", "0.1"}, {5, "346x260", "2"}};
  if (argc > 3) settings = {{std::atoi(argv[1]), argv[2], argv[3]}};
  if (argc > 4) settings[0].scene = argv[4];
  if (argc > 5) settings[0].outputs.assign(argv + 5, argv + argc);
  try {
    saccade::farm::measureAll(settings);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "farm_speed: %s\n", fault.what());
    return 1;
  }
}
