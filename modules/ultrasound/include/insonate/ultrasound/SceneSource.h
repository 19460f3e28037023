#pragma once

#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>
#include <insonate/ultrasound/Region.h>

#include <cstdint>
#include <functional>
#include <memory>

namespace insonate {

/// Data that all scenes of one patient share: properties of the whole case, which are computed once, and signed
/// distances, which can be computed in advance. The distances are cached, up to 384 MB for each resolution. A scene
/// that is made from a source equals a scene that is made without one. Any number of threads may use one source.
class SceneSource {
 public:
  /// `ct` and `labels` must outlive the source and must not change. Fails if their grids differ.
  static Result<std::shared_ptr<const SceneSource>> make(const CtVolume& ct, const LabelMap& labels);
  ~SceneSource();

  /// Returns a hash of the CT, which identifies the patient even after the labels were edited.
  std::uint32_t patient() const;
  /// Returns AcousticScene::trachea_mm() of the scenes of this source.
  double trachea_mm() const;

  /// Computes one part of the data that a scene of this region needs and that is not yet cached: the part nearest to
  /// the center of the region. Takes about a second of one processor. `stopped` is called repeatedly; if `stopped`
  /// returns true, the computation is cancelled. Returns false if nothing is missing, or if the cache is full.
  bool precompute(const Region& region, double detail_mm, const std::function<bool()>& stopped = {}) const;

  struct Impl;  ///< contents of the source, read by scenes
  Impl& impl() const { return *impl_; }

 private:
  explicit SceneSource(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
