#include "TestEntryDialog.h"

#include "TestAdmissions.h"

#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::train {
namespace {

constexpr int kEntry_px = 420;

}  // namespace

TestEntryDialog::TestEntryDialog(TestAdmissions& admissions, const Level& level, QWidget* parent)
    : QDialog(parent),
      admissions_(admissions),
      level_(level),
      words_(ui::paragraph("testEntryWords")),
      said_(ui::paragraph("testEntrySaid")),
      code_(ui::named(new QLineEdit, "testEntryCode", tr("Code"), tr("Code of the test, from your instructor"))),
      enter_(new QPushButton(tr("Enter Code"))),
      practice_(
          ui::pushButton("testEntryPractice", tr("Practice"),
                         tr("Opens the level for practice; attempts do not count until the test is open for you"))) {
  setObjectName(QStringLiteral("testEntry"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(ui::qt(level_.title));
  words_->setMinimumWidth(kEntry_px);
  code_->setPlaceholderText(tr("Code"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  column->setSpacing(ui::kGap);
  column->addWidget(ui::paragraph("", "title", ui::qt(level_.title)));
  column->addWidget(words_);
  column->addWidget(code_);
  column->addWidget(said_);
  column->addWidget(buildButtons());
  said_->hide();
  connect(&admissions_, &TestAdmissions::changed, this, [this] { refresh(); });
  refresh();
}

QWidget* TestEntryDialog::buildButtons() {
  enter_->setObjectName(QStringLiteral("testEntryGo"));
  enter_->setToolTip(tr("Begins the test with this code (Enter)"));
  ui::setRole(enter_, "primary");
  auto* cancel = ui::pushButton("testEntryCancel", tr("Cancel"), tr("Back to the levels (Esc)"));
  connect(enter_, &QPushButton::clicked, this, [this] { enter(); });
  connect(practice_, &QPushButton::clicked, this, &QDialog::accept);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  auto* part = new QWidget;
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(ui::kGap);
  row->addStretch(1);
  for (QPushButton* one : {cancel, practice_, enter_}) row->addWidget(one);
  return part;
}

/// The test may be opened or closed meanwhile.
void TestEntryDialog::refresh() {
  const auto admission = admissions_.of(level_);
  const bool needsCode = admission && admission->kind == TestAdmission::Kind::NeedsCode;
  const bool isClosed = admission && admission->kind == TestAdmission::Kind::Closed;
  if (admission && !needsCode && !isClosed) return accept();
  words_->setText(admissions_.findingText(level_));
  code_->setVisible(needsCode);
  enter_->setVisible(needsCode);
  enter_->setDefault(needsCode);
  practice_->setDefault(!needsCode);
  (needsCode ? static_cast<QWidget*>(code_) : practice_)->setFocus();
}

/// The right code closes the dialog, by refresh().
void TestEntryDialog::enter() {
  if (code_->text().trimmed().isEmpty()) return code_->setFocus();
  enter_->setEnabled(false);
  admissions_.enterCode(level_.name, code_->text(), [dialog = QPointer(this)](const Result<void>& entered) {
    if (dialog) dialog->answer(entered);
  });
}

void TestEntryDialog::answer(const Result<void>& entered) {
  enter_->setEnabled(true);
  said_->setText(entered ? QString() : QStringLiteral("▲ ") + ui::qt(entered.error().message));
  said_->setVisible(!entered);
  layout()->activate();
  resize(width(), std::max(height(), layout()->totalHeightForWidth(width())));
  code_->selectAll();
}

}  // namespace insonate::train
