#include "Commands.h"
#include "Interrupt.h"

#include <insonate/cases/HeartDistance.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/igtlink/ImageLink.h>
#include <insonate/simulator/ProbePlacement.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ScriptedSession.h>

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <thread>

namespace insonate::cli {
namespace {

using LinkClock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPoseStep{16};
constexpr std::int64_t kScriptImage_us = 33'000;

struct LinkOptions {
  std::string caseFolder, probe = "linear", pose = "auto", script;
  int port = kLinkPort;
  bool anyAddress = false, orbit = false;
};

/// Settings of the live images, which the commands of clients change on the server's thread.
class LinkedImaging {
 public:
  static Result<std::unique_ptr<LinkedImaging>> make(const LinkOptions& options,
                                                     const std::shared_ptr<const PatientCase>& patient,
                                                     const Transform& patientFromProbe) {
    auto made = std::make_unique<LinkedImaging>();
    auto probe = loadProbe(options.probe);
    if (!probe) return tl::unexpected(probe.error());
    auto tissues = loadAcousticTable("neck");
    if (!tissues) return tl::unexpected(tissues.error());
    made->setup_.probe = *probe, made->setup_.settings = settingsFor(*probe),
    made->setup_.tissues = std::move(*tissues);
    LiveOptions live;
    live.pulsating = true;
    live.physiology.siteAboveHeart_mm = siteAboveHeart_mm(patient->manifest);
    auto imaging = LiveImaging::make(patient, made->setup_, patientFromProbe, live);
    if (!imaging) return tl::unexpected(imaging.error());
    made->imaging_ = std::move(*imaging);
    return made;
  }

  LiveImaging& imaging() { return *imaging_; }
  void obey(const LinkCommand& command, const LinkServer::Answer& answer) {
    const std::scoped_lock lock(mutex_);
    LinkedSettings changed{setup_.settings, frozen_};
    const LinkReply reply = performCommand(command, setup_.probe, changed);
    setup_.settings = changed.settings;
    // The settings have been checked, so that they are accepted.
    if (auto ok = imaging_->setSetup(setup_); !ok) return answer({false, ok.error().message, {}});
    imaging_->setFrozen(changed.frozen);
    frozen_ = changed.frozen;
    answer(reply);
  }

 private:
  std::mutex mutex_;  ///< guards setup_ and frozen_
  ImagingSetup setup_;
  bool frozen_ = false;
  std::unique_ptr<LiveImaging> imaging_;
};

Result<std::shared_ptr<const PatientCase>> linkedCase(const LinkOptions& options) {
  auto read = readCase(options.caseFolder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  replaceOwnLabels(read->patient);
  return std::make_shared<const PatientCase>(std::move(read->patient));
}

Result<std::unique_ptr<LinkServer>> openServer(const LinkOptions& options, LinkServer::CommandHandler handler) {
  auto server = LinkServer::start({options.port, options.anyAddress}, std::move(handler));
  if (server)
    std::cout << "Serving at " << (options.anyAddress ? "port " : "127.0.0.1:") << (*server)->port()
              << ". Ctrl-C ends the server." << std::endl;  // flushed, so that a script can read the port
  return server;
}

/// Slides the probe over the skin on a circle, once in eight seconds, until a signal.
void moveOnCircle(LiveImaging& imaging, const ProbePlacement& start) {
  constexpr double kRadius_mm = 6, kPeriod_s = 8;
  const auto begin = LinkClock::now();
  while (interruptSignal() == 0) {
    const double angle =
        std::chrono::duration<double>(LinkClock::now() - begin).count() * 2 * std::numbers::pi / kPeriod_s;
    ProbePlacement placed = start;
    placed.slide(kRadius_mm * std::sin(angle), kRadius_mm * (1 - std::cos(angle)));
    imaging.setPose(placed.pose());
    std::this_thread::sleep_for(kPoseStep);
  }
}

Result<void> serveLive(const LinkOptions& options) {
  const auto patient = linkedCase(options);
  if (!patient) return tl::unexpected(patient.error());
  const auto path = readPoses(options.pose, **patient);
  if (!path) return tl::unexpected(path.error());
  if (path->isPath) return fail("link serve takes one pose, not a path of poses.");
  const auto placement = ProbePlacement::make((*patient)->labels, path->patientFromProbe.front());
  if (!placement) return tl::unexpected(placement.error());
  auto linked = LinkedImaging::make(options, *patient, placement->pose());
  if (!linked) return tl::unexpected(linked.error());
  LiveImaging& imaging = (*linked)->imaging();
  const auto server = openServer(
      options, [&](const LinkCommand& command, const LinkServer::Answer& answer) { (*linked)->obey(command, answer); });
  if (!server) return tl::unexpected(server.error());
  imaging.setFrameListener([&, last = std::uint64_t{0}]() mutable {
    const auto frame = imaging.latest();
    if (!frame || frame->number == last) return;
    last = frame->number;
    (*server)->post(linkFrameOf(frame));
  });
  if (options.orbit) moveOnCircle(imaging, *placement);
  while (interruptSignal() == 0) std::this_thread::sleep_for(kPoseStep);
  imaging.setFrameListener({});
  return {};
}

/// Plays the script in real time, as far as the images can be computed in time.
Result<void> serveScript(const LinkOptions& options) {
  const auto patient = linkedCase(options);
  if (!patient) return tl::unexpected(patient.error());
  const auto script = loadSessionScript(options.script, **patient);
  if (!script) return tl::unexpected(script.error());
  const auto server = openServer(options, [](const LinkCommand&, const LinkServer::Answer& answer) {
    answer({false, "A script is played, whose settings cannot be changed.", {}});
  });
  if (!server) return tl::unexpected(server.error());
  const std::filesystem::path recording =
      std::filesystem::temp_directory_path() / ("insonate-link-" + std::to_string(::getpid()) + ".attempt");
  std::optional<LinkClock::time_point> due;
  const auto take = [&](const LiveFrame& frame) -> Result<void> {
    due = due.value_or(LinkClock::now()) + std::chrono::microseconds(kScriptImage_us);
    std::this_thread::sleep_until(*due);
    (*server)->post(linkFrameOf(std::make_shared<LiveFrame>(frame)));
    return {};
  };
  const auto done = runSession(*script, **patient, "insonate " INSONATE_VERSION, recording, terminalProgress(),
                               {kScriptImage_us, take});
  std::error_code ignored;
  std::filesystem::remove(recording, ignored);
  if (!done) return tl::unexpected(done.error());
  return {};
}

}  // namespace

void addLinkCommand(CLI::App& app, Outcome& outcome) {
  auto* link = app.add_subcommand("link", "Exchange images and commands with other programs by OpenIGTLink");
  link->require_subcommand(1);
  auto* serve = link->add_subcommand("serve", "Send live images to 3D Slicer and other programs, until Ctrl-C");
  auto o = std::make_shared<LinkOptions>();
  serve->add_option("CASE", o->caseFolder, "Folder of the case")->required()->check(notEmpty());
  serve->add_option("--port", o->port, "TCP port; 0: a free port, which is printed")
      ->capture_default_str()
      ->check(CLI::Range(0, 65535));
  serve->add_flag("--any-address", o->anyAddress, "Accept programs of other computers, too: there is no password");
  serve->add_option("--probe", o->probe, "Probe: linear, curvilinear, phased, or a probe file")->capture_default_str();
  serve
      ->add_option("--pose", o->pose,
                   "Pose of the probe: auto, the name of a start pose of the case, a JSON file, or JSON text")
      ->capture_default_str();
  auto* orbit = serve->add_flag("--orbit", o->orbit, "Slide the probe over the skin on a circle");
  serve
      ->add_option("--script", o->script, "Play an attempt, with its needle: name of a built-in script, or a JSON file")
      ->excludes(orbit);
  serve->callback([o, &outcome] {
    const auto done = o->script.empty() ? serveLive(*o) : serveScript(*o);
    if (!done)
      refuse(outcome, done.error());
    else if (interruptSignal() != 0)
      outcome.status = 128 + interruptSignal();
  });
}

}  // namespace insonate::cli
