#pragma once

#include "../layout/SharedViews.h"

#include <QObject>
#include <optional>
#include <vector>

namespace insonate::train {

class CineBar;
class History;
class ImageInput;
class SliceMeasure;
class StatusLine;

/// Measurements with calipers, on the image and on CT slices.
class Measurements final : public QObject {
  Q_OBJECT

 public:
  Measurements(StatusLine& status, History& history, SharedViews& views, ImageInput& input, CineBar& cine,
               QObject* parent);

  /// Tells whether a caliper is selected.
  bool isMeasuring() const;
  /// Selects a caliper (views::CaliperKind); -1: no caliper. If the caliper is already selected, deselects it.
  void choose(int kind);
  /// Removes all measurements; the user can undo this.
  void clear();
  /// Removes the measurements on the image, because another image is shown.
  void clearImage();
  /// Removes all measurements without undo, because another case is shown.
  void forget();

 private:
  void addSlice(const SharedViews::Slice& slice);
  void show();

  StatusLine& status_;
  History& history_;
  SharedViews& views_;
  ImageInput& input_;
  CineBar& cine_;
  std::vector<SliceMeasure*> slices_;
};

}  // namespace insonate::train
