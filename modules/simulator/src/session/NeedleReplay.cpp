#include "session/NeedleReplay.h"

#include "hands/GridMaker.h"

#include <insonate/cases/TissueLabels.h>
#include <insonate/haptics/SimulatedHand.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/ServoRecord.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate {
namespace {

/// Motion of the probe from which the tissue is solved again; it moves tissue by less than an event may be off.
constexpr double kMoved_mm = 0.5, kTurned = 0.02;
/// Time between two solutions of the tissue, and between two maps of it near the tip.
constexpr std::int64_t kSolve_us = 200'000, kMap_us = 33'000;
/// Distance of the tip outside the skin from which the deformation matters to the needle.
constexpr double kBeforeSkin_mm = 10;
constexpr int kSkinIndex = 0;

bool hasMoved(const Transform& from, const Transform& to) {
  double turned = 0;
  for (int axis = 0; axis < 3; ++axis)
    turned = std::max(turned, norm(from.linear.column[axis] - to.linear.column[axis]));
  return norm(from.offset - to.offset) > kMoved_mm || turned > kTurned;
}

}  // namespace

Result<NeedleReplay> NeedleReplay::make(const std::shared_ptr<const PatientCase>& patient, const Progress& progress) {
  CaseVolumes volumes(patient, withTissueLabels(patient->manifest.ownLabels, CaseVolumes(patient).labels));
  auto source = makeSceneSource(CaseView(*patient, *volumes.labels));
  if (!source) return tl::unexpected(source.error());
  auto veins = centerLines(*volumes.labels, kVein, progress);
  if (!veins) return tl::unexpected(veins.error());
  return NeedleReplay(std::move(volumes), std::move(*source), std::move(*veins));
}

NeedleReplay::NeedleReplay(CaseVolumes volumes, std::shared_ptr<const SceneSource> source,
                           std::vector<CenterLine> veins)
    : volumes_(std::move(volumes)),
      veins_(std::move(veins)),
      imaging_(std::make_unique<MomentImaging>(*volumes_.labels, std::move(source), *volumes_.vessels)) {}

void NeedleReplay::restart(VesselLocator vessels, std::uint8_t target) {
  vessels_ = std::move(vessels);
  target_ = target;
  servo_ = HapticServo();
  restFromPatient_ = {};
  solvedFor_.reset();
  solveAt_us_ = mapAt_us_ = 0;
  atTip_.reset();
  held_ = inBody_ = false;
}

Result<void> NeedleReplay::use(const AttemptSettings& settings) {
  const auto table = loadNeedleTable(settings.needle);
  if (!table) return tl::unexpected(table.error());
  ServoSetup setup;
  setup.needle = *table;
  for (ToolSetup& hand : setup.tools) hand.limits = deviceProfiles().front().limits;
  servo_.configure(setup);
  AttemptSettings still = settings;
  still.pulsating = false, still.setup.engine = "cpu", still.setup.color.reset();
  still.rods.clear(), still.flush.reset();
  solvedFor_.reset();
  return imaging_->use(still);
}

Result<std::vector<AttemptEvent>> NeedleReplay::move(const AttemptSample& sample) {
  if (!sample.patientFromNeedle && !std::exchange(held_, false)) return std::vector<AttemptEvent>{};
  if (sample.patientFromNeedle) {
    held_ = true;
    takeGrid(*sample.patientFromNeedle);
    if (auto ok = deform(sample); !ok) return tl::unexpected(ok.error());
    tip_mm_ = restFromPatient_ * sample.patientFromNeedle->offset;
    atTip_ = grid_ ? std::optional(grid_->at(tip_mm_)) : std::nullopt;
  } else {
    atTip_.reset();
  }
  const ServoOutput output = tick(sample);
  inBody_ = output.needle.inBody;
  const TickContext context{sample.time_us, {}, 0, false, restFromPatient_};
  std::vector<AttemptEvent> events;
  for (int i = 0; i < output.eventCount; ++i)
    events.push_back(makeEvent(output.events[static_cast<std::size_t>(i)], context, nullptr, veins_, vessels_));
  return events;
}

/// A grid of another recording at the same place serves, too.
void NeedleReplay::takeGrid(const Transform& patientFromNeedle) {
  const Vec3 ahead_mm = patientFromNeedle * Vec3{0, 0, GridMaker::kAhead_mm};
  if (inBody_ || (grid_ && norm(ahead_mm - gridCenter_mm_) <= GridMaker::kElsewhere_mm)) return;
  auto grid = TissueGrid::fromLabels(*volumes_.labels, ahead_mm, GridMaker::kReach_mm);
  grid_ = grid ? *grid : nullptr;  // outside the volume there is no tissue to puncture
  gridCenter_mm_ = ahead_mm;
}

Result<void> NeedleReplay::deform(const AttemptSample& sample) {
  const Vec3 tip_mm = sample.patientFromNeedle->offset;
  const bool isNear = grid_ && (inBody_ || grid_->at(tip_mm).distance_mm[kSkinIndex] < kBeforeSkin_mm);
  if (!isNear || !sample.patientFromProbe) {
    restFromPatient_ = {}, mapAt_us_ = 0;
    return {};
  }
  const bool isDue = !solvedFor_ || (sample.time_us >= solveAt_us_ && hasMoved(*solvedFor_, *sample.patientFromProbe));
  if (isDue) {
    solvedFor_ = sample.patientFromProbe;
    solveAt_us_ = sample.time_us + kSolve_us;
    if (auto ok = imaging_->press(*solvedFor_, 0); !ok) return ok;
  }
  if (isDue || sample.time_us >= mapAt_us_) {
    mapAt_us_ = sample.time_us + kMap_us;
    restFromPatient_ = imaging_->restNear(tip_mm);
  }
  return {};
}

ServoOutput NeedleReplay::tick(const AttemptSample& sample) {
  const std::int64_t now_ns = sample.time_us * 1000;
  servo_.setLocalModel({.time_ns = now_ns, .grid = grid_, .restFromPatient = restFromPatient_, .patches = {}});
  ServoInput input{.now_ns = now_ns, .tools = {}, .present = {false, sample.patientFromNeedle.has_value()}};
  if (sample.patientFromNeedle) input.tools[kNeedleTool].deviceFromStylus = *sample.patientFromNeedle;
  for (DeviceState& hand : input.tools) hand.time_ns = now_ns;
  return servo_.tick(input);
}

}  // namespace insonate
