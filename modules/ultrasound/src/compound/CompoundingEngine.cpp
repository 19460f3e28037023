#include "compound/CompoundingEngine.h"

#include "scene/SceneData.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace insonate {

CompoundingEngine::CompoundingEngine(std::vector<std::unique_ptr<Engine>> engines, CompoundingSchedule angles)
    : engines_(std::move(engines)), inTurn_(angles == CompoundingSchedule::OneAnglePerFrame) {}

void CompoundingEngine::prepare(const Probe& probe, const ImagingSettings& settings) {
  const std::vector<double> angles_deg = steeringAngles_deg(probe, settings);
  const BeamGrid grid(probe, settings);
  const double base = std::tan(settings.steering_deg * std::numbers::pi / 180);
  linesPerSample_.clear();
  for (std::size_t a = 0; a < engines_.size(); ++a) {
    ImagingSettings steered = settings;
    steered.compoundingAngles = 1;
    steered.steering_deg = angles_deg[a];
    steered.conformingContact = false;  // drawn_ contains it
    engines_[a]->prepare(probe, steered);
    // All grids have the same depth and the same number of samples, so that sample k has the same depth in each.
    const double aside = std::tan(steered.steering_deg * std::numbers::pi / 180) - base;
    linesPerSample_.push_back(aside * settings.depth_mm / settings.samples / grid.pitch_mm());
  }
  angles_.assign(std::size_t(settings.samples) * settings.scanlines, 0);
  conforms_ = settings.conformingContact;
  double maxSteering_deg = 0;
  for (const double angle_deg : angles_deg) maxSteering_deg = std::max(maxSteering_deg, std::abs(angle_deg));
  if (conforms_) drawn_.prepare(probe, settings, maxSteering_deg);
  steered_.clear();
  isFirst_ = true;
  next_ = 0;
}

/// Adds the power of one angle along its scanlines.
void CompoundingEngine::add(const EnvelopeFrame& steered, double linesPerSample, EnvelopeFrame& power) {
  const int lines = steered.scanlines;
  for (int look = 0; look < steered.looks; ++look)
    for (int k = 0; k < steered.samples; ++k) {
      const double shift = -(k + 0.5) * linesPerSample;
      const int whole = static_cast<int>(std::floor(shift));
      const auto share = static_cast<float>(shift - whole);
      const float* from = steered.look(look) + std::size_t(k) * lines + whole;
      float* to = power.look(look) + std::size_t(k) * lines;
      float* angles = angles_.data() + std::size_t(k) * lines;
      const int first = std::max(0, -whole), end = std::min(lines, lines - whole - (share > 0 ? 1 : 0));
      for (int l = first; l < end; ++l) {
        const float right = share > 0 ? from[l + 1] : from[l];
        const float amplitude = from[l] + share * (right - from[l]);
        to[l] += amplitude * amplitude;
      }
      if (look == 0)
        for (int l = first; l < end; ++l) angles[l] += 1;
    }
}

/// The engines found no gap, and full contact where drawn_ found poor contact.
void CompoundingEngine::weaken(EnvelopeFrame& steered) const {
  for (int look = 0; look < steered.looks; ++look)
    for (int k = 0; k < steered.samples; ++k) {
      float* row = steered.look(look) + std::size_t(k) * steered.scanlines;
      for (int l = 0; l < steered.scanlines; ++l) row[l] *= drawn_.strength(l);
    }
}

void CompoundingEngine::render(const AcousticScene& scene, const Transform& patientFromProbe,
                               const PlaneDisplacement& displacement, const Instruments& instruments,
                               EnvelopeFrame& envelope) {
  const std::size_t count = engines_.size();
  const bool all = !inTurn_ || std::exchange(isFirst_, false);
  steered_.resize(count);
  const std::size_t first = all ? 0 : next_, end = all ? count : next_ + 1;
  next_ = all ? 0 : (next_ + 1) % count;
  const bool draws = conforms_ && scene.impl().field.backgroundChannel >= 0;
  if (draws) drawn_.find(scene.impl().field, patientFromProbe, displacement);
  const PlaneDisplacement& seen = draws ? drawn_.displacement() : displacement;
  const std::optional<Needle> moved =
      draws && instruments.needle ? std::optional(drawn_.moved(*instruments.needle, patientFromProbe)) : std::nullopt;
  const Instruments shown{moved ? &*moved : instruments.needle, instruments.rods, instruments.bubbles};
  for (std::size_t a = first; a < end; ++a) {
    engines_[a]->render(scene, patientFromProbe, seen, shown, steered_[a]);
    if (draws) weaken(steered_[a]);
    if (a == first)
      stages_ = engines_[a]->stages();
    else
      for (std::size_t s = 0; s < stages_.size(); ++s) stages_[s].ms += engines_[a]->stages()[s].ms;
  }
  std::fill(angles_.begin(), angles_.end(), 0.0F);
  envelope.resize(steered_[0].scanlines, steered_[0].samples, steered_[0].looks);
  std::fill(envelope.amplitude.begin(), envelope.amplitude.end(), 0.0F);
  for (std::size_t a = 0; a < count; ++a) add(steered_[a], linesPerSample_[a], envelope);
  for (int look = 0; look < envelope.looks; ++look) {
    float* power = envelope.look(look);
    for (std::size_t n = 0; n < angles_.size(); ++n) power[n] = std::sqrt(power[n] / std::max(angles_[n], 1.0F));
  }
}

}  // namespace insonate
