#include "ComparePage.h"

#include "../class/ClassController.h"
#include "../class/ClassWords.h"
#include "ClassComparison.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/Chart.h>
#include <insonate/ui/Theme.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::review {

ComparePage::ComparePage(const ClassController& controller, QWidget* parent)
    : QWidget(parent),
      controller_(controller),
      own_(new QLabel),
      words_(new QLabel),
      other_(new QComboBox),
      metric_(new QComboBox),
      chart_(new ui::Chart) {
  own_->setTextFormat(Qt::PlainText);
  words_->setObjectName(QStringLiteral("comparisonWords"));
  words_->setTextFormat(Qt::PlainText);
  words_->setWordWrap(true);
  other_->setObjectName(QStringLiteral("otherClass"));
  other_->setAccessibleName(tr("Other class"));
  other_->setToolTip(tr("The class to compare with"));
  metric_->setObjectName(QStringLiteral("metricCompared"));
  metric_->setAccessibleName(tr("Metric"));
  metric_->setToolTip(tr("Metric to compare: each person's mean of the last %1 attempts at levels").arg(kLastAttempts));
  for (QComboBox* box : {other_, metric_}) box->setMinimumWidth(230);
  for (std::size_t i = 0; i < MetricCatalog::instance().comparableCount(); ++i)
    metric_->addItem(titleWithUnit(MetricCatalog::instance().all()[i]));
  chart_->setObjectName(QStringLiteral("comparisonChart"));
  auto* row = new QHBoxLayout;
  row->setSpacing(ui::kGap);
  row->addWidget(own_);
  row->addWidget(other_);
  row->addStretch(1);
  row->addWidget(metric_);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kGap, ui::kGap, ui::kGap, ui::kGap);
  box->setSpacing(ui::kGap);
  box->addLayout(row);
  box->addWidget(chart_, 1);
  box->addWidget(words_);
  connect(other_, QOverload<int>::of(&QComboBox::activated), this, [this] { readOther(); });
  connect(metric_, QOverload<int>::of(&QComboBox::activated), this, [this] { show(); });
  connect(chart_, &ui::Chart::written, this, &ComparePage::written);
  connect(chart_, &ui::Chart::failed, this, &ComparePage::failed);
  connect(&controller_, &ClassController::cohortsChanged, this, [this] { fillClasses(); });
  connect(&controller_, &ClassController::classChanged, this, [this] { takeClass(); });
  fillClasses();
}

void ComparePage::fillClasses() {
  const QSignalBlocker quiet(other_);
  ++round_;
  otherFacts_.reset();
  ownId_ = ownClass();
  const QVariant before = other_->currentData();
  other_->clear();
  other_->addItem(tr("Compare with class ..."), QString());
  for (const Cohort& cohort : controller_.cohorts())
    if (cohort.id != ownId_) other_->addItem(QString::fromStdString(cohort.name), QString::fromStdString(cohort.id));
  // If there is only one other class, it is selected.
  other_->setCurrentIndex(other_->count() == 2 ? 1 : std::max(0, other_->findData(before)));
  isVisible() ? readOther() : show();
}

std::string ComparePage::ownClass() const {
  return controller_.cohorts().empty() ? std::string() : controller_.cohorts()[std::size_t(controller_.chosen())].id;
}

void ComparePage::takeClass() {
  ownClass() == ownId_ ? show() : fillClasses();
}

void ComparePage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!otherFacts_) readOther();
}

void ComparePage::readOther() {
  ++round_;
  otherFacts_.reset();
  const std::string id = other_->currentData().toString().toStdString();
  const auto cohort = std::ranges::find(controller_.cohorts(), id, &Cohort::id);
  if (cohort != controller_.cohorts().end())
    controller_.account()->query<ClassFacts>(
        this, [cohort = *cohort](const SignedIn& by) { return readClass(by, cohort); },
        [this, round = round_](Result<ClassFacts> facts) {
          if (round != round_) return;
          if (!facts) return Q_EMIT failed(QString::fromStdString(facts.error().message), {});
          otherFacts_ = std::move(*facts);
          show();
        });
  show();
}

void ComparePage::show() {
  const ClassFacts* own = controller_.facts();
  own_->setText(own ? QString::fromStdString(own->cohort.name) : QString());
  words_->clear();
  if (own && otherFacts_) {
    const ClassComparison comparison =
        compareClasses({own_->text(), own->heat}, {QString::fromStdString(otherFacts_->cohort.name), otherFacts_->heat},
                       std::size_t(std::max(0, metric_->currentIndex())));
    chart_->show(comparison.picture);
    return words_->setText(comparison.words);
  }
  ui::ChartContents nothing;
  nothing.words = controller_.cohorts().size() < 2 ? tr("You can see only one class; a comparison needs two.")
                                                   : tr("Choose the class to compare with in the list above.");
  chart_->show(nothing);
}

}  // namespace insonate::review
