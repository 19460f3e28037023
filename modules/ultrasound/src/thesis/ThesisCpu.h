#pragma once

#include "thesis/ThesisKernel.h"

#include <insonate/ultrasound/Engine.h>

#include <memory>
#include <vector>

namespace insonate::thesis {

/// Renders the style of the thesis (see ThesisModel.h) with SIMD across scanlines and threads across blocks of
/// scanlines. The constructor allocates all memory, except the scratch memory of additional threads in a larger arena.
class ThesisCpu {
 public:
  ThesisCpu(const Probe& probe, const ImagingSettings& settings);
  ThesisCpu(const ThesisCpu&) = delete;
  ThesisCpu& operator=(const ThesisCpu&) = delete;

  void render(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
              const PlaneDisplacement& displacement, EnvelopeFrame& envelope);
  const std::vector<Engine::Stage>& stages() const { return stages_; }

 private:
  /// Memory that one thread writes to.
  struct Workspace {
    KernelBuffers buffers;
    AlignedFloats ring;
    KernelTimes_ms times;
  };
  void setGeometry(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                   const PlaneDisplacement& displacement);
  void provideWorkspaces(int threads);
  Workspace& workspace();

  FramePlan plan_;
  ThesisPlan thesis_;
  KernelInput input_;
  EchoRows echo_;
  std::vector<float> lateralKernel_;
  std::vector<Contact> contacts_;                       ///< contact with the skin at each node column
  std::vector<std::unique_ptr<Workspace>> workspaces_;  ///< a workspace for each thread of the arena
  std::vector<Engine::Stage> stages_;
};

}  // namespace insonate::thesis
