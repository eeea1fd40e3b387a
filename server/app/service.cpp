#include "app/service.h"

#include "app/refusal.h"
#include "stream/control_server.h"

namespace saccade {

Service::Service(const SceneCache& scenes, Budget& budget, StreamRegistry& streams, StreamOpener& opener,
                 ClientLog& log, v1::ServerDescription description)
    : scenes_(scenes),
      budget_(budget),
      streams_(streams),
      opener_(opener),
      log_(log),
      description_(std::move(description)) {}

void Service::handle(const v1::Request& request, const std::string& user,
                     std::function<void(v1::Reply)> answer) {
  const auto tell = [&log = log_, user, answer = std::move(answer)](v1::Reply reply) {
    const v1::Status& status = reply.status();
    if (status.code() != v1::CODE_OK) log.info(user, "refused: " + status.field() + " " + status.message());
    answer(std::move(reply));
  };
  v1::Reply reply;
  try {
    auto slot = budget_.take(user, {{Limit::kRequests, 1}});
    if (request.has_open_stream()) {
      return opener_.open(request.open_stream(), user, [tell, slot](v1::Reply late) mutable {
        slot.reset();  // before its client, who may ask the next at once, hears of it
        tell(std::move(late));
      });
    }
    fill(request, user, reply);
    *reply.mutable_status() = okStatus();
  } catch (...) {
    *reply.mutable_status() = statusOfException();
  }
  tell(std::move(reply));
}

void Service::fill(const v1::Request& request, const std::string& user, v1::Reply& reply) {
  switch (request.call_case()) {
    case v1::Request::kListScenes:
      *reply.mutable_list_scenes() = listScenes();
      break;
    case v1::Request::kCloseStream:
      streams_.close(request.close_stream().stream_id(), request.close_stream().token());
      reply.mutable_close_stream();
      break;
    case v1::Request::kListStreams:
      *reply.mutable_list_streams() = listStreams(user);
      break;
    case v1::Request::kServerInfo:
      *reply.mutable_server_info() = description_;
      break;
    case v1::Request::kGetFrame:
      *reply.mutable_get_frame() = getFrame(request.get_frame());
      break;
    default:
      throw Refusal(v1::CODE_UNIMPLEMENTED, "call", "this server does not know the call");
  }
}

v1::SceneList Service::listScenes() const {
  v1::SceneList list;
  for (const SceneEntry& entry : scenes_.library().list()) {
    v1::SceneInfo& scene = *list.add_scenes();
    scene.set_name(entry.name);
    scene.set_description(entry.description);
    for (const auto& name : entry.trajectories) scene.add_trajectories(name);
    scene.set_unavailable(entry.unavailable);
    scene.set_needs(scenes_.needs(entry.name));
  }
  return list;
}

v1::StreamList Service::listStreams(const std::string& user) const {
  v1::StreamList list;
  for (auto& info : streams_.list(user)) *list.add_streams() = std::move(info);
  return list;
}

v1::FramePicture Service::getFrame(const v1::GetFrame& call) const {
  const Stream stream = streams_.find(call.stream_id(), call.token());
  const v1::View& view = stream.request.view();
  budget_.use(Limit::kPictures, 2.0 * sizeof(float) * view.width() * view.height() / (1 << 20));
  auto picture = stream.feed->snapshot().picture(stream.request.sensors(0).bias());
  if (!picture) throw Refusal(v1::CODE_UNAVAILABLE, {}, "the stream has no frame yet");
  return std::move(*picture);
}

void describeMethods(v1::ServerDescription& description) {
  for (const MethodInfo& info : methodTable()) {
    v1::MethodInfo& method = *description.add_methods();
    method.set_name(info.name);
    method.set_description(info.description);
    for (const ParamSpec& spec : info.params) {
      v1::ParamInfo& param = *method.add_params();
      param.set_name(spec.name);
      param.set_min(spec.min);
      param.set_max(spec.max);
      param.set_default_value(spec.fallback);
      param.set_description(spec.what);
    }
  }
}

void describeParts(v1::ServerDescription& description) {
  for (const PartInfo& info : partTable()) {
    v1::PartInfo& part = *description.add_parts();
    part.set_name(info.name);
    part.set_description(info.description);
  }
}

}  // namespace saccade
