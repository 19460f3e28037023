#pragma once

#include <insonate/ui/ViewWidget.h>
#include <insonate/views/View.h>

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <QBasicTimer>
#include <QImage>
#include <QWidget>
#include <functional>

namespace insonate::ui {

/// The picture of a ViewWidget. The view is drawn out of sight and its pixels are painted like those of any other
/// widget: with an OpenGL widget anywhere in a window, Qt puts the whole window together by OpenGL for each change of
/// any part of it, which takes longer than drawing where there is no graphics card.
class ViewWidget::Canvas final : public QWidget {
 public:
  Canvas(views::View& view, QWidget* parent);
  ~Canvas() override;

  vtkRenderWindow& renderWindow() { return *window_; }
  /// Draws the view and shows it.
  void render();
  /// Black until it is drawn again.
  void forget();

  std::function<void(bool focused)> onFocus;
  std::function<bool()> onDoubleClick;  ///< true when that was the click's meaning
  std::function<void()> onStale;        ///< what is shown is not of the widget's size

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void timerEvent(QTimerEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  views::DisplayPoint devicePoint(QPointF at) const;
  views::Pointer pointer(const QMouseEvent& event, Qt::MouseButton button) const;

  QSize deviceSize() const;
  void takePixels();

  views::View& view_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkUnsignedCharArray> pixels_;  ///< as OpenGL gives them
  QImage picture_;                       ///< in device pixels; null before the first
  Qt::MouseButton held_ = Qt::NoButton;
  QBasicTimer rest_;
};

}  // namespace insonate::ui
