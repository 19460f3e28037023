#pragma once

#include "../result/NormBar.h"
#include "../result/PaperPage.h"

#include <QStringList>

namespace insonate::review {

/// Writes down a page, from above to below.
class PaperColumn {
 public:
  explicit PaperColumn(QPainter& painter);

  double y() const { return y_; }
  bool hasRoom(double height) const { return y_ + height < paper::kHeight - paper::kMargin - paper::kRow; }
  void skip(double height) { y_ += height; }
  /// Title and facts of the page, with a line below.
  void head(const QString& title, const QStringList& facts);
  void heading(const QString& words);
  /// As high as it needs to be.
  void paragraph(const QString& words, const QColor& colour);
  /// In the present line; cut where it is wider.
  void cell(double left, double width, const QString& words, const QColor& colour, int align = Qt::AlignLeft);
  /// From the present line on, in as many as the words need; y() stays.
  void lines(double left, double width, const QString& words, const QColor& colour);
  /// Height of the text that lines() writes, one row at least.
  double heightOf(double width, const QString& words) const;
  void foot();

  QPainter& painter;
  const ResultInk ink = paperInk();

 private:
  double y_ = paper::kMargin;
};

}  // namespace insonate::review
