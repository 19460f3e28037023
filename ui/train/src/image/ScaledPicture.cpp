#include "ScaledPicture.h"

#include "CaliperPaint.h"

#include <insonate/ui/Theme.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QFont>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <cstring>

namespace insonate::train {
namespace {

/// Height of letters in pixels, the unit of all other lengths.
int letter_px(const BModeImage& image) {
  constexpr int kLeast_px = 11, kLinesOfText = 45;
  return std::max(kLeast_px, image.height / kLinesOfText);
}

/// Numbers this far apart are read without being crowded.
double numberStep_mm(const BModeImage& image, int letter) {
  for (const double step_mm : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0})
    if (step_mm / image.pixel_mm >= 3 * letter) return step_mm;
  return 100;
}

/// Columns of the image at the edges of the field of view; the rest of the image is black.
struct FieldOfView {
  int left_px, right_px;
};

FieldOfView fieldOf(const LiveFrame& frame) {
  const BModeImage& image = frame.image;
  const BeamGrid grid(frame.setup->probe, frame.setup->settings);
  const auto columnOf = [&](double lateral_mm) {
    return std::clamp(int(std::lround((lateral_mm - image.left_mm) / image.pixel_mm)), 0, image.width);
  };
  return {columnOf(grid.minLateral_mm()), columnOf(grid.maxLateral_mm())};
}

/// Draws the depths left of `origin`, which is at the upper left corner of the field of view.
void drawScale(QPainter& painter, const BModeImage& image, QPoint origin, int letter) {
  const double numbers_mm = numberStep_mm(image, letter), ticks_mm = numbers_mm / (numbers_mm == 2 ? 2 : 5);
  const double last_mm = image.top_mm + (image.height - 0.5) * image.pixel_mm;
  const int right = origin.x() - letter / 2, count = int(std::floor(last_mm / ticks_mm + 1e-9));
  for (int k = 0; k <= count; ++k) {
    const double depth_mm = k * ticks_mm;
    const int y = origin.y() + int(std::lround((depth_mm - image.top_mm) / image.pixel_mm));
    const bool numbered = std::abs(std::remainder(depth_mm, numbers_mm)) < 1e-6;
    painter.setPen(ui::toQColor(numbered ? views::theme::kText : views::theme::kQuiet));
    painter.drawLine(right - (numbered ? letter * 2 / 3 : letter / 3), y, right, y);
    if (numbered)
      painter.drawText(QRect(0, y - letter, right - letter, 2 * letter), Qt::AlignRight | Qt::AlignVCenter,
                       QString::number(depth_mm));
  }
  painter.setPen(ui::toQColor(views::theme::kQuiet));
  painter.drawText(QRect(0, 0, right - letter, origin.y() - letter), Qt::AlignRight | Qt::AlignVCenter,
                   QStringLiteral("mm"));
}

}  // namespace

QPoint pictureOrigin(const BModeImage& image) {
  const int letter = letter_px(image);
  return {4 * letter, 3 * letter};
}

QSize scaledPictureSize(const BModeImage& image, std::size_t calipers) {
  const int letter = letter_px(image);
  const QPoint origin = pictureOrigin(image);
  return {origin.x() + image.width + letter, origin.y() + image.height + letter + measuresHeight(calipers, letter)};
}

QImage scaledPicture(const LiveFrame& frame, std::span<const views::Caliper> calipers) {
  const BModeImage& image = frame.image;
  const FieldOfView field = fieldOf(frame);
  const int letter = letter_px(image);
  const QPoint origin = pictureOrigin(image);
  QImage gray(image.width, image.height, QImage::Format_Grayscale8);
  for (int row = 0; row < image.height; ++row)
    std::memcpy(gray.scanLine(row), image.gray.data() + std::size_t(row) * image.width, std::size_t(image.width));
  const int bottom = origin.y() + image.height;
  QImage whole(scaledPictureSize(image, calipers.size()), QImage::Format_RGB32);
  whole.fill(Qt::black);
  const int perMetre = int(std::lround(1000 / image.pixel_mm));
  whole.setDotsPerMeterX(perMetre);
  whole.setDotsPerMeterY(perMetre);
  QPainter painter(&whole);
  painter.drawImage(origin, gray);
  if (const ColorImage& color = frame.color; !color.empty())
    painter.drawImage(origin + QPoint(color.column, color.row),
                      QImage(color.rgba.data(), color.width, color.height, color.width * 4, QImage::Format_RGBA8888));
  painter.setRenderHint(QPainter::TextAntialiasing);
  QFont font;
  font.setPixelSize(letter);
  painter.setFont(font);
  drawScale(painter, image, origin + QPoint(field.left_px, 0), letter);
  // The side of the marker, as over the live picture.
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ui::toQColor(views::theme::kAccent));
  painter.drawEllipse(QPointF(origin.x() + field.right_px - 0.5 * letter, origin.y() - letter), 0.4 * letter,
                      0.4 * letter);
  paintCalipers(painter, image, origin, calipers, letter);
  paintMeasures(painter, {origin.x(), bottom + letter / 2}, calipers, letter);
  return whole;
}

}  // namespace insonate::train
