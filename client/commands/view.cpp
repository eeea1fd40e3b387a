// saccade view: shows the events of a stream in the terminal.
#include <chrono>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "client/commands/commands.h"
#include "client/commands/live_view.h"
#include "client/commands/stream_opening.h"
#include "client/formats/common/units.h"
#include "client/options/help_formatter.h"
#include "client/options/option_range.h"
#include "client/options/request_options.h"
#include "client/terminal/interrupt.h"

namespace saccade::client {
namespace {

constexpr std::chrono::milliseconds kPollInterval{50};  // for Ctrl-C and the drawing

struct ViewOptions {
  RequestOptions request;
  double decay_s = 0.02;
};

void watch(Subscription& subscription, LiveView& view) {
  for (bool ended = false; !ended && !interrupted();) {
    if (const auto batch = subscription.receive(kPollInterval)) {
      view.see(*batch);
      ended = batch->header.kind() == v1::KIND_END;
    }
    view.drawIfDue(subscription.losses());
  }
}

void fitTo(const TerminalScreen& screen, v1::OpenStream& request) {
  const v1::View fitting = viewOf(screen.size());
  request.mutable_view()->MergeFrom(fitting);
  for (v1::View& further : *request.mutable_further_views()) further.MergeFrom(fitting);
}

void runView(const ViewOptions& options) {
  if (options.request.sensors.thresholds.size() > 1)
    throw std::invalid_argument("--threshold: a view shows the events of one sensor");
  v1::OpenStream request = makeOpenStream(options.request);
  watchInterrupt();
  zmq::context_t context;
  ControlClient control = connectTo(context, options.request.server);
  const TerminalScreen screen;
  if (request.view().width() == 0) fitTo(screen, request);
  screen.showStatus("opening the stream; Ctrl-C ends");
  const double retry_s = options.request.retry_time_s;
  const auto show = [&screen](const std::string& text) { screen.showStatus(text); };
  StreamHandle stream =
      openStream(control, {std::move(request), options.request.trajectory, retry_s}, show, show);
  Subscription subscription(
      context, stream,
      {.retry_time = millisecondsOf(retry_s),
       .waiting = throwIfInterrupted,
       .lost = [&screen](const std::string& loss) { screen.showStatus(loss + "; trying again"); }});
  LiveView view(screen, stream.opened().resolved().view(), options.decay_s);
  watch(subscription, view);
}

}  // namespace

void addViewCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("view", "show the events of a stream in the terminal");
  const auto options = std::make_shared<ViewOptions>();
  options->request.camera.default_size.clear();
  options->request.duration_s = 0;
  options->request.delivery = "live";
  command
      ->add_option("--decay", options->decay_s, "seconds of stream time in which an event fades to a third")
      ->capture_default_str();
  limitTo(*command, "--decay", Range<double>{1e-6, 1e6});
  addRequestOptions(*command, options->request);
  std::set<std::string> common = commonRequestOptions();
  common.insert("--decay");
  showInHelp(*command, common);
  command->footer(std::string(kMotionHelp) +
                  "\n\nWithout --size the image has the terminal's size, two pixels in each letter.\n"
                  "The terminal must show 24-bit colours, as most do.\n\n"
                  "Example: saccade view cornell-box --motion orbit");
  command->callback([options] { runView(*options); });
}

}  // namespace saccade::client
