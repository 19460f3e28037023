#include "LevelList.h"

#include "LevelControls.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::ui {
namespace {

constexpr int kSummary_px = 58;

/// "level_3": attempts refer to this name; trainees do not see it.
std::string freshName(const Curriculum& curriculum) {
  for (std::size_t number = curriculum.levels.size() + 1;; ++number)
    if (const std::string name = "level_" + std::to_string(number); !curriculum.level(name)) return name;
}

QString titleOf(const Level& level) {
  return level.title.empty() ? LevelList::tr("a level without a title") : QString::fromStdString(level.title);
}

}  // namespace

LevelList::LevelList(QWidget* parent)
    : QWidget(parent), title_(new QLineEdit), about_(new QPlainTextEdit), list_(new QListWidget) {
  named(title_, "curriculumTitle", tr("Title of the curriculum"), tr("Title of the curriculum that trainees see"));
  title_->setPlaceholderText(tr("Title of the curriculum"));
  named(about_, "curriculumAbout", tr("About the curriculum"), tr("Learning goal of the curriculum; optional"));
  about_->setPlaceholderText(tr("Learning goal; optional"));
  about_->setTabChangesFocus(true);
  about_->setFixedHeight(kSummary_px);
  named(list_, "curriculumLevels", tr("Levels of the curriculum, in order"),
        tr("Ctrl+Up and Ctrl+Down move the selected level in the list"));
  list_->setWordWrap(true);
  add_ = button("levelAdd", tr("Add"), tr("Adds a level at the end of the list"), &LevelList::add);
  copy_ = button("levelCopy", tr("Copy"), tr("Adds a copy of the selected level below it"), &LevelList::copy);
  remove_ = button("levelRemove", tr("Remove"),
                   tr("Removes the selected level, also from the prerequisites of other levels"), &LevelList::remove);
  up_ = button("levelUp", QStringLiteral("↑"), tr("Moves the selected level up in the list (Ctrl+Up)"),
               &LevelList::moveUp);
  down_ = button("levelDown", QStringLiteral("↓"), tr("Moves the selected level down in the list (Ctrl+Down)"),
                 &LevelList::moveDown);
  up_->setAccessibleName(tr("Move level up"));
  down_->setAccessibleName(tr("Move level down"));
  up_->setShortcut(QKeySequence(QStringLiteral("Ctrl+Up")));
  down_->setShortcut(QKeySequence(QStringLiteral("Ctrl+Down")));
  auto* row = new QHBoxLayout;
  row->setSpacing(kSmallGap);
  for (QPushButton* one : {add_, copy_, remove_, up_, down_}) row->addWidget(one);
  auto* heading = new QLabel(tr("Levels"));
  setRole(heading, "heading");
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kGap);
  for (QWidget* one : std::initializer_list<QWidget*>{title_, about_, heading}) box->addWidget(one);
  box->addWidget(list_, 1);
  box->addLayout(row);
  connect(list_, &QListWidget::currentRowChanged, this, [this] {
    refresh();
    Q_EMIT chosenChanged();
  });
  connect(title_, &QLineEdit::textEdited, this, [this](const QString& text) {
    Q_EMIT edited(QStringLiteral("curriculum title"), [text](Curriculum& all) { all.title = text.toStdString(); });
  });
  connect(about_, &QPlainTextEdit::textChanged, this, [this] {
    Q_EMIT edited(QStringLiteral("curriculum about"),
                  [text = about_->toPlainText()](Curriculum& all) { all.about = text.toStdString(); });
  });
}

QPushButton* LevelList::button(const char* object, const QString& words, const QString& tip, void (LevelList::*act)()) {
  auto* made = pushButton(object, words, tip);
  connect(made, &QPushButton::clicked, this, act);
  return made;
}

std::string LevelList::chosen() const {
  const QListWidgetItem* item = list_->currentItem();
  return item ? item->data(Qt::UserRole).toString().toStdString() : std::string();
}

void LevelList::show(const Curriculum& curriculum, const std::vector<DraftError>& errors, bool editable) {
  editable_ = editable;
  showText(*title_, QString::fromStdString(curriculum.title));
  {
    const QSignalBlocker quiet(about_);
    if (const QString about = QString::fromStdString(curriculum.about); about_->toPlainText() != about)
      about_->setPlainText(about);
  }
  const int before = list_->currentRow();
  const std::string name = chosen();
  const QSignalBlocker quiet(list_);
  list_->clear();
  int row = -1;
  for (const Level& level : curriculum.levels) {
    const bool wrong = std::ranges::find(errors, level.name, &DraftError::level) != errors.end();
    const QString sign = wrong ? QStringLiteral("▲  ") : QString();
    auto* item = new QListWidgetItem(QStringLiteral("%1%2.  %3").arg(sign).arg(list_->count() + 1).arg(titleOf(level)));
    item->setData(Qt::UserRole, QString::fromStdString(level.name));
    list_->addItem(item);
    if (level.name == name) row = list_->count() - 1;
  }
  choose(row >= 0 ? row : std::clamp(before, 0, std::max(0, list_->count() - 1)));
}

void LevelList::choose(int row) {
  list_->setCurrentRow(row);
  refresh();
}

void LevelList::refresh() {
  const int row = list_->currentRow();
  title_->setEnabled(editable_);
  about_->setEnabled(editable_);
  add_->setEnabled(editable_);
  copy_->setEnabled(editable_ && row >= 0);
  remove_->setEnabled(editable_ && row >= 0);
  up_->setEnabled(editable_ && row > 0);
  down_->setEnabled(editable_ && row >= 0 && row + 1 < list_->count());
}

void LevelList::add() {
  Q_EMIT edited({}, [](Curriculum& all) {
    Level level{.name = freshName(all)};
    if (!all.levels.empty()) {
      level.procedure = all.levels.back().procedure, level.caseName = all.levels.back().caseName;
      level.prerequisites = {all.levels.back().name};
    }
    all.levels.push_back(std::move(level));
  });
  list_->setCurrentRow(list_->count() - 1);
}

void LevelList::copy() {
  const int row = list_->currentRow();
  Q_EMIT edited({}, [row](Curriculum& all) {
    Level level = all.levels[std::size_t(row)];
    level.name = freshName(all);
    level.title += " (copy)";
    all.levels.insert(all.levels.begin() + row + 1, std::move(level));
  });
  list_->setCurrentRow(row + 1);
}

void LevelList::remove() {
  Q_EMIT edited({}, [name = chosen()](Curriculum& all) {
    std::erase_if(all.levels, [&](const Level& level) { return level.name == name; });
    for (Level& level : all.levels) std::erase(level.prerequisites, name);
  });
  Q_EMIT chosenChanged();
}

void LevelList::move(int by) {
  const int row = list_->currentRow();
  if (row < 0 || row + by < 0 || row + by >= list_->count()) return;
  Q_EMIT edited(
      {}, [row, by](Curriculum& all) { std::swap(all.levels[std::size_t(row)], all.levels[std::size_t(row + by)]); });
}

}  // namespace insonate::ui
