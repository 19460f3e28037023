#include "ReportParts.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFontMetricsF>
#include <QLocale>

namespace insonate::review {

using namespace paper;

namespace {

constexpr int kWrapped = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

}  // namespace

PaperColumn::PaperColumn(QPainter& on) : painter(on) {}

void PaperColumn::head(const QString& title, const QStringList& facts) {
  painter.setFont(paperFont(kTitle, true));
  cell(kMargin, kWidth - 2 * kMargin, title, ink.text);
  y_ += 90;
  painter.setFont(paperFont(kText));
  cell(kMargin, kWidth - 2 * kMargin, facts.join(QStringLiteral("   ·   ")), ink.quiet);
  y_ += 60;
  painter.setPen(QPen(ink.line, 3));
  painter.drawLine(QPointF(kMargin, y_), QPointF(kWidth - kMargin, y_));
  y_ += 30;
}

void PaperColumn::heading(const QString& words) {
  y_ += 20;
  painter.setFont(paperFont(kText, true));
  cell(kMargin, kWidth - 2 * kMargin, words, ink.text);
  y_ += kRow + 6;
  painter.setFont(paperFont(kSmall));
}

void PaperColumn::paragraph(const QString& words, const QColor& color) {
  painter.setPen(color);
  QRectF used;
  painter.drawText(QRectF(kMargin, y_, kWidth - 2 * kMargin, 400), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                   words, &used);
  y_ += used.height() + 8;
}

void PaperColumn::cell(double left, double width, const QString& words, const QColor& color, int align) {
  painter.setPen(color);
  const QFontMetricsF metrics(painter.font(), painter.device());
  const double height = std::max(kRow, metrics.height());
  painter.drawText(QRectF(left, y_, width, height), align | Qt::AlignVCenter | Qt::TextSingleLine,
                   metrics.elidedText(words, Qt::ElideRight, width - 8));
}

void PaperColumn::lines(double left, double width, const QString& words, const QColor& color) {
  painter.setPen(color);
  painter.drawText(QRectF(left, y_, width, heightOf(width, words)), kWrapped, words);
}

double PaperColumn::heightOf(double width, const QString& words) const {
  return std::max(kRow, painter.boundingRect(QRectF(0, 0, width, kHeight), kWrapped, words).height());
}

void PaperColumn::foot() {
  painter.setFont(paperFont(kSmall));
  y_ = kHeight - kMargin;
  cell(kMargin, kWidth - 2 * kMargin,
       QCoreApplication::translate("Review", "Insonate, %1. For training; points are no measure of competence.")
           .arg(QLocale(QLocale::English).toString(QDate::currentDate(), QStringLiteral("d MMM yyyy"))),
       ink.quiet);
}

}  // namespace insonate::review
