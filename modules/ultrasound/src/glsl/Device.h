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

/// One a shader file.
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

/// One of the project's shader files with another text.
struct EditedFile {
  std::string name, text;
};

/// Text of a shader file of the project (without extension), as it is or with included files inserted; empty if no
/// file has the name.
std::string_view shaderFile(std::string_view name);
std::string shaderText(std::string_view name, const EditedFile& edited = {});
/// Constants of the model as the shaders know them, from those of C++.
std::string constantsText();

/// Resources shared by the engines of one process: a context, the shaders, the textures' tiles, scenes.
class Device {
 public:
  /// Made at the first call, which takes as long as the driver's compiler does; made again after a loss. Fails with a
  /// sentence without a suitable OpenGL.
  static Result<std::shared_ptr<const Device>> shared();
  /// The same with one file edited, for tests: files that include it are compiled again.
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

/// First byte of each tile in the device's buffer, by Texture, and last that of patchTile().
std::array<int, kTiles> tileOffsets();

}  // namespace insonate::glsl
