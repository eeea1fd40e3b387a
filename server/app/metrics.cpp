#include "app/metrics.h"

#include <prometheus/metric_family.h>
#include <prometheus/text_serializer.h>

#include "app/process_usage.h"
#include "app/request/enum_names.h"
#include "log/log.h"
#include "stream/bounded_peers.h"
#include "stream/refused_connections.h"

namespace saccade {
namespace {

using prometheus::MetricFamily;
using prometheus::MetricType;

class Families {
 public:
  void counter(const std::string& name, const std::string& help) { begin(name, help, MetricType::Counter); }
  void gauge(const std::string& name, const std::string& help) { begin(name, help, MetricType::Gauge); }

  // A value of the family begun last.
  void value(double value, std::vector<prometheus::ClientMetric::Label> labels = {}) {
    prometheus::ClientMetric metric;
    metric.label = std::move(labels);
    (families_.back().type == MetricType::Counter ? metric.counter.value : metric.gauge.value) = value;
    families_.back().metric.push_back(std::move(metric));
  }
  std::string text() const { return prometheus::TextSerializer().Serialize(families_); }

 private:
  void begin(const std::string& name, const std::string& help, MetricType type) {
    families_.push_back({name, help, type, {}});
  }
  std::vector<MetricFamily> families_;
};

void addWork(Families& all, const Totals& totals) {
  all.counter("saccade_frames_total", "Frames rendered; those of a shared feed once.");
  all.value(static_cast<double>(totals.frames));
  all.counter("saccade_frame_cpu_seconds_total", "CPU time of frames over all threads, by stage.");
  for (std::size_t i = 0; i < kStageNames.size(); ++i) {
    all.value(static_cast<double>(totals.stage_cpu_ns[i]) * 1e-9, {{"stage", kStageNames[i]}});
  }
  all.counter("saccade_events_total", "Events that sensors have made.");
  all.value(static_cast<double>(totals.events));
}

void addTraffic(Families& all, const Traffic& traffic) {
  all.counter("saccade_sent_packets_total", "Packets sent on the data and broadcast sockets.");
  all.value(static_cast<double>(traffic.packets));
  all.counter("saccade_sent_bytes_total", "Bytes of their headers and payloads.");
  all.value(static_cast<double>(traffic.bytes));
  all.counter("saccade_dropped_packets_total", "Packets that live streams without credit have dropped.");
  all.value(static_cast<double>(traffic.dropped_packets));
  if (!peersAreBounded()) return;
  all.counter("saccade_refused_connections_total",
              "Connections that a limit refused, or that were cut for what they sent.");
  all.value(refusedConnections());
}

void addRequests(Families& all, const RequestCounts& requests) {
  all.counter("saccade_requests_total", "Requests answered on the control socket, by call and code.");
  for (const auto& [kind, count] : requests.all()) {
    const auto* call = v1::Request::descriptor()->FindFieldByNumber(kind.first);
    all.value(static_cast<double>(count), {{"call", call ? call->name() : "none"},
                                           {"code", nameWithout("CODE_", v1::Code_Name(kind.second))}});
  }
  all.counter("saccade_dropped_requests_total",
              "Requests without a reply: the client takes none, or memory ran out.");
  all.value(static_cast<double>(requests.dropped()));
}

void addStreams(Families& all, const StreamCensus& census) {
  all.gauge("saccade_streams", "Streams that have not ended, by delivery.");
  for (const auto& [delivery, count] : census.running) all.value(count, {{"delivery", delivery}});
  all.gauge("saccade_lag_seconds", "Lag of the paced stream that is furthest behind its clock.");
  all.value(census.lag_s);
}

void addClients(Families& all, const ClientKeys& clients, const StreamCensus& census) {
  all.counter("saccade_refused_keys_total", "Connections whose key was not on the list of clients.");
  all.value(static_cast<double>(clients.refused()));
  const ClientKeys::CountsByName counts = clients.counts();
  std::map<std::string, int> streams;
  for (const auto& [key, running] : census.running_of) streams[clients.find(key).name] += running;
  all.gauge("saccade_client_streams", "Streams that have not ended, by the client's name on the list.");
  for (const auto& [name, one] : counts) all.value(streams[name], {{"client", name}});
  all.counter("saccade_client_sent_bytes_total",
              "Bytes of saccade_sent_bytes_total, by the owner of the stream.");
  for (const auto& [name, one] : counts) all.value(static_cast<double>(one->sent_bytes), {{"client", name}});
  all.counter("saccade_client_refused_requests_total",
              "Requests of saccade_requests_total with another code than ok, by client.");
  for (const auto& [name, one] : counts) all.value(static_cast<double>(one->refusals), {{"client", name}});
}

void addScenes(Families& all, const SceneCache& scenes) {
  const SceneLoads& loads = scenes.loads();
  all.gauge("saccade_scene_memory_bytes", "Memory of the scenes, as estimated.");
  all.value(static_cast<double>(scenes.bytes()));
  all.counter("saccade_scene_evictions_total", "Scenes that made room for others.");
  all.value(static_cast<double>(loads.evicted));
  all.counter("saccade_scene_loads_total", "Scenes read from their files, by result.");
  all.value(static_cast<double>(loads.done), {{"result", "ok"}});
  all.value(static_cast<double>(loads.failed), {{"result", "failed"}});
  all.counter("saccade_scene_load_seconds_total", "Time that loads with result ok took.");
  all.value(static_cast<double>(loads.ns) * 1e-9);
}

void addProcess(Families& all) {
  all.counter("saccade_dropped_log_lines_total", "Log lines dropped because the log's reader was too slow.");
  all.value(static_cast<double>(droppedLogLines()));
  const ProcessUsage usage = processUsage();
  all.counter("process_cpu_seconds_total", "User and system CPU time.");
  all.value(usage.cpu_s);
  all.gauge("process_resident_memory_bytes", "Resident memory.");
  all.value(usage.resident_bytes);
  all.gauge("process_open_fds", "Open file descriptors; near process_max_fds no client can connect.");
  all.value(usage.open_fds);
  all.gauge("process_max_fds", "Limit of open file descriptors.");
  all.value(usage.max_fds);
}

}  // namespace

std::string metricsText(const Totals& totals, const StreamRegistry& streams, const SceneCache& scenes,
                        const ClientKeys* clients, std::size_t viewers, bool ready) {
  Families all;
  all.gauge("saccade_info", "1, labelled with the version of the server.");
  all.value(1, {{"version", SACCADE_VERSION}});
  all.gauge("saccade_ready", "1 while streams may be opened.");
  all.value(ready ? 1 : 0);
  all.gauge("saccade_viewers", "Pages of browsers that watch.");
  all.value(static_cast<double>(viewers));
  addWork(all, totals);
  addTraffic(all, totals.traffic);
  addRequests(all, totals.requests);
  const StreamCensus census = streams.census();
  addStreams(all, census);
  if (clients) addClients(all, *clients, census);
  addScenes(all, scenes);
  addProcess(all);
  return all.text();
}

}  // namespace saccade
