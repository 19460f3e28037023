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

/// Asks for sharp images on dense displays. Call it once, before QApplication.
void prepareGraphics();

/// Shows one view in the window: passes mouse, wheel and keys to it, tells it its size in device pixels, and renders
/// it on request, at most once for each pass of the event loop and 60 times a second; views that allow it are drawn by
/// a thread of their own. A thin frame marks the keyboard focus.
///
/// A double click or M lets the view fill its area; again or Escape restores the others. The area is the nearest
/// parent with markViewRoom(), else the widget's parent.
class ViewWidget : public QFrame {
  Q_OBJECT

 public:
  /// `name` is what a screen reader says. The view may be shared with who feeds it; it lives as long as the widget.
  ViewWidget(std::shared_ptr<views::View> view, const QString& name, QWidget* parent = nullptr);
  ~ViewWidget() override;

  views::View& view() { return *view_; }

  /// Discards an image that is no longer true, for example of another patient: black until the view is drawn again,
  /// which is soon.
  void forget();

  void setMaximised(bool maximised);
  bool isMaximised() const { return maximised_; }
  /// Switches maximizing by a double click, for views in which it has another meaning.
  void setMaximiseOnDoubleClick(bool on) { maximiseOnDoubleClick_ = on; }

  /// Renderings so far.
  int renderings() const { return renderings_; }
  /// Tells whether a thread still draws the latest state; other views are drawn as soon as the event loop reaches
  /// them.
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
  bool missed_ = false;  ///< it wanted to be rendered while nobody saw it
  int renderings_ = 0;
  double lastRender_ms_ = 0;
  QElapsedTimer sinceRender_;
};

/// Names the widget within which a view is maximised.
void markViewRoom(QWidget* room);

}  // namespace insonate::ui
