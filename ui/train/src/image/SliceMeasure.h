#pragma once

#include "CalliperTool.h"

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

  void setKind(std::optional<views::CalliperKind> kind);
  const std::vector<views::SliceCalliper>& callipers() const { return done_; }
  void setCallipers(std::vector<views::SliceCalliper> callipers);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  views::PicturePoint pointAt(const QMouseEvent& event) const;
  void take();

  views::MprView& slice_;
  QWidget& canvas_;
  CalliperTool tool_;
  std::vector<views::SliceCalliper> done_;
};

}  // namespace insonate::train
