#include "PaperPage.h"

#include <insonate/ui/Ink.h>

#include <QBuffer>
#include <QCoreApplication>
#include <QImage>
#include <QPageSize>
#include <QPdfWriter>
#include <QSaveFile>

namespace insonate::review {
namespace {

constexpr int kPdf_dpi = 300, kPng_dpi = 150;
constexpr double kTenths_perInch = 254;

}  // namespace

QFont paperFont(double height, bool bold) {
  QFont font(QStringLiteral("sans-serif"));
  font.setPixelSize(int(height));
  font.setBold(bold);
  return font;
}

void paintPage(QPainter& painter, const QRectF& place, const PaperPainter& paint) {
  painter.save();
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing | QPainter::SmoothPixmapTransform);
  painter.fillRect(place, ui::paperInk().ground);
  painter.translate(place.topLeft());
  painter.scale(place.width() / paper::kWidth, place.height() / paper::kHeight);
  paint(painter);
  painter.restore();
}

QString writePage(const QString& file, const QString& title, const PaperPainter& paint) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  if (file.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive)) {
    QPdfWriter pdf(&buffer);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins({0, 0, 0, 0});
    pdf.setResolution(kPdf_dpi);
    pdf.setTitle(title);
    QPainter painter(&pdf);
    paintPage(painter, QRectF(0, 0, pdf.width(), pdf.height()), paint);
  } else {
    QImage picture(QSizeF(paper::kWidth, paper::kHeight).toSize() * (kPng_dpi / kTenths_perInch), QImage::Format_RGB32);
    QPainter painter(&picture);
    paintPage(painter, picture.rect(), paint);
    painter.end();
    picture.save(&buffer, "PNG");
  }
  QSaveFile out(file);
  if (out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size() && out.commit()) return {};
  return QCoreApplication::translate("Review", "The page could not be written to '%1': %2. Choose another location.")
      .arg(file, out.errorString());
}

}  // namespace insonate::review
