#include "LibraryModel.h"

#include <algorithm>

namespace insonate::ui {
namespace {

int rankOf(const QString& grade) {
  static const QStringList kGrades{QStringLiteral("easy"), QStringLiteral("moderate"), QStringLiteral("hard")};
  const int rank = kGrades.indexOf(grade);
  return rank < 0 ? kGrades.size() : rank;
}

/// Text for screen readers, and the tooltip.
QString spoken(const LibraryEntry& entry) {
  if (entry.state == LibraryEntry::State::Broken)
    return LibraryModel::tr("%1. This case cannot be opened: %2").arg(entry.title, entry.error);
  QStringList lines{entry.title};
  if (!entry.description.isEmpty()) lines << entry.description;
  if (entry.state == LibraryEntry::State::Waiting) return lines.join(QLatin1Char('\n'));
  lines << (entry.graded
                ? LibraryModel::tr("Difficulty stated by the author: %1. Difficulty estimated from the labels: %2")
                      .arg(entry.grade, entry.reason)
                : entry.reason);
  lines << (entry.fit ? LibraryModel::tr("Fit for training.")
                      : LibraryModel::tr("Not fit for training: %1").arg(entry.errors.join(QLatin1Char(' '))));
  if (!entry.warnings.isEmpty()) lines << LibraryModel::tr("Warnings:");
  for (const QString& warning : entry.warnings) lines << QStringLiteral("- ") + warning;
  lines << LibraryModel::tr("Labeled: %1.").arg(entry.structures.join(QStringLiteral(", ")));
  if (!entry.builtIn) lines << entry.place;
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

void LibraryModel::setEntries(std::vector<LibraryEntry> entries) {
  beginResetModel();
  entries_ = std::move(entries);
  endResetModel();
}

void LibraryModel::update(const LibraryEntry& entry) {
  const auto found = std::ranges::find(entries_, entry.place, &LibraryEntry::place);
  if (found == entries_.end()) return;
  *found = entry;
  const QModelIndex changed = index(int(found - entries_.begin()));
  Q_EMIT dataChanged(changed, changed);
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(entries_.size());
}

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const LibraryEntry& one = entry(index.row());
  if (role == Qt::DisplayRole) return one.title;
  if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole) return spoken(one);
  return {};
}

LibraryFilter::LibraryFilter(LibraryModel& model, QObject* parent) : QSortFilterProxyModel(parent), model_(model) {
  setSourceModel(&model);
  setDynamicSortFilter(true);
  sort(0);
}

void LibraryFilter::setWords(const QString& words) {
  words_ = words.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  invalidateFilter();
}

void LibraryFilter::setGrade(const QString& grade) {
  grade_ = grade;
  invalidateFilter();
}

void LibraryFilter::setFitness(Fitness fitness) {
  fitness_ = fitness;
  invalidateFilter();
}

void LibraryFilter::setOrder(Order order) {
  order_ = order;
  invalidate();
}

bool LibraryFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  const LibraryEntry& one = model_.entry(row);
  if (!grade_.isEmpty() && one.grade != grade_) return false;
  if (fitness_ == Fitness::Fit && !one.fit) return false;
  const bool known = one.state != LibraryEntry::State::Waiting;
  if (fitness_ == Fitness::Unfit && (!known || one.fit)) return false;
  const QString text =
      QStringList{one.title, one.description, one.grade, one.structures.join(QLatin1Char(' '))}.join(QLatin1Char(' '));
  return std::ranges::all_of(words_, [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

bool LibraryFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const LibraryEntry &a = model_.entry(left.row()), &b = model_.entry(right.row());
  if (order_ == Order::Difficulty && rankOf(a.grade) != rankOf(b.grade)) return rankOf(a.grade) < rankOf(b.grade);
  if (order_ == Order::Newest && a.date != b.date) return a.date > b.date;
  const int byTitle = a.title.localeAwareCompare(b.title);
  return byTitle != 0 ? byTitle < 0 : a.place < b.place;
}

}  // namespace insonate::ui
