#include "PaperSlices.h"

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextLayout>
#include <QTextTable>
#include <algorithm>

namespace insonate::review {
namespace {

/// Part of the document that stays on one page: a row of a table or a paragraph.
struct PaperUnit {
  PaperSpan span;
  bool staysWithNext = false;
  const QTextTable* table = nullptr;  ///< null: not in a table
  int row = 0;
  std::vector<double> lineEnds;  ///< of its highest paragraph
};

std::vector<double> lineEndsOf(const QTextBlock& block, double top) {
  std::vector<double> ends;
  for (int i = 0; i < block.layout()->lineCount(); ++i) {
    const QTextLine line = block.layout()->lineAt(i);
    ends.push_back(top + line.y() + line.height());
  }
  return ends;
}

std::vector<PaperUnit> unitsOf(const QTextDocument& document) {
  std::vector<PaperUnit> units;
  for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
    const QRectF place = document.documentLayout()->blockBoundingRect(block);
    const QTextTable* table = QTextCursor(block).currentTable();
    const int row = table ? table->cellAt(block.position()).row() : 0;
    const double padding = table ? table->format().cellPadding() : 0;
    PaperUnit one{.span = {place.top() - padding, place.bottom() + padding},
                  .staysWithNext = block.blockFormat().headingLevel() > 0 || (table && row == 0),
                  .table = table,
                  .row = row,
                  .lineEnds = lineEndsOf(block, place.top())};
    if (table && row == 0 && !units.empty() && units.back().table != table) units.back().staysWithNext = true;
    if (!table || units.empty() || units.back().table != table || units.back().row != row) {
      units.push_back(std::move(one));
      continue;
    }
    PaperUnit& same = units.back();
    same.span = {std::min(same.span.top, one.span.top), std::max(same.span.bottom, one.span.bottom)};
    if (one.lineEnds.size() > same.lineEnds.size()) same.lineEnds = std::move(one.lineEnds);
  }
  return units;
}

std::optional<PaperSpan> headFor(const std::vector<PaperUnit>& units, const PaperUnit& first) {
  if (!first.table || first.row == 0) return std::nullopt;
  const auto head = std::ranges::find(units, first.table, &PaperUnit::table);
  return head->span;
}

double heightOf(const std::optional<PaperSpan>& head) {
  return head ? head->bottom - head->top : 0;
}

/// Divides a unit that is higher than the page which it begins.
void divide(std::vector<PaperSlice>& pages, const PaperUnit& unit, const std::optional<PaperSpan>& head,
            double height) {
  for (;;) {
    PaperSlice& page = pages.back();
    const double most = page.part.top + height - heightOf(page.head);
    double end = most;
    for (const double line : unit.lineEnds)
      if (line > page.part.top && line <= most) end = line;
    page.part.bottom = std::min(end, unit.span.bottom);
    if (unit.span.bottom <= most) return void(page.part.bottom = unit.span.bottom);
    pages.push_back({{end, end}, head});
  }
}

}  // namespace

std::vector<PaperSlice> slicesOf(const QTextDocument& document, double height) {
  const std::vector<PaperUnit> units = unitsOf(document);
  std::vector<PaperSlice> pages;
  std::size_t first = 0;
  for (std::size_t i = 0; i < units.size();) {
    if (pages.empty()) pages.push_back({units[i].span, std::nullopt});
    PaperSlice& page = pages.back();
    if (units[i].span.bottom - page.part.top + heightOf(page.head) <= height) {
      page.part.bottom = std::max(page.part.bottom, units[i++].span.bottom);
      continue;
    }
    std::size_t next = i;
    while (next > first && units[next - 1].staysWithNext) --next;
    if (next > first) {
      page.part.bottom = units[next - 1].span.bottom;
      pages.push_back({{units[next].span.top, units[next].span.top}, headFor(units, units[next])});
      first = i = next;
      continue;
    }
    // The first unit of the page is higher than the page.
    divide(pages, units[i], headFor(units, units[i]), height);
    first = ++i;
  }
  return pages;
}

}  // namespace insonate::review
