#include "StepList.h"

#include "AttemptWords.h"

#include <insonate/simulator/LiveAttempt.h>
#include <insonate/ui/StateColors.h>
#include <insonate/ui/Theme.h>

#include <QLabel>
#include <QStringList>
#include <QVBoxLayout>

namespace insonate::train {
namespace {

constexpr std::size_t kFindingsShown = 3;

QString colored(const QString& sign, views::Color color) {
  return QStringLiteral("<span style='color:%1'>%2</span>").arg(ui::toQColor(color).name(), sign);
}

QString plain(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped();
}

QString lineOf(const ProcedureStep& step, ProcedureRun::StepState state) {
  QString sign = colored(QStringLiteral("○"), views::theme::kQuiet);
  if (state == ProcedureRun::StepState::Done) sign = colored(QStringLiteral("✓"), views::theme::kGood);
  if (state == ProcedureRun::StepState::Skipped) sign = colored(QStringLiteral("–"), views::theme::kQuiet);
  const bool open = state == ProcedureRun::StepState::Open;
  const QString optional = step.optional && open ? QObject::tr(", optional") : QString();
  return sign + QStringLiteral("&nbsp; ") + plain(step.title) + optional;
}

QLabel* paragraph(const char* object, QVBoxLayout& box) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(object));
  label->setTextFormat(Qt::RichText);
  label->setWordWrap(true);
  box.addWidget(label);
  return label;
}

bool write(QLabel& label, const QString& text) {
  label.setVisible(!text.isEmpty());
  if (label.text() == text) return false;
  label.setText(text);
  return true;
}

}  // namespace

StepList::StepList(QWidget* parent) : QWidget(parent) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  findings_ = paragraph("attemptFindings", *box);
  steps_ = paragraph("attemptStepsDone", *box);
  say_ = paragraph("attemptDue", *box);
  act_ = paragraph("attemptAct", *box);
  later_ = paragraph("attemptStepsLater", *box);
  ui::setRole(steps_, "quiet");
  ui::setRole(later_, "quiet");
}

QString errorText(const Procedure& procedure, const AttemptView& view, std::size_t finding) {
  const ProcedureRun::Finding& one = view.findings[finding];
  const ProcedureRule& rule = procedure.rules[one.rule];
  return colored(QStringLiteral("▲"), ui::colorOf(rule.severity)) + QStringLiteral("&nbsp; <b>%1, %2.</b> %3")
                                                                        .arg(capital(ui::nameOf(rule.severity)),
                                                                             clockOf(double(one.time_us) * 1e-6),
                                                                             plain(findingText(rule, one)));
}

QRect StepList::dueRows() const {
  const int line_px = steps_->fontMetrics().lineSpacing() + ui::kSmallGap;
  return (say_->geometry() | act_->geometry()).adjusted(0, -line_px, 0, line_px) & rect();
}

bool StepList::show(const Procedure& procedure, const AttemptView& view, bool withSteps, const QString& act,
                    std::optional<std::size_t> standing) {
  QStringList before, after;
  QString due = QObject::tr("<b>All steps are done.</b>");
  for (std::size_t i = 0; i < view.steps.size(); ++i) {
    const ProcedureStep& step = procedure.steps[i];
    if (view.nextStep == i)
      due = colored(QStringLiteral("▶"), views::theme::kAccent) +
            QStringLiteral("&nbsp; <b>%1</b><br>%2").arg(plain(step.title), plain(step.instruction));
    else
      (view.nextStep && i > *view.nextStep ? after : before) << lineOf(step, view.steps[i].state);
  }
  QStringList findings;
  for (std::size_t i = view.findings.size(); i-- > 0 && std::size_t(findings.size()) < kFindingsShown;)
    if (standing != i) findings << errorText(procedure, view, i);
  bool other = write(*findings_, findings.join(QStringLiteral("<br>")));
  if (!withSteps) {
    due = view.findings.empty() ? QObject::tr("No errors so far.") : QString();
    before.clear(), after.clear();
  }
  other |= write(*steps_, before.join(QStringLiteral("<br>")));
  other |= write(*say_, due);
  // The sign is that of the mark on the control.
  other |= write(*act_, withSteps ? colored(QStringLiteral("▼"), views::theme::kAccent) + QStringLiteral("&nbsp; ") +
                                        act.toHtmlEscaped()
                                  : QString());
  other |= write(*later_, after.join(QStringLiteral("<br>")));
  return other;
}

}  // namespace insonate::train
