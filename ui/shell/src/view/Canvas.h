#pragma once

#include <insonate/ui/ViewWidget.h>
#include <insonate/views/DrawingThread.h>
#include <insonate/views/View.h>

#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>

#include <QBasicTimer>
#include <QImage>
#include <QWidget>
#include <functional>
#include <memory>

namespace insonate::ui {

/// The widget that shows the image of a ViewWidget. The view is drawn off screen, and its pixels are painted like those
/// of any other widget. An OpenGL widget would make Qt compose the whole window by OpenGL for each change; without a
/// graphics card, that takes longer than drawing. Views that allow it are drawn on a background thread.
class ViewWidget::Canvas final : public QWidget {
 public:
  Canvas(views::View& view, QWidget* parent);
  ~Canvas() override;

  /// Passes the size to the view, which then requests a rendering.
  void fit();
  /// Draws and shows the view, or lets the background thread draw the view; onDrawn() is called afterwards in both
  /// cases. Has no effect while the thread is drawing: call the function again after onDrawn().
  void render();
  bool isDrawing() const { return drawn_.wish < wish_; }
  /// Shows black until the view is drawn again.
  void forget();

  std::function<void(bool focused)> onFocus;
  std::function<bool()> onDoubleClick;  ///< function that returns true if it has handled the double click
  std::function<void()> onStale;        ///< called when the image shown does not have the widget's size
  /// Called when an image has been drawn; `took_ms` is the time that drawing took.
  std::function<void(double took_ms)> onDrawn;

 protected:
  bool event(QEvent* event) override;
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
  void show(const views::Pixels& pixels);
  void takeDrawn();
  void askIfStale();

  views::View& view_;
  vtkSmartPointer<vtkRenderWindow> window_;  ///< null if a background thread draws
  bool isOpen_ = false;                      ///< true: the render window has drawn before
  views::PixelReader reader_;
  views::DrawingThread::Drawn drawn_;
  QImage picture_;  ///< the pixels drawn last, in device pixels; null before the first image
  QSize fitted_;    ///< size that was passed to the view, in device pixels
  double ratio_ = 1;
  std::unique_ptr<views::DrawingThread> thread_;
  /// wish_: number of the drawing that was requested last from the thread; forgotten_: number of the last drawing that
  /// must not be shown.
  std::uint64_t wish_ = 0, forgotten_ = 0;
  Qt::MouseButton held_ = Qt::NoButton;
  QBasicTimer rest_;
};

}  // namespace insonate::ui
