#pragma once

#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>
#include <insonate/ultrasound/Region.h>

#include <cstdint>
#include <functional>
#include <memory>

namespace insonate {

/// Shared parts of all scenes of one patient: facts about the whole case, found once, and the distances that scenes
/// are likely to need, computed ahead and kept up to 384 MB for each resolution. A scene is then put together rather
/// than computed, with the same result. Any number of threads may use one.
class SceneSource {
 public:
  /// `ct` and `labels` must outlive the source and stay as they are. Fails where they lie on different grids.
  static Result<std::shared_ptr<const SceneSource>> make(const CtVolume& ct, const LabelMap& labels);
  ~SceneSource();

  /// Hash of the CT: identifies the patient, whatever edits the labels have.
  std::uint32_t patient() const;

  /// Computes one more part of a region, the one nearest to its center, for scenes to come. Takes about a second of one
  /// processor; `stopped` is asked now and then, and ends it. False where nothing is missing, or no room is left.
  bool makeAhead(const Region& region, double detail_mm, const std::function<bool()>& stopped = {}) const;

  struct Impl;  ///< for scenes
  Impl& impl() const { return *impl_; }

 private:
  explicit SceneSource(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
