#include <insonate/ui/RowTable.h>

#include <QHeaderView>
#include <QTableWidget>

namespace insonate::ui {

void makeRowTable(QTableWidget& table, int row_px) {
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setShowGrid(false);
  table.setTabKeyNavigation(false);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(row_px);
  QHeaderView* header = table.horizontalHeader();
  header->setHighlightSections(false);
  header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  header->setSectionResizeMode(QHeaderView::Fixed);
}

}  // namespace insonate::ui
