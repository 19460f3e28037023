#pragma once

#include "../result/NormBar.h"
#include "../result/PaperPage.h"

#include <QStringList>

namespace insonate::review {

/// Writes text on a page from top to bottom.
class PaperColumn {
 public:
  explicit PaperColumn(QPainter& painter);

  double y() const { return y_; }
  bool hasRoom(double height) const { return y_ + height < paper::kHeight - paper::kMargin - paper::kRow; }
  void skip(double height) { y_ += height; }
  /// Writes title and facts of the page, with a line below.
  void head(const QString& title, const QStringList& facts);
  void heading(const QString& words);
  /// Writes a paragraph; the present position moves down by its height.
  void paragraph(const QString& words, const QColor& color);
  /// Writes a cell in the present line; text beyond the width is cut off.
  void cell(double left, double width, const QString& words, const QColor& color, int align = Qt::AlignLeft);
  /// Writes wrapped text from the present line on; y() does not change.
  void lines(double left, double width, const QString& words, const QColor& color);
  /// Height of the text that lines() writes, at least one line.
  double heightOf(double width, const QString& words) const;
  void foot();

  QPainter& painter;
  const ui::Ink ink = ui::paperInk();

 private:
  double y_ = paper::kMargin;
};

}  // namespace insonate::review
