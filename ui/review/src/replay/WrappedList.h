#pragma once

#include <QIcon>
#include <QListWidget>
#include <functional>

class QPainter;

namespace insonate::review {

/// A list whose rows are as high as their wrapped texts. Each row has a mark as on the timeline.
class WrappedList : public QListWidget {
 public:
  explicit WrappedList(QWidget* parent = nullptr);

  /// Makes the icon of a mark that `paint` paints around a point. The mark keeps its color in a selected row.
  static QIcon markIcon(double pixelRatio, const std::function<void(QPainter&, QPointF)>& paint);

 protected:
  /// Sets the rows' heights after their texts were set.
  void fitRows();
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace insonate::review
