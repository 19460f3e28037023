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

/// The image of a ViewWidget. The view is drawn out of sight and its pixels are painted like those of any other
/// widget: with an OpenGL widget anywhere in a window, Qt puts the whole window together by OpenGL for each change of
/// any part of it, which takes longer than drawing where there is no graphics card. Views that allow it are drawn by a
/// thread of their own.
class ViewWidget::Canvas final : public QWidget {
 public:
  Canvas(views::View& view, QWidget* parent);
  ~Canvas() override;

  /// Passes the size to the view, which then requests a rendering.
  void fit();
  /// Draws the view and shows it, or has it drawn; onDrawn() follows either way. Nothing while it is being drawn: then
  /// it is to be asked for again after that.
  void render();
  bool isDrawing() const { return drawn_.wish < wish_; }
  /// Black until it is drawn again.
  void forget();

  std::function<void(bool focused)> onFocus;
  std::function<bool()> onDoubleClick;  ///< true when that was the click's meaning
  std::function<void()> onStale;        ///< what is shown is not of the widget's size
  /// An image is there, and took so long to draw.
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
  vtkSmartPointer<vtkRenderWindow> window_;  ///< none where a thread draws
  bool isOpen_ = false;                      ///< the window has drawn
  views::PixelReader reader_;
  views::DrawingThread::Drawn drawn_;
  QImage picture_;  ///< of the pixels drawn, in device pixels; null before the first
  QSize fitted_;    ///< what the view was told, in device pixels
  double ratio_ = 1;
  std::unique_ptr<views::DrawingThread> thread_;
  std::uint64_t wish_ = 0, forgotten_ = 0;  ///< the last of the thread's, and the last that nobody wants to see
  Qt::MouseButton held_ = Qt::NoButton;
  QBasicTimer rest_;
};

}  // namespace insonate::ui
