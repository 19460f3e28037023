#include "FlowTable.h"
#include "OpenLumens.h"
#include "Womersley.h"

#include <insonate/cases/HeartDirection.h>
#include <insonate/cases/VesselName.h>
#include <insonate/flow/BloodFlowModel.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

namespace insonate {
namespace {

using std::numbers::pi;
using Profile = std::array<std::complex<double>, BloodTube::kProfile>;

/// Pressures to which the table's flows apply, mmHg.
constexpr double kMeanPressure_mmHg = 93.3, kPulsePressure_mmHg = 40;
/// Resistance of an open, unnarrowed part of a vein under the probe, relative to that of the whole path of its blood.
constexpr double kLocalResistance = 0.02;
/// Share of the flow of a vessel that takes other ways around a filled lumen. Chosen.
constexpr double kCollaterals = 0.15;

double meanRadius_mm(const NamedVessel& vessel) {
  double sum = 0;
  for (const NamedVessel::Point& point : vessel.course) sum += point.radius_mm;
  return sum / static_cast<double>(vessel.course.size());
}

/// Factor on the flow of a vessel that is narrowed to this area: 0 if it is closed. The resistance of a narrowed part
/// grows with the square of the area (Poiseuille).
double openness(double area) {
  const double open = (area - kClosedArea) / (1 - kClosedArea);
  if (open <= 0) return 0;
  return open >= 1 ? 1 : 1 / (1 + kLocalResistance * (1 / (open * open) - 1));
}

/// Limit of the augmented flow, relative to the flow of the open vein.
constexpr double kMaxAugmentation = 8;

/// Volume of the part of a vessel in the CT that is nearest to a point of its center line.
double restVolume_mm3(const NamedVessel& vessel, std::size_t point) {
  const std::size_t last = vessel.course.size() - 1;
  double length_mm = 0;
  if (point > 0) length_mm += norm(vessel.course[point].position_mm - vessel.course[point - 1].position_mm) / 2;
  if (point < last) length_mm += norm(vessel.course[point + 1].position_mm - vessel.course[point].position_mm) / 2;
  return pi * vessel.course[point].radius_mm * vessel.course[point].radius_mm * length_mm;
}

}  // namespace

struct BloodFlowModel::Impl {
  struct Vessel {
    bool flows = true;
    bool forward = true;  ///< blood flows from the first to the last point of the center line
    double passes = 1;    ///< share of the flow that filled lumens and collaterals let through
    double mean_mm3ps = 0, radius_mm = 0;
    const Waveform* wave = nullptr;
    std::vector<Profile> harmonicProfile;  ///< by harmonic, for the heart rate `rate_perMin`
    VesselFlow flow;
  };

  std::vector<NamedVessel> named;
  std::vector<Vessel> vessels;
  double rate_perMin = -1;

  void narrow(const LabelMap& labels);
  void add(const NamedVessel& vessel);
  void useRate(double perMin);
  void setProfile(Vessel& vessel, const Physiology& p, std::optional<double> time_s, BloodTube& tube);
};

void BloodFlowModel::Impl::add(const NamedVessel& source) {
  const FlowTable& table = adultFlowTable();
  const bool artery = source.label == kArtery;
  Vessel vessel;
  vessel.flows = artery || source.label == kVein;
  vessel.radius_mm = meanRadius_mm(source);
  vessel.forward = beginsAtHeart(source, named) == artery;
  const auto entry = std::ranges::find_if(table.vessels, [&](const FlowTable::Entry& e) {
    const VesselName name = parsedVesselName(e.vessel);
    return (!name.label || *name.label == source.label) && namesVessel(source.name, e.vessel);
  });
  if (entry != table.vessels.end()) {
    vessel.mean_mm3ps = entry->flow_mm3ps, vessel.wave = &table.waveforms[entry->waveform];
  } else {
    const double shear_perS = artery ? table.arteryShear_perS : table.veinShear_perS;
    vessel.mean_mm3ps = pi / 4 * shear_perS * vessel.radius_mm * vessel.radius_mm * vessel.radius_mm;
    vessel.wave = &table.waveforms[artery ? table.arteryWaveform : table.veinWaveform];
  }
  vessels.push_back(std::move(vessel));
}

void BloodFlowModel::Impl::narrow(const LabelMap& labels) {
  std::vector<bool> beginsAtHeart;
  for (std::size_t v = 0; v < vessels.size(); ++v)
    beginsAtHeart.push_back(vessels[v].forward == (named[v].label == kArtery));
  const std::vector<double> open = openLumens(named, beginsAtHeart, labels);
  for (std::size_t v = 0; v < vessels.size(); ++v)
    vessels[v].passes = kCollaterals + (1 - kCollaterals) * openness(open[v]);
}

void BloodFlowModel::Impl::useRate(double perMin) {
  if (perMin == rate_perMin) return;
  rate_perMin = perMin;
  for (std::size_t v = 0; v < vessels.size(); ++v) {
    vessels[v].harmonicProfile.resize(Waveform::kHarmonics);
    for (int n = 1; n <= Waveform::kHarmonics; ++n) {
      // Veins have thin walls whose area follows the pressure; their profile is taken as steady.
      const double omega_perS = named[v].label == kArtery ? 2 * pi * n * perMin / 60 : 0;
      vessels[v].harmonicProfile[n - 1] = womersleyProfile(womersleyNumber(vessels[v].radius_mm, omega_perS));
    }
  }
}

/// Profile and volume flow of the vessel while it is open.
void BloodFlowModel::Impl::setProfile(Vessel& vessel, const Physiology& p, std::optional<double> time_s,
                                      BloodTube& tube) {
  const bool artery = tube.label == kArtery;
  double steady = 1, swing = 1;
  if (artery) {
    steady = (p.diastolic_mmHg + (p.systolic_mmHg - p.diastolic_mmHg) / 3) / kMeanPressure_mmHg;
    swing = (p.systolic_mmHg - p.diastolic_mmHg) / kPulsePressure_mmHg;
  } else if (time_s) {
    // Venous pressure in the thorax falls during inspiration, and more blood returns to it.
    const double change_mmHg = p.breathingSwing_mmHg * respirationAt(p, *time_s);
    steady = std::max(0.0, 1 - vessel.wave->breathing * adultFlowTable().breathing_permmHg * change_mmHg);
    swing = steady;
  }
  const double mean = vessel.flows ? vessel.mean_mm3ps : 0;
  const double velocity_mmps = mean / (pi * vessel.radius_mm * vessel.radius_mm);
  for (int i = 0; i < BloodTube::kProfile; ++i) {
    const double x = double(i) / (BloodTube::kProfile - 1);
    tube.profile_mmps[i] = velocity_mmps * steady * 2 * (1 - x * x);
  }
  vessel.flow = {mean * steady, mean * (artery ? steady : 1)};
  if (!time_s || p.heartRate_perMin <= 0) return;
  const double phase = heartPhaseAt(p, *time_s);
  for (int n = 1; n <= Waveform::kHarmonics; ++n) {
    const std::complex<double> now = swing * vessel.wave->harmonic[n - 1] * std::polar(1.0, 2 * pi * n * phase);
    vessel.flow.now_mm3ps += mean * now.real();
    for (int i = 0; i < BloodTube::kProfile; ++i)
      tube.profile_mmps[i] += velocity_mmps * (now * vessel.harmonicProfile[n - 1][i]).real();
  }
}

BloodFlowModel::BloodFlowModel(std::span<const NamedVessel> vessels, const LabelMap* labels)
    : impl_(std::make_unique<Impl>()) {
  impl_->named.assign(vessels.begin(), vessels.end());
  // A course may contain a radius of 0, by which no velocity can be divided.
  constexpr double kThinnest_mm = 0.1;
  for (NamedVessel& vessel : impl_->named)
    for (NamedVessel::Point& point : vessel.course) point.radius_mm = std::max(point.radius_mm, kThinnest_mm);
  for (const NamedVessel& vessel : impl_->named) impl_->add(vessel);
  if (labels) impl_->narrow(*labels);
}
BloodFlowModel::~BloodFlowModel() = default;
BloodFlowModel::BloodFlowModel(BloodFlowModel&&) noexcept = default;
BloodFlowModel& BloodFlowModel::operator=(BloodFlowModel&&) noexcept = default;

void BloodFlowModel::at(const Physiology& physiology, std::optional<double> time_s, const VesselAreas& areas,
                        const VesselAreas& rates_perS, BloodFlow& flow) {
  impl_->useRate(physiology.heartRate_perMin);
  flow.tubes.resize(impl_->vessels.size());
  static const std::vector<double> kOpen;
  for (std::size_t v = 0; v < impl_->vessels.size(); ++v) {
    Impl::Vessel& vessel = impl_->vessels[v];
    const NamedVessel& named = impl_->named[v];
    BloodTube& tube = flow.tubes[v];
    tube.label = named.label;
    const std::vector<double>& area = areas.empty() ? kOpen : areas[v];
    impl_->setProfile(vessel, physiology, time_s, tube);
    const double open = area.empty() ? 1 : openness(*std::ranges::min_element(area));
    const bool expels = named.label == kVein && !rates_perS.empty() && vessel.flow.now_mm3ps > 0;
    const std::vector<double>& rates = expels ? rates_perS[v] : kOpen;
    // Share of the flow at each point, in the order of the flow: blood that a part expels flows through all later
    // parts.
    tube.course.resize(named.course.size());
    double expelled_mm3ps = 0;
    for (std::size_t step = 0; step < named.course.size(); ++step) {
      const std::size_t i = vessel.forward ? step : named.course.size() - 1 - step;
      if (expels) expelled_mm3ps -= rates[i] * restVolume_mm3(named, i);
      const double augmented = expels ? expelled_mm3ps / vessel.flow.now_mm3ps : 0;
      tube.course[i].scale = vessel.passes * std::clamp(open + augmented, 0.0, kMaxAugmentation);
    }
    vessel.flow.now_mm3ps *= open * vessel.passes, vessel.flow.mean_mm3ps *= open * vessel.passes;
    for (std::size_t i = 0; i < named.course.size(); ++i) {
      const NamedVessel::Point& point = named.course[i];
      const Vec3 before = named.course[i > 0 ? i - 1 : 0].position_mm;
      const Vec3 after = named.course[std::min(i + 1, named.course.size() - 1)].position_mm;
      const double length_mm = norm(after - before), narrower = vessel.radius_mm / point.radius_mm;
      const double areaNow = area.empty() ? 1 : std::max(area[i], kClosedArea);
      tube.course[i] = {point.position_mm,
                        length_mm > 0 ? (after - before) * ((vessel.forward ? 1 : -1) / length_mm) : Vec3{},
                        point.radius_mm, tube.course[i].scale * narrower * narrower / areaNow};
    }
  }
}

VesselFlow BloodFlowModel::volumeFlow(std::size_t vessel) const {
  return impl_->vessels[vessel].flow;
}

std::span<const NamedVessel> BloodFlowModel::vessels() const {
  return impl_->named;
}

}  // namespace insonate
