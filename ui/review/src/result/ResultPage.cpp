#include "ResultPage.h"

#include "../ReviewSession.h"
#include "../attempt/Words.h"
#include "../class/ClassWords.h"
#include "../judge/JudgingController.h"
#include "MetricTable.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <cmath>

namespace insonate::review {
namespace {

constexpr int kPoints_pt = 30;

/// Words about a test; none for other attempts.
QString sittingWords(TestConditions testConditions) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("Review", text); };
  switch (testConditions) {
    case TestConditions::Opened:
      return tr("● Test: an instructor had opened the test when the attempt began.");
    case TestConditions::SelfAdministered:
      return tr("● Test: self-administered, without an instructor.");
    case TestConditions::Practice:
      return tr("○ Practice: the test was not open when the attempt began, so the attempt does not count.");
    case TestConditions::Undecided:
      return tr("○ Test: it is not known yet whether the test was open when the attempt began.");
    case TestConditions::None:
    case TestConditions::Earlier:
      break;
  }
  return {};
}

}  // namespace

QString pointsOf(const AttemptDigest& attempt) {
  if (!attempt.score || !attempt.score->points) return QStringLiteral("–");
  return QString::number(std::lround(*attempt.score->points));
}

QString pointsNoteOf(const AttemptDigest& attempt) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("Review", text); };
  if (!attempt.score) return tr("No points: parts of the recording are missing, so the metrics would be wrong.");
  if (!attempt.score->points)
    return tr(
        "The attempt has no points: the skin was not punctured, or no metric has published values of novices and "
        "experts.");
  switch (attempt.recording->status()) {
    case AttemptStatus::Completed:
      break;
    case AttemptStatus::Abandoned:
      return tr(
          "of 100 points for what was done. The attempt was abandoned: it did not succeed, and its points do not "
          "count.");
    case AttemptStatus::CutShort:
      return tr(
          "of 100 points up to the end of the recording. The recording stopped early, so the attempt counts as "
          "abandoned, and its points do not count.");
  }
  return attempt.score->succeeded ? tr("of 100 points. The attempt succeeded: the tip was placed in the vein.")
                                  : tr("of 100 points. The attempt did not succeed.");
}

ResultPage::ResultPage(ReviewSession& session, const JudgingController& judging, QWidget* parent)
    : QWidget(parent),
      session_(session),
      judging_(judging),
      points_(new QLabel),
      success_(new QLabel),
      sitting_(ui::paragraph("resultSitting")),
      flags_(ui::paragraph("resultFlags", "problem")),
      advice_(new QLabel),
      errors_(new QLabel),
      metrics_(new MetricTableView) {
  setObjectName(QStringLiteral("resultPage"));
  QFont large = points_->font();
  large.setPointSize(kPoints_pt);
  large.setWeight(QFont::DemiBold);
  points_->setFont(large);
  points_->setStyleSheet(QStringLiteral("font-size: %1pt; font-weight: 600;").arg(kPoints_pt));
  points_->setObjectName(QStringLiteral("points"));
  points_->setToolTip(
      tr("Mean position of the metrics from novice (0) to expert (100), minus 5 for each minor finding and 20 for each "
         "major finding. A critical finding gives 0 points; without success, the maximum is 50"));
  success_->setWordWrap(true);
  success_->setObjectName(QStringLiteral("pointsNote"));
  ui::setRole(success_, "quiet");
  advice_->setWordWrap(true);
  advice_->setObjectName(QStringLiteral("advice"));
  ui::setRole(advice_, "heading");
  errors_->setWordWrap(true);
  errors_->setObjectName(QStringLiteral("criticalErrors"));
  auto* words = new QVBoxLayout;
  words->setSpacing(ui::kSmallGap);
  words->addWidget(success_);
  words->addWidget(sitting_);
  words->addWidget(flags_);
  words->addWidget(advice_);
  words->addWidget(errors_);
  auto* top = new QHBoxLayout;
  top->setSpacing(ui::kLargeGap);
  top->addWidget(points_, 0, Qt::AlignTop);
  top->addLayout(words, 1);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kLargeGap, ui::kGap, ui::kLargeGap, ui::kGap);
  box->setSpacing(ui::kGap);
  box->addLayout(top);
  box->addWidget(metrics_, 1);
  errors_->setTextFormat(Qt::RichText);
  connect(&session_, &ReviewSession::attemptChanged, this, [this] { show(); });
  connect(&judging_, &JudgingController::changed, this, [this] { showSitting(); });
  showSitting();
}

void ResultPage::showSitting() {
  const auto& origin = judging_.origin();
  const bool isKnown = origin && origin->attempt && origin->same;
  sitting_->setText(isKnown ? sittingWords(origin->attempt->testConditions) : QString());
  sitting_->setVisible(!sitting_->text().isEmpty());
  // As on the page of the person, only instructors see flags.
  const bool isFlagged = judging_.mayJudge() && !origin->flags.empty();
  flags_->setText(isFlagged ? tr("▲ Needs attention: %1").arg(displayText(*origin->attempt, origin->flags))
                            : QString());
  flags_->setVisible(isFlagged);
}

void ResultPage::show() {
  const auto& attempt = session_.attempt();
  if (!attempt) return;
  points_->setText(pointsOf(*attempt));
  success_->setText(pointsNoteOf(*attempt));
  advice_->setText(attempt->score ? QString::fromStdString(attempt->score->advice) : QString());
  QStringList errors;
  if (attempt->score)
    for (const AttemptMoment& moment : attempt->score->criticalErrors)
      errors << QStringLiteral("<span style='color:%1'>▲ %2  %3</span>")
                    .arg(ui::screenInk().danger.name(), clockOf(moment.time_us),
                         QString::fromStdString(moment.description).toHtmlEscaped());
  errors_->setText(errors.join(QStringLiteral("<br>")));
  errors_->setVisible(!errors.isEmpty());
  metrics_->show(attempt->score ? attempt->score->metrics : std::vector<MetricScore>{});
}

PathPane::PathPane(ReviewSession& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("pathPane"));
  setAccessibleName(tr("Path of the needle tip in the image plane"));
  setToolTip(
      tr("Path of the tip in the image plane, in mm: lateral position to the right, depth down; dotted where the tip "
         "was outside the slice. Structures are shown as in the CT"));
  setMinimumHeight(160);
  const auto renew = [this] {
    const auto& attempt = session_.attempt();
    section_ = attempt ? sectionOf(*attempt, session_.fits() ? session_.patient().get() : nullptr) : PlaneSection{};
    update();
  };
  connect(&session_, &ReviewSession::attemptChanged, this, renew);
  connect(&session_, &ReviewSession::caseChanged, this, renew);
}

void PathPane::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), ui::toQColor(views::theme::kGround));
  if (!session_.attempt()) return;
  const int line = painter.fontMetrics().height() + ui::kSmallGap;
  painter.setPen(ui::screenInk().quiet);
  if (!section_.place_mm.isEmpty())
    painter.drawText(QRect(ui::kGap, 0, width() - ui::kGap, line), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("needle tip in the image plane, mm, at %1").arg(clockOf(section_.time_us)));
  paintPlane(painter, QRectF(rect()).adjusted(0, line, 0, 0), *session_.attempt(), section_, ui::screenInk());
}

}  // namespace insonate::review
