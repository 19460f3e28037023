#pragma once

#include <QObject>
#include <QPointF>

class QMouseEvent;

namespace insonate::prepare {

class CaseViews;
class ToolSession;

/// Scissors over 3D: a left drag, or clicks, draw an outline. The part inside the outline is cut along the viewing
/// direction. With Ctrl or Shift, a drag turns or shifts the view as usual.
class SceneTools : public QObject {
 public:
  /// `views` is the parent of this object.
  SceneTools(CaseViews& views, ToolSession& tools);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool pressed(const QMouseEvent& event);
  bool moved(const QMouseEvent& event);
  bool released(const QMouseEvent& event);
  void addCorner(QPointF at);
  void showLine();

  CaseViews& views_;
  ToolSession& tools_;
  QPointF last_;
  bool held_ = false;
};

}  // namespace insonate::prepare
