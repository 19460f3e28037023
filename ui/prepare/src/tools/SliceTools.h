#pragma once

#include "ToolSession.h"

#include <QObject>
#include <array>

class QMouseEvent;
class QWheelEvent;

namespace insonate::prepare {

class CaseViews;
class LabelPreview;

/// The tool on the slices: takes the mouse from them, and from the guide, if the tool uses it (not with Ctrl or Shift,
/// which stay the slice's own), and shows points, outline, brush and preview over all three. The status line describes
/// the voxel under the tool.
class SliceTools : public QObject {
 public:
  SliceTools(CaseViews& views, ToolSession& tools, PrepareModel& shared, QObject* parent);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  int sliceOf(const QObject* canvas) const;
  Vec3 placeOf(int slice, QPointF at) const;
  bool pressed(int slice, const QMouseEvent& event);
  bool moved(int slice, const QMouseEvent& event);
  bool released(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  bool key(int key, bool act);
  /// Sets the point under the tool; none if it is empty.
  void pointAt(std::optional<QPointF> at);
  void showMarks();
  void showPreview();

  CaseViews& views_;
  ToolSession& tools_;
  PrepareModel& shared_;
  const LabelPreview& preview_;
  std::optional<QPointF> pointer_;
  std::optional<Vec3> pointer_mm_;
  int under_ = 0;  ///< slice the pointer is over
  bool held_ = false;
};

}  // namespace insonate::prepare
