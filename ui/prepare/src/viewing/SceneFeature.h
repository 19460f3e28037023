#pragma once

#include "../feature/Feature.h"

namespace insonate::ui {
class HistogramEditor;
class ScenePanel;
}  // namespace insonate::ui

namespace insonate::prepare {

/// The feature for the display of 3D: the CT as a volume, clipping, stereo.
class SceneFeature final : public Feature {
 public:
  SceneFeature(PrepareModel& model, PrepareLayout& layout);

  /// Returns the editor of the transfer function, which computes the histogram of the open case's CT.
  ui::HistogramEditor& histogram();
  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 private:
  ui::ScenePanel* panel_;
};

}  // namespace insonate::prepare
