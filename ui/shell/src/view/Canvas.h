#pragma once

#include <insonate/ui/ViewWidget.h>
#include <insonate/views/View.h>

#include <QVTKOpenGLNativeWidget.h>
#include <vtkRenderWindow.h>

#include <QBasicTimer>
#include <functional>

namespace insonate::ui {

/// The OpenGL part of a ViewWidget: VTK's widget without VTK's interactor, which would answer the mouse in its own way.
class ViewWidget::Canvas final : public QVTKOpenGLNativeWidget {
 public:
  Canvas(views::View& view, QWidget* parent);

  std::function<void(bool focused)> onFocus;
  std::function<bool()> onDoubleClick;  ///< true when that was the click's meaning

 protected:
  bool event(QEvent* event) override;
  void resizeGL(int width, int height) override;
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

  views::View& view_;
  Qt::MouseButton held_ = Qt::NoButton;
  QBasicTimer rest_;
};

}  // namespace insonate::ui
