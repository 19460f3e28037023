#pragma once

#include "glsl/Device.h"
#include "glsl/Tables.h"

#include <insonate/gpu/Stopwatch.h>
#include <insonate/ultrasound/Engine.h>

#include <memory>
#include <optional>

namespace insonate::glsl {

/// Renders frames of one probe with one set of settings on the graphics card. Data that depends only on probe and
/// settings is uploaded once, and a scene is uploaded once for all engines (SceneStore.h). In each frame a block of
/// parameters and the displacement are uploaded.
class CardFrame {
 public:
  static Result<std::unique_ptr<CardFrame>> make(std::shared_ptr<const Device> device, const Probe& probe,
                                                 const ImagingSettings& settings);

  /// Renders a frame. Fails if the card was reset or has no room for the scene; after that, no frame can be rendered.
  Result<void> render(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                      const PlaneDisplacement& displacement, const Instruments& instruments, EnvelopeFrame& envelope);

  /// Returns the times of the last frame: "upload" of the processor, parts of the computation on the card, and
  /// "read-back", all that remains: commands, waiting, copying.
  const std::vector<Engine::Stage>& stages() const { return stages_; }

 private:
  CardFrame(std::shared_ptr<const Device> device, const Probe& probe, const ImagingSettings& settings);
  Result<void> allocate(const gpu::CurrentContext& current);
  Result<void> upload(const gpu::CurrentContext& current, const AcousticScene::Impl& scene,
                      const Transform& patientFromProbe, const PlaneDisplacement& displacement);
  void uploadNeedle(const gpu::CurrentContext& current);
  void bindShared(const gpu::CurrentContext& current) const;
  void traceCoherent(const gpu::CurrentContext& current);
  void traceThesis(const gpu::CurrentContext& current);
  Result<void> readEnvelope(const gpu::CurrentContext& current, EnvelopeFrame& envelope);
  /// Ends a part of the computation, in the order of stages_.
  void endPart(const gpu::CurrentContext& current) { watch_.mark(current, partsDone_++); }
  void noteTimes(const gpu::CurrentContext& current, double frame_ms);
  int groupsOfLines() const { return (plan_.lines + 31) / 32; }

  std::shared_ptr<const Device> device_;
  FramePlan plan_;
  NeedleEchoes needle_;
  std::vector<float> needleWords_;
  std::optional<thesis::ThesisPlan> thesis_;  ///< set only if the settings select the rendering style of the thesis
  PlanTables tables_;
  std::shared_ptr<const gpu::Buffer> volumes_;  ///< volumes of the last rendered scene, in the card's memory

  // Valid as long as the settings.
  gpu::Buffer planTable_, kernels_, repeats_, block_, thesisBlock_;
  gpu::Buffer contacts_, shifts_, nodes_, cells_, samples_, crossings_, gasGates_, reaching_, aperture_, points_, map_;
  gpu::Buffer echo_, blurred_, envelope_, needleBuffer_;
  gpu::PairTexture displacement_;
  gpu::ReadBack readBack_;
  std::size_t pointCapacity_ = 0;
  int pointEchoes_ = 0;  ///< number of point echoes in this frame
  gpu::Stopwatch watch_;
  int partsDone_ = 0;
  std::vector<Engine::Stage> stages_;
};

}  // namespace insonate::glsl
