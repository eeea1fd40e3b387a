#include "farm/worker/sequence_renderer.h"

#include <algorithm>
#include <stdexcept>

#include "app/request/refusal.h"
#include "app/request/resolve_trajectory.h"
#include "app/request/server_description.h"
#include "app/sequence/channel.h"
#include "app/sequence/stream_rig.h"
#include "base/instruction_set.h"
#include "client/calibration/calibration.h"
#include "client/recording/recorded_files.h"
#include "render/world/render_scene.h"
#include "truth/id_names.h"

namespace saccade::farm {
namespace {

using client::RecordedFiles;

// The answer of a server that opens the stream.
v1::StreamOpened describe(const StreamPlan& plan) {
  v1::StreamOpened opened;
  *opened.mutable_resolved() = plan.resolved.request;
  opened.set_frames(plan.resolved.frames);
  if (plan.bake) opened.set_bake_digest(plan.bake->digest);
  if (plan.resolved.path_begin_ns) opened.set_trajectory_begin_ns(*plan.resolved.path_begin_ns);
  if (asksForIds(opened.resolved())) *opened.mutable_id_names() = idNames(plan.scene->description());
  return opened;
}

RecordedFiles startFiles(const client::RecordJob& job, const v1::StreamOpened& opened,
                         const v1::ServerDescription& description) {
  RecordedFiles files{.recorder = client::Recorder(job.output, *job.format, opened, description),
                      .time_offset_ns = job.keep_times ? opened.trajectory_begin_ns() : 0};
  files.recorder.setTimeOffset(files.time_offset_ns);
  if (job.poses) files.poses.emplace(job.output, opened.resolved());
  return files;
}

void take(std::vector<Packet> packets, std::vector<RecordedFiles>& files) {
  for (Packet& packet : packets) {
    DecodedPacket batch;
    batch.header = std::move(packet.header);
    if (const std::string fault = decodePacket(batch.header, *packet.payload, batch); !fault.empty())
      throw std::logic_error(fault);
    for (RecordedFiles& file : files) file.take(batch);
  }
}

// Renders the frames of a plan, and gives what comes of them to the files.
void renderFrames(const StreamPlan& plan, const Trajectory& body, FrameIndex frames, TilePool& pool,
                  std::vector<RecordedFiles>& files) {
  const ResolvedStream& resolved = plan.resolved;
  Rig rig = makeRig(plan.scene, body, resolved, pool);
  const auto channels = makeChannels(resolved, {}, 0);
  const bool whole = resolved.request.timing().packet_per_frame();
  for (FrameIndex frame = 0; frame < frames;) {
    const std::vector<FeedInterval>& views = rig.step(pool);
    PoolHandle(pool).run(static_cast<int>(channels.size()), [&](int i) {
      Channel& channel = *channels[static_cast<std::size_t>(i)];
      channel.process(views[channel.view()], whole);
    });
    for (const auto& channel : channels) take(channel->takePackets(), files);
    frame = views.front().reachedFrame();
  }
  for (const auto& channel : channels) take(channel->end({}, frames, v1::END_REASON_FINISHED), files);
}

void writeCalibration(const client::RecordJob& job, const v1::OpenStream& resolved) {
  if (!job.calibration) return;
  for (const client::CalibrationFile& file : client::calibrationFiles(job.output, resolved)) {
    client::OutputFile out(file.name);
    out.append(file.text);
    out.close();
  }
}

v1::ServerDescription describeBuild() {
  v1::ServerDescription description;
  description.set_version(SACCADE_VERSION);
  description.set_instruction_set(instructionSetName());
  describeTruth(description);
  return description;
}

}  // namespace

SequenceRenderer::SequenceRenderer(const RenderSettings& settings, int threads)
    : tables_{openAccuracySource(settings.accuracy), openSimplificationSource(settings.simplification)},
      pool_(threads == 1 ? TilePool(CallingThread{}) : TilePool(threads)),
      scenes_(settings.scenes, limits_, settings.meshes),
      bakes_(settings.bakes, limits_),
      description_(describeBuild()) {
  flushDenormalsToZero();
}

StreamPlan SequenceRenderer::plan(const v1::OpenStream& request) const {
  StreamPlan plan = planStream(request, scenes_.library(), tables_, limits_);
  if (plan.resolved.frames == 0)
    refuse("timing.duration_s", "a sequence has an end: give a duration above 0");
  return plan;
}

Trajectory SequenceRenderer::load(StreamPlan& plan) {
  loadScenes(plan, scenes_, {});
  return resolveTrajectory(plan.resolved, *plan.whole, scenes_.library());
}

std::vector<std::pair<std::string, v1::Recording>> SequenceRenderer::render(
    const std::vector<client::RecordJob>& jobs, FrameIndex most_frames) {
  StreamPlan of = plan(jobs.front().request);
  const Trajectory body = load(of);
  bakeLight(of, body, bakes_, pool_, {});
  const v1::StreamOpened opened = describe(of);
  std::vector<RecordedFiles> files;
  for (const client::RecordJob& job : jobs) files.push_back(startFiles(job, opened, description_));
  const FrameIndex all = of.resolved.frames;
  renderFrames(of, body, most_frames > 0 ? std::min(all, most_frames) : all, pool_, files);
  std::vector<std::pair<std::string, v1::Recording>> recordings;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    files[i].commit();
    writeCalibration(jobs[i], opened.resolved());
    const auto places =
        client::recordingPlaces(jobs[i].output, *jobs[i].format, opened.resolved().sensors_size());
    for (std::size_t sensor = 0; sensor < places.size(); ++sensor)
      recordings.emplace_back(places[sensor].file, files[i].recorder.about(static_cast<int>(sensor)));
  }
  return recordings;
}

}  // namespace saccade::farm
