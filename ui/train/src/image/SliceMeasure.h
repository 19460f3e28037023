#pragma once

#include "CaliperTool.h"

#include <insonate/views/MprView.h>

#include <QObject>
#include <QWidget>
#include <optional>
#include <vector>

class QMouseEvent;

namespace insonate::train {

/// Mouse input on a CT slice: if a caliper is selected, left clicks measure; all other input goes to the slice.
class SliceMeasure : public QObject {
 public:
  SliceMeasure(views::MprView& slice, QWidget& canvas, QObject* parent);

  void setKind(std::optional<views::CaliperKind> kind);
  const std::vector<views::SliceCaliper>& calipers() const { return done_; }
  void setCalipers(std::vector<views::SliceCaliper> calipers);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  views::ImagePoint pointAt(const QMouseEvent& event) const;
  void take();

  views::MprView& slice_;
  QWidget& canvas_;
  CaliperTool tool_;
  std::vector<views::SliceCaliper> done_;
};

}  // namespace insonate::train
