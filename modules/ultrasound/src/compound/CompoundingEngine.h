#pragma once

#include "compound/DrawnSkin.h"

#include <insonate/ultrasound/Engine.h>

namespace insonate {

/// Spatial compounding. Renders the frame for each of steeringAngles_deg(), each with its own engine of the same kind,
/// and averages the power of the steered scanlines at each point of the image. Shadows become cones, walls are seen
/// from more sides, and speckle that differs between the angles averages out. The cost is one frame per angle or, with
/// one angle per frame, one frame; plus the averaging.
class CompoundingEngine final : public Engine {
 public:
  /// `engines` must be of the same kind, one for each steering angle of the settings; see makeEngineFor().
  CompoundingEngine(std::vector<std::unique_ptr<Engine>> engines, CompoundingSchedule angles);

  std::string_view name() const override { return engines_.front()->name(); }
  std::string_view note() const override { return engines_.front()->note(); }
  void prepare(const Probe& probe, const ImagingSettings& settings) override;
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const Instruments& instruments, EnvelopeFrame& envelope) override;
  void forget() override { isFirst_ = true; }
  const std::vector<Stage>& stages() const override { return stages_; }

 private:
  void add(const EnvelopeFrame& steered, double linesPerSample, EnvelopeFrame& power);
  void weaken(EnvelopeFrame& steered) const;

  std::vector<std::unique_ptr<Engine>> engines_;
  bool inTurn_;
  bool conforms_ = false;
  DrawnSkin drawn_;
  std::size_t next_ = 0;                ///< index of the next angle to render
  std::vector<EnvelopeFrame> steered_;  ///< the last frame of each angle
  bool isFirst_ = true;                 ///< true: the next frame renders all angles
  /// For each angle: lateral shift of steered scanlines, in lines per sample of depth.
  std::vector<double> linesPerSample_;
  std::vector<float> angles_;  ///< number of steering angles whose scanlines cover a sample of one look
  std::vector<Stage> stages_;
};

}  // namespace insonate
