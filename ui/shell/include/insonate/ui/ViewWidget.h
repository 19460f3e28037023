#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <QPointer>
#include <memory>
#include <vector>

class QTimer;

namespace insonate::views {
class View;
}

namespace insonate::ui {

/// Enables full resolution on high-density displays. Call it once, before QApplication.
void prepareGraphics();

/// A widget that shows one view. It passes mouse, wheel and keys to the view, sets the view's size in device pixels,
/// and renders the view on request, at most once per pass of the event loop and 60 times per second. Views that allow
/// it are drawn on a background thread. A thin frame marks the keyboard focus.
///
/// A double click or M maximizes the view within its area. Another double click, M or Escape restores the other views.
/// The area is the nearest parent widget for which setMaximizeArea() was called, else the parent of this widget.
class ViewWidget : public QFrame {
  Q_OBJECT

 public:
  /// `name`: name for screen readers. The widget and the code that updates the view share ownership of the view.
  ViewWidget(std::shared_ptr<views::View> view, const QString& name, QWidget* parent = nullptr);
  ~ViewWidget() override;

  views::View& view() { return *view_; }

  /// Discards the displayed image if it is no longer valid, for example after a change of the patient. The widget is
  /// black until the view is drawn again. The function also requests this drawing.
  void forget();

  void setMaximized(bool maximized);
  bool isMaximized() const { return maximized_; }
  /// Enables maximizing by a double click. Disable it for views in which a double click does something else.
  void setMaximizeOnDoubleClick(bool on) { maximizeOnDoubleClick_ = on; }

  /// Returns the number of renderings so far.
  int renderings() const { return renderings_; }
  /// Tells whether a background thread is still drawing the latest state. Always false for views that the window's
  /// thread draws.
  bool isDrawing() const;

 Q_SIGNALS:
  void maximizedChanged(bool maximized);
  void rendered();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  class Canvas;
  void want();
  void renderNow();
  void drawn(double took_ms);

  std::shared_ptr<views::View> view_;
  Canvas* canvas_;
  QTimer* timer_;
  std::vector<QPointer<QWidget>> hidden_;
  bool maximized_ = false, maximizeOnDoubleClick_ = true, wantedAgain_ = false;
  bool missed_ = false;  ///< true: a rendering was requested while the view was not visible
  int renderings_ = 0;
  double lastRender_ms_ = 0;
  QElapsedTimer sinceRender_;
};

/// Marks a widget as the area within which its views are maximized.
void setMaximizeArea(QWidget* room);

}  // namespace insonate::ui
