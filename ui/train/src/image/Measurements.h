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

/// Measurements with calipers, on the image and on the slices of the CT.
class Measurements final : public QObject {
  Q_OBJECT

 public:
  Measurements(StatusLine& status, History& history, SharedViews& views, ImageInput& input, CineBar& cine,
               QObject* parent);

  /// Tells whether a caliper is chosen.
  bool isMeasuring() const;
  /// Chooses a caliper (views::CalliperKind), or none with -1. Choosing the chosen one deselects it.
  void choose(int kind);
  /// Removes all measurements, which can be undone.
  void clear();
  /// Removes those on the image, which belong to another image.
  void clearImage();
  /// Removes all of them for good: the case is another.
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
