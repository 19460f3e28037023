#include "hands/RestNear.h"
#include "live/LiveLoop.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <algorithm>
#include <utility>

namespace insonate {
namespace {

constexpr double kPulse_s = 1.0 / 30;

bool samePress(const ImagingSetup& a, const ImagingSetup& b) {
  const ProbeFace faceA = probeFaceOf(a.probe, a.mechanics), faceB = probeFaceOf(b.probe, b.mechanics);
  return a.mechanics == b.mechanics && faceA.width_mm == faceB.width_mm && faceA.radius_mm == faceB.radius_mm &&
         deformationWindow(a.probe, a.settings, a.mechanics) == deformationWindow(b.probe, b.settings, b.mechanics);
}

}  // namespace

void LiveImaging::Impl::setPhysiology(const Physiology& physiology) {
  physiologies_.post(physiology);
  wake();
}

void LiveImaging::Impl::setPulsating(bool pulsating) {
  if (pulsating_.exchange(pulsating) != pulsating) wake();
}

void LiveImaging::Impl::setKeepMesh(bool keep) {
  keepMesh_ = keep;
}

void LiveImaging::Impl::takePhysiology() {
  if (const auto physiology = physiologies_.takeLatest()) {
    physiology_ = *physiology;
    bloodChanged_ = true;
  }
  const bool pulsating = pulsating_;
  if (std::exchange(pulsatingSeen_, pulsating) != pulsating) bloodChanged_ = true;
}

void LiveImaging::Impl::takePneumothorax() {
  const auto lungs = pneumothoraces_.takeLatest();
  if (!lungs) return;
  for (std::size_t side = 0; side < lungs->size(); ++side) {
    std::optional<double>& since_s = pneumothorax_.since_s[side];
    since_s = (*lungs)[side] ? std::optional(since_s.value_or(now_s())) : std::nullopt;
  }
}

/// Tissue continues from its present state if the new setup has the same mechanics.
void LiveImaging::Impl::activate(Source source) {
  if (samePress(*active_.setup, *source.setup)) std::swap(source.tissue, active_.tissue);
  active_ = std::move(source);
  drawn_ = false;
}

void LiveImaging::Impl::press() {
  const double start_s = now_s();
  const auto time_s = pulsatingSeen_ ? std::optional(start_s) : std::nullopt;
  press_.pressure = bloodPressure(physiology_, active_.setup->mechanics.tissues, time_s);
  active_.tissue.hold(*scene_.scene, pose_, press_.pressure);
  active_.tissue.moveLung({time_s ? lungSlideAt_mm(physiology_, *time_s) : 0, pneumothorax_.detachedAt_mm(start_s)});
  const Deformation& answer = active_.tissue.deformation();
  press_.force_N = answer.force_N;
  press_.indentation_mm = active_.tissue.indentation_mm();
  press_.lumens = answer.lumens;
  press_.restFromPatient = needle_.needle ? restNear(answer.displacement, pose_, needle_.needle->tip_mm) : Transform{};
  restAlongMiddle(answer.displacement, pose_, active_.setup->settings.depth_mm, press_.middleAtRest_mm);
  thinOut(answer.displacement, press_.displacement);
  lungShown_ = breathes() && showsLung();
  press_.settled = answer.converged;
  press_.solve_ms = 1000 * (now_s() - start_s);
}

void LiveImaging::Impl::setGate(const std::optional<SpectralSettings>& gate) {
  const bool began = gate && !spectra_.isOn();
  spectra_.setGate(gate);
  // A probe at rest makes an image, from which the spectra begin.
  if (!began) return;
  gateBegun_ = true;
  wake();
}

/// A probe that rested before moves over the interval of two images, not since the last one.
Vec3 LiveImaging::Impl::tissueVelocity_mmps() const {
  if (!drawn_) return {};
  return insonate::tissueVelocity_mmps(drawnPose_, pose_, interval_s(), active_.setup->settings.depth_mm / 2);
}

double LiveImaging::Impl::interval_s() const {
  constexpr double kMaxInterval_s = 0.1;
  return drawn_ ? std::min(sinceDrawn_s_, kMaxInterval_s) : 0;
}

/// Velocities of blood and tissue for color Doppler, at the time at which the deformation was computed.
void LiveImaging::Impl::setMotion(const PlaneDisplacement& displacement) {
  const auto time_s = pulsatingSeen_ ? std::optional(begun_s_) : std::nullopt;
  scratch_.motion.blood = &blood_.next(physiology_, time_s, displacement, pose_, interval_s());
  scratch_.motion.tissue_mmps = tissueVelocity_mmps();
}

void LiveImaging::Impl::showGate(const PlaneDisplacement& displacement) {
  spectra_.show({scene_.scene, active_.setup, pose_, std::make_shared<const PlaneDisplacement>(displacement),
                 physiology_, pulsatingSeen_, tissueVelocity_mmps(), begun_s_, interval_s()});
}

bool LiveImaging::Impl::breathes() const {
  return pulsatingSeen_ && physiology_.breathing_perMin > 0 && physiology_.lungSlide_mm > 0;
}

/// Tells whether there is gas in the image, at points so near to each other that no lung lies between them.
bool LiveImaging::Impl::showsLung() {
  constexpr int kAcross = 9, kDown = 12;
  const ImagingSetup& setup = *active_.setup;
  const BeamGrid grid(setup.probe, setup.settings);
  lungPoints_.clear();
  for (int line = 0; line < kAcross; ++line)
    for (int step = 1; step <= kDown; ++step) {
      const double scanline = double(grid.scanlines() - 1) * line / (kAcross - 1);
      const Vec3 at = grid.origin(scanline) + grid.direction(scanline) * (setup.settings.depth_mm * step / kDown);
      lungPoints_.push_back({static_cast<float>(at.x), static_cast<float>(at.z)});
    }
  samplePlane(*scene_.scene, pose_, lungPoints_, lungTissue_);
  return std::ranges::find(lungTissue_.label, kAirway) != lungTissue_.label.end();
}

/// Bubbles as old as the image is at this moment. Without them nothing is computed.
std::span<const Bubble> LiveImaging::Impl::bubblesNow() {
  if (!flush_) return {};
  const double age_s = now_s() - flushed_s_;
  if (age_s >= SalineBubbles::kLife_s) flush_.reset();
  if (!flush_) return {};
  return bubbles_.at(*flush_, age_s, physiology_, pulsatingSeen_ ? std::optional(flushed_s_) : std::nullopt);
}

double LiveImaging::Impl::timeToNextPulse_s() const {
  const bool flows = active_.setup->color || spectra_.isOn() || lungShown_;
  if (!flush_ && (!pulsatingSeen_ || (press_.lumens.empty() && !flows))) return kNever_s;
  return std::max(0.0, begun_s_ + kPulse_s - now_s());
}

void LiveImaging::Impl::describePress(LiveDeformation& press) const {
  press = press_;
  if (!keepMesh_) return;
  const Deformation& answer = active_.tissue.deformation();
  press.mesh.columns = answer.meshColumns;
  press.mesh.rows = answer.meshRows;
  press.mesh.nodes = answer.mesh;
  press.mesh.pressure_kPa = answer.pressure_kPa;
}

}  // namespace insonate
