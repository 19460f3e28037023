#pragma once

#include <QTextDocument>
#include <optional>
#include <vector>

namespace insonate::review {

/// A part of a document's layout, from top to bottom, in the document's pixels.
struct PaperSpan {
  double top = 0, bottom = 0;
};

/// Contents of one page: a part of the document, below the head of the table that continues on the page.
struct PaperSlice {
  PaperSpan part;
  std::optional<PaperSpan> head;  ///< row of titles; empty: the page does not continue a table
};

/// Divides a document that is laid out without pages into pages of this height. A row of a table, a line of text and a
/// chart stay whole, and a heading stays on the page of the text that follows it. Only a row or a paragraph that is
/// higher than a page is divided, between two lines.
std::vector<PaperSlice> slicesOf(const QTextDocument& document, double height);

}  // namespace insonate::review
