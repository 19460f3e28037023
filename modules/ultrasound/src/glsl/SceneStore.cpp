#include "glsl/SceneStore.h"

#include "glsl/Tables.h"

#include <algorithm>

namespace insonate::glsl {

Result<std::shared_ptr<const gpu::Buffer>> SceneStore::of(const gpu::CurrentContext& current,
                                                          const AcousticScene::Impl& scene) {
  const auto found = std::ranges::find(kept_, scene.serial, &Kept::serial);
  if (found != kept_.end()) {
    std::rotate(kept_.begin(), found, found + 1);
    return kept_.front().volumes;
  }
  const std::vector<std::int32_t> words = sceneWords(scene);
  const auto upload = [&] { return gpu::Buffer::of(current, std::span(words)); };
  auto buffer = upload();
  if (!buffer && !kept_.empty()) {
    kept_.clear();
    buffer = upload();
  }
  if (!buffer) return tl::unexpected(buffer.error());
  ++uploads_;
  if (kept_.size() == kKept) kept_.pop_back();
  kept_.insert(kept_.begin(), {scene.serial, std::make_shared<const gpu::Buffer>(std::move(*buffer))});
  return kept_.front().volumes;
}

}  // namespace insonate::glsl
