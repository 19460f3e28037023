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
  /// Writes a paragraph at the height that it needs.
  void paragraph(const QString& words, const QColor& colour);
  /// Writes a cell in the present line; cut if it is too wide.
  void cell(double left, double width, const QString& words, const QColor& colour, int align = Qt::AlignLeft);
  /// Writes lines from the present one on, as many as the words need; y() stays.
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
