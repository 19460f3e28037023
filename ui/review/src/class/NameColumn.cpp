#include "NameColumn.h"

#include <insonate/ui/Theme.h>

#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>

namespace insonate::review {

NameColumn::NameColumn(QTableView& table) : QTableView(&table), table_(table) {
  setObjectName(table.objectName() + QStringLiteral("Names"));
  setAccessibleName(table.accessibleName());
  setToolTip(table.toolTip());
  setModel(table.model());
  setSelectionModel(table.selectionModel());
  setSelectionBehavior(table.selectionBehavior());
  setSelectionMode(table.selectionMode());
  setEditTriggers(NoEditTriggers);
  setShowGrid(false);
  ui::setRole(this, "frozen");
  setFocusProxy(&table);  // the keyboard stays in the table
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(table.verticalScrollMode());
  for (int column = 1; column < model()->columnCount(); ++column) setColumnHidden(column, true);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(table.verticalHeader()->defaultSectionSize());
  buildHeader();
  connect(verticalScrollBar(), &QScrollBar::valueChanged, table.verticalScrollBar(), &QScrollBar::setValue);
  connect(table.verticalScrollBar(), &QScrollBar::valueChanged, verticalScrollBar(), &QScrollBar::setValue);
  connect(this, &QTableView::activated, &table, &QTableView::activated);
  table.installEventFilter(this);
  table.viewport()->installEventFilter(this);
  place();
}

void NameColumn::buildHeader() {
  QHeaderView &own = *horizontalHeader(), &other = *table_.horizontalHeader();
  own.setHighlightSections(false);
  own.setDefaultAlignment(other.defaultAlignment());
  own.setFixedHeight(other.minimumHeight());
  own.setSectionsClickable(true);
  own.setSortIndicatorShown(true);
  own.setSortIndicator(other.sortIndicatorSection(), other.sortIndicatorOrder());
  connect(&own, &QHeaderView::sortIndicatorChanged, &other, &QHeaderView::setSortIndicator);
  connect(&other, &QHeaderView::sortIndicatorChanged, &own, &QHeaderView::setSortIndicator);
  connect(&own, &QHeaderView::sectionResized, this, [this](int column, int, int width_px) {
    if (column == 0) table_.setColumnWidth(0, width_px);
  });
  connect(&other, &QHeaderView::sectionResized, this, [this](int column, int, int) {
    if (column == 0) place();
  });
}

bool NameColumn::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Show) place();
  return QTableView::eventFilter(watched, event);
}

void NameColumn::place() {
  setColumnWidth(0, table_.columnWidth(0));
  setGeometry(table_.frameWidth(), table_.frameWidth(), table_.columnWidth(0),
              table_.horizontalHeader()->height() + table_.viewport()->height());
}

}  // namespace insonate::review
