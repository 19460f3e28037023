#pragma once

#include "glsl/FrameBlock.h"
#include "glsl/SceneStore.h"

#include <insonate/gpu/Context.h>
#include <insonate/gpu/Memory.h>
#include <insonate/gpu/Program.h>

#include <array>
#include <initializer_list>
#include <memory>
#include <string>

namespace insonate::glsl {

/// Stages of computation of a frame on the graphics card; each has its own shader file.
enum class Stage {
  Contact,
  Nodes,
  Cells,
  Tissue,
  Crossings,
  Levels,
  Reaching,
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
  ColorRest,
  ColorWay,
  ColorEchoes,
  ColorAxial,
  ColorLateral,
  kCount
};

/// A shader file of the project with changed text, for tests.
struct EditedFile {
  std::string name, text;
};

/// shaderFile() and shaderText() return the text of a shader file of the project, by its name without extension.
/// shaderFile() returns the text unchanged, shaderText() with included files inserted. Empty if no file has this name.
std::string_view shaderFile(std::string_view name);
std::string shaderText(std::string_view name, const EditedFile& edited = {});
/// Returns shader text that defines the acoustic model's constants, generated from those in C++.
std::string constantsText();

/// A buffer at a slot of a stage.
struct Binding {
  unsigned slot;
  const gpu::Buffer* buffer;
};

/// Resources on the graphics card that all engines of one process share: a context, the shaders, the texture tiles, and
/// scenes.
class Device {
 public:
  /// Returns the shared device. The first call makes the device, which takes as long as the driver compiles the
  /// shaders; after a loss of the context the next call makes a new one. Fails with a sentence if no suitable OpenGL is
  /// available.
  static Result<std::shared_ptr<const Device>> shared();
  /// Returns this device with one file edited, for tests: shaders that include the file are compiled again.
  Result<std::shared_ptr<const Device>> with(const EditedFile& edited) const;

  gpu::Context& context() const { return *context_; }
  const gpu::Program& program(Stage stage) const { return *programs_[std::size_t(stage)]; }
  /// Queues a stage with these buffers.
  void run(const gpu::CurrentContext& current, Stage stage, std::initializer_list<Binding> bindings, int groupsX,
           int groupsY = 1, int groupsZ = 1) const;
  const gpu::Buffer& tiles() const { return *tiles_; }
  SceneStore& scenes() const { return *scenes_; }

 private:
  static Result<std::shared_ptr<const Device>> make();
  explicit Device(std::shared_ptr<gpu::Context> context) : context_(std::move(context)) {}
  static Result<std::shared_ptr<const gpu::Program>> compiled(const gpu::CurrentContext& current, std::string_view file,
                                                              const std::string& text);
  Result<void> fill(const gpu::CurrentContext& current);

  std::shared_ptr<gpu::Context> context_;
  std::vector<std::shared_ptr<const gpu::Program>> programs_;  ///< compiled shader of each stage
  std::shared_ptr<const gpu::Buffer> tiles_;
  std::shared_ptr<SceneStore> scenes_ = std::make_shared<SceneStore>();
};

/// Returns the offset of the first byte of each texture tile in the device's buffer, in the order of the enum Texture;
/// the last is that of patchTile().
std::array<int, kTiles> tileOffsets();

}  // namespace insonate::glsl
