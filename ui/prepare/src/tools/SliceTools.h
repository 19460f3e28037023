#pragma once

#include "ToolSession.h"

#include <QObject>
#include <array>

class QMouseEvent;
class QWheelEvent;

namespace insonate::ui {
class Commands;
}

namespace insonate::prepare {

class CaseViews;
class LabelPreview;

/// Applies the selected tool to the slices. If the tool uses the mouse, the tool receives mouse input before the guide
/// and the slices do; input with Ctrl or Shift still goes to the slice. Points, outline, brush and preview are shown
/// over all three slices. The status line describes the voxel under the tool.
class SliceTools : public QObject {
 public:
  /// `views` is the parent of this object. `commands` contain the keys of tools, which take precedence over the keys of
  /// the guide on a slice.
  SliceTools(CaseViews& views, ToolSession& tools, PrepareModel& shared, const ui::Commands& commands);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  int sliceOf(const QObject* canvas) const;
  Vec3 placeOf(int slice, QPointF at) const;
  bool pressed(int slice, const QMouseEvent& event);
  bool moved(int slice, const QMouseEvent& event);
  bool released(const QMouseEvent& event);
  bool wheel(const QWheelEvent& event);
  /// Sets the position of the pointer; empty: the pointer is over no slice.
  void pointAt(std::optional<QPointF> at);
  void showMarks();
  void showPreview();

  CaseViews& views_;
  ToolSession& tools_;
  PrepareModel& shared_;
  const ui::Commands& commands_;
  const LabelPreview& preview_;
  std::optional<QPointF> pointer_;
  std::optional<Vec3> pointer_mm_;
  int under_ = 0;  ///< index of the slice under the pointer
  bool held_ = false;
};

}  // namespace insonate::prepare
