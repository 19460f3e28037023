#include "TrainSession.h"

#include <insonate/cases/CaseView.h>
#include <insonate/simulator/EffectLayers.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/AcousticTable.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ultrasound/Textures.h>

#include <QThreadPool>
#include <algorithm>
#include <tuple>
#include <utility>

namespace insonate::train {

namespace {

/// Few enough triangles that 3D follows the probe without a graphics card.
const std::vector<ui::SurfaceWish> kSurfaces = {{kVein, {4, 1}}, {kArtery, {4, 1}}, {kSkin, {8, 3}},
                                                {kBone, {5, 2}}, {kAirway, {5, 2}}, {kThyroid, {5, 1.5}}};

auto fields(const Probe& p) {
  return std::tie(p.name, p.shape, p.width_mm, p.fovAngle_deg, p.faceRadius_mm, p.minFrequency_MHz, p.maxFrequency_MHz,
                  p.minDepth_mm, p.maxDepth_mm, p.defaultFrequency_MHz, p.defaultDepth_mm, p.defaultFocus_mm,
                  p.pitch_mm, p.bandwidth, p.transmitFNumber, p.receiveFNumber, p.maxAperture_mm, p.apodization,
                  p.elementHeight_mm, p.elevationFocus_mm);
}

/// The settings that a user can change.
auto fields(const ImagingSettings& s) {
  return std::tie(s.depth_mm, s.frequency_MHz, s.focus_mm, s.gain_dB, s.tgc_dB, s.dynamicRange_dB, s.persistence,
                  s.grayMap, s.speckleReduction, s.edgeEnhancement, s.dynamicFilter, s.noise_dB, s.ringing_dB,
                  s.poorContactLeft_mm, s.poorContactRight_mm, s.lateralGain_dB, s.looks, s.steering_deg,
                  s.compoundingAngles, s.scanlines, s.samples, s.elevationPlanes, s.width, s.height,
                  s.conformingContact, s.look);
}

template <class T>
bool same(const T& a, const T& b) {
  return fields(a) == fields(b);
}

}  // namespace

ImagingSettings fitted(ImagingSettings settings, const Probe& probe) {
  settings.depth_mm = std::clamp(settings.depth_mm, probe.minDepth_mm, probe.maxDepth_mm);
  settings.frequency_MHz = std::clamp(settings.frequency_MHz, probe.minFrequency_MHz, probe.maxFrequency_MHz);
  settings.focus_mm = std::clamp(settings.focus_mm, 1.0, settings.depth_mm);
  settings.gain_dB = std::clamp(settings.gain_dB, -40.0, 40.0);
  settings.dynamicRange_dB = std::clamp(settings.dynamicRange_dB, 20.0, 120.0);
  settings.persistence = std::clamp(settings.persistence, 0.0, 0.95);
  settings.speckleReduction = std::clamp(settings.speckleReduction, 0.0, 1.0);
  settings.edgeEnhancement = std::clamp(settings.edgeEnhancement, 0.0, 1.0);
  settings.dynamicFilter = std::clamp(settings.dynamicFilter, 0.0, 2.0);
  settings.noise_dB = std::clamp(settings.noise_dB, -120.0, 0.0);
  settings.ringing_dB = std::clamp(settings.ringing_dB, -20.0, 60.0);
  settings.poorContactLeft_mm = std::clamp(settings.poorContactLeft_mm, 0.0, 30.0);
  settings.poorContactRight_mm = std::clamp(settings.poorContactRight_mm, 0.0, 30.0);
  settings.looks = std::clamp(settings.looks, 1, 3);
  settings.steering_deg = std::clamp(settings.steering_deg, -20.0, 20.0);
  settings.compoundingAngles = std::clamp(settings.compoundingAngles, 1, 5) | 1;  // odd
  settings.scanlines = std::clamp(settings.scanlines, 16, 1024);
  for (auto* sliders : {&settings.tgc_dB, &settings.lateralGain_dB})
    for (double& value : *sliders) value = std::clamp(value, -20.0, 20.0);
  return settings;
}

TrainSession::TrainSession(QObject* parent) : QObject(parent), feed_([this] { news(); }) {
  connectHands();
  QThreadPool::globalInstance()->start([] { prepareTextures(); });
  // Both come with the program.
  probe_ = loadProbe("linear").value_or(Probe{});
  tissues_ = loadAcousticTable(acousticPresetNames().front()).value_or(AcousticTable{});
  settings_ = settingsFor(probe_);
  chosen_ = {probe_, settings_, effect_};
  said_.setSingleShot(true);
  said_.setInterval(kSaid_ms);
  connect(&said_, &QTimer::timeout, this, [this] {
    message_ = standing();
    Q_EMIT messageChanged();
  });
  control_.setGestureBegan([this](const ProbeHandState& before) { rememberMove(before); });
}

TrainSession::~TrainSession() {
  stop();
}

void TrainSession::stop() {
  worker_ = nullptr;
  hands_.setImaging(nullptr);
  feed_.set(nullptr);
}

void TrainSession::setCase(std::shared_ptr<const PatientCase> patient, const ui::CaseOrigin& origin) {
  stop();
  patient_ = std::move(patient);
  tissueLabels_ = nullptr;
  origin_ = origin;
  control_.setHand(std::nullopt);
  hands_.setHeld(false);
  hands_.setCase(nullptr, nullptr);
  history_.clear();
  start_ = {};
  levelStart_.reset();
  unplaced_.reset();
  structures_.reset();
  shown_ = nullptr;
  cine_.clear();
  cineIndex_ = 0;
  failure_.clear();
  const bool wasFrozen = std::exchange(frozen_, false);
  say(patient_ ? tr("Building the first scene.") : QString());
  Q_EMIT caseChanged();
  if (wasFrozen) Q_EMIT frozenChanged();
  if (patient_) startWorker();
}

bool TrainSession::lacksVessels() const {
  return structures_ && std::ranges::none_of(*structures_, [](auto one) { return one == kVein || one == kArtery; });
}

void TrainSession::startWorker() {
  ui::CaseWork work;
  work.tissues = [this](std::shared_ptr<const LabelMap> labels) {
    tissueLabels_ = std::move(labels);
    Q_EMIT tissuesKnown();
  };
  work.start = [this](StartPose pose) {
    start_ = std::move(pose);
    startLive();
  };
  work.hand = [this](ProbeHand hand) {
    control_.setHand(std::move(hand));
    giveHands();
    Q_EMIT handMoved();
  };
  work.unplaced = [this](ProbeHand hand, const QString& why) {
    unplaced_ = std::move(hand);
    say(why);
    wantSurfaces();
    Q_EMIT placingChanged();
  };
  work.structures = [this](const std::vector<std::uint8_t>& labels) {
    structures_ = labels;
    Q_EMIT structuresKnown();
  };
  work.surface = [this](std::uint8_t label, std::shared_ptr<const Mesh> mesh) { Q_EMIT surfaceMade(label, mesh); };
  work.surfacesDone = [this] {
    surfacesThere_ = surfacesWanted_;
    if (surfacesThere_) Q_EMIT surfacesDone();
  };
  work.failed = [this](const QString& text) {
    failure_ = text.toStdString();
    say(text);
    wantSurfaces();
    Q_EMIT failed(text);
  };
  worker_ = std::make_unique<ui::CaseWorker>(patient_, std::move(work), std::vector<ui::SurfaceWish>{});
  surfacesWanted_ = surfacesThere_ = false;
}

/// The image comes first; where there is none, nothing is to be waited for.
void TrainSession::wantSurfaces() {
  if (!worker_ || std::exchange(surfacesWanted_, true)) return;
  std::vector<ui::SurfaceWish> wishes = kSurfaces;
  for (const auto& [label, shown] : patient_->manifest.shown)
    if (shown.visible && shown.opacity > 0 && std::ranges::find(wishes, label, &ui::SurfaceWish::label) == wishes.end())
      wishes.push_back({label, {5, 2}});
  worker_->want(wishes);
}

ImagingSetup TrainSession::setup() const {
  ImagingSetup all{probe_, settings_, tissues_, "cpu"};
  all.mechanics.model = tissue_.model;
  if (effect_ != kWholeModel)
    for (const EffectLayer& layer : effectLayers(settings_))
      if (layer.name == effect_) all.settings = layer.settings;
  return all;
}

void TrainSession::startLive() {
  const auto pose = patientFromProbe(start_.position_mm, start_.axial, start_.lateral);
  if (!pose) return say(QString::fromStdString(pose.error().message));
  auto live = LiveImaging::make(CaseVolumes(patient_, tissueLabels_), setup(), *pose, liveOptions());
  if (!live) {
    const QString text = QString::fromStdString(live.error().message);
    say(text);
    wantSurfaces();
    Q_EMIT failed(text);
    return;
  }
  feed_.set(std::move(*live));
  hands_.setImaging(feed_.live());
  updateTissueRequest();
}

void TrainSession::placeOnSkin() {
  if (!unplaced_) return;
  control_.setHand(std::exchange(unplaced_, std::nullopt));
  start_ = poseOf(pose());
  startLive();
  Q_EMIT placingChanged();
  Q_EMIT handMoved();
  say(tr("The probe is on the skin in front. Drag on the skin in 3D to put it elsewhere."));
}

void TrainSession::news() {
  if (!feed_.live()) return;
  const LiveStatus now = feed_.live()->status();
  if (now.message != failure_) {
    failure_ = now.message;
    if (!failure_.empty()) say(QString::fromStdString(failure_));
  }
  if (!frozen_) show(feed_.live()->latest());
}

void TrainSession::show(std::shared_ptr<const LiveFrame> frame) {
  if (!frame || frame == shown_) return;
  const bool first = !shown_;
  shown_ = std::move(frame);
  if (first) say(tr("Drag on the image to slide the probe, press with + and -. Keys: ?"));
  Q_EMIT pictureShown();
  if (!first) return;
  wantSurfaces();
  giveHands();
}

bool TrainSession::setProbe(const std::string& name) {
  auto probe = loadProbe(name);
  if (!probe) return false;
  const ImagingSettings own = settingsFor(*probe);
  probe_ = std::move(*probe);
  settings_.depth_mm = own.depth_mm;
  settings_.frequency_MHz = own.frequency_MHz;
  settings_.focus_mm = own.focus_mm;
  sendSetup();
  return true;
}

Result<void> TrainSession::useProbe(const Probe& probe, const std::string& what) {
  if (auto ok = validate(probe); !ok) return ok;
  if (probe.defaultDepth_mm != probe_.defaultDepth_mm) settings_.depth_mm = probe.defaultDepth_mm;
  if (probe.defaultFrequency_MHz != probe_.defaultFrequency_MHz) settings_.frequency_MHz = probe.defaultFrequency_MHz;
  if (probe.defaultFocus_mm != probe_.defaultFocus_mm) settings_.focus_mm = probe.defaultFocus_mm;
  probe_ = probe;
  settings_ = fitted(settings_, probe_);
  editKind_ = "probe " + what;
  sendSetup();
  editKind_.clear();
  return {};
}

void TrainSession::setSettings(ImagingSettings settings) {
  settings_ = fitted(settings, probe_);
  sendSetup();
}

void TrainSession::setDisclosure(const Disclosure& disclosure) {
  if (std::exchange(disclosure_, disclosure) == disclosure) return;
  if (!disclosure_.anatomy) {
    if (effect_ != kWholeModel) {
      effect_ = kWholeModel;
      sendSetup();
    }
    history_.clear();
  }
  hands_.setSilent(!disclosure_.anatomy);
  Q_EMIT disclosureChanged();
}

bool TrainSession::mayShowAnatomy() {
  if (!disclosure_.anatomy) say(tr("A test shows neither CT nor anatomy."));
  return disclosure_.anatomy;
}

void TrainSession::setEffect(const std::string& name) {
  if (name != kWholeModel && !mayShowAnatomy()) return;
  effect_ = name;
  sendSetup();
}

void TrainSession::stepEffect(int by) {
  std::vector<std::string> names{kWholeModel};
  for (const EffectLayer& layer : effectLayers(settings_)) names.push_back(layer.name);
  const int count = int(names.size());
  const int now = int(std::ranges::find(names, effect_) - names.begin()) % count;
  setEffect(names[std::size_t(((now + by) % count + count) % count)]);
}

void TrainSession::sendSetup() {
  rememberSetup();
  if (feed_.live())
    if (auto ok = feed_.live()->setSetup(setup()); !ok) say(QString::fromStdString(ok.error().message));
  giveProbe();
  Q_EMIT setupChanged();
}

void TrainSession::undo() {
  showHistoryOutcome(history_.undo(), tr("Undone: %1."), tr("There is nothing to undo."));
}

void TrainSession::redo() {
  showHistoryOutcome(history_.redo(), tr("Redone: %1."), tr("There is nothing to redo."));
}

void TrainSession::showHistoryOutcome(History::Outcome outcome, const QString& done, const QString& nothing) {
  if (outcome == History::Outcome::Done) say(done.arg(QString::fromStdString(history_.lastWords())));
  if (outcome == History::Outcome::Nothing) say(nothing);
}

void TrainSession::rememberMove(const ProbeHandState& before) {
  history_.add(tr("move of the probe").toStdString(), [this, other = before]() mutable {
    if (!mayMove()) return false;
    const ProbeHandState now = handState();
    control_.restore(std::exchange(other, now));
    moved({});
    return true;
  });
}

void TrainSession::rememberSetup() {
  const Chosen before = std::exchange(chosen_, Chosen{probe_, settings_, effect_});
  const bool sameProbe = same(before.probe, probe_);
  if (sameProbe && before.effect == effect_ && same(before.settings, settings_)) return;
  const QString what = sameProbe ? tr("setting of the image") : tr("change of the probe");
  const auto exchange = [this, other = before]() mutable {
    const Chosen now = chosen_;
    // Set here, too, so that nothing new is remembered.
    chosen_ = other;
    probe_ = other.probe, settings_ = other.settings, effect_ = other.effect;
    other = now;
    sendSetup();
    return true;
  };
  history_.add(what.toStdString(), exchange, sameProbe ? "settings" : editKind_);
}

void TrainSession::setFrozen(bool frozen) {
  if (frozen == frozen_ || !feed_.live() || !shown_) return;
  feed_.live()->setFrozen(frozen);
  hands_.setHeld(frozen);
  frozen_ = frozen;
  cine_ = frozen ? feed_.live()->cine(kCine_s) : decltype(cine_){};
  cineIndex_ = std::max(0, int(cine_.size()) - 1);
  Q_EMIT frozenChanged();
  say(frozen ? tr("Frozen. Comma and period step through the last seconds.") : tr("Live."));
  show(frozen && !cine_.empty() ? cine_.back() : feed_.live()->latest());
}

void TrainSession::showCine(int index) {
  if (!frozen_ || cine_.empty()) return;
  cineIndex_ = std::clamp(index, 0, int(cine_.size()) - 1);
  show(cine_[cineIndex_]);
}

LiveStatus TrainSession::status() const {
  return feed_.live() ? feed_.live()->status() : LiveStatus{};
}

double TrainSession::imagesPerSecond() const {
  return feed_.live() ? feed_.live()->imagesPerSecond() : 0;
}

QString TrainSession::standing() const {
  if (!patient_) return {};
  if (!failure_.empty()) return QString::fromStdString(failure_);
  if (unplaced_) return tr("Place the probe: press the button, or click on the skin in 3D.");
  if (!shown_) return tr("Building the first scene.");
  if (frozen_) return tr("Frozen. Comma and period step through the last seconds.");
  return hint_.isEmpty() ? tr("Drag on the image to slide the probe, press with + and -. Keys: ?") : hint_;
}

void TrainSession::setHint(const QString& hint) {
  hint_ = hint;
  say(standing());
}

void TrainSession::say(const QString& sentence) {
  said_.start();
  if (sentence == message_) return;
  message_ = sentence;
  Q_EMIT messageChanged();
}

}  // namespace insonate::train
