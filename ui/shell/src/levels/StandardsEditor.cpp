#include "StandardsEditor.h"

#include "../controls/NumberBox.h"

#include <insonate/ui/RowTable.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::ui {
namespace {

enum Column { kMetric, kLimit, kOtherwise, kColumns };
constexpr int kRow_px = 26, kTable_px = 190, kMetric_px = 250, kLimit_px = 110;
constexpr double kAnyLimit = 1e6;

QDoubleSpinBox* number(const QString& name, double low, double high, int decimals, const QString& suffix) {
  auto* box = new NumberBox<QDoubleSpinBox>(name);
  box->setRange(low, high);
  box->setDecimals(decimals);
  box->setSuffix(suffix);
  box->setKeyboardTracking(false);
  return box;
}

}  // namespace

StandardsEditor::StandardsEditor(const std::vector<MetricMeaning>& metrics, QWidget* parent)
    : QWidget(parent), metrics_(metrics) {
  auto* always = new QLabel(tr("An attempt passes if it was completed, succeeded, had no critical error, and:"));
  setRole(always, "quiet");
  table_ = named(new QTableWidget(0, kColumns), "standards", tr("Standards"),
                 tr("List of passing standards; edit the selected standard below the list"));
  table_->setHorizontalHeaderLabels({tr("Metric"), tr("Limit"), tr("Message if the standard is missed")});
  makeRowTable(*table_, kRow_px);
  table_->setColumnWidth(kMetric, kMetric_px);
  table_->setColumnWidth(kLimit, kLimit_px);
  table_->horizontalHeader()->setSectionResizeMode(kOtherwise, QHeaderView::Stretch);
  table_->setFixedHeight(kTable_px);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &StandardsEditor::showStandard);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kGap);
  box->addWidget(always);
  box->addWidget(buildRule());
  box->addWidget(table_);
  box->addWidget(buildStandard());
}

QWidget* StandardsEditor::buildRule() {
  points_ = named(new QCheckBox(tr("Minimum")), "leastPointsOn", tr("Minimum number of points"),
                  tr("Requires a minimum number of points out of 100"));
  minPoints_ = named(number(tr("Points"), 0, 100, 0, tr(" points")), "leastPoints", tr("Points"),
                     tr("Points, out of 100, that an attempt has to reach"));
  percent_ = named(number(tr("Percentage of standards"), 1, 100, 0, tr(" %")), "masteryPercent",
                   tr("Percentage of standards to meet"),
                   tr("Percentage of the listed standards that an attempt must meet; 100 %: all standards"));
  const auto tell = [this] {
    const auto least = points_->isChecked() ? std::optional(minPoints_->value()) : std::nullopt;
    Q_EMIT edited(QStringLiteral("points"), [least](Level& level) { level.pass.minPoints = least; });
  };
  connect(points_, &QCheckBox::clicked, this, tell);
  connect(minPoints_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, tell);
  connect(percent_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    Q_EMIT edited(QStringLiteral("percent"), [value](Level& level) { level.pass.mastery_percent = value; });
  });
  auto* line = new QWidget;
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGap);
  row->addWidget(points_);
  row->addWidget(minPoints_);
  row->addSpacing(kLargeGap);
  row->addWidget(new QLabel(tr("Standards to meet")));
  row->addWidget(percent_);
  row->addStretch(1);
  return line;
}

QWidget* StandardsEditor::buildStandard() {
  metric_ = named(new QComboBox, "standardMetric", tr("Metric"), tr("Metric that the standard limits"));
  for (const MetricMeaning& one : metrics_) metric_->addItem(titleOf({.metric = one.id}), qt(one.id));
  bound_ = named(new QComboBox, "standardBound", tr("Minimum or maximum"),
                 tr("Whether the limit is a minimum or a maximum"));
  bound_->addItems({tr("minimum"), tr("maximum")});
  limit_ = named(number(tr("The limit"), -kAnyLimit, kAnyLimit, 2, QString()), "standardLimit", tr("Limit"),
                 tr("Limit of the metric, in the unit of the metric"));
  otherwise_ = named(new QLineEdit, "standardOtherwise", tr("Message if the standard is missed"),
                     tr("Completes the sentence \"failed because ...\", for example \"the artery was punctured\""));
  otherwise_->setPlaceholderText(tr("for example: the artery was punctured"));
  critical_ = named(new QCheckBox(tr("Must be met")), "standardCritical", tr("Must be met"),
                    tr("An attempt that misses this standard fails, even if it meets all other standards"));
  add_ = pushButton("standardAdd", tr("Add"), tr("Adds a passing standard"));
  remove_ = pushButton("standardRemove", tr("Remove"), tr("Removes the selected passing standard"));
  connect(add_, &QPushButton::clicked, this, &StandardsEditor::add);
  connect(remove_, &QPushButton::clicked, this, &StandardsEditor::remove);
  connect(metric_, QOverload<int>::of(&QComboBox::activated), this, [this](int at) {
    const MetricMeaning& meaning = metrics_[std::size_t(at)];
    change(QStringLiteral("metric"),
           [&](MetricStandard& one) { one.metric = meaning.id, one.version = meaning.version; });
  });
  const auto tellLimit = [this] {
    change(QStringLiteral("limit"), [this](MetricStandard& one) {
      one.minimum.reset(), one.maximum.reset();
      (bound_->currentIndex() == 0 ? one.minimum : one.maximum) = limit_->value();
    });
  };
  connect(bound_, QOverload<int>::of(&QComboBox::activated), this, tellLimit);
  connect(limit_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, tellLimit);
  connect(otherwise_, &QLineEdit::textEdited, this, [this](const QString& text) {
    change(QStringLiteral("otherwise"), [&](MetricStandard& one) { one.otherwise = text.toStdString(); });
  });
  connect(critical_, &QCheckBox::clicked, this,
          [this](bool on) { change(QStringLiteral("critical"), [on](MetricStandard& one) { one.critical = on; }); });
  auto* line = new QWidget;
  auto* column = new QVBoxLayout(line);
  column->setContentsMargins(0, 0, 0, 0);
  auto *first = new QHBoxLayout, *second = new QHBoxLayout;
  for (QWidget* one : std::initializer_list<QWidget*>{metric_, bound_, limit_}) first->addWidget(one, one == metric_);
  second->addWidget(otherwise_, 1);
  second->addWidget(critical_);
  second->addWidget(add_);
  second->addWidget(remove_);
  column->addLayout(first);
  column->addLayout(second);
  return line;
}

QString StandardsEditor::titleOf(const MetricStandard& standard) const {
  const auto known = std::ranges::find(metrics_, standard.metric, &MetricMeaning::id);
  if (known == metrics_.end()) return tr("%1 (not available)").arg(qt(standard.metric));
  return known->unit.empty() ? qt(known->title) : QStringLiteral("%1, %2").arg(qt(known->title), qt(known->unit));
}

void StandardsEditor::show(const PassRule& rule) {
  rule_ = rule;
  const QSignalBlocker a(points_), b(minPoints_), c(percent_);
  points_->setChecked(rule.minPoints.has_value());
  minPoints_->setEnabled(rule.minPoints.has_value());
  if (rule.minPoints) minPoints_->setValue(*rule.minPoints);
  percent_->setValue(rule.mastery_percent);
  const int row = table_->currentRow();
  {
    const QSignalBlocker quiet(table_);
    table_->setRowCount(int(rule.standards.size()));
    for (int at = 0; at < table_->rowCount(); ++at) {
      const MetricStandard& one = rule.standards[std::size_t(at)];
      const QString limit =
          one.minimum ? tr("at least %1").arg(*one.minimum) : tr("at most %1").arg(one.maximum.value_or(0));
      const QString said = one.critical ? tr("%1 (must be met)").arg(qt(one.otherwise)) : qt(one.otherwise);
      const QString texts[kColumns] = {titleOf(one), limit, said};
      for (int column = 0; column < kColumns; ++column)
        table_->setItem(at, column, new QTableWidgetItem(texts[column]));
    }
    if (table_->rowCount() > 0) table_->selectRow(std::clamp(row, 0, table_->rowCount() - 1));
  }
  showStandard();
}

void StandardsEditor::showStandard() {
  const int row = table_->currentRow();
  const bool is = row >= 0 && row < int(rule_.standards.size());
  for (QWidget* one : std::initializer_list<QWidget*>{metric_, bound_, limit_, otherwise_, critical_, remove_})
    one->setEnabled(is);
  if (!is) return;
  const MetricStandard& one = rule_.standards[std::size_t(row)];
  const QSignalBlocker quiet(limit_);
  metric_->setCurrentIndex(metric_->findData(qt(one.metric)));
  bound_->setCurrentIndex(one.minimum ? 0 : 1);
  limit_->setValue(one.minimum ? *one.minimum : one.maximum.value_or(0));
  critical_->setChecked(one.critical);
  showText(*otherwise_, qt(one.otherwise));
  otherwise_->setCursorPosition(std::min(otherwise_->cursorPosition(), otherwise_->text().size()));
}

void StandardsEditor::change(const QString& field, const std::function<void(MetricStandard&)>& what) {
  const int row = table_->currentRow();
  if (row < 0 || row >= int(rule_.standards.size())) return;
  MetricStandard changed = rule_.standards[std::size_t(row)];
  what(changed);
  Q_EMIT edited(QStringLiteral("standard %1 %2").arg(row).arg(field), [row, changed](Level& level) {
    if (row < int(level.pass.standards.size())) level.pass.standards[std::size_t(row)] = changed;
  });
}

void StandardsEditor::add() {
  if (metrics_.empty()) return;
  const MetricMeaning& first = metrics_.front();
  Q_EMIT edited({}, [&](Level& level) {
    level.pass.standards.push_back({.metric = first.id, .version = first.version, .maximum = 0});
  });
  table_->selectRow(table_->rowCount() - 1);
  metric_->setFocus();
}

void StandardsEditor::remove() {
  const int row = table_->currentRow();
  Q_EMIT edited({}, [row](Level& level) {
    auto& all = level.pass.standards;
    if (row >= 0 && row < int(all.size())) all.erase(all.begin() + row);
  });
}

}  // namespace insonate::ui
