#include "HandsDialog.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

namespace insonate::ui {
namespace {

constexpr QSize kDrawing{160, 96};

void drawMouse(QPainter& p) {
  p.drawRoundedRect(QRectF(20, 20, 70, 56), 4, 4);
  for (int row = 0; row < 3; ++row)
    for (int key = 0; key < 4; ++key) p.drawRect(QRectF(26 + key * 15, 27 + row * 15, 11, 10));
  p.drawRoundedRect(QRectF(106, 22, 34, 52), 17, 17);
  p.drawLine(QPointF(123, 22), QPointF(123, 44));
  p.drawLine(QPointF(106, 44), QPointF(140, 44));
}

/// A camera above two bodies with tags.
void drawCamera(QPainter& p) {
  p.drawRoundedRect(QRectF(56, 6, 48, 22), 8, 8);
  p.drawEllipse(QPointF(80, 17), 7, 7);
  for (const double x : {44.0, 116.0}) {
    QPolygonF outline;
    for (int i = 0; i < 6; ++i) {
      const double angle = (i + 0.5) * std::numbers::pi / 3;
      outline << QPointF(x + 22 * std::cos(angle), 60 + 22 * std::sin(angle));
    }
    p.drawPolygon(outline);
    p.fillRect(QRectF(x - 8, 52, 16, 16), p.pen().color());
  }
  p.drawLine(QPointF(44, 82), QPointF(44, 94));
  p.drawRect(QRectF(106, 82, 20, 10));
}

void drawController(QPainter& p) {
  QPainterPath body;
  body.moveTo(34, 26);
  body.lineTo(126, 26);
  body.cubicTo(150, 40, 152, 78, 138, 84);
  body.cubicTo(124, 84, 120, 64, 106, 62);
  body.lineTo(54, 62);
  body.cubicTo(40, 64, 36, 84, 22, 84);
  body.cubicTo(8, 78, 10, 40, 34, 26);
  p.drawPath(body);
  p.drawEllipse(QPointF(50, 44), 10, 10);
  p.drawEllipse(QPointF(110, 44), 10, 10);
  p.drawRoundedRect(QRectF(36, 16, 24, 8), 3, 3);
  p.drawRoundedRect(QRectF(100, 16, 24, 8), 3, 3);
}

/// A motorized arm with its stylus.
void drawArm(QPainter& p) {
  p.drawRoundedRect(QRectF(20, 70, 52, 18), 4, 4);
  p.drawLine(QPointF(46, 70), QPointF(46, 34));
  p.drawEllipse(QPointF(46, 34), 6, 6);
  p.drawLine(QPointF(51, 31), QPointF(106, 18));
  p.drawEllipse(QPointF(108, 18), 4, 4);
  p.drawLine(QPointF(110, 22), QPointF(132, 68));
  p.drawLine(QPointF(122, 34), QPointF(140, 60));
}

QIcon drawn(void (*draw)(QPainter&), const QColor& ink) {
  constexpr int kScale = 2;  // for screens with a high resolution
  QPixmap drawing(kDrawing * kScale);
  drawing.setDevicePixelRatio(kScale);
  drawing.fill(Qt::transparent);
  QPainter painter(&drawing);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(ink, 2));
  draw(painter);
  return drawing;
}

}  // namespace

HandsDialog::HandsDialog(QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("handsDialog"));
  setWindowTitle(tr("What are your hands?"));
  setAttribute(Qt::WA_DeleteOnClose);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  column->setSpacing(kLargeGap);
  auto* title = new QLabel(windowTitle());
  setRole(title, "title");
  column->addWidget(title);
  auto* about =
      paragraph("", "quiet",
                tr("Choose the devices with which you move probe and needle. View > Devices changes and mixes "
                   "them later."));
  column->addWidget(about);
  struct Answer {
    HandsChoice choice;
    const char* name;
    QString text, tip;
    void (*draw)(QPainter&);
  };
  const Answer answers[] = {
      {HandsChoice::Mouse, "handsMouse", tr("Mouse and keys"), tr("Needs nothing else"), drawMouse},
      {HandsChoice::Camera, "handsCamera", tr("Webcam and printed bodies"),
       tr("Opens the camera's window, which also prints the bodies"), drawCamera},
      {HandsChoice::Controller, "handsController", tr("Game controller"),
       tr("The left stick moves the probe, the right stick the needle"), drawController},
      {HandsChoice::Haptic, "handsHaptic", tr("Haptic device"), tr("Opens the devices' window"), drawArm}};
  auto* grid = new QGridLayout;
  grid->setSpacing(kGap);
  int at = 0;
  for (const Answer& answer : answers) {
    auto* button = named(new QToolButton, answer.name, answer.text, answer.tip);
    button->setText(answer.text);
    button->setIcon(drawn(answer.draw, palette().color(QPalette::WindowText)));
    button->setIconSize(kDrawing);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    button->setMinimumSize(kDrawing.width() + 60, kDrawing.height() + 48);
    connect(button, &QToolButton::clicked, this, [this, choice = answer.choice] {
      accept();
      Q_EMIT chosen(choice);
    });
    grid->addWidget(button, at / 2, at % 2);
    ++at;
  }
  column->addLayout(grid);
}

}  // namespace insonate::ui
