#include "OpeningDialog.h"

#include "../class/ClassController.h"
#include "../class/ClassWords.h"
#include "OpeningWords.h"

#include <insonate/teaching/OverlappingOpening.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::review {
namespace {

constexpr int kTable_px = 760, kTable_rows_px = 190, kUsualLength_s = 2 * 60 * 60, kLongestCode = 32;
enum OpeningColumn { kOpeningState, kTest, kWhom, kStart, kEnd, kCode, kOpenedBy, kOpeningColumns };

QDateTimeEdit* timeField(const char* object, const QString& name, const QString& tip, const QDateTime& time) {
  auto* field = ui::named(new QDateTimeEdit(time), object, name, tip);
  field->setDisplayFormat(QStringLiteral("d MMM yyyy  HH:mm"));
  field->setCalendarPopup(true);
  return field;
}

std::int64_t timeIn(const QDateTimeEdit& field) {
  return field.dateTime().toMSecsSinceEpoch() * 1000;
}

}  // namespace

OpeningDialog::OpeningDialog(ClassController& controller, QWidget* parent)
    : QDialog(parent),
      controller_(controller),
      cohort_(controller.facts()->cohort.id),
      openings_(new QTableWidget),
      test_(ui::choiceBox("openingTest", tr("Test"), tr("Test to open"))),
      whom_(ui::choiceBox("openingWhom", tr("Open to"), tr("People who may take the test"))),
      ends_(new QCheckBox(tr("End"))),
      code_(new QLineEdit),
      open_(new QPushButton(tr("Open test"))),
      close_(ui::pushButton("openingClose", tr("Close test"),
                            tr("Closes the selected test now; attempts that have begun still count"))),
      ready_(ui::paragraph("openingReady", "quiet")),
      said_(ui::paragraph("openingSaid")) {
  setObjectName(QStringLiteral("openingDialog"));
  setAttribute(Qt::WA_DeleteOnClose);
  const QString name = QString::fromStdString(controller_.facts()->cohort.name);
  setWindowTitle(tr("Tests of %1").arg(name));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  column->setSpacing(ui::kGap);
  column->addWidget(ui::paragraph(
      "openingAbout", "quiet",
      tr("An attempt at a test counts only if the test is open when the attempt begins. Otherwise the attempt is "
         "practice. You can open a test for a period of time, for trainees who enter a code, or for both together.")));
  column->addWidget(buildTable(), 1);
  column->addWidget(buildForm());
  column->addWidget(said_);
  column->addWidget(buildButtons());
  connect(&controller_, &ClassController::classChanged, this, [this] { refresh(); });
  refresh();
  edited();
  readReadiness();
  if (controller_.facts()->cohort.archived)
    said_->setText(
        tr("The class is archived: its tests cannot be opened. An administrator can restore the class under "
           "People and classes."));
}

QWidget* OpeningDialog::buildTable() {
  ui::named(openings_, "openings", tr("Opened tests, newest first"), tr("Opened tests, newest first"));
  openings_->setColumnCount(kOpeningColumns);
  openings_->setHorizontalHeaderLabels(
      {tr("State"), tr("Test"), tr("Open to"), tr("Start"), tr("End"), tr("Code"), tr("Opened by")});
  openings_->setSelectionBehavior(QAbstractItemView::SelectRows);
  openings_->setSelectionMode(QAbstractItemView::SingleSelection);
  openings_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  openings_->setTabKeyNavigation(false);
  openings_->setShowGrid(false);
  openings_->verticalHeader()->hide();
  openings_->horizontalHeader()->setHighlightSections(false);
  openings_->setMinimumSize(kTable_px, kTable_rows_px);
  connect(openings_, &QTableWidget::currentCellChanged, this, [this] { showChosen(); });
  return openings_;
}

QWidget* OpeningDialog::buildForm() {
  const ClassFacts& facts = *controller_.facts();
  for (const Level& level : facts.curriculum->levels)
    if (level.assistance == Assistance::Test)
      test_->addItem(QString::fromStdString(level.title), QString::fromStdString(level.name));
  whom_->addItem(tr("the class %1").arg(QString::fromStdString(facts.cohort.name)));
  if (controller_.administers()) whom_->addItem(tr("everyone"));
  const QDateTime now = QDateTime::currentDateTime();
  start_ = timeField("openingStart", tr("Start"),
                     tr("Start of the time in which attempts count; if this time is past, the test opens now"), now);
  end_ = timeField("openingEnd", tr("End"),
                   tr("End of the time in which attempts count; attempts that begin later are practice"),
                   now.addSecs(kUsualLength_s));
  ui::named(ends_, "openingEnds", tr("End"),
            tr("A test without an end time needs a code that trainees enter, and stays open until you close the test"));
  ends_->setChecked(true);
  connect(ends_, &QCheckBox::toggled, end_, &QWidget::setEnabled);
  ui::named(code_, "openingCode", tr("Code"), tr("Trainees enter the code before their first attempt"));
  code_->setPlaceholderText(tr("optional: trainees enter this code"));
  code_->setMaxLength(kLongestCode);
  auto* part = new QWidget;
  auto* form = new QFormLayout(part);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(ui::kSmallGap);
  for (QComboBox* one : {test_, whom_})
    connect(one, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] { edited(); });
  for (QDateTimeEdit* one : {start_, end_}) connect(one, &QDateTimeEdit::dateTimeChanged, this, [this] { edited(); });
  connect(code_, &QLineEdit::textEdited, this, [this] { edited(); });
  form->addRow(tr("Test"), test_);
  form->addRow(ready_);
  form->addRow(tr("Open to"), whom_);
  form->addRow(tr("Start"), start_);
  form->addRow(ends_, end_);
  form->addRow(tr("Code"), code_);
  return part;
}

QWidget* OpeningDialog::buildButtons() {
  open_->setObjectName(QStringLiteral("openingOpen"));
  open_->setToolTip(tr("Opens the test at its start (Enter)"));
  open_->setAutoDefault(false);  // else a click on another button and back would make it the default again
  open_->setDefault(true);
  ui::setRole(open_, "primary");
  auto* done = ui::pushButton("openingDone", tr("Done"), tr("Back to the class (Esc)"));
  connect(open_, &QPushButton::clicked, this, [this] { openTest(); });
  connect(close_, &QPushButton::clicked, this, [this] { closeTest(); });
  connect(done, &QPushButton::clicked, this, &QDialog::reject);
  auto* part = new QWidget;
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  row->addWidget(close_);
  row->addStretch(1);
  row->addWidget(done);
  row->addWidget(open_);
  return part;
}

void OpeningDialog::refresh() {
  const ClassFacts* facts = controller_.facts();
  // Another class, or another user: the openings that are shown here are no longer those of the page.
  if (!facts || facts->cohort.id != cohort_ || !facts->curriculum) return reject();
  const int before = openings_->currentRow();
  openings_->setRowCount(int(facts->openings.size()));
  for (int row = 0; row < openings_->rowCount(); ++row) {
    const TestOpening& one = facts->openings[std::size_t(row)];
    const OpeningState state = stateAt(one, facts->read_us);
    const auto set = [&](int column, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(plainToolTip(text));
      openings_->setItem(row, column, item);
    };
    set(kOpeningState, signedWordOf(state));
    set(kTest, levelTitle(&*facts->curriculum, one.level));
    set(kWhom, one.cohort.empty() ? tr("everyone") : tr("the class"));
    set(kStart, ui::dayAndTimeOf(one.start_us));
    set(kEnd, one.closed_us ? tr("closed %1").arg(ui::dayAndTimeOf(*one.closed_us))
              : one.end_us  ? ui::dayAndTimeOf(*one.end_us)
                            : tr("none"));
    const QString code = controller_.codeOf(one.id);
    set(kCode, !one.hasCode ? tr("no") : code.isEmpty() ? tr("yes") : code);
    if (one.hasCode && code.isEmpty())
      openings_->item(row, kCode)
          ->setToolTip(
              tr("The code is shown only to the instructor who has opened the test, until this instructor signs "
                 "out. If the code is lost, close the test and open it with another code."));
    set(kOpenedBy, QString::fromStdString(one.openedBy));
  }
  openings_->resizeColumnsToContents();
  openings_->setMinimumWidth(std::max(kTable_px, openings_->horizontalHeader()->length() + 2 * openings_->frameWidth() +
                                                     openings_->verticalScrollBar()->sizeHint().width()));
  openings_->setCurrentCell(std::min(std::max(before, 0), openings_->rowCount() - 1), kOpeningState);
  showChosen();
}

const TestOpening* OpeningDialog::chosen() const {
  const ClassFacts* facts = controller_.facts();
  const int row = openings_->currentRow();
  return facts && row >= 0 && row < int(facts->openings.size()) ? &facts->openings[std::size_t(row)] : nullptr;
}

void OpeningDialog::showChosen() {
  isCloseAsked_ = false;
  close_->setText(tr("Close test"));
  const TestOpening* one = chosen();
  const OpeningState state = one ? stateAt(*one, controller_.facts()->read_us) : OpeningState::Ended;
  close_->setEnabled((state == OpeningState::Open || state == OpeningState::Waiting) &&
                     (controller_.administers() || !one->cohort.empty()));
}

NewOpening OpeningDialog::entered() const {
  const bool isForAll = whom_->currentIndex() == 1;
  NewOpening opening{.cohort = isForAll ? std::string() : cohort_,
                     .curriculum = controller_.facts()->curriculum->name,
                     .level = test_->currentData().toString().toStdString(),
                     .start_us = timeIn(*start_),
                     .code = code_->text().toStdString()};
  if (ends_->isChecked()) opening.end_us = timeIn(*end_);
  return opening;
}

const TestOpening* OpeningDialog::sameOpening(const NewOpening& opening) const {
  return overlappingOpening(controller_.facts()->openings, opening, QDateTime::currentMSecsSinceEpoch() * 1000);
}

void OpeningDialog::readReadiness() {
  controller_.account()->query<std::map<std::string, int>>(
      this, [facts = *controller_.facts()](const SignedIn& by) { return testReadiness(by, facts); },
      [this](Result<std::map<std::string, int>> readiness) {
        if (!readiness) return said_->setText(QStringLiteral("▲ ") + QString::fromStdString(readiness.error().message));
        readiness_ = std::move(*readiness);
        showReadiness();
      });
}

void OpeningDialog::showReadiness() {
  const auto found = readiness_.find(test_->currentData().toString().toStdString());
  const ClassFacts* facts = controller_.facts();
  if (found == readiness_.end() || !facts) return ready_->clear();
  const QString words = readinessWords(*facts, found->second);
  ready_->setText(found->second > 0
                      ? tr("Trainees of the class: %1 now.").arg(words)
                      : tr("▲ Trainees of the class: %1 now, since each of them still has to master a level "
                           "that this test requires.")
                            .arg(words));
  layout()->activate();
  resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
}

/// After an opening, Enter opens a test again only if the user has entered something.
void OpeningDialog::edited() {
  isAsked_ = false;
  open_->setText(tr("Open test"));
  open_->setDefault(true);
  open_->setEnabled(mayOpen());
  showReadiness();
}

/// Tests of an archived class cannot be opened, but an administrator can open a test for everyone.
bool OpeningDialog::mayOpen() const {
  const ClassFacts* facts = controller_.facts();
  return facts && (!facts->cohort.archived || whom_->currentIndex() == 1);
}

void OpeningDialog::askAgain(const TestOpening& open) {
  isAsked_ = true;
  open_->setText(tr("Open again"));
  open_->setDefault(false);
  openings_->setFocus();
  said_->setText(
      tr("▲ The test '%1' is open already, or opens during this time%2. If you open it again, each of the two openings "
         "is enough to take the test.")
          .arg(test_->currentText(), open.hasCode ? tr(", with a code") : QString()));
}

void OpeningDialog::openTest() {
  const NewOpening opening = entered();
  if (const TestOpening* open = sameOpening(opening); open && !isAsked_) return askAgain(*open);
  const bool isOpenNow = opening.start_us <= QDateTime::currentMSecsSinceEpoch() * 1000;
  change(
      [opening](const SignedIn& by) -> Result<std::string> {
        const auto opened = OpeningStore(by).open(opening);
        return opened ? Result<std::string>(opened->id) : tl::unexpected(opened.error());
      },
      (isOpenNow ? tr("The test '%1' is open.") : tr("The test '%1' is saved and opens at its start time."))
          .arg(test_->currentText()),
      code_->text());
}

void OpeningDialog::closeTest() {
  const TestOpening* one = chosen();
  if (!one) return;
  if (!std::exchange(isCloseAsked_, true)) {
    close_->setText(tr("Close for good"));
    return said_->setText(tr("A test that was closed cannot be opened again. Press Close for good to close '%1'.")
                              .arg(levelTitle(controller_.curriculum(), one->level)));
  }
  change(
      [cohort = one->cohort, id = one->id](const SignedIn& by) -> Result<std::string> {
        const auto closed = OpeningStore(by).close(cohort, id);
        return closed ? Result<std::string>(id) : tl::unexpected(closed.error());
      },
      tr("The test '%1' is closed. Attempts that have begun still count.")
          .arg(levelTitle(controller_.curriculum(), one->level)));
}

void OpeningDialog::change(std::function<Result<std::string>(const SignedIn&)> change, const QString& done,
                           const QString& code) {
  for (QPushButton* one : {open_, close_}) one->setEnabled(false);
  controller_.account()->query<std::string>(
      this, std::move(change), [this, done, code](const Result<std::string>& changed) {
        open_->setEnabled(mayOpen());
        showChosen();
        said_->setText(changed ? done : QStringLiteral("▲ ") + QString::fromStdString(changed.error().message));
        if (!changed) return;
        if (!code.isEmpty()) controller_.rememberCode(*changed, code);
        code_->clear();
        edited();
        // A second Enter, which comes easily, must not open the test again.
        open_->setDefault(false);
        openings_->setFocus();
        controller_.refresh();
      });
}

}  // namespace insonate::review
