#include "session/MomentImaging.h"

#include "hands/RestNear.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Settling time of a closing vein.
constexpr int kPatience = 200;
/// Scenes begin and end on this lattice, so that near poses share one, and equal poses always have the same one.
constexpr double kLattice_mm = 8;
constexpr std::size_t kScenesKept = 4;
/// Number of places from which a probe counts as moving: the parts that scenes share are then worth their time.
constexpr int kScenesAlone = 6;
/// A smaller value is not a dent (see HapticLoop).
constexpr double kMinTent_mm = 0.02;

Region onLattice(const Region& region) {
  Region wide = region;
  for (int axis = 0; axis < 3; ++axis) {
    wide.low_mm[axis] = kLattice_mm * std::floor(region.low_mm[axis] / kLattice_mm);
    wide.high_mm[axis] = kLattice_mm * std::ceil(region.high_mm[axis] / kLattice_mm);
  }
  return wide;
}

bool same(const Region& a, const Region& b) {
  return a.low_mm == b.low_mm && a.high_mm == b.high_mm;
}

std::optional<Needle> needleOf(const AttemptSample& sample, const AttemptSettings& settings) {
  if (!sample.patientFromNeedle) return std::nullopt;
  const Transform& held = *sample.patientFromNeedle;
  return Needle{.tip_mm = held.offset,
                .direction = held.linear.column[2],
                .bevelNormal = -held.linear.column[1],
                .radius_mm = settings.needleRadius_mm,
                .length_mm = settings.needleLength_mm};
}

}  // namespace

MomentImaging::MomentImaging(const LabelMap& labels, std::shared_ptr<const SceneSource> source,
                             std::span<const NamedVessel> vessels)
    : grid_(labels.geometry), source_(std::move(source)), flow_(vessels, &labels), bubbles_(vessels, &labels) {}
MomentImaging::~MomentImaging() = default;

/// A wire that moves, and a flush, change only themselves: neither beams nor tissue have to be computed again.
bool MomentImaging::useInstruments(const AttemptSettings& settings) {
  if (!settings_) return false;
  if (settings.rods.empty() && settings_->rods.empty() && settings.flush == settings_->flush) return false;
  AttemptSettings before = *settings_, now = settings;
  before.rods.clear(), now.rods.clear(), before.flush.reset(), now.flush.reset();
  if (textOf(before) != textOf(now)) return false;
  settings_->rods = settings.rods, settings_->flush = settings.flush;
  rods_ = std::make_shared<const std::vector<FlexibleRod>>(settings.rods);
  return true;
}

Result<void> MomentImaging::use(const AttemptSettings& settings) {
  if (useInstruments(settings)) return {};
  ImagingSetup setup = settings.setup;
  setup.settings.persistence = 0;
  if (setup.color) setup.color->persistence = 0;
  setup.mechanics.settings.maxIterations = kPatience;
  auto imager = Imager::make(setup);
  if (!imager) return tl::unexpected(imager.error());
  if (auto ok = validate(setup.mechanics); !ok) return ok;
  const live::SceneNeed need(setup, grid_);
  if (!setup_ || setup_->tissues.tissues != setup.tissues.tissues || need_->detail_mm() != need.detail_mm())
    scenes_.clear();
  need_ = need;
  setup_ = std::make_shared<const ImagingSetup>(std::move(setup));
  imager_.emplace(std::move(*imager));
  settings_ = settings;
  rods_ = settings.rods.empty() ? nullptr : std::make_shared<const std::vector<FlexibleRod>>(settings.rods);
  pose_.reset(), tissue_.reset();
  return {};
}

Result<void> MomentImaging::takeScene(const Transform& patientFromProbe) {
  const Region region = onLattice(need_->at(patientFromProbe));
  const auto known = std::ranges::find_if(scenes_, [&](const Scene& scene) { return same(scene.region_mm, region); });
  if (known != scenes_.end()) {
    std::rotate(scenes_.begin(), known, known + 1);
    return {};
  }
  if (++scenesMade_ > kScenesAlone)
    while (source_->precompute(region, need_->detail_mm())) {
    }
  auto scene = makeScene(*source_, *setup_, region);
  if (!scene) return tl::unexpected(scene.error());
  if (scenes_.size() == kScenesKept) scenes_.pop_back();
  scenes_.insert(scenes_.begin(), {region, std::move(*scene)});
  return {};
}

Result<void> MomentImaging::press(const Transform& patientFromProbe, double time_s) {
  const BloodPressure blood = settings_->blood(time_s);
  const LungMotion lung = settings_->lung(time_s);
  if (tissue_) tissue_->moveLung(lung);
  if (pose_ == patientFromProbe && blood.artery_kPa == blood_.artery_kPa && blood.vein_kPa == blood_.vein_kPa)
    return {};
  pose_.reset(), tissue_.reset(), middleAtRest_mm_.clear();
  if (!need_->misses(patientFromProbe)) {
    if (auto ok = takeScene(patientFromProbe); !ok) return ok;
    auto tissue = CompressedTissue::make(setup_->probe, setup_->settings, setup_->mechanics);
    if (!tissue) return tl::unexpected(tissue.error());
    tissue_.emplace(std::move(*tissue));
    tissue_->moveLung(lung);
    tissue_->hold(scene(), patientFromProbe, blood);
    restAlongMiddle(deformation().displacement, patientFromProbe, setup_->settings.depth_mm, middleAtRest_mm_);
  }
  pose_ = patientFromProbe, blood_ = blood;
  return {};
}

const Deformation& MomentImaging::deformation() const {
  static const Deformation kRest;
  return tissue_ ? tissue_->deformation() : kRest;
}

Transform MomentImaging::restNear(Vec3 patient_mm) const {
  return pose_ ? insonate::restNear(deformation().displacement, *pose_, patient_mm) : Transform{};
}

void MomentImaging::describePress(LiveFrame& frame) const {
  const Deformation& answer = deformation();
  frame.press.force_N = answer.force_N;
  frame.press.indentation_mm = tissue_ ? tissue_->indentation_mm() : std::nan("");
  frame.press.lumens = answer.lumens;
  frame.press.pressure = blood_;
  frame.press.middleAtRest_mm = middleAtRest_mm_;
  thinOut(answer.displacement, frame.press.displacement);
  frame.press.settled = answer.converged;
  if (frame.needle) frame.press.restFromPatient = restNear(frame.needle->tip_mm);
}

ColorMotion MomentImaging::motionOf(const AttemptSample& sample, const AttemptSample* before,
                                    const PlaneDisplacement& displacement) {
  const double time_s = static_cast<double>(sample.time_us) * 1e-6;
  const auto bloodTime_s =
      settings_->pulsating ? std::optional(settings_->bloodTime_s + time_s) : std::optional<double>();
  const Transform& pose = *sample.patientFromProbe;
  ColorMotion motion{.blood = &flow_.at(settings_->physiology, bloodTime_s, displacement, pose)};
  if (before && before->patientFromProbe)
    motion.tissue_mmps =
        tissueVelocity_mmps(*before->patientFromProbe, pose, time_s - static_cast<double>(before->time_us) * 1e-6,
                            setup_->settings.depth_mm / 2);
  return motion;
}

std::span<const Bubble> MomentImaging::bubblesAt(double time_s) {
  if (!settings_->flush) return {};
  const auto bloodTime_s =
      settings_->pulsating ? std::optional(settings_->bloodTime_s + settings_->flush->time_s) : std::nullopt;
  return bubbles_.at(*settings_->flush, time_s - settings_->flush->time_s, settings_->physiology, bloodTime_s);
}

Result<std::shared_ptr<const LiveFrame>> MomentImaging::picture(const AttemptSample& sample,
                                                                const AttemptSample* before) {
  const Transform& pose = *sample.patientFromProbe;
  const double time_s = static_cast<double>(sample.time_us) * 1e-6;
  if (auto ok = press(pose, time_s); !ok) return tl::unexpected(ok.error());
  auto frame = std::make_shared<LiveFrame>();
  frame->patientFromProbe = pose, frame->time_s = time_s;
  frame->setup = setup_;
  frame->needle = needleOf(sample, *settings_);
  frame->rods = rods_, frame->flush = settings_->flush;
  frame->warnings =
      std::make_shared<const std::vector<std::string>>(tissue_ ? scene().warnings() : std::vector<std::string>{});
  describePress(*frame);
  if (!tissue_) {  // beyond the patient: black
    Display(setup_->probe, setup_->settings).process({}, frame->image);
    return frame;
  }
  const PlaneDisplacement* seen = &deformation().displacement;
  if (frame->needle && sample.tenting_mm > kMinTent_mm)
    seen = &tented_.addTenting(*seen, pose, {frame->needle->tip_mm, frame->needle->direction, sample.tenting_mm});
  ImagingFrame made;
  // The noise of this moment, independent of the image shown before.
  made.noiseSeed = static_cast<std::uint32_t>(sample.time_us);
  if (hasColor()) made.motion = motionOf(sample, before, *seen);
  imager_->render(scene(), pose, *seen, {frame->needle ? &*frame->needle : nullptr, settings_->rods, bubblesAt(time_s)},
                  made);
  frame->image = std::move(made.image), frame->color = std::move(made.color),
  frame->envelope = std::move(made.envelope);
  frame->stages = std::move(made.stages), frame->frame_ms = made.frame_ms;
  frame->engine = made.engine, frame->engineNote = made.engineNote;
  return frame;
}

}  // namespace insonate
