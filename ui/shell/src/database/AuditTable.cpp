#include "AuditTable.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/RowTable.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QDateTime>
#include <QHeaderView>
#include <QLineEdit>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>

namespace insonate::ui {
namespace {

constexpr int kEntriesAtOnce = 200, kEntryRow_px = 26;
enum AuditColumn { kAuditTime, kAuditActor, kAuditAct, kAuditPerson, kAuditDetail, kAuditComputer, kAuditColumns };

QString nameIn(const std::map<std::string, std::string>& names, const std::string& id) {
  const auto found = names.find(id);
  return qt(found == names.end() ? id : found->second);
}

/// Replaces the ids in the details of an entry by names.
QString withNames(QString detail, const std::map<std::string, std::string>& names) {
  for (const auto& [id, name] : names) detail.replace(qt(id), qt(name));
  return detail;
}

Result<std::map<std::string, std::string>> namesFor(const SignedIn& by) {
  std::map<std::string, std::string> names;
  const auto people = PeopleStore(by).all();
  if (!people) return tl::unexpected(people.error());
  for (const Person& person : *people) names[person.id] = person.fullName;
  const auto classes = CohortStore(by).cohorts();
  if (!classes) return tl::unexpected(classes.error());
  for (const Cohort& one : *classes) names[one.id] = one.name;
  return names;
}

}  // namespace

AuditTable::AuditTable(Account& account, QWidget* parent)
    : QWidget(parent),
      account_(account),
      search_(named(new QLineEdit, "auditSearch", tr("Search the audit log"),
                    tr("Shows only the entries that contain this text"))),
      table_(named(new QTableWidget(0, kAuditColumns), "auditTable", tr("Audit log"),
                   tr("Accesses to data of other people, changes and refused requests, the newest first"))),
      earlier_(pushButton("auditEarlier", tr("Earlier entries"), tr("Reads the next 200 entries of the log"))) {
  search_->setPlaceholderText(tr("Search, for example by a name"));
  search_->setClearButtonEnabled(true);
  makeRowTable(*table_, kEntryRow_px);
  table_->setHorizontalHeaderLabels({tr("Time"), tr("Who"), tr("What"), tr("About"), tr("Details"), tr("Computer")});
  table_->horizontalHeader()->setSectionResizeMode(kAuditDetail, QHeaderView::Stretch);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGap);
  column->addWidget(search_);
  column->addWidget(table_, 1);
  column->addWidget(earlier_, 0, Qt::AlignLeft);
  connect(search_, &QLineEdit::textChanged, this, &AuditTable::filter);
  connect(earlier_, &QPushButton::clicked, this, [this] { readBefore(oldest_); });
}

void AuditTable::read() {
  table_->setRowCount(0);
  oldest_ = 0;
  readBefore(0);
}

void AuditTable::readBefore(std::int64_t number) {
  earlier_->setEnabled(false);
  account_.query<Part>(
      this,
      [number](const SignedIn& by) -> Result<Part> {
        auto entries = AuditLog(by).page(kEntriesAtOnce, number);
        if (!entries) return tl::unexpected(entries.error());
        auto names = namesFor(by);
        if (!names) return tl::unexpected(names.error());
        return Part{.entries = std::move(*entries), .names = std::move(*names)};
      },
      [this](const Result<Part>& part) {
        if (!part) return Q_EMIT failed(qt(part.error().message));
        add(*part);
      });
}

void AuditTable::add(const Part& part) {
  for (const AuditEntry& entry : part.entries) {
    const QString act = qt(entry.act), actor = nameIn(part.names, entry.actor);
    const QString texts[] = {
        QLocale().toString(QDateTime::fromMSecsSinceEpoch(entry.time_us / 1000), QLocale::ShortFormat),
        actor.isEmpty() ? tr("the program") : actor,
        entry.allowed ? act : tr("refused: %1").arg(act),
        nameIn(part.names, entry.person),
        withNames(qt(entry.detail), part.names),
        qt(entry.workstation)};
    const int row = table_->rowCount();
    table_->insertRow(row);
    for (int column = 0; column < kAuditColumns; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      item->setToolTip(plainToolTip(texts[column]));
      table_->setItem(row, column, item);
    }
    oldest_ = entry.number;
  }
  for (int column = 0; column < kAuditColumns; ++column)
    if (column != kAuditDetail) table_->resizeColumnToContents(column);
  earlier_->setEnabled(oldest_ > 1);
  filter();
}

void AuditTable::filter() {
  const QString wanted = search_->text().trimmed();
  for (int row = 0; row < table_->rowCount(); ++row) {
    bool contains = wanted.isEmpty();
    for (int column = 0; column < kAuditColumns && !contains; ++column)
      contains = table_->item(row, column)->text().contains(wanted, Qt::CaseInsensitive);
    table_->setRowHidden(row, !contains);
  }
}

}  // namespace insonate::ui
