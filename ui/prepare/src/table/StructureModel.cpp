#include "StructureModel.h"

#include "../PrepareSession.h"
#include "Swatch.h"

#include <insonate/ui/Theme.h>

namespace insonate::prepare {
StructureModel::StructureModel(PrepareSession& session, QObject* parent)
    : QAbstractTableModel(parent),
      session_(session),
      locked_(ui::icon(QStringLiteral("lock"))),
      unlocked_(ui::icon(QStringLiteral("unlock"), views::theme::kQuiet)),
      shown_(ui::icon(QStringLiteral("eye"))),
      unseen_(ui::icon(QStringLiteral("eye"), views::theme::kQuiet)),
      hidden_(ui::icon(QStringLiteral("eye-off"), views::theme::kQuiet)) {
  connect(&session_, &PrepareSession::structuresChanged, this, [this] {
    beginResetModel();
    endResetModel();
  });
  connect(&session_, &PrepareSession::lookChanged, this, [this](int label) {
    const int row = rowOf(std::uint8_t(label));
    if (row >= 0) Q_EMIT dataChanged(index(row, 0), index(row, kColumns - 1));
  });
  connect(&session_.labelling(), &LabelSession::rulesChanged, this, [this] {
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, kLock), index(rowCount() - 1, kLock));
  });
  connect(&session_.measuring(), &CaseMeasuring::changed, this, [this] {
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, kVolume), index(rowCount() - 1, kVolume));
  });
}

int StructureModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(session_.structures().size());
}

int StructureModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(kColumns);
}

std::uint8_t StructureModel::labelAt(int row) const {
  const auto& all = session_.structures();
  return row >= 0 && row < int(all.size()) ? all[std::size_t(row)] : std::uint8_t{0};
}

int StructureModel::rowOf(std::uint8_t label) const {
  const auto& all = session_.structures();
  const auto found = std::ranges::find(all, label);
  return found == all.end() ? -1 : int(found - all.begin());
}

QString StructureModel::volume(std::uint8_t label) const {
  const auto& measures = session_.measuring().measures();
  if (!measures) return {};
  const double ml = measures->statistics.volume_ml(label);
  return QString::number(ml, 'f', ml < 10 ? 2 : ml < 100 ? 1 : 0);
}

QVariant StructureModel::tip(Column column, std::uint8_t label) const {
  const QString name = structureName(label);
  switch (column) {
    case kEye:
      if (session_.look(label).visible && session_.look(label).opacity <= 0)
        return tr("Nothing of %1 is seen in 3D: its opacity is 0 %. Space hides it on the slices, too").arg(name);
      return session_.look(label).visible ? tr("Hide %1 in 3D and on the slices (Space)").arg(name)
                                          : tr("Show %1 in 3D and on the slices (Space)").arg(name);
    case kColour:
      return tr("Colour of %1 (Enter); saved with the case").arg(name);
    case kLock:
      return session_.labelling().rules().locked.test(label) ? tr("Let tools change %1 again (L)").arg(name)
                                                             : tr("Lock %1: tools leave it as it is (L)").arg(name);
    case kVolume:
      return tr("Volume of %1 in millilitres").arg(name);
    default:
      return tr("%1, label %2").arg(name).arg(int(label));
  }
}

QVariant StructureModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto column = Column(index.column());
  const std::uint8_t label = labelAt(index.row());
  const StructureLook& look = session_.look(label);
  switch (role) {
    case Qt::DisplayRole:
      return column == kName ? structureName(label) : column == kVolume ? volume(label) : QVariant();
    case Qt::DecorationRole:
      if (column == kEye) return !look.visible ? hidden_ : look.opacity > 0 ? shown_ : unseen_;
      if (column == kLock) return session_.labelling().rules().locked.test(label) ? locked_ : unlocked_;
      return column == kColour ? QVariant(swatch(look.colour)) : QVariant();
    case Qt::TextAlignmentRole:
      return column == kVolume ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ForegroundRole:
      return look.visible ? QVariant() : QVariant(ui::colour(views::theme::kQuiet));
    case Qt::ToolTipRole:
      return tip(column, label);
    case Qt::AccessibleTextRole:
      if (column == kEye)
        return look.visible ? tr("%1 is shown").arg(structureName(label))
                            : tr("%1 is hidden").arg(structureName(label));
      if (column == kLock)
        return session_.labelling().rules().locked.test(label) ? tr("%1 is locked").arg(structureName(label))
                                                               : tr("%1 is not locked").arg(structureName(label));
      if (column == kColour) return tr("colour %1").arg(ui::colour(look.colour).name());
      return data(index, Qt::DisplayRole);
    default:
      return {};
  }
}

QVariant StructureModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return section == kVolume ? int(Qt::AlignRight | Qt::AlignVCenter) : int(Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  return section == kName ? tr("structure") : section == kVolume ? tr("ml") : QString();
}

}  // namespace insonate::prepare
