#pragma once

#include "glsl/FrameBlock.h"
#include "model/FramePlan.h"
#include "model/NeedleEchoes.h"
#include "thesis/ThesisModel.h"

#include <insonate/gpu/Memory.h>
#include <insonate/image/PlaneDisplacement.h>

#include <vector>

/// Conversion of the model's plan and of a scene to the shaders' data.
namespace insonate::glsl {

/// Returns an affine map row by row.
Rows rowsOf(const Transform& t);

/// Tables that depend only on probe and settings; uploaded once.
struct PlanTables {
  PlanTables(const FramePlan& plan, bool thesis);

  std::vector<Float4> plan;     ///< tables of scanlines and gates, see shaders/geometry.glsl
  std::vector<float> kernels;   ///< kernels of the point-spread function, see shaders/kernels.glsl
  std::vector<Float4> repeats;  ///< repeated echoes behind gas, see shaders/reverberate.comp
  FrameBlock block{};           ///< parameters of a frame; only the fields that are the same in every frame are set
};

/// sceneWords() returns distances, CT deviations and boundary profiles of a scene as 32-bit words, see
/// shaders/field.glsl; setScene() stores in `block` where each of the three begins among the words.
std::vector<std::int32_t> sceneWords(const AcousticScene::Impl& scene);
void setScene(const AcousticScene::Impl& scene, FrameBlock& block);

/// Sets the fields of `block` that depend on the probe's pose and the scene.
void setPose(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe,
             FrameBlock& block);
/// Uploads the displacement to `texture`, and sets the fields of `block` that describe it.
Result<void> uploadDisplacement(const gpu::CurrentContext& current, const PlaneDisplacement& displacement,
                                FrameBlock& block, gpu::PairTexture& texture);

/// Returns the echoes of point targets in the layout of shaders/points.comp.
std::vector<Float4> pointTable(const FramePlan& plan, const AcousticScene::Impl& scene,
                               const Transform& patientFromProbe, const PlaneDisplacement& displacement);

/// Writes the needle's echoes and shadow in the layout of shaders/needle.glsl to `words`, whose memory is reused.
void setNeedle(const FramePlan& plan, const NeedleEchoes& needle, std::vector<float>& words);

ThesisBlock thesisBlock(const FramePlan& plan, const thesis::ThesisPlan& thesis, const AcousticScene::Impl& scene,
                        const Transform& patientFromProbe);

}  // namespace insonate::glsl
