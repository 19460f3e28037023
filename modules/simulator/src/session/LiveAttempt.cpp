#include "line/LineHands.h"
#include "line/PleuraSight.h"
#include "session/AimWatch.h"
#include "session/ScanWatch.h"

#include <insonate/haptics/LatestValue.h>
#include <insonate/simulator/LiveAttempt.h>
#include <insonate/simulator/ServoRecord.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

namespace insonate {
namespace {

/// The servo's clock.
std::int64_t monotonic_ns() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Passes the recorded samples on to the procedure's rules.
class Following final : public AttemptListener {
 public:
  Following(Procedure procedure, const AttemptHeader& header)
      : run_(std::move(procedure), header.picture, header.vessels) {}

  void add(const AttemptSample& sample) override {
    const std::lock_guard lock(mutex_);
    run_.add(sample);
    needle_ = sample.patientFromNeedle;
  }
  void add(const AttemptEvent& event) override {
    const std::lock_guard lock(mutex_);
    run_.add(event);
    events_.push_back(event);
  }
  MetricValues metrics() const override {
    const std::lock_guard lock(mutex_);
    return run_.metrics().values();
  }
  /// The events from index `first` on.
  std::vector<AttemptEvent> eventsFrom(std::size_t first) const {
    const std::lock_guard lock(mutex_);
    return {events_.begin() + static_cast<std::ptrdiff_t>(std::min(first, events_.size())), events_.end()};
  }

  const Procedure& procedure() const { return run_.procedure(); }
  AttemptView view() const {
    const std::lock_guard lock(mutex_);
    return {.steps = run_.steps(),
            .nextStep = run_.nextStep(),
            .findings = run_.findings(),
            .events = events_,
            .metrics = run_.metrics().values(),
            .needle = run_.metrics().needle(),
            .vessel = run_.vesselAtTip(),
            .succeeded = run_.succeeded()};
  }
  void end(AttemptStatus status) {
    const std::lock_guard lock(mutex_);
    status_ = status;
  }
  AttemptScore score() const {
    const std::lock_guard lock(mutex_);
    return computeScore(run_, status_);
  }
  std::optional<Transform> needle() const {
    const std::lock_guard lock(mutex_);
    return needle_;
  }

 private:
  mutable std::mutex mutex_;
  ProcedureRun run_;
  AttemptStatus status_ = AttemptStatus::Completed;
  std::vector<AttemptEvent> events_;
  std::optional<Transform> needle_;  ///< as last recorded
};

/// Distance by which the probe has to be withdrawn until a compressed vein counts as released.
constexpr double kReleased_mm = 3;
constexpr double kDeeper_mm = 0.1;

/// An image without a setup describes only the tissue, at a moment of a script.
bool showsBubbles(const LiveFrame& frame, const std::optional<SalineFlush>& flush) {
  if (!frame.setup) return true;
  const ImagingSettings& settings = frame.setup->settings;
  return frame.flush == flush && settings.effects.scattering && settings.look != Look::Thesis;
}

}  // namespace

struct LiveAttempt::State {
  std::filesystem::path file;
  VesselLocator vessels;
  std::shared_ptr<Following> following;
  std::unique_ptr<AttemptRecorder> recorder;
  std::int64_t begun_ns = monotonic_ns();
  std::atomic<std::int64_t> ended_ns{0};  ///< 0: has not ended
  LatestValue<Surroundings> around;
  std::atomic<bool> aspirating{false}, frozen{false};
  // Used by addFrame().
  ScanWatch scan;
  std::optional<Transform> centeredAt, compressedAt;  ///< pose of the probe in the last image in which the vein was so
  std::weak_ptr<const LiveFrame> seen;
  std::shared_ptr<const TissueGrid> seenIn;
  // The instruments after the needle; addFrame() and the window's thread use them.
  mutable std::mutex lineMutex;
  std::optional<LineHands> line;
  AttemptSettings settings;
  ImageField field;
  std::size_t lineEvents = 0;        ///< number of recorded events that the hands of the line know
  std::size_t lungEvents = 0;        ///< number of recorded events in which a puncture of a lung was looked for
  std::optional<double> trachea_mm;  ///< LiveFrame::trachea_mm of the last image that states it
  LatestValue<AttemptSample> lineSample;
  std::atomic<bool> hasLine{false}, isSyringeOn{true};
  SharedRods rods;  ///< instruments of the line in the images
  // Written by addFrame().
  std::atomic<bool> isVeinCentered{false}, isVeinCompressed{false};
  std::atomic<NeedleAim> aim{NeedleAim::Unknown};
  // Orders finish() and a tick: the first is visible to the other.
  std::atomic<bool> closed{false}, inTick{false};

  void record(const ServoSnapshot& tick) noexcept;
  void watchCompression(const LiveFrame* frame, std::span<const AttemptEvent> events);
  std::optional<ColorSettings> color() const;
  void followLine(const LiveFrame* frame, const Surroundings& tissue);
  void keepLine();
  void watchLungs();
  void showLine(std::int64_t time_us);
  std::int64_t now_us() const { return (monotonic_ns() - begun_ns) / 1000; }
};

/// A needle that punctures the pleura causes a pneumothorax on this side.
void LiveAttempt::State::watchLungs() {
  if (!trachea_mm || closed) return;
  for (const AttemptEvent& event : following->eventsFrom(lungEvents)) {
    ++lungEvents;
    const auto puncture = pneumothoraxOf(event, *trachea_mm);
    if (!puncture) continue;
    const std::lock_guard lock(lineMutex);
    std::optional<double>& since_s = settings.pneumothorax.since_s[puncture->side == BodySide::Right ? 0 : 1];
    if (since_s) continue;
    AttemptEvent grown = puncture->event;
    grown.time_us = now_us();
    since_s = static_cast<double>(grown.time_us) * 1e-6;
    recorder->recordFromOtherThread(grown);
    recorder->recordFromOtherThread(SettingsChange{grown.time_us, textOf(settings)});
  }
}

/// Moves wire, dilator and catheter along with the needle, and looks for the wire in the live image; null: none.
void LiveAttempt::State::followLine(const LiveFrame* frame, const Surroundings& tissue) {
  if (!hasLine) return;
  const std::lock_guard lock(lineMutex);
  line->setVeins(tissue.veins);
  for (const AttemptEvent& event : following->eventsFrom(lineEvents)) {
    ++lineEvents;
    if (event.kind < AttemptEventKind::Performed) line->add(event);
  }
  const std::int64_t time_us = now_us();
  line->follow(time_us,
               {tissue.needle.inBody, tissue.needle.in, tissue.needle.depth_mm, tissue.patientFromNeedle,
                tissue.restFromPatient, settings.needleLength_mm},
               settings.physiology, settings.bloodTime_s + static_cast<double>(time_us) * 1e-6);
  std::optional<LineHands::Sight> sight;
  if (frame && tissue.labels)
    sight = sightOf({frame->patientFromProbe, frame->press.displacement, field, tissue.imageDepth_mm}, *line,
                    *tissue.labels, trachea_mm, settings.lung(static_cast<double>(time_us) * 1e-6).detached_mm);
  if (sight && !showsBubbles(*frame, line->flush())) sight->bubbles = 0;
  line->look(sight);
  keepLine();
  showLine(time_us);
}

/// Shows and records the instruments if they have moved, and a flush.
void LiveAttempt::State::showLine(std::int64_t time_us) {
  auto moved = line->takeRods();
  if (!moved && line->flush() == settings.flush) return;
  settings.flush = line->flush();
  if (moved) {
    settings.rods = std::move(*moved);
    rods = std::make_shared<const std::vector<FlexibleRod>>(settings.rods);
  }
  if (!closed) recorder->recordFromOtherThread(SettingsChange{time_us, textOf(settings)});
}

/// Records the events of the line, and passes the lengths of its instruments to the ticks. `lineMutex` is locked.
void LiveAttempt::State::keepLine() {
  for (const AttemptEvent& event : line->takeEvents())
    if (!closed) recorder->recordFromOtherThread(event);
  AttemptSample lengths;
  line->fill(lengths);
  lineSample.write(lengths);
  isSyringeOn = line->state().isSyringeOn;
}

void LiveAttempt::State::record(const ServoSnapshot& tick) noexcept {
  if (tick.time_ns < begun_ns) return;
  const Surroundings& now = around.read();
  const TickContext context{.time_us = (tick.time_ns - begun_ns) / 1000,
                            .present = tick.present,
                            .imageDepth_mm = frozen ? 0 : now.imageDepth_mm,
                            .aspirating = aspirating && isSyringeOn,
                            .restFromPatient = now.restFromPatient};
  const std::span<const CenterLine> veins = now.veins ? std::span(*now.veins) : std::span<const CenterLine>{};
  AttemptSample sample = makeSample(tick.output, context, now.grid.get(), veins, vessels);
  if (hasLine) {
    const AttemptSample& lengths = lineSample.read();
    sample.wire_mm = lengths.wire_mm, sample.dilator_mm = lengths.dilator_mm;
    sample.catheter_mm = lengths.catheter_mm;
    sample.wireToHeart_mm = lengths.wireToHeart_mm, sample.catheterToHeart_mm = lengths.catheterToHeart_mm;
  }
  recorder->record(sample);
  for (int i = 0; i < tick.output.eventCount; ++i)
    recorder->record(makeEvent(tick.output.events[i], context, now.skin.get(), veins, vessels));
}

/// `frame`: null without a live image.
void LiveAttempt::State::watchCompression(const LiveFrame* frame, std::span<const AttemptEvent> events) {
  const bool isInMiddle = frame && scan.target() && scan.target()->isCentered;
  if (isInMiddle) centeredAt = frame->patientFromProbe;
  const auto isTargetCompressed = [&](const AttemptEvent& event) {
    return event.kind == AttemptEventKind::Compressed && event.vessel <= 1;
  };
  if (frame && std::ranges::any_of(events, isTargetCompressed)) compressedAt = frame->patientFromProbe;
  const bool isHeld = frame && compressedAt && isPressedFrom(*compressedAt, frame->patientFromProbe, -kReleased_mm);
  if (frame && !isHeld) compressedAt.reset();
  // Strong compression moves a vein aside.
  isVeinCentered =
      isInMiddle || (frame && centeredAt && isPressedFrom(*centeredAt, frame->patientFromProbe, kDeeper_mm));
  isVeinCompressed = isHeld;
}

std::optional<ColorSettings> LiveAttempt::State::color() const {
  const std::lock_guard lock(lineMutex);
  return settings.setup.color;
}

Result<std::shared_ptr<LiveAttempt>> LiveAttempt::start(const std::filesystem::path& file, const AttemptHeader& header,
                                                        Procedure procedure, VesselLocator vessels,
                                                        const std::optional<RecordKey>& key) {
  auto state = std::make_unique<State>();
  state->file = file;
  state->vessels = std::move(vessels);
  state->field = header.picture;
  if (auto settings = parseAttemptSettings(header.settings)) state->settings = std::move(*settings);
  state->following = std::make_shared<Following>(std::move(procedure), header);
  auto recorder = AttemptRecorder::start(file, header, state->following, key);
  if (!recorder) return tl::unexpected(recorder.error());
  state->recorder = std::move(*recorder);
  return std::shared_ptr<LiveAttempt>(new LiveAttempt(std::move(state)));
}

LiveAttempt::LiveAttempt(std::unique_ptr<State> state) : state_(std::move(state)) {}

LiveAttempt::~LiveAttempt() = default;

void LiveAttempt::onTick(const ServoSnapshot& tick) noexcept {
  state_->inTick = true;
  if (!state_->closed) state_->record(tick);
  state_->inTick = false;
}

void LiveAttempt::setSurroundings(Surroundings around) {
  state_->around.write(std::move(around));
}

void LiveAttempt::addFrame(const std::shared_ptr<const LiveFrame>& frame, const Surroundings& around) {
  State& s = *state_;
  const bool hasImage = frame && around.grid && !s.frozen;
  const bool isLive = hasImage && frame->press.force_N > 0;
  if (hasImage && (s.seen.lock() != frame || s.seenIn != around.grid)) {
    const std::span<const CenterLine> veins = around.veins ? std::span(*around.veins) : std::span<const CenterLine>{};
    s.scan.see({frame->patientFromProbe, frame->press.displacement, frame->press.middleAtRest_mm}, *around.grid,
               s.vessels, veins);
    s.aim = around.veins ? aimOf(*frame, around.needle.tent_mm, *around.grid, s.vessels, veins) : NeedleAim::Unknown;
    s.seen = frame, s.seenIn = around.grid;
  }
  const std::int64_t time_us = (monotonic_ns() - s.begun_ns) / 1000;
  const std::optional<ColorSettings> color = s.color();
  const auto events = s.scan.look(time_us, isLive, frame ? frame->patientFromProbe : Transform{},
                                  color ? &*color : nullptr, s.field.width_mm);
  s.watchCompression(isLive ? frame.get() : nullptr, events);
  for (const AttemptEvent& event : events)
    if (!s.closed) s.recorder->recordFromOtherThread(event);
  if (frame && frame->trachea_mm) s.trachea_mm = frame->trachea_mm;
  s.watchLungs();
  s.followLine(isLive ? frame.get() : nullptr, around);
}

Result<void> LiveAttempt::prepareLine(std::span<const NamedVessel> vessels) {
  auto line = LineHands::make(vessels, state_->vessels);
  if (!line) return tl::unexpected(line.error());
  state_->line = std::move(*line);
  state_->hasLine = true;
  return {};
}

SharedRods LiveAttempt::rods() const {
  if (!state_->hasLine) return nullptr;
  const std::lock_guard lock(state_->lineMutex);
  return state_->rods;
}

std::array<bool, 2> LiveAttempt::pneumothorax() const {
  const std::lock_guard lock(state_->lineMutex);
  const auto& since_s = state_->settings.pneumothorax.since_s;
  return {since_s[0].has_value(), since_s[1].has_value()};
}

Result<double> LiveAttempt::perform(LineAct act, int lumen) {
  if (!state_->hasLine) return fail("This attempt has no wire and no catheter.");
  const std::lock_guard lock(state_->lineMutex);
  auto done = state_->line->perform(state_->now_us(), act, lumen);
  state_->keepLine();
  state_->showLine(state_->now_us());
  return done;
}

std::optional<SalineFlush> LiveAttempt::flush() const {
  if (!state_->hasLine) return std::nullopt;
  const std::lock_guard lock(state_->lineMutex);
  return state_->settings.flush;
}

InstrumentMove LiveAttempt::moveInstrument(Instrument instrument, double by_mm) {
  if (!state_->hasLine) return {0, "This attempt has no wire and no catheter."};
  const LineState& line = state_->line->state();
  // In slices, so that the thread of the forces never waits for a long advance.
  constexpr double kSlice_mm = 2;
  InstrumentMove move;
  for (double left_mm = by_mm; std::abs(left_mm) > 1e-9;) {
    // A push that was refused goes on with all its length against the stop.
    const double slice_mm = move.refusal.empty() ? std::clamp(left_mm, -kSlice_mm, kSlice_mm) : left_mm;
    left_mm -= slice_mm;
    const std::lock_guard lock(state_->lineMutex);
    const double before_mm = line.length_mm(instrument);
    std::string why = state_->line->move(state_->now_us(), instrument, slice_mm);
    state_->keepLine();
    move.moved_mm += line.length_mm(instrument) - before_mm;
    // An instrument that has come out cannot be withdrawn farther.
    if (!why.empty() && by_mm < 0) return {move.moved_mm, move.moved_mm < 0 ? std::string() : std::move(why)};
    if (!why.empty()) move.refusal = std::move(why);
  }
  return move;
}

double LiveAttempt::wireResistance_N() const {
  if (!state_->hasLine) return 0;
  const std::lock_guard lock(state_->lineMutex);
  return state_->line->wireResistance_N();
}

void LiveAttempt::recordEvent(AttemptEventKind kind, double tilt_deg) {
  if (kind == AttemptEventKind::Frozen) state_->frozen = true;
  if (kind == AttemptEventKind::Released) state_->frozen = false;
  AttemptEvent event;
  event.time_us = (monotonic_ns() - state_->begun_ns) / 1000;
  event.kind = kind, event.tilt_deg = tilt_deg;
  if (const auto needle = state_->following->needle())
    event.tip_mm = needle->offset, event.axis = needle->linear.column[2];
  state_->recorder->recordFromOtherThread(event);
}

void LiveAttempt::setAspirating(bool on) {
  state_->aspirating = on;
}

void LiveAttempt::setSettings(const AttemptSettings& settings) {
  const std::lock_guard lock(state_->lineMutex);
  std::vector<FlexibleRod> rods = std::move(state_->settings.rods);
  const std::optional<SalineFlush> flush = state_->settings.flush;
  const Pneumothorax pneumothorax = state_->settings.pneumothorax;
  state_->settings = settings;
  state_->settings.rods = std::move(rods), state_->settings.flush = flush, state_->settings.pneumothorax = pneumothorax;
  state_->recorder->recordFromOtherThread(SettingsChange{state_->now_us(), textOf(state_->settings)});
}

const Procedure& LiveAttempt::procedure() const {
  return state_->following->procedure();
}

const std::filesystem::path& LiveAttempt::file() const {
  return state_->file;
}

AttemptView LiveAttempt::view() const {
  AttemptView view = state_->following->view();
  const std::int64_t ended_ns = state_->ended_ns;
  view.isVeinCentered = state_->isVeinCentered;
  view.isVeinCompressed = state_->isVeinCompressed;
  view.aim = state_->aim;
  if (state_->hasLine) {
    const std::lock_guard lock(state_->lineMutex);
    view.line = state_->line->state();
  }
  view.time_s = static_cast<double>((ended_ns ? ended_ns : monotonic_ns()) - state_->begun_ns) * 1e-9;
  return view;
}

AttemptScore LiveAttempt::score() const {
  return state_->following->score();
}

std::string LiveAttempt::error() const {
  return state_->recorder->error();
}

Result<MetricValues> LiveAttempt::finish(AttemptStatus status) {
  state_->closed = true;
  while (state_->inTick) std::this_thread::yield();
  state_->ended_ns = monotonic_ns();
  state_->following->end(status);
  return state_->recorder->finish(status);
}

}  // namespace insonate
