#include "LevelForm.h"

#include "MasteryEditor.h"
#include "StandardsEditor.h"

#include <insonate/procedure/Procedure.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::ui {
namespace {

constexpr int kAbout_px = 58, kPrerequisites_px = 96;

QString procedureTitle(const std::string& name) {
  const auto procedure = builtInProcedure(name);
  return qt(procedure ? procedure->title : name);
}

/// An unknown value stays visible until another one is selected.
void choose(QComboBox& box, const QString& value) {
  int at = box.findData(value);
  if (at < 0) {
    box.addItem(value.isEmpty() ? LevelForm::tr("choose one") : LevelForm::tr("%1 (not available)").arg(value), value);
    at = box.count() - 1;
  }
  box.setCurrentIndex(at);
}

QComboBox* choice() {
  auto* box = new QComboBox;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  return box;
}

}  // namespace

LevelForm::LevelForm(const TeachingNames& known, QWidget* parent)
    : QWidget(parent),
      known_(known),
      title_(new QLineEdit),
      about_(new QPlainTextEdit),
      case_(choice()),
      procedure_(choice()),
      position_(choice()),
      assistance_(choice()),
      prerequisites_(new QListWidget),
      standards_(new StandardsEditor(known.metrics)),
      mastery_(new MasteryEditor) {
  auto* form = new QFormLayout;
  form->setVerticalSpacing(kGap);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  buildNames(*form);
  buildSetting(*form);
  const auto heading = [](const QString& words) {
    auto* label = new QLabel(words);
    setRole(label, "heading");
    return label;
  };
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, kGap, 0);
  box->setSpacing(kGap);
  box->addLayout(form);
  box->addSpacing(kGap);
  box->addWidget(heading(tr("Requirements for passing an attempt")));
  box->addWidget(standards_);
  box->addSpacing(kGap);
  box->addWidget(heading(tr("Mastering the level")));
  box->addWidget(mastery_);
  box->addStretch(1);
  connect(standards_, &StandardsEditor::edited, this, &LevelForm::edited);
  connect(mastery_, &MasteryEditor::edited, this, &LevelForm::edited);
}

void LevelForm::buildNames(QFormLayout& form) {
  named(title_, "levelEditTitle", tr("Title"), tr("Title of the level that trainees see"));
  connect(title_, &QLineEdit::textEdited, this, [this](const QString& text) {
    Q_EMIT edited(QStringLiteral("title"), [text](Level& level) { level.title = text.toStdString(); });
  });
  named(about_, "levelEditAbout", tr("About"), tr("Learning goal of the level, in one or two sentences"));
  about_->setTabChangesFocus(true);
  about_->setFixedHeight(kAbout_px);
  connect(about_, &QPlainTextEdit::textChanged, this, [this] {
    Q_EMIT edited(QStringLiteral("about"),
                  [text = about_->toPlainText()](Level& level) { level.about = text.toStdString(); });
  });
  named(prerequisites_, "levelEditNeeds", tr("Prerequisites"),
        tr("The level stays locked until the ticked levels are mastered (Space ticks or unticks a level)"));
  prerequisites_->setFixedHeight(kPrerequisites_px);
  connect(prerequisites_, &QListWidget::itemChanged, this, [this] {
    std::vector<std::string> needed;
    for (int row = 0; row < prerequisites_->count(); ++row)
      if (const QListWidgetItem* item = prerequisites_->item(row); item->checkState() == Qt::Checked)
        needed.push_back(item->data(Qt::UserRole).toString().toStdString());
    Q_EMIT edited({}, [needed](Level& level) { level.prerequisites = needed; });
  });
  form.addRow(tr("Title"), title_);
  form.addRow(tr("About"), about_);
  form.addRow(tr("Requires"), prerequisites_);
}

void LevelForm::addChoice(QComboBox* box, std::string Level::*member) {
  connect(box, QOverload<int>::of(&QComboBox::activated), this, [this, box, member] {
    const std::string value = box->currentData().toString().toStdString();
    Q_EMIT edited({}, [value, member](Level& level) { level.*member = value; });
  });
}

void LevelForm::buildSetting(QFormLayout& form) {
  named(case_, "levelEditCase", tr("Case"),
        tr("Case of the level: a built-in case, a case that was opened on this computer, or a case in a folder of the "
           "case library"));
  named(procedure_, "levelEditProcedure", tr("Procedure"),
        tr("Procedure that the trainee practices and that determines steps, rules and metrics"));
  named(position_, "levelEditPosition", tr("Position"), tr("Position of the patient when an attempt begins"));
  named(assistance_, "levelEditAssistance", tr("Assistance"), tr("Amount of help during an attempt"));
  assistance_->addItems(
      {tr("guided: states each step, shows hints and CT"), tr("hints: states errors only"), tr("test: no help")});
  addChoice(case_, &Level::caseName);
  addChoice(position_, &Level::position);
  connect(procedure_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    const std::string chosen = procedure_->currentData().toString().toStdString();
    const auto known = std::ranges::find(known_.procedures, chosen, &TeachingNames::Procedure::name);
    if (known == known_.procedures.end()) return;
    Q_EMIT edited({}, [one = *known](Level& level) {
      level.procedure = one.name;
      if (std::ranges::find(one.positions, level.position) == one.positions.end()) level.position.clear();
    });
  });
  connect(assistance_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int at) { Q_EMIT edited({}, [at](Level& level) { level.assistance = Assistance(at); }); });
  form.addRow(tr("Case"), case_);
  form.addRow(tr("Procedure"), procedure_);
  form.addRow(tr("Position"), position_);
  form.addRow(tr("Assistance"), assistance_);
}

void LevelForm::showPlace(const Level& level) {
  case_->clear(), procedure_->clear(), position_->clear();
  for (const std::string& name : known_.cases) case_->addItem(builtInTitle(qt(name)), qt(name));
  for (const auto& one : known_.procedures) procedure_->addItem(procedureTitle(one.name), qt(one.name));
  position_->addItem(tr("chosen by the trainee"), QString());
  const auto procedure = std::ranges::find(known_.procedures, level.procedure, &TeachingNames::Procedure::name);
  if (procedure != known_.procedures.end())
    for (const std::string& name : procedure->positions) position_->addItem(qt(name), qt(name));
  choose(*case_, qt(level.caseName));
  choose(*procedure_, qt(level.procedure));
  choose(*position_, qt(level.position));
  assistance_->setCurrentIndex(int(level.assistance));
}

void LevelForm::showPrerequisites(const Curriculum& curriculum, const Level& level) {
  const QSignalBlocker quiet(prerequisites_);
  std::vector<const Level*> others;
  for (const Level& other : curriculum.levels)
    if (other.name != level.name) others.push_back(&other);
  // The items stay, so that the list keeps its place when one is checked.
  while (prerequisites_->count() > int(others.size())) delete prerequisites_->takeItem(prerequisites_->count() - 1);
  while (prerequisites_->count() < int(others.size())) prerequisites_->addItem(new QListWidgetItem);
  for (int row = 0; row < prerequisites_->count(); ++row) {
    const Level& other = *others[std::size_t(row)];
    QListWidgetItem* item = prerequisites_->item(row);
    item->setText(qt(other.title.empty() ? other.name : other.title));
    item->setData(Qt::UserRole, qt(other.name));
    const bool needed = std::ranges::find(level.prerequisites, other.name) != level.prerequisites.end();
    item->setCheckState(needed ? Qt::Checked : Qt::Unchecked);
  }
  if (prerequisites_->currentRow() < 0) prerequisites_->setCurrentRow(0);
}

void LevelForm::show(const Curriculum& curriculum, const Level& level, bool editable) {
  showText(*title_, qt(level.title));
  if (const QString about = qt(level.about); about_->toPlainText() != about) {
    const QSignalBlocker quiet(about_);
    about_->setPlainText(about);
  }
  showPrerequisites(curriculum, level);
  showPlace(level);
  standards_->show(level.pass);
  mastery_->show(level);
  setEnabled(editable);
}

}  // namespace insonate::ui
