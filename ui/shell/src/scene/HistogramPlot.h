#pragma once

#include <insonate/views/HuHistogram.h>
#include <insonate/views/TransferFunction.h>
#include <insonate/views/WindowLevel.h>

#include <QWidget>
#include <optional>

namespace insonate::ui {

/// Plot of a histogram with the transfer function drawn over it. The user can drag the nodes of the function. The plot
/// does not change the function itself: edited() requests changes, and the plot shows the function that it is given.
class HistogramPlot : public QWidget {
  Q_OBJECT

 public:
  explicit HistogramPlot(QWidget* parent = nullptr);

  void setHistogram(const views::HuHistogram& histogram);
  void setFunction(const views::TransferFunction& function);
  void setWindowLevel(std::optional<views::WindowLevel> window);

  const views::HuHistogram& histogram() const { return histogram_; }
  const views::TransferFunction& function() const { return function_; }
  int selected() const { return selected_; }
  void select(int node);
  /// Adds a node halfway between the selected node and the more distant of its neighbors.
  void addBeside();
  void removeSelected();

  /// Converts between a node's values and positions on the plot.
  QPointF placeOf(double hu, double opacity) const;
  double huAt(double x) const;
  double opacityAt(double y) const;

  QSize sizeHint() const override { return {280, 170}; }
  QSize minimumSizeHint() const override { return {200, 130}; }

 Q_SIGNALS:
  /// Emitted when the user changes the function to `wanted`; `what` names the change. Changes with the same `gesture`,
  /// if it is not 0, are one step of undo.
  void edited(const insonate::views::TransferFunction& wanted, int gesture, const QString& what);
  void selectionChanged(int node);
  void movingChanged(bool moving);
  void colorRequested();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void focusInEvent(QFocusEvent* event) override;

 private:
  QRectF field() const;
  int nodeAt(QPointF place) const;
  void add(double hu, double opacity);
  void remove(int node);
  void moveSelected(double hu, double opacity, int gesture);
  void fitRange();
  void paintWindow(QPainter& painter, const QRectF& area) const;
  void paintAxes(QPainter& painter, const QRectF& area) const;
  void paintFunction(QPainter& painter, const QRectF& area) const;

  views::HuHistogram histogram_;
  views::TransferFunction function_;
  std::optional<views::WindowLevel> window_;
  double min_HU_ = -1024, max_HU_ = 1500;
  int selected_ = -1;
  bool dragging_ = false;
  int gesture_ = 0;  ///< number of the present drag or series of key presses
  /// Arrow key pressed last, 0 after another action; pressing the same arrow again continues the gesture.
  int lastArrow_ = 0;
  QPointF grip_;  ///< offset from the node's center to the mouse at the start of the drag
};

}  // namespace insonate::ui
