#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <functional>

namespace insonate::review {

/// An A4 page in portrait format, laid out in tenths of a millimeter.
namespace paper {
inline constexpr double kWidth = 2100, kHeight = 2970, kMargin = 150;
inline constexpr double kRow = 47, kTitle = 64, kText = 36, kSmall = 30;
/// Paper units per screen pixel, for elements whose size is given for a screen.
inline constexpr double kScreen = 2.6;
}  // namespace paper

QFont paperFont(double height, bool bold = false);

/// Function that paints a page in tenths of a millimeter, on white.
using PaperPainter = std::function<void(QPainter&)>;

/// Paints the page into `place`, in the painter's units.
void paintPage(QPainter& painter, const QRectF& place, const PaperPainter& paint);

/// Writes a page, as PDF if the file's name ends in .pdf, else as a PNG of 150 dots per inch. The page is first written
/// to a temporary file in the same folder and then renamed. Returns an empty string or an error message.
QString writePage(const QString& file, const QString& title, const PaperPainter& paint);

}  // namespace insonate::review
