#include "MasteryEditor.h"

#include "../controls/NumberBox.h"

#include <insonate/curriculum/LcCusum.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/curriculum/Unlocking.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <cmath>
#include <utility>

namespace insonate::ui {
namespace {

constexpr double kPercent = 100;

template <class Box, class Value>
Box* number(const char* object, const QString& name, const QString& tip, Value low, Value high, const QString& suffix) {
  auto* box = named(new NumberBox<Box>(name), object, name, tip);
  box->setRange(low, high);
  box->setSuffix(suffix);
  box->setKeyboardTracking(false);
  return box;
}

QDoubleSpinBox* share(const char* object, const QString& name, const QString& tip) {
  auto* box = number<QDoubleSpinBox>(object, name, tip, 0.1, 99.9, QStringLiteral(" %"));
  box->setDecimals(1);
  return box;
}

QWidget* lineOf(std::initializer_list<QWidget*> parts) {
  auto* line = new QWidget;
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGap);
  for (QWidget* part : parts) row->addWidget(part);
  row->addStretch(1);
  return line;
}

/// The limit, and the share of able trainees who reach it.
struct Calibrated {
  double limit = 0;
  Estimate falseSignals{}, power{};
};

Result<Calibrated> calibratedFor(const LcCusum& test, double falseSignals, const CusumTrials& trials,
                                 const Progress& progress) {
  const auto exact = calibratedLimit(test, falseSignals, trials, progress);
  if (!exact) return tl::unexpected(exact.error());
  // Rounded up to the two digits that are stored, so that the share is still met.
  const double limit = std::ceil(100 * *exact) / 100;
  // Computed from careers other than those of the calibration.
  CusumTrials others = trials;
  ++others.seed;
  const auto share = [&](double failureRate) {
    const double rate = signalRate(test, limit, failureRate, others);
    return proportion(int(std::lround(rate * others.careers)), others.careers).value_or(Estimate{rate});
  };
  return Calibrated{limit, share(test.unacceptable), share(test.acceptable)};
}

/// "9.9 % (9.5 to 10.3 %)", for a simulated share.
QString simulatedPercent(const Estimate& share) {
  const auto percent = [](double value) { return QString::number(kPercent * value, 'f', 1); };
  const Interval interval = share.interval.value_or(Interval{share.value, share.value});
  return MasteryEditor::tr("%1 % (%2 to %3 %)")
      .arg(percent(share.value), percent(interval.low), percent(interval.high));
}

QString displayText(const Calibrated& done, const LcCusum& test, const CusumTrials& trials) {
  return MasteryEditor::tr(
             "Limit %1: about %2 of trainees who fail %3 % of the time get a false signal within %4 attempts; about %5 "
             "of those who fail %6 % of the time get a signal. Simulated, with 95 % intervals.")
      .arg(QString::number(done.limit, 'f', 2), simulatedPercent(done.falseSignals),
           QString::number(kPercent * test.unacceptable), QString::number(trials.trials), simulatedPercent(done.power),
           QString::number(kPercent * test.acceptable));
}

}  // namespace

MasteryEditor::MasteryEditor(QWidget* parent) : QWidget(parent), tasks_(new TaskBar) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kGap);
  for (QWidget* part : {buildRow(), buildCusum(), buildCalibration(), buildLapses()}) box->addWidget(part);
}

QWidget* MasteryEditor::buildRow() {
  passes_ = number<QSpinBox>("passesInARow", tr("Consecutive passes"),
                             tr("Number of consecutive passes that mastery requires"), 1, 100, tr(" consecutive"));
  connect(passes_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int passes) {
    Q_EMIT edited(QStringLiteral("passes"), [passes](Level& level) { level.mastery.consecutivePasses = passes; });
  });
  fewest_ = new QLabel;
  fewest_->setObjectName(QStringLiteral("fewestAttempts"));
  setRole(fewest_, "quiet");
  return lineOf({new QLabel(tr("Passed in a row")), passes_, fewest_});
}

QWidget* MasteryEditor::buildCusum() {
  cusum_ = named(new QCheckBox(tr("LC-CUSUM")), "cusumOn", tr("Learning curve test LC-CUSUM"),
                 tr("Mastery also requires that the score of the learning curve test LC-CUSUM reaches the limit"));
  acceptable_ = share("cusumAcceptable", tr("Acceptable failure rate"), tr("Failure rate of a competent operator"));
  unacceptable_ = share("cusumUnacceptable", tr("Unacceptable failure rate"),
                        tr("Failure rate of an operator who is not competent"));
  limit_ =
      number<QDoubleSpinBox>("cusumLimit", tr("Limit"),
                             tr("LC-CUSUM score that the trainee must reach. With a higher limit, fewer trainees who "
                                "are not able reach it by chance, and all need more attempts"),
                             0.01, 100.0, QString());
  connect(cusum_, &QCheckBox::clicked, this, [this](bool on) {
    Q_EMIT edited({}, [on](Level& level) { level.mastery.cusum = on ? std::optional(CusumRule()) : std::nullopt; });
  });
  for (QDoubleSpinBox* one : {acceptable_, unacceptable_, limit_})
    connect(one, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &MasteryEditor::applyCusum);
  return lineOf({cusum_, new QLabel(tr("acceptable")), acceptable_, new QLabel(tr("unacceptable")), unacceptable_,
                 new QLabel(tr("limit of the score")), limit_});
}

QWidget* MasteryEditor::buildCalibration() {
  falseSignals_ =
      share("cusumFalse", tr("False signal rate"),
            tr("Maximum share of trainees with the unacceptable failure rate who reach the limit by chance"));
  falseSignals_->setValue(10);
  trials_ = number<QSpinBox>("cusumTrials", tr("Attempts"),
                             tr("Number of attempts within which false signals are counted"), 1, 1000, tr(" attempts"));
  trials_->setValue(CusumTrials().trials);
  calibrate_ = named(new QPushButton(tr("Calibrate")), "cusumCalibrate", tr("Calibrate the limit"),
                     tr("Sets the limit by a reproducible simulation of trainees"));
  calibrate_->setAutoDefault(false);
  connect(calibrate_, &QPushButton::clicked, this, &MasteryEditor::findLimit);
  calibrated_ = new QLabel;
  calibrated_->setObjectName(QStringLiteral("cusumCalibrated"));
  calibrated_->setTextFormat(Qt::PlainText);
  calibrated_->setWordWrap(true);
  setRole(calibrated_, "quiet");
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSmallGap);
  column->addWidget(lineOf({new QLabel(tr("Choose limit h for a false signal rate of")), falseSignals_,
                            new QLabel(tr("within")), trials_, calibrate_}));
  column->addWidget(tasks_);
  column->addWidget(calibrated_);
  return part;
}

QWidget* MasteryEditor::buildLapses() {
  byDays_ = named(new QCheckBox(tr("lapses after")), "lapseDaysOn", tr("Mastery lapses without practice"),
                  tr("Mastery of the level lapses after the given number of days without practice"));
  days_ =
      number<QSpinBox>("lapseDays", tr("Days"),
                       tr("Number of days without an attempt at this level, or at a level that requires this level"), 1,
                       36500, tr(" days without practice"));
  byFailures_ = named(new QCheckBox(tr("lapses after")), "lapseFailuresOn", tr("Mastery lapses after failures"),
                      tr("Mastery of the level lapses after the given number of failures among the latest attempts"));
  failures_ = number<QSpinBox>("lapseFailures", tr("Failures"),
                               tr("Number of failed attempts after which mastery lapses"), 1, 1000, tr(" failures"));
  within_ = number<QSpinBox>("lapseWithin", tr("Within"),
                             tr("Number of latest attempts among which failed attempts are counted"), 1, 1000,
                             tr(" attempts"));
  for (QCheckBox* one : {byDays_, byFailures_}) connect(one, &QCheckBox::clicked, this, &MasteryEditor::applyLapses);
  for (QSpinBox* one : {days_, failures_, within_})
    connect(one, QOverload<int>::of(&QSpinBox::valueChanged), this, &MasteryEditor::applyLapses);
  days_->setValue(180), failures_->setValue(FailureRule().failures), within_->setValue(FailureRule().within);
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap);
  column->addWidget(lineOf({byDays_, days_}));
  column->addWidget(lineOf({byFailures_, failures_, new QLabel(tr("within")), within_}));
  return part;
}

void MasteryEditor::show(const Level& level) {
  const MasteryRule& rule = level.mastery;
  // A limit calibrated for one level does not apply to another.
  if (std::exchange(level_, level.name) != level.name) tasks_->cancel(), calibrated_->clear();
  const QSignalBlocker a(passes_), b(acceptable_), c(unacceptable_), d(limit_), e(days_), f(failures_), g(within_);
  passes_->setValue(rule.consecutivePasses);
  const int fewest = fewestAttempts(rule);
  fewest_->setText(fewest == LcCusum::kMaxToSignal
                       ? tr("the two failure rates are too close to distinguish: raise the unacceptable rate")
                   : fewest == 1 ? tr("mastery takes at least 1 attempt")
                                 : tr("mastery takes at least %1 attempts").arg(fewest));
  cusum_->setChecked(rule.cusum.has_value());
  for (QWidget* one :
       std::initializer_list<QWidget*>{acceptable_, unacceptable_, limit_, falseSignals_, trials_, calibrate_})
    one->setEnabled(rule.cusum.has_value());
  const CusumRule cusum = rule.cusum.value_or(CusumRule());
  if (cusum != rule_ || !rule.cusum) calibrated_->clear();
  rule_ = cusum;
  calibrated_->setVisible(!calibrated_->text().isEmpty());
  acceptable_->setValue(kPercent * cusum.acceptable);
  unacceptable_->setValue(kPercent * cusum.unacceptable);
  limit_->setValue(cusum.limit);
  byDays_->setChecked(rule.lapsesAfter_days.has_value());
  days_->setEnabled(rule.lapsesAfter_days.has_value());
  if (rule.lapsesAfter_days) days_->setValue(*rule.lapsesAfter_days);
  byFailures_->setChecked(rule.lapsesAfter.has_value());
  failures_->setEnabled(rule.lapsesAfter.has_value());
  within_->setEnabled(rule.lapsesAfter.has_value());
  if (rule.lapsesAfter) failures_->setValue(rule.lapsesAfter->failures), within_->setValue(rule.lapsesAfter->within);
}

void MasteryEditor::applyCusum() {
  const CusumRule rule{acceptable_->value() / kPercent, unacceptable_->value() / kPercent, limit_->value()};
  Q_EMIT edited(QStringLiteral("cusum"), [rule](Level& level) {
    if (level.mastery.cusum) level.mastery.cusum = rule;
  });
}

void MasteryEditor::applyLapses() {
  const auto days = byDays_->isChecked() ? std::optional(days_->value()) : std::nullopt;
  const auto failures =
      byFailures_->isChecked() ? std::optional(FailureRule{failures_->value(), within_->value()}) : std::nullopt;
  Q_EMIT edited(QStringLiteral("lapse"), [days, failures](Level& level) {
    level.mastery.lapsesAfter_days = days;
    level.mastery.lapsesAfter = failures;
  });
}

void MasteryEditor::findLimit() {
  const LcCusum test{acceptable_->value() / kPercent, unacceptable_->value() / kPercent};
  const double share = falseSignals_->value() / kPercent;
  CusumTrials trials;
  trials.trials = trials_->value();
  tasks_->run<Calibrated>(
      tr("Simulating %L1 trainees with %2 attempts each").arg(trials.careers).arg(trials.trials),
      [=](const Progress& progress) { return calibratedFor(test, share, trials, progress); },
      [this, test, trials](const Result<Calibrated>& done) {
        const QString words = done ? displayText(*done, test, trials) : QString::fromStdString(done.error().message);
        if (done) limit_->setValue(done->limit);
        calibrated_->setText(words);
        calibrated_->setVisible(true);
      });
}

}  // namespace insonate::ui
