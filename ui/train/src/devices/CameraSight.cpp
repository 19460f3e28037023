#include "CameraSight.h"

#include <insonate/ui/Ink.h>
#include <insonate/ui/Theme.h>

#include <QPainter>
#include <algorithm>
#include <utility>

namespace insonate::train {

CameraSight::CameraSight(QWidget* parent) : QWidget(parent) {
  setMinimumSize(320, 180);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void CameraSight::show(CameraView view) {
  view_ = std::move(view);
  update();
}

void CameraSight::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  const CameraFrame& frame = view_.frame;
  if (frame.pixels.empty()) {
    painter.setPen(Qt::lightGray);
    painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No image of a camera"));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setRenderHint(QPainter::Antialiasing);
  const double scale = std::min(double(width()) / frame.width, double(height()) / frame.height);
  painter.translate(width() / 2.0, height() / 2.0);
  painter.scale(-scale, scale);
  painter.translate(-frame.width / 2.0, -frame.height / 2.0);
  painter.drawImage(0, 0,
                    QImage(frame.pixels.data(), frame.width, frame.height, frame.width, QImage::Format_Grayscale8));
  // Colors of probe and needle.
  const QColor colors[] = {QColor(0x4d, 0xd0, 0xe1), QColor(0xff, 0xb7, 0x4d)};
  for (std::size_t hand = 0; hand < 2; ++hand) {
    painter.setPen(QPen(colors[hand], 2 / scale));
    for (const CameraView::Edge& edge : view_.bodies[hand].outline)
      painter.drawLine(QPointF(edge.from.x, edge.from.y), QPointF(edge.to.x, edge.to.y));
  }
}

}  // namespace insonate::train
