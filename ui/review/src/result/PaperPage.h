#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <functional>

namespace insonate::review {

/// An A4 page, upright, laid out in tenths of a millimeter.
namespace paper {
inline constexpr double kWidth = 2100, kHeight = 2970, kMargin = 150;
inline constexpr double kRow = 47, kTitle = 64, kText = 36, kSmall = 30;
/// Paper units per pixel, for elements with sizes of a screen.
inline constexpr double kScreen = 2.6;
}  // namespace paper

QFont paperFont(double height, bool bold = false);

/// Paints in tenths of a millimeter, on white.
using PaperPainter = std::function<void(QPainter&)>;

/// Paints the page into `place`, in the painter's unit.
void paintPage(QPainter& painter, const QRectF& place, const PaperPainter& paint);

/// Writes a page, as PDF where the file ends in .pdf, else as a PNG of 150 dots an inch; beside its place first, and
/// moved there. An empty string, or a sentence that says why not.
QString writePage(const QString& file, const QString& title, const PaperPainter& paint);

}  // namespace insonate::review
