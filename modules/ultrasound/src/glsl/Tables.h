#pragma once

#include "glsl/FrameBlock.h"
#include "model/FramePlan.h"
#include "model/NeedleEchoes.h"
#include "thesis/ThesisModel.h"

#include <insonate/image/PlaneDisplacement.h>

#include <vector>

/// Conversion of the model's plan and of a scene to the shaders' data.
namespace insonate::glsl {

/// Tables that depend only on probe and settings; uploaded once.
struct PlanTables {
  PlanTables(const FramePlan& plan, bool thesis);

  std::vector<Float4> plan;     ///< scanlines and gates, see shaders/geometry.glsl
  std::vector<float> kernels;   ///< see shaders/kernels.glsl
  std::vector<Float4> repeats;  ///< see shaders/reverberate.comp
  FrameBlock block{};           ///< the fields that are the same in every frame
};

/// sceneWords() returns distances, CT and profiles of a scene as words, see shaders/field.glsl; setScene() sets where
/// among the words each of them begins.
std::vector<std::int32_t> sceneWords(const AcousticScene::Impl& scene);
void setScene(const AcousticScene::Impl& scene, FrameBlock& block);

/// Sets the fields that depend on pose and scene.
void setPose(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe,
             FrameBlock& block);
/// Sets a displacement of at least one point.
void setDisplacement(const PlaneDisplacement& displacement, FrameBlock& block);

/// Point targets in the form of shaders/points.comp.
std::vector<Float4> pointTable(const FramePlan& plan, const AcousticScene::Impl& scene,
                               const Transform& patientFromProbe, const PlaneDisplacement& displacement);

/// Writes the needle in the form of shaders/needle.glsl to `words`, whose memory is reused.
void setNeedle(const FramePlan& plan, const NeedleEchoes& needle, std::vector<float>& words);

ThesisBlock thesisBlock(const FramePlan& plan, const thesis::ThesisPlan& thesis, const AcousticScene::Impl& scene,
                        const Transform& patientFromProbe);

}  // namespace insonate::glsl
