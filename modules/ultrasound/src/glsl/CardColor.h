#pragma once

#include "color/ColorPlan.h"
#include "color/FlowSegments.h"
#include "glsl/Device.h"
#include "glsl/FrameBlock.h"

#include <insonate/ultrasound/ColorDoppler.h>

#include <memory>
#include <vector>

namespace insonate::glsl {

/// Computes color Doppler of one probe with one set of settings on the graphics card. It uses the scenes that CardFrame
/// has uploaded (SceneStore.h), and the memory of the card that make() has allocated. In each frame, two blocks of
/// parameters, the displacement and the center lines of the vessels are uploaded.
class CardColor {
 public:
  static Result<std::unique_ptr<CardColor>> make(std::shared_ptr<const Device> device, const Probe& probe,
                                                 const ImagingSettings& settings, const ColorSettings& color);

  /// Computes a frame. Fails if the card was reset or has no room for the scene; after that, no frame can be computed.
  Result<void> render(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                      const PlaneDisplacement& displacement, const ColorMotion& motion, ColorFrame& frame);

 private:
  CardColor(std::shared_ptr<const Device> device, const Probe& probe, const ImagingSettings& settings,
            const ColorSettings& color);
  std::vector<Float4> planTable() const;
  void addKnot(int line, double range_mm, std::vector<Float4>& table) const;
  Result<void> allocate(const gpu::CurrentContext& current);
  void setTissues(const AcousticScene::Impl& scene);
  Result<void> uploadFlow(const gpu::CurrentContext& current, const BloodFlow* blood, const Transform& patientFromProbe,
                          const TissueField& field);
  Result<void> upload(const gpu::CurrentContext& current, const AcousticScene::Impl& scene,
                      const Transform& patientFromProbe, const PlaneDisplacement& displacement,
                      const ColorMotion& motion);
  void bindShared(const gpu::CurrentContext& current) const;
  Result<void> readFrame(const gpu::CurrentContext& current, ColorFrame& frame);

  std::shared_ptr<const Device> device_;
  ColorPlan plan_;
  FrameBlock frameBlock_{};
  ColorBlock colorBlock_{};
  FlowSegments segments_;
  std::vector<Float4> flowWords_;
  std::shared_ptr<const gpu::Buffer> volumes_;  ///< volumes of the last scene, in the card's memory

  gpu::Buffer frame_, color_, planTable_, kernels_, contacts_, rests_, flow_, passed_, echoes_, axial_, averages_;
  gpu::PairTexture displacement_;
  gpu::ReadBack readBack_;
};

}  // namespace insonate::glsl
