#include "MetricTable.h"

#include "NormBar.h"

#include <insonate/teaching/MetricExplanation.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/PlainToolTip.h>

#include <QHeaderView>
#include <QStringList>
#include <QStyledItemDelegate>
#include <algorithm>

namespace insonate::review {
namespace {

constexpr int kRow_px = 26, kNumber_px = 84;

int alignmentOf(int column) {
  const bool left = column == MetricTableView::kName || column == MetricTableView::kExpert;
  return int((left ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
}

}  // namespace

class MetricTableView::Bars final : public QStyledItemDelegate {
 public:
  explicit Bars(MetricTableView& table) : QStyledItemDelegate(&table), table_(table) {}
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    paintNormBar(*painter, QRectF(option.rect).adjusted(8, 0, -8, 0), table_.scores_[std::size_t(index.row())],
                 ui::screenInk());
  }

 private:
  MetricTableView& table_;
};

QString normOf(Metric metric, double value) {
  return QString::fromStdString(publishedValue(value, definitionOf(metric).unit));
}

QString explanationOf(const MetricScore& score) {
  QStringList parts;
  for (const MetricExplanation& part :
       insonate::explanationOf(definitionOf(score.metric), score.norm ? score.norm->source : std::string()))
    parts << QString::fromStdString(part.heading + ": " + part.text);
  return ui::plainToolTip(parts.join(QStringLiteral("\n\n")));
}

std::vector<MetricScore> ordered(std::vector<MetricScore> scores) {
  std::erase_if(scores, [](const MetricScore& one) { return isOfLine(one.metric) && !one.value; });
  std::ranges::stable_partition(scores, [](const MetricScore& one) { return one.norm.has_value(); });
  return scores;
}

MetricTableView::MetricTableView(QWidget* parent) : QTableWidget(parent) {
  setObjectName(QStringLiteral("metrics"));
  setAccessibleName(tr("Metrics of the attempt beside novice and expert values"));
  setColumnCount(kColumns);
  setHorizontalHeaderLabels({tr("Metric"), tr("Value"), tr("Novice"), {}, tr("Expert")});
  for (int column = 0; column < kColumns; ++column) horizontalHeaderItem(column)->setTextAlignment(alignmentOf(column));
  horizontalHeaderItem(kBar)->setToolTip(tr("Left end: novice value; right end: expert value; dot: this attempt"));
  setEditTriggers(NoEditTriggers);
  setSelectionBehavior(SelectRows);
  setSelectionMode(SingleSelection);
  setShowGrid(false);
  setTabKeyNavigation(false);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(kRow_px);
  verticalHeader()->setMinimumSectionSize(kRow_px);
  QHeaderView* header = horizontalHeader();
  header->setHighlightSections(false);
  header->setSectionResizeMode(QHeaderView::Fixed);
  header->setSectionResizeMode(kName, QHeaderView::ResizeToContents);
  header->setSectionResizeMode(kBar, QHeaderView::Stretch);
  for (const Column column : {kValue, kNovice, kExpert}) header->resizeSection(column, kNumber_px);
  setItemDelegateForColumn(kBar, new Bars(*this));
}

void MetricTableView::show(const std::vector<MetricScore>& scores) {
  scores_ = ordered(scores);
  setRowCount(int(scores_.size()));
  for (int row = 0; row < int(scores_.size()); ++row) {
    const MetricScore& score = scores_[std::size_t(row)];
    const auto set = [&](Column column, const QString& text, bool quiet) {
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(explanationOf(score));
      item->setTextAlignment(alignmentOf(column));
      if (quiet) item->setForeground(ui::screenInk().quiet);
      setItem(row, column, item);
    };
    const auto norm = [&](double value) { return normOf(score.metric, value); };
    set(kName, ui::titleOf(score.metric), false);
    set(kValue, ui::valueOf(score.metric, score.value), !score.value);
    set(kNovice, score.norm ? norm(score.norm->novice) : tr("n/a"), true);
    set(kBar, {}, true);
    set(kExpert, score.norm ? norm(score.norm->expert) : tr("n/a"), true);
    item(row, kBar)->setData(Qt::AccessibleTextRole,
                             score.share ? tr("%1 % of the way from novice to expert").arg(*score.share, 0, 'f', 0)
                                         : tr("no comparison with novice and expert"));
  }
}

}  // namespace insonate::review
