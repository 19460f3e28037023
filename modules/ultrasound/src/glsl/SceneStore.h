#pragma once

#include "scene/SceneData.h"

#include <insonate/gpu/Memory.h>

#include <memory>
#include <vector>

namespace insonate::glsl {

/// Keeps the volumes of the latest scenes in the graphics card's memory, shared by all engines of the process, with any
/// probes and settings, so that each scene is uploaded once. Only the thread for which the context is current may use
/// the store.
class SceneStore {
 public:
  /// Returns the volumes of a scene, and uploads them if they are missing. Fails if the card has no room for them, even
  /// after the volumes of other scenes were removed.
  Result<std::shared_ptr<const gpu::Buffer>> of(const gpu::CurrentContext& current, const AcousticScene::Impl& scene);

  int uploads() const { return uploads_; }

 private:
  /// Number of scenes kept: live imaging shows one scene while the next is made, and a second image may show another.
  static constexpr std::size_t kKept = 3;
  struct Kept {
    std::uint64_t serial = 0;
    std::shared_ptr<const gpu::Buffer> volumes;
  };
  std::vector<Kept> kept_;  ///< the kept scenes, latest first
  int uploads_ = 0;
};

}  // namespace insonate::glsl
