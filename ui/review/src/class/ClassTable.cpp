#include "ClassTable.h"

#include "ClassController.h"
#include "ClassWords.h"
#include "HeatColors.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/ui/Theme.h>

#include <QPainter>
#include <cmath>

namespace insonate::review {
namespace {

/// Punctures of lung or airway have no published values, so that no color shows them.
bool isComplication(const HeatCell& cell, const MetricMeaning& meaning) {
  return !cell.share && cell.value.value_or(0) > 0 && meaning.id == "lung_punctures";
}

}  // namespace

ClassTable::ClassTable(const ClassController& controller, QObject* parent)
    : QAbstractTableModel(parent), controller_(controller) {}

int ClassTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !controller_.facts() ? 0 : int(controller_.facts()->learners.size());
}

int ClassTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kFirstMetric + int(MetricCatalog::instance().comparableCount());
}

void ClassTable::renew() {
  beginResetModel();
  endResetModel();
}

void ClassTable::renewPerson(const QString& person) {
  for (int row = 0; row < rowCount(); ++row)
    if (controller_.facts()->learners[std::size_t(row)].person.id == person.toStdString())
      Q_EMIT dataChanged(index(row, 0), index(row, columnCount() - 1));
}

QVariant ClassTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (section >= kFirstMetric) {
    const MetricMeaning& meaning = MetricCatalog::instance().all()[std::size_t(section - kFirstMetric)];
    if (role == Qt::DisplayRole) return titleWithUnit(meaning);
    if (role == Qt::ToolTipRole)
      return tr("%1: mean of the last %2 counted attempts at levels, without free practice. Click to sort")
          .arg(titleWithUnit(meaning), QString::number(kLastAttempts));
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignCenter) | Qt::TextWordWrap;
    return {};
  }
  static const QString titles[] = {tr("Person"), tr("Needs attention"), tr("Level"), tr("Attempts"),
                                   tr("Last attempt")};
  if (role == Qt::DisplayRole) return titles[section];
  if (role != Qt::ToolTipRole) return {};
  return section == kAttempts ? tr("Number of attempts that count, at levels and in free practice. Click to sort")
                              : tr("Click to sort");
}

QVariant ClassTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Member& member = controller_.facts()->learners[std::size_t(index.row())];
  if (role == kPerson) return QString::fromStdString(member.person.id);
  if (index.column() < kFirstMetric) return aboutPerson(member, index.column(), role);
  return aboutMetric(member, std::size_t(index.column() - kFirstMetric), role);
}

QString ClassTable::levelOf(const Member& member) const {
  if (member.attempts == 0) return tr("not begun");
  if (!member.standing) return tr("...");
  if (member.standing->level.empty()) return tr("all mastered");
  return levelTitle(controller_.curriculum(), member.standing->level);
}

QVariant ClassTable::aboutPerson(const Member& member, int column, int role) const {
  const Attention attention = attentionOf(*controller_.facts(), member);
  const bool isFlagged = hasImplausible(*controller_.facts(), member);
  if (role == Qt::ToolTipRole)
    return member.standing ? plainToolTip(QString::fromStdString(member.standing->sentence)) : QString();
  if (role == Qt::ForegroundRole && column == kNeeds)
    return ui::toQColor(attention >= Attention::Stuck || isFlagged ? views::theme::kCaution : views::theme::kQuiet);
  if (role == kSort && column == kNeeds) return -2 * int(attention) - int(isFlagged);
  if (role == kSort && column == kLevel) return member.standing ? member.standing->mastered : -1;
  if (role == kSort && column == kAttempts) return member.attempts;
  if (role == kSort && column == kLast) return qlonglong(member.lastAttempt_us.value_or(0));
  if (role != Qt::DisplayRole && role != kSort) return {};
  switch (column) {
    case kName:
      return QString::fromStdString(member.person.fullName);
    case kNeeds:
      return attentionWords(*controller_.facts(), member);
    case kLevel:
      return levelOf(member);
    case kAttempts:
      return QString::number(member.attempts);
    default:
      return member.lastAttempt_us ? dayOf(*member.lastAttempt_us) : tr("none");
  }
}

QVariant ClassTable::aboutMetric(const Member& member, std::size_t metric, int role) const {
  const auto row = controller_.heat().find(member.person.id);
  const HeatCell cell = row == controller_.heat().end() ? HeatCell{} : row->second[metric];
  const MetricMeaning& meaning = MetricCatalog::instance().all()[metric];
  switch (role) {
    case Qt::DisplayRole:
      return !cell.value ? tr("n/a")
                         : (isComplication(cell, meaning) ? QStringLiteral("▲ ") : QString()) +
                               QString::fromStdString(numberOf(*cell.value));
    case kSort:  // missing values come last if the best come first
      return cell.share.value_or(-1);
    case kGround:
      return cell.share ? QVariant(heatColor(*cell.share)) : QVariant();
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
      if (!cell.value) return tr("No data in the last %1 attempts at levels.").arg(kLastAttempts);
      return tr("%1: %2, mean of %3, %4")
          .arg(titleWithUnit(meaning), QString::fromStdString(numberOf(*cell.value)),
               countOf(cell.attempts, tr("attempt"), tr("attempts")), QString::fromStdString(heatWords(cell.share)));
    default:
      return {};
  }
}

void HeatDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QVariant ground = index.data(ClassTable::kGround);
  const QRect cell = option.rect.adjusted(1, 1, -1, -1);
  const bool chosen = option.state & QStyle::State_Selected;
  painter->fillRect(option.rect, ui::toQColor(chosen ? views::theme::kLine : views::theme::kPanel));
  if (ground.isValid()) painter->fillRect(cell, ground.value<QColor>());
  painter->setPen(ground.isValid() ? inkOn(ground.value<QColor>()) : ui::toQColor(views::theme::kQuiet));
  painter->drawText(cell, Qt::AlignCenter, index.data().toString());
  if (!chosen) return;
  painter->setPen(QPen(ui::toQColor(views::theme::kText), 1));
  painter->drawLine(option.rect.topLeft(), option.rect.topRight());
  painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
}

}  // namespace insonate::review
