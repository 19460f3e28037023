#include "PeopleWindow.h"

#include "RoleWords.h"

#include <insonate/curriculum/PeopleStore.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/NameOrder.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/RowTable.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::ui {
namespace {

constexpr int kPersonRow_px = 28;
enum PersonColumn { kPersonFullName, kPersonName, kPersonEmail, kPersonRole, kPersonState, kPersonColumns };

/// Members of one class, or of all classes, as far as the user may see them.
Result<std::vector<Member>> membersOf(const SignedIn& by, const std::string& cohort) {
  if (!cohort.empty()) return CohortStore(by).members(cohort);
  const auto all = PeopleStore(by).all();
  if (!all) return tl::unexpected(all.error());
  std::vector<Member> members;
  for (const Person& person : *all) members.push_back({.person = person});
  return members;
}

QString textIn(int column, const Person& person, bool teaches) {
  switch (column) {
    case kPersonFullName:
      return qt(person.fullName);
    case kPersonName:
      return qt(person.name);
    case kPersonEmail:
      return qt(person.email);
    case kPersonRole:
      return teaches ? PeopleWindow::tr("%1, teacher").arg(nameOf(person.role)) : nameOf(person.role);
    default:
      return person.disabled ? PeopleWindow::tr("disabled") : QString();
  }
}

/// Sorts by the column that the header shows; people who teach come first if this is the full name.
template <class People>
void sort(People& people, const QHeaderView& header) {
  const int column = header.sortIndicatorSection();
  const QCollator collator = nameCollator();
  const auto isBefore = [&](const auto& a, const auto& b) {
    if (column == kPersonFullName && a.teaches != b.teaches) return a.teaches;
    return collator.compare(textIn(column, a.person, a.teaches), textIn(column, b.person, b.teaches)) < 0;
  };
  const bool descends = header.sortIndicatorOrder() == Qt::DescendingOrder;
  std::ranges::stable_sort(people,
                           [&](const auto& a, const auto& b) { return descends ? isBefore(b, a) : isBefore(a, b); });
}

}  // namespace

PeopleWindow::PeopleWindow(Account& account, QWidget* parent)
    : QDialog(parent),
      account_(account),
      classes_(new QListWidget),
      table_(new QTableWidget(0, kPersonColumns)),
      curriculum_(new QComboBox),
      target_(new QComboBox),
      as_(new QComboBox),
      error_(new QLabel) {
  setWindowTitle(tr("People and classes"));
  setAttribute(Qt::WA_DeleteOnClose);
  error_->setObjectName(QStringLiteral("peopleTrouble"));
  error_->setTextFormat(Qt::PlainText);
  error_->setWordWrap(true);
  error_->hide();
  auto* columns = new QHBoxLayout;
  columns->setSpacing(kLargeGap);
  columns->addWidget(classColumn());
  columns->addWidget(peopleColumn(), 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  column->addWidget(error_);
  column->addLayout(columns, 1);
  resize(1040, 620);
  connect(classes_, &QListWidget::currentRowChanged, this, &PeopleWindow::readPeople);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &PeopleWindow::refresh);
  connect(table_, &QTableWidget::itemActivated, this, &PeopleWindow::editPerson);
  // The next user must not see anything that was read for the former one.
  connect(&account_, &Account::changed, this, [this, whose = account_.person().id] {
    if (account_.person().id != whose) close();
  });
  connect(&account_, &Account::reconnected, this, [this] {
    tell({});
    read();
  });
  refresh();
  read();
}

QPushButton* PeopleWindow::button(const char* name, const QString& words, const QString& tip,
                                  void (PeopleWindow::*act)()) {
  auto* made = pushButton(name, words, tip);
  connect(made, &QPushButton::clicked, this, act);
  return made;
}

QWidget* PeopleWindow::classColumn() {
  auto* side = new QWidget;
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap);
  classes_->setObjectName(QStringLiteral("peopleClasses"));
  classes_->setAccessibleName(tr("Classes"));
  classes_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  classes_->setToolTip(tr("Class whose people are shown"));
  addClass_ = button("peopleAddClass", tr("New class ..."), tr("Makes a class of people who are taught together"),
                     &PeopleWindow::addClass);
  renameClass_ =
      button("peopleRenameClass", tr("Rename ..."), tr("Renames the selected class"), &PeopleWindow::renameClass);
  archive_ = button("peopleArchive", tr("Archive ..."), tr("Archives a class that has ended, or restores it"),
                    &PeopleWindow::archiveClass);
  delete_ = button("peopleDelete", tr("Delete ..."), tr("Deletes the selected class; accounts and attempts stay"),
                   &PeopleWindow::deleteClass);
  curriculum_->setObjectName(QStringLiteral("peopleCurriculum"));
  curriculum_->setAccessibleName(tr("Curriculum of the class"));
  curriculum_->setToolTip(tr("Version of the curriculum by which this class is taught"));
  curriculum_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  connect(curriculum_, QOverload<int>::of(&QComboBox::activated), this, &PeopleWindow::setCurriculum);
  column->addWidget(heading(tr("Classes")));
  column->addWidget(classes_, 1);
  column->addWidget(addClass_);
  for (QPushButton* one : {renameClass_, archive_, delete_}) column->addWidget(one);
  column->addWidget(heading(tr("Curriculum")));
  column->addWidget(curriculum_);
  column->addWidget(button("peopleLevels", tr("Levels ..."),
                           tr("Opens the curricula, to view them or to edit a new version"),
                           &PeopleWindow::editLevels));
  side->setFixedWidth(220);
  return side;
}

QWidget* PeopleWindow::peopleColumn() {
  table_->setObjectName(QStringLiteral("peopleTable"));
  table_->setAccessibleName(tr("People"));
  table_->setToolTip(tr("Press Enter to edit the selected person"));
  table_->setHorizontalHeaderLabels({tr("Full name"), tr("Sign-in name"), tr("E-mail"), tr("Role"), tr("State")});
  makeRowTable(*table_, kPersonRow_px);
  QHeaderView* header = table_->horizontalHeader();
  for (const int column : {kPersonFullName, kPersonEmail}) header->setSectionResizeMode(column, QHeaderView::Stretch);
  for (const int column : {kPersonName, kPersonRole, kPersonState})
    header->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  header->setSectionsClickable(true);
  header->setSortIndicatorShown(true);
  header->setSortIndicator(kPersonFullName, Qt::AscendingOrder);
  header->setToolTip(tr("Click to sort"));
  connect(header, &QHeaderView::sortIndicatorChanged, this, [this] { showPeople(people_); });
  add_ = button("peopleAdd", tr("Add ..."), tr("Adds a person with a first password"), &PeopleWindow::addPerson);
  import_ = button("peopleImport", tr("Import class list ..."),
                   tr("Adds the people of a class list (CSV) to the selected class"), &PeopleWindow::importList);
  edit_ = button("peopleEdit", tr("Change ..."), tr("Changes the name, e-mail address and role of the selected person"),
                 &PeopleWindow::editPerson);
  password_ = button("peoplePassword", tr("New password ..."),
                     tr("Sets a new password for a person who forgot the password or is locked out; the person chooses "
                        "another password at the next sign-in"),
                     &PeopleWindow::setPassword);
  disable_ = button("peopleDisable", tr("Disable"),
                    tr("Disables or enables sign-in for the selected person; attempts and results are kept"),
                    &PeopleWindow::toggleDisabled);
  target_->setObjectName(QStringLiteral("peopleTarget"));
  target_->setAccessibleName(tr("Class to add the person to"));
  target_->setToolTip(tr("Class to which the selected person is added"));
  as_->setObjectName(QStringLiteral("peopleAs"));
  as_->setAccessibleName(tr("Role in the class"));
  as_->setToolTip(tr("Role in the class: teachers see the attempts of all trainees of the class"));
  as_->addItem(tr("trainee"), false);
  as_->addItem(tr("teacher"), true);
  join_ =
      button("peopleJoin", tr("Add to class"), tr("Adds the selected person to the chosen class"), &PeopleWindow::join);
  leave_ = button("peopleLeave", tr("Remove from class"),
                  tr("Removes the selected person from the class that is shown"), &PeopleWindow::leave);
  auto* first = new QHBoxLayout;
  first->setSpacing(kGap);
  for (QPushButton* one : {add_, import_, edit_, password_, disable_}) first->addWidget(one);
  first->addStretch();
  auto* second = new QHBoxLayout;
  second->setSpacing(kGap);
  second->addWidget(new QLabel(tr("Class")));
  second->addWidget(target_, 1);
  second->addWidget(as_);
  second->addWidget(join_);
  second->addWidget(leave_);
  auto* side = new QWidget;
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap);
  column->addWidget(heading(tr("People")));
  column->addWidget(table_, 1);
  column->addLayout(first);
  column->addLayout(second);
  return side;
}

bool PeopleWindow::isAdministrator() const {
  return account_.person().role == Role::Administrator;
}

const Cohort* PeopleWindow::cohort() const {
  const int row = classes_->currentRow() - (isAdministrator() ? 1 : 0);
  return row >= 0 && row < int(cohorts_.size()) ? &cohorts_[std::size_t(row)] : nullptr;
}

const PeopleWindow::Shown* PeopleWindow::chosen() const {
  const int row = table_->currentRow();
  return !table_->selectedItems().isEmpty() && row < int(people_.size()) ? &people_[std::size_t(row)] : nullptr;
}

void PeopleWindow::tell(const QString& words) {
  error_->setText(words.isEmpty() ? QString() : QStringLiteral("▲  ") + words);
  error_->setVisible(!words.isEmpty());
}

Result<PeopleWindow::Read> PeopleWindow::readFrom(const SignedIn& by) {
  auto cohorts = CohortStore(by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  auto taught = taughtCurricula(by);
  if (!taught) return tl::unexpected(taught.error());
  return Read{std::move(*cohorts), std::move(*taught)};
}

void PeopleWindow::read() {
  Q_EMIT changed();
  account_.query<Read>(this, &PeopleWindow::readFrom, [this](const Result<Read>& read) {
    if (!read) return tell(qt(read.error().message));
    const std::string before = cohort() ? cohort()->id : "";
    cohorts_ = read->cohorts, curricula_ = read->curricula;
    const QSignalBlocker quiet(classes_);
    classes_->clear();
    target_->clear();
    if (isAdministrator()) classes_->addItem(tr("All people"));
    for (const Cohort& one : cohorts_) {
      classes_->addItem(qt(listedName(one)));
      if (!one.archived) target_->addItem(qt(one.name), qt(one.id));
    }
    const std::string added = std::exchange(newClass_, QString()).toStdString();
    const auto at = std::ranges::find_if(
        cohorts_, [&](const Cohort& one) { return added.empty() ? one.id == before : one.name == added; });
    const bool found = at != cohorts_.end();
    classes_->setCurrentRow(found ? int(at - cohorts_.begin()) + (isAdministrator() ? 1 : 0) : 0);
    refresh();  // buttons belong to the class at once, and not only when its people have been read
    readPeople();
  });
}

void PeopleWindow::showCurricula() {
  curriculum_->clear();
  curriculum_->setEnabled(cohort() && !cohort()->archived);
  if (!cohort()) return;
  curriculum_->addItem(tr("no curriculum yet"));
  for (const OfferedCurriculum& one : curricula_) {
    const QString version = tr("%1, version %2").arg(qt(one.name)).arg(one.version);
    curriculum_->addItem(one.kind == OfferedCurriculum::Kind::Published ? version
                                                                        : tr("%1 (comes with Insonate)").arg(version));
    if (one.name == cohort()->curriculum && one.version == cohort()->curriculumVersion)
      curriculum_->setCurrentIndex(curriculum_->count() - 1);
  }
}

void PeopleWindow::readPeople() {
  showCurricula();
  if (!cohort() && !isAdministrator()) return showPeople({});
  account_.query<std::vector<Member>>(
      this, [id = cohort() ? cohort()->id : std::string()](const SignedIn& by) { return membersOf(by, id); },
      [this, id = cohort() ? cohort()->id : std::string()](const Result<std::vector<Member>>& members) {
        if (id != (cohort() ? cohort()->id : std::string())) return;  // another class was selected meanwhile
        if (!members) return tell(qt(members.error().message));
        std::vector<Shown> people;
        for (const Member& member : *members) people.push_back({member.person, member.teaches});
        showPeople(people);
      });
}

void PeopleWindow::showPeople(std::vector<Shown> people) {
  const std::string before = chosen() ? chosen()->person.id : "";
  sort(people, *table_->horizontalHeader());
  people_ = std::move(people);
  const QSignalBlocker quiet(table_);
  table_->clearSelection();
  table_->setRowCount(int(people_.size()));
  for (int row = 0; row < int(people_.size()); ++row) {
    const auto& [person, teaches] = people_[std::size_t(row)];
    for (int column = 0; column < kPersonColumns; ++column) {
      const QString text = textIn(column, person, teaches);
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(plainToolTip(text));
      table_->setItem(row, column, item);
    }
    if (person.id == before) table_->selectRow(row);
  }
  refresh();
}

void PeopleWindow::refresh() {
  const bool all = isAdministrator(), someone = chosen() != nullptr;
  addClass_->setVisible(all);
  for (QPushButton* one : {renameClass_, archive_, delete_}) {
    one->setVisible(all);
    one->setEnabled(cohort());
  }
  const bool isArchived = cohort() && cohort()->archived;
  archive_->setText(isArchived ? tr("Restore") : tr("Archive ..."));
  add_->setEnabled((all || cohort()) && !isArchived);
  import_->setEnabled(cohort() && !isArchived);
  edit_->setVisible(all);
  disable_->setVisible(all);
  edit_->setEnabled(someone);
  disable_->setEnabled(someone);
  disable_->setText(someone && chosen()->person.disabled ? tr("Enable") : tr("Disable"));
  password_->setEnabled(someone && chosen()->person.id != account_.person().id);
  target_->setEnabled(all && !cohorts_.empty());
  as_->setEnabled(target_->isEnabled());
  join_->setEnabled(target_->isEnabled() && someone);
  leave_->setEnabled(cohort() && someone);
}

void PeopleWindow::change(std::function<Result<void>(const SignedIn&)> what) {
  account_.query<void>(this, std::move(what), [this](const Result<void>& result) {
    tell(result ? QString() : qt(result.error().message));
    read();
  });
}

}  // namespace insonate::ui
