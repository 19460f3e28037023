#include "hand/SkinSurface.h"
#include "line/LineHands.h"
#include "line/WireSight.h"
#include "session/MomentImaging.h"
#include "session/ScanWatch.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/haptics/SimulatedHand.h>
#include <insonate/simulator/AttemptOrigin.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/ProcedureFit.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/simulator/ServoRecord.h>
#include <insonate/simulator/VesselLocator.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>
#include <utility>

namespace insonate {
namespace {

constexpr std::int64_t kTick_us = 1000;
constexpr double kTick_s = 1e-3;
constexpr std::int64_t kTissue_us = 33'000;
/// Extent of tissue that a needle of 70 mm can reach from its first position.
constexpr double kReach_mm = 90;

/// Axes with z along the insertion, and x and y at right angles.
Transform needleAt(Vec3 tip_mm, Vec3 axis) {
  const Vec3 aside = std::abs(axis.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 y = normalized(cross(axis, aside));
  return {{{cross(y, axis), y, axis}}, tip_mm};
}

/// Both hands and their tools, one tick at a time.
class Session {
 public:
  Session(std::shared_ptr<const TissueGrid> grid, SkinSurface skin, std::vector<CenterLine> veins,
          VesselLocator vessels, AttemptSettings settings, MomentImaging& imaging, const SessionImages& pictures,
          AttemptRecorder& recorder, std::optional<LineHands> line, SessionOutcome& outcome)
      : grid_(std::move(grid)),
        skin_(std::move(skin)),
        veins_(std::move(veins)),
        vessels_(std::move(vessels)),
        settings_(std::move(settings)),
        imaging_(imaging),
        pictures_(pictures),
        imageAt_us_(pictures.every_us),
        recorder_(recorder),
        line_(std::move(line)),
        outcome_(outcome) {}

  Result<void> begin() {
    const auto needle = loadNeedleTable(settings_.needle);
    if (!needle) return tl::unexpected(needle.error());
    ServoSetup setup;
    setup.needle = *needle;
    for (ToolSetup& hand : setup.tools) hand.limits = deviceProfiles().front().limits;
    servo_.configure(setup);
    return {};
  }

  /// The error of tissue or imaging, if any.
  const Result<void>& error() const { return error_; }

  void operator()(const ScriptAction::PlaceProbe& act) { probe_ = act.patientFromProbe, tissueAt_us_ = 0; }
  void operator()(const ScriptAction::LiftProbe&) { probe_.reset(); }
  void operator()(const ScriptAction::MoveProbe& act) {
    const Vec3 from_mm = probe_->offset, way_mm = act.to_mm - from_mm;
    const int ticks = static_cast<int>(std::lround(norm(way_mm) / (act.speed_mmps * kTick_s)));
    for (int i = 1; i <= ticks; ++i) {
      probe_->offset = from_mm + way_mm * (static_cast<double>(i) / ticks);
      tick();
    }
  }
  void operator()(const ScriptAction::PlaceNeedle& act) {
    tip_mm_ = act.from_mm, axis_ = normalized(act.to_mm - act.from_mm), holdsNeedle_ = true;
    tick();
  }
  void operator()(const ScriptAction::MoveNeedle& act) {
    const Vec3 from_mm = tip_mm_;
    const int ticks = static_cast<int>(std::lround(std::abs(act.by_mm) / (act.speed_mmps * kTick_s)));
    for (int i = 1; i <= ticks; ++i) {
      tip_mm_ = from_mm + axis_ * (act.by_mm * i / ticks);
      tick();
    }
  }
  void operator()(const ScriptAction::Wait& act) {
    for (int i = 0; i < static_cast<int>(std::lround(act.seconds / kTick_s)); ++i) tick();
  }
  void operator()(const ScriptAction::Aspirate& act) { aspirating_ = act.on; }
  void operator()(const ScriptAction::ReportEvent& act) {
    if (act.kind == AttemptEventKind::Positioned) tilt(act.tilt_deg);
    if (act.kind == AttemptEventKind::Frozen) freeze();
    if (act.kind == AttemptEventKind::Released) frozen_ = false;
    const AttemptEvent event{
        .time_us = time_us_, .kind = act.kind, .tip_mm = tip_mm_, .axis = axis_, .tilt_deg = act.tilt_deg};
    tell(event);
    if (line_) line_->add(event);
  }
  void operator()(const ScriptAction::PerformAct& act) {
    tick();
    if (const auto done = line_->perform(time_us_, act.act, act.lumen); !done)
      keep(fail("The script cannot perform '" + std::string(nameOf(act.act)) + "': " + done.error().message));
    tellOfLine();
  }
  void operator()(const ScriptAction::MoveInstrument& act) {
    const int steps =
        std::max(1, static_cast<int>(std::lround(std::abs(act.by_mm) / (act.speed_mmps * 1e-6 * kTissue_us))));
    for (int i = 0; i < steps; ++i) {
      line_->move(time_us_, act.instrument, act.by_mm / steps);
      tellOfLine();
      for (std::int64_t t = 0; t < kTissue_us; t += kTick_us) tick();
    }
  }

 private:
  /// Tells the hands of the line where needle and image are, 30 times per second.
  void followLine() {
    if (!line_ || time_us_ < lineAt_us_) return;
    lineAt_us_ = time_us_ + kTissue_us;
    line_->follow(time_us_,
                  {needle_.inBody, needle_.in, needle_.depth_mm, needleAt(tip_mm_, axis_), restFromPatient_,
                   settings_.needleLength_mm},
                  settings_.physiology, settings_.bloodTime_s + static_cast<double>(time_us_) * 1e-6);
    std::optional<LineHands::Sight> sight;
    if (probe_ && force_N_ > 0 && !frozen_)
      sight = wireSightOf({*probe_, imaging_.deformation().displacement, field_, settings_.setup.settings.depth_mm},
                          *line_);
    line_->look(sight);
    tellOfLine();
  }
  void tellOfLine() {
    for (const AttemptEvent& event : line_->takeEvents()) tell(event);
    auto rods = line_->takeRods();
    if (!rods) return;
    settings_.rods = std::move(*rods);
    recorder_.recordFromOtherThread(SettingsChange{time_us_ + kTick_us, textOf(settings_)});  // from the next tick on
    keep(imaging_.use(settings_));
  }

  /// Applies the blood pressure of the patient's tilt.
  void tilt(double tilt_deg) {
    settings_.physiology.tilt_deg = tilt_deg;
    recorder_.recordFromOtherThread(SettingsChange{time_us_ + kTick_us, textOf(settings_)});  // from the next tick on
    keep(imaging_.use(settings_));
    tissueAt_us_ = 0;
  }
  /// The last image stays until imaging is unfrozen.
  void freeze() {
    frozen_ = true;
    standing_ = nullptr;
    if (!pictures_.take || !seen_ || !error_) return;
    auto frame = imaging_.picture(*seen_);
    if (frame)
      standing_ = std::move(*frame);
    else
      keep(tl::unexpected(frame.error()));
  }
  void keep(const Result<void>& done) {
    if (error_ && !done) error_ = done;
  }
  void followTissue() {
    if (!probe_) {
      force_N_ = 0, restFromPatient_ = {};
      watch_.look(time_us_, false, {}, nullptr, 0);
    }
    if (!probe_ || !error_ || time_us_ < tissueAt_us_) return;
    tissueAt_us_ = time_us_ + kTissue_us;
    // Rounded as in the recording, so that images need no other solution.
    const auto pose = dequantize(quantize({.patientFromProbe = probe_})).patientFromProbe;
    if (!pose) return;
    keep(imaging_.press(*pose, static_cast<double>(time_us_) * 1e-6));
    force_N_ = imaging_.deformation().force_N;
    restFromPatient_ = holdsNeedle_ ? imaging_.restNear(tip_mm_) : Transform{};
    watchVeins();
  }
  void watchVeins() {
    const bool isLive = force_N_ > 0 && !frozen_;
    if (isLive)
      watch_.see({*probe_, imaging_.deformation().displacement, imaging_.middleAtRest_mm()}, *grid_, vessels_, veins_);
    const auto& color = settings_.setup.color;
    for (const AttemptEvent& event : watch_.look(time_us_, isLive, *probe_, color ? &*color : nullptr, field_.width_mm))
      tell(event);
  }
  void makeImage(const AttemptSample& sample) {
    if (!pictures_.take || !error_ || time_us_ < imageAt_us_) return;
    imageAt_us_ += pictures_.every_us;
    if (!sample.patientFromProbe) return;
    if (frozen_) {
      if (const auto once = std::exchange(standing_, nullptr)) keep(pictures_.take(*once));
      return;
    }
    const auto frame = imaging_.picture(sample);
    keep(frame ? pictures_.take(**frame) : tl::unexpected(frame.error()));
  }
  void tick() {
    time_us_ += kTick_us;
    followTissue();
    const std::int64_t now_ns = time_us_ * 1000;
    servo_.setLocalModel({.time_ns = now_ns, .grid = grid_, .restFromPatient = restFromPatient_, .patches = {}});
    ServoInput input{.now_ns = now_ns, .tools = {}, .present = {probe_.has_value(), holdsNeedle_}};
    if (probe_) input.tools[kProbeTool].deviceFromStylus = *probe_;
    input.tools[kNeedleTool].deviceFromStylus = needleAt(tip_mm_, axis_);
    for (DeviceState& hand : input.tools) hand.time_ns = now_ns;
    const ServoOutput output = servo_.tick(input);

    const bool live = probe_ && !frozen_;
    const TickContext context{time_us_, input.present, live ? settings_.setup.settings.depth_mm : 0,
                              aspirating_ && (!line_ || line_->state().isSyringeOn), restFromPatient_};
    AttemptSample sample = makeSample(output, context, grid_.get(), veins_, vessels_);
    sample.probeForce_N = force_N_;
    needle_ = output.needle;
    if (line_) line_->fill(sample);
    waitForRoom();
    recorder_.record(sample);
    const AttemptSample kept = dequantize(quantize(sample));
    outcome_.run.add(kept);
    if (live) seen_ = kept;
    makeImage(kept);
    for (int i = 0; i < output.eventCount; ++i) {
      const AttemptEvent event = makeEvent(output.events[i], context, &skin_, veins_, vessels_);
      tell(event);
      if (line_) line_->add(event);
    }
    followLine();
  }
  void tell(const AttemptEvent& event) {
    waitForRoom();
    recorder_.record(event);
    outcome_.run.add(event);
    outcome_.events.push_back(event);
  }
  /// The script is faster than the recorder.
  void waitForRoom() const {
    while (recorder_.freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  std::shared_ptr<const TissueGrid> grid_;
  SkinSurface skin_;
  std::vector<CenterLine> veins_;
  VesselLocator vessels_;
  ScanWatch watch_;
  AttemptSettings settings_;
  MomentImaging& imaging_;
  const SessionImages& pictures_;
  std::int64_t imageAt_us_, tissueAt_us_ = 0;  ///< times of the next ones
  double force_N_ = 0;
  Transform restFromPatient_;
  Result<void> error_;
  AttemptRecorder& recorder_;
  std::optional<LineHands> line_;  ///< empty: the script has no acts of the line
  std::int64_t lineAt_us_ = 0;
  NeedleState needle_;
  SessionOutcome& outcome_;
  HapticServo servo_;
  std::int64_t time_us_ = 0;
  std::optional<Transform> probe_;
  bool holdsNeedle_ = false, aspirating_ = false, frozen_ = false;
  std::optional<AttemptSample> seen_;          ///< the last one with a live image
  std::shared_ptr<const LiveFrame> standing_;  ///< until an image was rendered
  Vec3 tip_mm_, axis_{0, 0, 1};
  ImageField field_ = imageFieldOf(settings_.setup.probe);
};

/// The image that this probe would give of a patient at rest.
Result<AttemptSettings> settingsOf(const SessionScript& script) {
  const auto probe = loadProbe(script.probe);
  if (!probe) return tl::unexpected(probe.error());
  auto tissues = loadAcousticTable(acousticPresetNames().front());
  if (!tissues) return tl::unexpected(tissues.error());
  AttemptSettings settings;
  settings.setup = {*probe, settingsFor(*probe), std::move(*tissues), "cpu"};
  settings.needle = needlePresetNames().front();
  return settings;
}

/// First position of the needle, or of the probe if there is no needle.
Vec3 placeOf(const SessionScript& script) {
  std::optional<Vec3> probe_mm;
  for (const ScriptAction& act : script.actions) {
    if (const auto* put = std::get_if<ScriptAction::PlaceNeedle>(&act.what)) return put->from_mm;
    if (const auto* put = std::get_if<ScriptAction::PlaceProbe>(&act.what); put && !probe_mm)
      probe_mm = put->patientFromProbe.offset;
  }
  return probe_mm.value_or(Vec3{});
}

/// The hands of the line, if the script uses them.
Result<std::optional<LineHands>> lineOf(const SessionScript& script, const PatientCase& patient,
                                        const VesselLocator& vessels, const std::vector<CenterLine>& veins) {
  const bool isUsed = std::ranges::any_of(script.actions, [](const ScriptAction& act) {
    return std::holds_alternative<ScriptAction::PerformAct>(act.what) ||
           std::holds_alternative<ScriptAction::MoveInstrument>(act.what);
  });
  if (!isUsed) return std::optional<LineHands>{};
  auto line = LineHands::make(patient.manifest.vessels, vessels);
  if (!line) return tl::unexpected(line.error());
  line->setVeins(std::make_shared<const std::vector<CenterLine>>(veins));
  return std::optional(std::move(*line));
}

}  // namespace

Result<SessionOutcome> runSession(const SessionScript& script, const PatientCase& patient, std::string_view software,
                                  const std::filesystem::path& recording, const Progress& progress,
                                  const SessionImages& pictures) {
  auto procedure = loadProcedure(script.procedure);
  if (!procedure) return tl::unexpected(procedure.error());
  if (auto ok = checkProcedureFits(*procedure, patient); !ok) return tl::unexpected(ok.error());
  auto settings = settingsOf(script);
  if (!settings) return tl::unexpected(settings.error());
  auto grid = TissueGrid::fromLabels(patient.labels, placeOf(script), kReach_mm);
  if (!grid) return tl::unexpected(grid.error());
  auto skin = SkinSurface::make(patient.labels);
  if (!skin) return tl::unexpected(skin.error());
  auto veins = centerLines(patient.labels, kVein, progress);
  if (!veins) return tl::unexpected(veins.error());
  AttemptHeader header = headerOf(*procedure, patient, settings->setup.probe, software);
  VesselLocator vessels(patient.manifest, *procedure, placeOf(script));
  header.vessels = vessels.names();
  header.caseHash = voxelHashOf(patient);
  header.engine = settings->setup.engine;
  header.settings = textOf(*settings);
  header.isScripted = true;
  auto line = lineOf(script, patient, vessels, *veins);
  if (!line) return tl::unexpected(line.error());
  auto source = makeSceneSource(patient);
  if (!source) return tl::unexpected(source.error());
  MomentImaging imaging(patient.labels, std::move(*source), patient.manifest.vessels);
  if (auto ok = imaging.use(*settings); !ok) return tl::unexpected(ok.error());
  auto recorder = AttemptRecorder::start(recording, header);
  if (!recorder) return tl::unexpected(recorder.error());
  SessionOutcome outcome{{}, {}, {}, ProcedureRun(std::move(*procedure), header.picture, header.vessels)};
  Session session(std::move(*grid), std::move(*skin), std::move(*veins), std::move(vessels), std::move(*settings),
                  imaging, pictures, **recorder, std::move(*line), outcome);
  if (auto ok = session.begin(); !ok) return tl::unexpected(ok.error());
  const auto withdrawn = [&](tl::unexpected<Error> why) {
    recorder->reset();
    std::error_code error;
    std::filesystem::remove(recording, error);
    return why;
  };
  for (std::size_t i = 0; i < script.actions.size(); ++i) {
    if (!report(progress, "attempt", static_cast<double>(i) / static_cast<double>(script.actions.size())))
      return withdrawn(fail(std::string(kCancelled)));
    std::visit([&](const auto& act) { session(act); }, script.actions[i].what);
    if (!session.error()) return withdrawn(tl::unexpected(session.error().error()));
  }
  outcome.status = script.abandoned ? AttemptStatus::Abandoned : AttemptStatus::Completed;
  const auto metrics = (*recorder)->finish(outcome.status);
  if (!metrics) return tl::unexpected(metrics.error());
  outcome.metrics = *metrics;
  return outcome;
}

}  // namespace insonate
