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

/// Shows one view in the window: passes mouse, wheel and keys to the view, sets its size in device pixels, and renders
/// it on request, at most once per pass of the event loop and 60 times per second. Views that allow it are drawn on a
/// background thread. A thin frame marks the keyboard focus.
///
/// A double click or M maximizes the view within its area; another or Escape restores the others. The area is the
/// nearest parent with markViewRoom(), else the widget's parent.
class ViewWidget : public QFrame {
  Q_OBJECT

 public:
  /// `name` is read by screen readers. The view may be shared with the code that updates it; it lives as long as the
  /// widget.
  ViewWidget(std::shared_ptr<views::View> view, const QString& name, QWidget* parent = nullptr);
  ~ViewWidget() override;

  views::View& view() { return *view_; }

  /// Discards an image that is no longer valid, for example of another patient: the view is black until it is drawn
  /// again, soon after.
  void forget();

  void setMaximised(bool maximised);
  bool isMaximised() const { return maximised_; }
  /// Enables maximizing by a double click. Disable it for views in which a double click does something else.
  void setMaximiseOnDoubleClick(bool on) { maximiseOnDoubleClick_ = on; }

  /// Number of renderings so far.
  int renderings() const { return renderings_; }
  /// Tells whether a background thread is still drawing the latest state. Views without such a thread are drawn as soon
  /// as the event loop reaches them.
  bool isDrawing() const;

 Q_SIGNALS:
  void maximisedChanged(bool maximised);
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
  bool maximised_ = false, maximiseOnDoubleClick_ = true, wantedAgain_ = false;
  bool missed_ = false;  ///< a rendering was requested while the view was not visible
  int renderings_ = 0;
  double lastRender_ms_ = 0;
  QElapsedTimer sinceRender_;
};

/// Marks the widget within which a view is maximized.
void markViewRoom(QWidget* room);

}  // namespace insonate::ui
