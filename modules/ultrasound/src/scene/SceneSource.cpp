#include "scene/SceneSourceData.h"

namespace insonate {

TissueTiles& SceneSource::Impl::tilesOf(double detail_mm) {
  const std::lock_guard lock(mutex_);
  auto& tiles = tiles_[detail_mm];
  if (!tiles) tiles = std::make_unique<TissueTiles>(ct, labels, facts, NodeLattice(labels.geometry, detail_mm));
  return *tiles;
}

SceneSource::SceneSource(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SceneSource::~SceneSource() = default;

Result<std::shared_ptr<const SceneSource>> SceneSource::make(const CtVolume& ct, const LabelMap& labels) {
  if (!sameGrid(ct.geometry, labels.geometry))
    return fail("The CT and the label map are on different grids. Resample one to the grid of the other.");
  return std::shared_ptr<const SceneSource>(new SceneSource(std::make_unique<Impl>(ct, labels)));
}

std::uint32_t SceneSource::patient() const {
  return impl_->facts.patient;
}

double SceneSource::trachea_mm() const {
  return impl_->facts.trachea_mm;
}

bool SceneSource::precompute(const Region& region, double detail_mm, const std::function<bool()>& stopped) const {
  TissueTiles& tiles = impl_->tilesOf(detail_mm);
  const NodeBox box = tiles.lattice().boxOf(region);
  return box.count() > 0 && tiles.precompute(box, stopped);
}

}  // namespace insonate
