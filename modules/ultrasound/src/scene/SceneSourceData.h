#pragma once

#include "scene/CaseFacts.h"
#include "scene/TissueTiles.h"

#include <insonate/ultrasound/SceneSource.h>

#include <map>
#include <memory>
#include <mutex>

namespace insonate {

struct SceneSource::Impl {
  Impl(const CtVolume& itsCt, const LabelMap& itsLabels)
      : ct(itsCt),
        labels(itsLabels),
        facts(ct, labels),
        coarseTiles(ct, labels, facts, NodeLattice::coarse(labels.geometry)) {}

  TissueTiles& tilesOf(double detail_mm);

  const CtVolume& ct;
  const LabelMap& labels;
  const CaseFacts facts;
  TissueTiles coarseTiles;  ///< tiles of coarse scenes; none of them is cached

 private:
  std::mutex mutex_;
  /// Tiles for each value of detail_mm, the resolution of a scene.
  std::map<double, std::unique_ptr<TissueTiles>> tiles_;
};

}  // namespace insonate
