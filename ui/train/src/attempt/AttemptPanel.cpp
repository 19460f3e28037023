#include "AttemptPanel.h"

#include "../model/CaseModel.h"
#include "../model/Disclosure.h"
#include "../model/HapticControl.h"
#include "../model/ImagingModel.h"
#include "../model/LiveModel.h"
#include "AttemptControl.h"
#include "AttemptWords.h"
#include "StepAct.h"
#include "StepList.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/StateColors.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QGridLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::train {
namespace {

using State = AttemptControl::State;

/// Beside those of the strip, which has no room for the time where the window is narrow.
constexpr Metric kFurther[] = {Metric::TimeToVein, Metric::Passes,        Metric::Redirections,  Metric::InsertionAngle,
                               Metric::TipInImage, Metric::NearestArtery, Metric::ProbeForceMost};

QVBoxLayout* pageColumn(QWidget* widget) {
  auto* box = new QVBoxLayout(widget);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(ui::kSmallGap);
  return box;
}

QComboBox* attemptChoice(const char* object, const QString& name, const QString& says) {
  auto* combo = ui::choiceBox(object, name, says, Qt::TabFocus);
  combo->setMinimumContentsLength(6);
  return combo;
}

}  // namespace

AttemptPanel::AttemptPanel(DisclosureModel& disclosure, HapticControl& hands, CaseModel& patientCase,
                           ImagingModel& imaging, LiveModel& live, AttemptControl& attempt,
                           const ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      disclosure_(disclosure),
      hands_(hands),
      patientCase_(patientCase),
      imaging_(imaging),
      live_(live),
      attempt_(attempt),
      commands_(commands) {
  setObjectName("attemptPanel");
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(12, 8, 12, 8);
  box->setSpacing(ui::kSmallGap);
  head_ = ui::paragraph("attemptHead", "heading");
  box->addWidget(head_);
  for (QWidget* page : {begin_ = buildBegin(), running_ = buildRunning(), result_ = buildResult()})
    box->addWidget(page);
  connect(&attempt_, &AttemptControl::begun, this, [this] { standing_.reset(); });
  connect(&attempt_, &AttemptControl::stateChanged, this, [this] { refresh(); });
  connect(&attempt_, &AttemptControl::viewChanged, this, [this] { refreshRunning(); });
  connect(&attempt_, &AttemptControl::aspiratingChanged, this, [this] { draw_->setChecked(attempt_.isAspirating()); });
  connect(&patientCase_, &CaseModel::caseChanged, this, [this] { refreshBegin(); });
  connect(&patientCase_, &CaseModel::structuresKnown, this, [this] { refreshBegin(); });
  connect(&live_, &LiveModel::pictureShown, this, [this] {
    const bool waits = attempt_.state() == State::Idle && !start_->isEnabled() && unfit_->text().isEmpty();
    if (waits) refreshBegin();
  });
  connect(&imaging_, &ImagingModel::tissueChanged, this, [this] { refreshRunning(); });
  refresh();
}

QPushButton* AttemptPanel::button(const char* object, const QString& text, const QString& says) {
  auto* made = ui::pushButton(object, text, says, Qt::TabFocus);
  return made;
}

QWidget* AttemptPanel::buildBegin() {
  auto* page = new QWidget;
  auto* box = beginBox_ = pageColumn(page);
  procedure_ = attemptChoice("attemptProcedure", tr("Procedure"), tr("The steps of the procedure"));
  for (const Procedure& one : attempt_.procedures()) {
    procedure_->addItem(QString::fromStdString(one.title), QString::fromStdString(one.name));
    procedure_->setItemData(procedure_->count() - 1, QString::fromStdString(one.title), Qt::ToolTipRole);
  }
  assistance_ = attemptChoice("attemptAssistance", tr("Assistance"),
                              tr("Guided: the panel states each step and each error. Hints: the panel states errors "
                                 "only. Test: CT and anatomy are hidden until the attempt ends"));
  for (const Assistance one : {Assistance::Guided, Assistance::Hints, Assistance::Test})
    assistance_->addItem(assistanceText(one), int(one));
  start_ =
      button("attemptStart", tr("Start"),
             commands_.toolTip(tr("Begins an attempt, which is recorded and scored"), "train.attempt.startOrFinish"));
  ui::setRole(start_, "primary");
  auto* row = new QHBoxLayout;
  row->setSpacing(ui::kSmallGap);
  row->addWidget(assistance_, 1);
  row->addWidget(start_, 1);
  unfit_ = ui::paragraph("attemptUnfit", "problem");
  box->addWidget(procedure_);
  box->addWidget(unfit_);
  box->addLayout(row);
  connect(procedure_, qOverload<int>(&QComboBox::activated), this,
          [this] { attempt_.choose(procedure_->currentData().toString().toStdString()); });
  connect(assistance_, qOverload<int>(&QComboBox::activated), this,
          [this] { attempt_.setAssistance(Assistance(assistance_->currentData().toInt())); });
  connect(start_, &QPushButton::clicked, &attempt_, &AttemptControl::start);
  return page;
}

QWidget* AttemptPanel::buildHands() {
  auto* page = new QWidget;
  auto* grid = new QGridLayout(page);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(ui::kSmallGap);
  position_ = attemptChoice("attemptPosition", tr("Position of the patient"),
                            tr("Tilt of the table in degrees; positive: head down"));
  draw_ = button("attemptDraw", tr("Aspirate"), commands_.toolTip("train.attempt.aspirate"));
  draw_->setCheckable(true);
  auto* fresh = button("attemptNewNeedle", tr("New needle"), commands_.toolTip("train.attempt.newNeedle"));
  grid->addWidget(position_, 0, 0, 1, 2);
  grid->addWidget(draw_, 1, 0);
  grid->addWidget(fresh, 1, 1);
  connect(position_, qOverload<int>(&QComboBox::activated), this,
          [this] { imaging_.setTilt(position_->currentData().toDouble()); });
  connect(draw_, &QPushButton::clicked, &attempt_, &AttemptControl::setAspirating);
  connect(fresh, &QPushButton::clicked, &attempt_, &AttemptControl::replaceNeedle);
  return page;
}

QWidget* AttemptPanel::buildStanding() {
  standingBox_ = new QWidget;
  auto* row = new QHBoxLayout(standingBox_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kSmallGap);
  standingText_ = ui::paragraph("attemptStanding");
  standingText_->setTextFormat(Qt::RichText);
  auto* dismiss =
      ui::named(new QToolButton, "attemptDismiss", tr("Dismiss"), commands_.toolTip("train.attempt.dismiss"));
  dismiss->setText(QStringLiteral("✕"));
  dismiss->setFocusPolicy(Qt::TabFocus);
  row->addWidget(standingText_, 1);
  row->addWidget(dismiss, 0, Qt::AlignTop);
  connect(dismiss, &QToolButton::clicked, this, &AttemptPanel::dismissError);
  return standingBox_;
}

QWidget* AttemptPanel::buildRunning() {
  auto* page = new QWidget;
  auto* box = pageColumn(page);
  box->addWidget(buildStanding());
  auto* inner = new QWidget;
  auto* told = pageColumn(inner);
  steps_ = new StepList;
  numbers_ = ui::paragraph("attemptNumbers", "");
  numbers_->setTextFormat(Qt::RichText);
  numbers_->setToolTip(tr("More metrics of the attempt in progress"));
  told->addWidget(steps_);
  told->addWidget(numbers_);
  scroll_ = new QScrollArea;
  scroll_->setObjectName("attemptMessages");
  scroll_->setWidget(inner);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  box->addWidget(scroll_);
  guideOptions_ = new QWidget;
  pageColumn(guideOptions_);
  box->addWidget(guideOptions_);
  box->addWidget(buildHands());
  auto* row = new QHBoxLayout;
  row->setSpacing(ui::kSmallGap);
  auto* finish = button("attemptFinish", tr("Finish"),
                        commands_.toolTip(tr("Ends the attempt and shows its result"), "train.attempt.startOrFinish"));
  auto* again = button("attemptAgain", tr("Again"), tr("Abandons this attempt and starts another"));
  auto* abandon = button("attemptAbandon", tr("Abandon"), tr("Ends this attempt and saves it as abandoned"));
  for (QPushButton* one : {finish, again, abandon}) row->addWidget(one, 1);
  box->addLayout(row);
  connect(finish, &QPushButton::clicked, &attempt_, &AttemptControl::finish);
  connect(again, &QPushButton::clicked, &attempt_, &AttemptControl::startAgain);
  connect(abandon, &QPushButton::clicked, &attempt_, &AttemptControl::abandon);
  return page;
}

QWidget* AttemptPanel::buildResult() {
  auto* page = new QWidget;
  auto* box = resultBox_ = pageColumn(page);
  headline_ = ui::paragraph("attemptHeadline", "title");
  advice_ = ui::paragraph("attemptAdvice", "");
  errors_ = ui::paragraph("attemptErrors", "");
  errors_->setTextFormat(Qt::RichText);
  for (QLabel* one : {headline_, errors_, advice_}) box->addWidget(one);
  review_ =
      button("attemptReview", tr("Open attempt in Review"), tr("Replays this attempt, with its events and metrics"));
  ui::setRole(review_, "primary");
  box->addWidget(review_);
  auto* row = resultButtons_ = new QHBoxLayout;
  row->setSpacing(ui::kSmallGap);
  auto* again = button("attemptNext", tr("New attempt"), tr("Starts another attempt at the same procedure"));
  auto* leave = button("attemptLeave", tr("Close"), tr("Returns to free scanning; the attempt is saved"));
  row->addWidget(again, 1);
  row->addWidget(leave, 1);
  box->addLayout(row);
  connect(review_, &QPushButton::clicked, this, [this] { Q_EMIT reviewRequested(attempt_.file()); });
  connect(again, &QPushButton::clicked, &attempt_, &AttemptControl::startAgain);
  connect(leave, &QPushButton::clicked, &attempt_, &AttemptControl::leave);
  return page;
}

void AttemptPanel::refresh() {
  const State state = attempt_.state();
  begin_->setVisible(state == State::Idle || state == State::Starting);
  running_->setVisible(state == State::Running || state == State::Writing);
  running_->setEnabled(state == State::Running);
  result_->setVisible(state == State::Over);
  refreshBegin();
  if (state == State::Running) {
    position_->clear();
    for (const PatientPosition& one : attempt_.procedure().positions)
      position_->addItem(QString::fromStdString(one.name), one.tilt_deg);
  }
  refreshRunning();
  if (state == State::Over) refreshResult();
  fit();
}

void AttemptPanel::refreshBegin() {
  procedure_->setCurrentIndex(procedure_->findData(QString::fromStdString(attempt_.procedure().name)));
  assistance_->setCurrentIndex(assistance_->findData(int(attempt_.assistance())));
  for (QWidget* one : {procedure_, assistance_}) one->setVisible(!isProcedureFixed_);
  const QString unfit = attempt_.unfit();
  unfit_->setText(unfit);
  unfit_->setVisible(!unfit.isEmpty());
  start_->setEnabled(live_.shown() && patientCase_.structures() && unfit.isEmpty() && attempt_.state() == State::Idle);
  start_->setText(attempt_.state() == State::Starting ? tr("Starting ...") : tr("Start"));
}

void AttemptPanel::refreshRunning() {
  const AttemptView& view = attempt_.view();
  const State state = attempt_.state();
  const QString procedure = QString::fromStdString(attempt_.procedure().title);
  const Disclosure& told = disclosure_.current();
  if (state == State::Idle || state == State::Starting) head_->setText(tr("Attempt"));
  if (state == State::Over || state == State::Writing) head_->setText(tr("Attempt, %1").arg(clockOf(view.time_s)));
  const bool isGuided = state == State::Running && told.steps;
  const StepAct act =
      isGuided ? nextAct(attempt_.procedure(), view, handsNow(hands_, live_, attempt_.isAspirating()), commands_)
               : StepAct();
  Q_EMIT actControlNamed(act.control);
  if (state != State::Running) return;
  const std::size_t step = view.nextStep ? *view.nextStep + 1 : view.steps.size();
  head_->setText(told.steps ? tr("Step %1 of %2, %3").arg(step).arg(view.steps.size()).arg(clockOf(view.time_s))
                            : tr("%1, %2").arg(capital(assistanceText(attempt_.assistance())), clockOf(view.time_s)));
  head_->setToolTip(told.anatomy ? procedure : QString());
  scroll_->setVisible(told.findings);
  guideOptions_->setVisible(told.steps);
  const bool otherStanding = refreshStanding();
  const double tilt_deg = imaging_.tissue().body.tilt_deg;
  position_->setCurrentIndex(position_->findData(tilt_deg));
  if (!told.findings) return fit();
  const bool other =
      steps_->show(attempt_.procedure(), view, told.steps, act.words, standing_.find(attempt_.procedure(), view));
  numbers_->setVisible(told.steps);
  if (told.steps) refreshNumbers();
  if (!other && !otherStanding) return;
  fit();
  // After the layout.
  if (told.steps) QTimer::singleShot(0, this, [this] { scrollToDueStep(); });
}

void AttemptPanel::scrollToDueStep() {
  const QRect due = steps_->dueRows();
  const int height_px = scroll_->viewport()->height();
  QScrollBar& bar = *scroll_->verticalScrollBar();
  if (steps_->height() <= height_px) return bar.setValue(0);
  // A due step that is higher than the panel is shown from its beginning.
  bar.setValue(std::min(due.top(), std::max(bar.value(), due.bottom() + 1 - height_px)));
}

/// Returns whether the standing error is another one than before.
bool AttemptPanel::refreshStanding() {
  const Procedure& procedure = attempt_.procedure();
  const auto standing = standing_.find(procedure, attempt_.view());
  const bool isShown = standing && disclosure_.current().findings;
  const QString words = isShown ? errorText(procedure, attempt_.view(), *standing) : QString();
  standingBox_->setVisible(isShown);
  if (standingText_->text() == words) return false;
  standingText_->setText(words);
  return true;
}

void AttemptPanel::dismissError() {
  const auto standing = standing_.find(attempt_.procedure(), attempt_.view());
  if (!standing || !disclosure_.current().findings) return;
  standing_.dismiss(*standing);
  refreshRunning();
}

void AttemptPanel::refreshNumbers() {
  QString rows;
  for (const Metric metric : kFurther)
    rows += QStringLiteral("<tr><td>%1</td><td align='right'>&nbsp;&nbsp;%2</td></tr>")
                .arg(ui::titleOf(metric).toHtmlEscaped(), ui::valueOf(metric, attempt_.view().metrics[metric]));
  const QString table = QStringLiteral("<table width='100%' cellspacing='0'>%1</table>").arg(rows);
  if (numbers_->text() != table) numbers_->setText(table);
}

void AttemptPanel::refreshResult() {
  const AttemptScore& score = attempt_.score();
  headline_->setText(headlineOf(score, attempt_.status()));
  advice_->setText(QString::fromStdString(score.advice));
  advice_->setVisible(!score.advice.empty());
  QStringList errors;
  for (const AttemptMoment& moment : score.criticalErrors)
    errors << QStringLiteral("<span style='color:%1'>▲</span>&nbsp; <b>%2, %3.</b> %4")
                  .arg(ui::toQColor(ui::colorOf(Severity::Critical)).name(), capital(ui::nameOf(Severity::Critical)),
                       clockOf(double(moment.time_us) * 1e-6),
                       QString::fromStdString(moment.description).toHtmlEscaped());
  errors_->setText(errors.join(QStringLiteral("<br>")));
  errors_->setVisible(!errors.isEmpty());
  review_->setEnabled(!attempt_.file().isEmpty());
}

void AttemptPanel::addCard(QWidget* card) {
  beginBox_->insertWidget(0, card);
  // Tab goes from the card to the choice under it.
  QWidget* last = card;
  for (QPushButton* one : card->findChildren<QPushButton*>()) last = one;
  for (QWidget* next :
       {static_cast<QWidget*>(procedure_), static_cast<QWidget*>(assistance_), static_cast<QWidget*>(start_)}) {
    setTabOrder(last, next);
    last = next;
  }
}

void AttemptPanel::addToResult(QWidget* verdict, QWidget* button) {
  resultBox_->insertWidget(resultBox_->indexOf(advice_), verdict);
  resultButtons_->insertWidget(1, button, 1);
  setTabOrder(resultButtons_->itemAt(0)->widget(), button);
}

void AttemptPanel::addGuideOption(QWidget* option) {
  guideOptions_->layout()->addWidget(option);
}

void AttemptPanel::setProcedureFixed(bool isFixed) {
  isProcedureFixed_ = isFixed;
  refreshBegin();
}

void AttemptPanel::setMostHeight(int max_px) {
  if (std::exchange(max_px_, max_px) != max_px) fit();
}

void AttemptPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fit();
}

/// Gives the messages the height that they need at this width, as far as head and buttons leave room.
void AttemptPanel::fit() {
  QWidget* inner = scroll_->widget();
  const int width_px = width() - 24, needs_px = std::max(inner->layout()->heightForWidth(width_px), 40);
  scroll_->setFixedHeight(std::min(needs_px, std::max(80, max_px_ - besideMessages_px(width_px))));
}

/// Height of everything beside the messages while an attempt runs.
int AttemptPanel::besideMessages_px(int width_px) const {
  const QMargins margins = layout()->contentsMargins();
  int height_px = margins.top() + head_->heightForWidth(width_px) + ui::kSmallGap + margins.bottom();
  const QLayout& rows = *running_->layout();
  for (int i = 0; i < rows.count(); ++i) {
    QLayoutItem& row = *rows.itemAt(i);
    if (row.isEmpty() || row.widget() == scroll_) continue;
    // The layout does not know the error's new height yet.
    const bool isStanding = row.widget() == standingBox_;
    height_px +=
        ui::kSmallGap + (isStanding ? standingBox_->layout()->heightForWidth(width_px) : row.sizeHint().height());
  }
  return height_px;
}

}  // namespace insonate::train
