#pragma once

#include "glsl/FrameBlock.h"
#include "glsl/SceneStore.h"

#include <insonate/gpu/Context.h>
#include <insonate/gpu/Memory.h>
#include <insonate/gpu/Program.h>

#include <array>
#include <memory>
#include <string>

namespace insonate::glsl {

/// Stages of a frame; one shader file each.
enum class Stage {
  Contact,
  Nodes,
  Cells,
  Tissue,
  Crossings,
  Levels,
  Aperture,
  Penumbra,
  Echoes,
  Gas,
  Reverberate,
  Points,
  NeedleShadow,
  NeedleEchoes,
  Axial,
  Lateral,
  Envelope,
  ThesisMap,
  ThesisEchoes,
  ThesisTail,
  kCount
};

/// One of the project's shader files with changed text.
struct EditedFile {
  std::string name, text;
};

/// Text of a shader file of the project (by name without extension), either as it is or with included files inserted;
/// empty if no file has this name.
std::string_view shaderFile(std::string_view name);
std::string shaderText(std::string_view name, const EditedFile& edited = {});
/// Shader text that defines the model's constants, generated from those in C++.
std::string constantsText();

/// Resources shared by the engines of one process: a context, the shaders, the texture tiles, and scenes.
class Device {
 public:
  /// Returns the shared device. It is made at the first call, which takes as long as the driver compiles, and made
  /// again after a loss. Fails with a sentence if no suitable OpenGL is available.
  static Result<std::shared_ptr<const Device>> shared();
  /// Returns this device with one file edited, for tests: shaders that include the file are compiled again.
  Result<std::shared_ptr<const Device>> with(const EditedFile& edited) const;

  gpu::Context& context() const { return *context_; }
  const gpu::Program& program(Stage stage) const { return *programs_[std::size_t(stage)]; }
  const gpu::Buffer& tiles() const { return *tiles_; }
  SceneStore& scenes() const { return *scenes_; }

 private:
  static Result<std::shared_ptr<const Device>> make();
  explicit Device(std::shared_ptr<gpu::Context> context) : context_(std::move(context)) {}
  static Result<std::shared_ptr<const gpu::Program>> compiled(const gpu::Current& current, std::string_view file,
                                                              const std::string& text);
  Result<void> fill(const gpu::Current& current);

  std::shared_ptr<gpu::Context> context_;
  std::vector<std::shared_ptr<const gpu::Program>> programs_;  ///< [stage]
  std::shared_ptr<const gpu::Buffer> tiles_;
  std::shared_ptr<SceneStore> scenes_ = std::make_shared<SceneStore>();
};

/// Offset of the first byte of each tile in the device's buffer, by Texture; the last is that of patchTile().
std::array<int, kTiles> tileOffsets();

}  // namespace insonate::glsl
