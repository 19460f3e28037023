#include "CropViews.h"

#include <insonate/image/VoxelBox.h>
#include <insonate/ui/StateColors.h>
#include <insonate/ui/Theme.h>
#include <insonate/views/Theme.h>
#include <insonate/views/WindowLevel.h>

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::ui {
namespace {

constexpr double kGap_px = 8, kGrip_px = 8, kLeast_mm = 10;

/// Axes of the patient in a view, as a radiologist looks at it: to the right and downward on the screen.
struct ViewAxes {
  int across, down, through;
  bool isUpward;  ///< true: the patient's axis `down` runs up on the screen
  const char *left, *right, *top, *bottom;
};
constexpr ViewAxes kAxes[]{
    {0, 1, 2, false, "R", "L", "A", "P"}, {0, 2, 1, true, "R", "L", "H", "F"}, {1, 2, 0, true, "A", "P", "H", "F"}};

double lengthOf(const PatientBox& box, int axis) {
  return box.high_mm[axis] - box.low_mm[axis];
}

/// Moves one border, but not beyond the limits or too near to the other border.
void moveBorder(PatientBox& box, const PatientBox& limits, int axis, bool isHigh, double to_mm) {
  const double least_mm = std::min(kLeast_mm, lengthOf(limits, axis));
  if (isHigh)
    box.high_mm[axis] = std::clamp(to_mm, box.low_mm[axis] + least_mm, limits.high_mm[axis]);
  else
    box.low_mm[axis] = std::clamp(to_mm, limits.low_mm[axis], box.high_mm[axis] - least_mm);
}

}  // namespace

CropViews::CropViews(std::shared_ptr<const PatientCase> patient, const PatientBox& limits, QWidget* parent)
    : QWidget(parent), patient_(std::move(patient)), limits_(limits), box_(limits) {
  setObjectName(QStringLiteral("cropViews"));
  setAccessibleName(tr("Part to keep, in three slices"));
  setToolTip(tr("Drag the borders or the corners of the box, or the whole box"));
  setMouseTracking(true);
  setMinimumSize(360, 160);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize CropViews::sizeHint() const {
  return {720, 260};
}

void CropViews::setBox(const PatientBox& box) {
  if (box == box_) return;
  box_ = box;
  drawSlices();
  update();
}

/// All views have one scale, so that lengths can be compared.
double CropViews::scale_pxpmm() const {
  double across_mm = 0, down_mm = 0;
  for (const ViewAxes& axes : kAxes) {
    across_mm += lengthOf(limits_, axes.across);
    down_mm = std::max(down_mm, lengthOf(limits_, axes.down));
  }
  return std::max(0.01, std::min((width() - (kViews - 1) * kGap_px) / across_mm, height() / down_mm));
}

QRectF CropViews::frameOf(int view) const {
  const double scale = scale_pxpmm();
  double all = (kViews - 1) * kGap_px;
  for (const ViewAxes& axes : kAxes) all += lengthOf(limits_, axes.across) * scale;
  double left = std::floor(std::max(0.0, width() - all) / 2);
  for (int n = 0; n < view; ++n) left += lengthOf(limits_, kAxes[n].across) * scale + kGap_px;
  return {left, 0, lengthOf(limits_, kAxes[view].across) * scale, lengthOf(limits_, kAxes[view].down) * scale};
}

QPointF CropViews::placeOf(int view, Vec3 patient_mm) const {
  const ViewAxes& axes = kAxes[view];
  const QRectF frame = frameOf(view);
  const double across = (patient_mm[axes.across] - limits_.low_mm[axes.across]) * scale_pxpmm();
  const double along = (patient_mm[axes.down] - limits_.low_mm[axes.down]) * scale_pxpmm();
  return {frame.left() + across, axes.isUpward ? frame.bottom() - along : frame.top() + along};
}

QRectF CropViews::boxIn(int view) const {
  return QRectF(placeOf(view, box_.low_mm), placeOf(view, box_.high_mm)).normalized();
}

QImage CropViews::drawnSlice(int view) const {
  const views::WindowLevel softTissue;
  const ViewAxes& axes = kAxes[view];
  const CtVolume& ct = patient_->ct;
  const QSize size = frameOf(view).size().toSize().expandedTo({1, 1});
  const Transform indexFromPatient = ct.geometry.indexFromPatient();
  const double mm_per_px = 1 / scale_pxpmm();
  Vec3 at_mm = (box_.low_mm + box_.high_mm) * 0.5;
  QImage slice(size, QImage::Format_Grayscale8);
  for (int y = 0; y < size.height(); ++y) {
    uchar* const line = slice.scanLine(y);
    const double along_mm = (y + 0.5) * mm_per_px;
    at_mm[axes.down] = axes.isUpward ? limits_.high_mm[axes.down] - along_mm : limits_.low_mm[axes.down] + along_mm;
    for (int x = 0; x < size.width(); ++x) {
      at_mm[axes.across] = limits_.low_mm[axes.across] + (x + 0.5) * mm_per_px;
      const auto [i, j, k] = nearestVoxel(indexFromPatient * at_mm);
      line[x] = ct.geometry.contains(i, j, k) ? softTissue.gray(ct.at(i, j, k)) : uchar{0};
    }
  }
  return slice;
}

void CropViews::drawSlices() {
  for (int view = 0; view < kViews; ++view) slices_[std::size_t(view)] = drawnSlice(view);
}

void CropViews::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  drawSlices();
}

void CropViews::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = toQColor(views::theme::kAccent), text = toQColor(views::theme::kText);
  for (int view = 0; view < kViews; ++view) {
    const QRectF frame = frameOf(view), box = boxIn(view);
    painter.drawImage(frame.topLeft(), slices_[std::size_t(view)]);
    QPainterPath outside;
    outside.addRect(frame);
    outside.addRect(box);
    painter.fillPath(outside, QColor(0, 0, 0, 150));
    painter.setPen(QPen(accent, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
    painter.setBrush(accent);
    for (const double x : {box.left(), box.center().x(), box.right()})
      for (const double y : {box.top(), box.center().y(), box.bottom()})
        if (QPointF(x, y) != box.center()) painter.drawRect(QRectF(x - 3, y - 3, 6, 6));
    painter.setPen(text);
    const ViewAxes& axes = kAxes[view];
    const QRectF inner = frame.adjusted(9, 6, -9, -6);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter, QLatin1String(axes.left));
    painter.drawText(inner, Qt::AlignRight | Qt::AlignVCenter, QLatin1String(axes.right));
    painter.drawText(inner, Qt::AlignHCenter | Qt::AlignTop, QLatin1String(axes.top));
    painter.drawText(inner, Qt::AlignHCenter | Qt::AlignBottom, QLatin1String(axes.bottom));
  }
}

std::optional<CropViews::Grip> CropViews::gripAt(QPointF at) const {
  const auto border = [](double here, double low, double high) {
    return std::abs(here - low) <= kGrip_px ? -1 : std::abs(here - high) <= kGrip_px ? 1 : 0;
  };
  for (int view = 0; view < kViews; ++view) {
    const QRectF box = boxIn(view);
    if (!box.adjusted(-kGrip_px, -kGrip_px, kGrip_px, kGrip_px).contains(at)) continue;
    const int down = border(at.y(), box.top(), box.bottom());
    return Grip{view, border(at.x(), box.left(), box.right()), kAxes[view].isUpward ? -down : down};
  }
  return std::nullopt;
}

void CropViews::moveTo(QPointF at) {
  const ViewAxes& axes = kAxes[grip_->view];
  const QPointF moved_mm = (at - from_) / scale_pxpmm();
  const std::array<std::pair<int, double>, 2> moves{std::pair{axes.across, moved_mm.x()},
                                                    {axes.down, axes.isUpward ? -moved_mm.y() : moved_mm.y()}};
  PatientBox box = before_;
  const bool isWhole = grip_->across == 0 && grip_->down == 0;
  for (const auto& [axis, by_mm] : moves) {
    const int which = axis == axes.across ? grip_->across : grip_->down;
    if (isWhole) {
      const double most_mm = limits_.high_mm[axis] - box.high_mm[axis],
                   least_mm = limits_.low_mm[axis] - box.low_mm[axis];
      const double fit_mm = std::clamp(by_mm, least_mm, most_mm);
      box.low_mm[axis] += fit_mm, box.high_mm[axis] += fit_mm;
    } else if (which != 0) {
      moveBorder(box, limits_, axis, which > 0, (which > 0 ? box.high_mm : box.low_mm)[axis] + by_mm);
    }
  }
  if (box == box_) return;
  setBox(box);
  Q_EMIT boxChanged();
}

void CropViews::showCursor(const std::optional<Grip>& grip) {
  if (!grip) return unsetCursor();
  const bool isUpward = kAxes[grip->view].isUpward;
  const int slope = grip->across * (isUpward ? -grip->down : grip->down);
  setCursor(grip->across == 0 && grip->down == 0 ? Qt::SizeAllCursor
            : grip->down == 0                    ? Qt::SizeHorCursor
            : grip->across == 0                  ? Qt::SizeVerCursor
            : slope > 0                          ? Qt::SizeFDiagCursor
                                                 : Qt::SizeBDiagCursor);
}

void CropViews::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  grip_ = gripAt(event->localPos());
  from_ = event->localPos();
  before_ = box_;
}

void CropViews::mouseMoveEvent(QMouseEvent* event) {
  if (grip_)
    moveTo(event->localPos());
  else
    showCursor(gripAt(event->localPos()));
}

void CropViews::mouseReleaseEvent(QMouseEvent*) {
  grip_.reset();
}

}  // namespace insonate::ui
