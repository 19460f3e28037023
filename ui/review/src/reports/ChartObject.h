#pragma once

#include "PaperSlices.h"

#include <QObject>
#include <QPainter>
#include <QPicture>
#include <QTextFormat>
#include <QTextObjectInterface>
#include <utility>
#include <vector>

namespace insonate::review {

/// Draws charts in the text of a document. Each chart is one character, whose format contains the index of the chart.
class ChartObject final : public QObject, public QTextObjectInterface {
  Q_OBJECT
  Q_INTERFACES(QTextObjectInterface)

 public:
  static constexpr int kType = QTextFormat::UserObject + 1;

  explicit ChartObject(QSizeF size) : size_(size) {}
  /// Adds a chart and returns the format of its character.
  QTextCharFormat add(QPicture chart) {
    QTextCharFormat format;
    format.setObjectType(kType);
    format.setProperty(kIndex, int(charts_.size()));
    charts_.push_back(std::move(chart));
    return format;
  }

  /// Draws from now on only charts within this part of the document. A chart sets its own clipping, which replaces that
  /// of the painter: the charts of the next page would run over the foot of this page.
  void setPart(const PaperSpan& part) { part_ = part; }

  QSizeF intrinsicSize(QTextDocument*, int, const QTextFormat&) override { return size_; }
  void drawObject(QPainter* painter, const QRectF& place, QTextDocument*, int, const QTextFormat& format) override {
    const double middle = place.center().y();
    if (middle < part_.top || middle > part_.bottom) return;
    painter->drawPicture(place.topLeft(), charts_[std::size_t(format.property(kIndex).toInt())]);
  }

 private:
  static constexpr int kIndex = QTextFormat::UserProperty + 1;

  const QSizeF size_;
  PaperSpan part_{};
  std::vector<QPicture> charts_;
};

}  // namespace insonate::review
