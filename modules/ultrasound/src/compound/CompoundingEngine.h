#pragma once

#include <insonate/ultrasound/Engine.h>

namespace insonate {

/// Spatial compounding: renders the frame for each of steeringAngles_deg(), each by its own engine of one kind, and
/// averages power where an image line meets the steered ones. Shadows become cones, walls are seen from more sides,
/// and speckle that the angles do not share averages out. Costs as many frames as there are angles, or with angles in
/// turn one, beside the average.
class CompoundingEngine final : public Engine {
 public:
  /// `first` and further engines of the same kind, as many as the settings' angles; see makeEngineFor().
  CompoundingEngine(std::vector<std::unique_ptr<Engine>> engines, CompoundedAngles angles);

  std::string_view name() const override { return engines_.front()->name(); }
  std::string_view note() const override { return engines_.front()->note(); }
  void prepare(const Probe& probe, const ImagingSettings& settings) override;
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const Needle* needle, EnvelopeFrame& envelope) override;
  const std::vector<Stage>& stages() const override { return stages_; }

 private:
  void add(const EnvelopeFrame& steered, double linesPerSample, EnvelopeFrame& power);

  std::vector<std::unique_ptr<Engine>> engines_;
  bool inTurn_;
  std::size_t next_ = 0;                ///< angle whose turn it is
  std::vector<EnvelopeFrame> steered_;  ///< the last frame of each angle; empty before the first
  std::vector<double> linesPerSample_;  ///< by angle: how far steered scanlines have moved, per sample of depth
  std::vector<float> angles_;           ///< how many angles have seen a sample of a look
  std::vector<Stage> stages_;
};

}  // namespace insonate
