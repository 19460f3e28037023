#include "ChartItems.h"

#include <insonate/core/AtomicFile.h>

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_renderer.h>

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QImage>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

namespace insonate::ui {
namespace {

/// Size of a saved plot, in pixels of a screen; a PNG file has twice as many.
constexpr int kWidth_px = 800, kHeight_px = 500, kPngScale = 2;
constexpr int kDots_perInch = 96, kPdf_dpi = 300;
constexpr double kPoint_px = 72.0 / kDots_perInch;

QByteArray png(const ChartContents& picture) {
  QImage image(QSize(kWidth_px, kHeight_px) * kPngScale, QImage::Format_RGB32);
  image.fill(paperInk().ground);
  QPainter painter(&image);
  paintChart(painter, QRectF(image.rect()), kPngScale, picture);
  painter.end();
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes;
}

QByteArray svg(const ChartContents& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  QSvgGenerator out;
  out.setOutputDevice(&buffer);
  out.setSize({kWidth_px, kHeight_px});
  out.setViewBox(QRect(0, 0, kWidth_px, kHeight_px));
  out.setResolution(kDots_perInch);
  out.setTitle(picture.title.toHtmlEscaped());  // Qt 5 writes the title without escaping
  QPainter painter(&out);
  paintChart(painter, QRectF(0, 0, kWidth_px, kHeight_px), 1, picture);
  painter.end();
  return bytes;
}

QByteArray pdf(const ChartContents& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  QPdfWriter out(&buffer);
  out.setPageSize(QPageSize(QSizeF(kWidth_px, kHeight_px) * kPoint_px, QPageSize::Point));
  out.setPageMargins({0, 0, 0, 0});
  out.setResolution(kPdf_dpi);
  out.setTitle(picture.title);
  QPainter painter(&out);
  paintChart(painter, QRectF(0, 0, out.width(), out.height()), double(kPdf_dpi) / kDots_perInch, picture);
  painter.end();
  return bytes;
}

}  // namespace

void paintChart(QPainter& painter, const QRectF& place, double unit, const ChartContents& picture) {
  QwtPlot plot;
  auto* canvas = new QwtPlotCanvas(&plot);
  canvas->setFrameStyle(QFrame::NoFrame);
  plot.setCanvas(canvas);
  fillPlot(plot, picture, paperInk());
  QwtPlotRenderer renderer;
  renderer.setDiscardFlags(QwtPlotRenderer::DiscardBackground | QwtPlotRenderer::DiscardCanvasBackground);
  // The renderer scales by the device's resolution, whatever the painter's units are.
  const double magnified = double(painter.device()->logicalDpiX()) / plot.logicalDpiX();
  painter.save();
  painter.translate(place.topLeft());
  painter.scale(unit / magnified, unit / magnified);
  renderer.render(&plot, &painter, QRectF(QPointF(), place.size() / unit * magnified));
  painter.restore();
}

Result<void> saveChart(const QString& file, const ChartContents& picture) {
  const QString ending = QFileInfo(file).suffix().toLower();
  QByteArray bytes;
  if (ending == QLatin1String("png"))
    bytes = png(picture);
  else if (ending == QLatin1String("svg"))
    bytes = svg(picture);
  else if (ending == QLatin1String("pdf"))
    bytes = pdf(picture);
  else
    return fail(QCoreApplication::translate(
                    "Chart", "A plot cannot be saved as '%1'. Choose a name that ends in .png, .svg or .pdf.")
                    .arg(QFileInfo(file).fileName())
                    .toStdString());
  return writeAtomically(file.toStdString(), std::string_view(bytes.constData(), std::size_t(bytes.size())));
}

}  // namespace insonate::ui
