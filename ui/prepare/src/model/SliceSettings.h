#pragma once

#include <insonate/views/LabelStyle.h>
#include <insonate/views/WindowLevel.h>

#include <QObject>

class QSettings;

namespace insonate::prepare {

/// The user's settings for slices: window and level, how labels are drawn over the CT, and whether places are marked.
class SliceSettings : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  const views::WindowLevel& windowLevel() const { return windowLevel_; }
  void setWindowLevel(views::WindowLevel value);
  double labelOpacity() const { return labelOpacity_; }
  void setLabelOpacity(double opacity);
  bool labelsShown() const { return labelsShown_; }
  void setLabelsShown(bool shown);
  const views::LabelStyle& labelStyle() const { return labelStyle_; }
  void setLabelStyle(const views::LabelStyle& style);
  /// Tells whether targets, landmarks and start poses are shown on slices and in 3D.
  bool placesShown() const { return placesShown_; }
  void setPlacesShown(bool shown);
  void save(QSettings& settings) const;
  void restore(const QSettings& settings);

 Q_SIGNALS:
  void changed();

 private:
  views::WindowLevel windowLevel_;
  double labelOpacity_ = 0.25;
  bool labelsShown_ = true, placesShown_ = true;
  views::LabelStyle labelStyle_;
};

}  // namespace insonate::prepare
