#include "StructureModel.h"

#include "../labels/LabelSession.h"
#include "../model/CaseMeasuring.h"
#include "../model/PrepareModel.h"
#include "../model/StructureAppearance.h"
#include "../model/StructureList.h"
#include "../model/Structures.h"
#include "../model/TermsEditor.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Theme.h>

#include <QLocale>
#include <utility>

namespace insonate::prepare {
StructureModel::StructureModel(PrepareModel& shared, QObject* parent)
    : QAbstractTableModel(parent),
      shared_(shared),
      locked_(ui::icon(QStringLiteral("lock"))),
      unlocked_(ui::icon(QStringLiteral("unlock"), views::theme::kQuiet)),
      shown_(ui::icon(QStringLiteral("eye"))),
      unseen_(ui::icon(QStringLiteral("eye-clear"), views::theme::kQuiet)),
      hidden_(ui::icon(QStringLiteral("eye-off"), views::theme::kQuiet)) {
  for (const LabelState state : kLabelStates) states_[std::size_t(state)] = stateIcon(state);
  connect(&shared_.structures, &StructureList::changed, this, [this] {
    beginResetModel();
    endResetModel();
  });
  const auto refresh = [this] {
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
  };
  connect(&shared_.terms, &TermsEditor::changed, this, refresh);
  connect(&shared_.appearance, &StructureAppearance::lookChanged, this, [this](int label) {
    const int row = rowOf(std::uint8_t(label));
    if (row >= 0) Q_EMIT dataChanged(index(row, 0), index(row, kColumns - 1));
  });
  connect(&shared_.labeling, &LabelSession::rulesChanged, this, [this] {
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, kLock), index(rowCount() - 1, kLock));
  });
  connect(&shared_.measuring, &CaseMeasuring::changed, this, refresh);
}

int StructureModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(shared_.structures.labels().size());
}

int StructureModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(kColumns);
}

std::uint8_t StructureModel::labelAt(int row) const {
  const auto& all = shared_.structures.labels();
  return row >= 0 && row < int(all.size()) ? all[std::size_t(row)] : std::uint8_t{0};
}

int StructureModel::rowOf(std::uint8_t label) const {
  const auto& all = shared_.structures.labels();
  const auto found = std::ranges::find(all, label);
  return found == all.end() ? -1 : int(found - all.begin());
}

QString StructureModel::volume(std::uint8_t label) const {
  const auto& measures = shared_.measuring.measures();
  return measures ? marked(volumeText(measures->statistics.volume_ml(label)), label) : QString();
}

QString StructureModel::voxels(std::uint8_t label) const {
  const auto& measures = shared_.measuring.measures();
  return measures ? marked(QLocale().toString(qulonglong(measures->statistics.voxels[label])), label) : QString();
}

QString StructureModel::marked(const QString& value, std::uint8_t label) const {
  return isOutdated(label) ? QChar(0x2026) + value : value;
}

bool StructureModel::isOutdated(std::uint8_t label) const {
  return shared_.measuring.isOutdated(label);
}

void StructureModel::setRoomy(bool roomy) {
  if (std::exchange(roomy_, roomy) != roomy && rowCount() > 0)
    Q_EMIT dataChanged(index(0, kState), index(rowCount() - 1, kState));
}

Qt::ItemFlags StructureModel::flags(const QModelIndex& index) const {
  const bool editable = index.column() == kName && isOwnLabel(labelAt(index.row()));
  return QAbstractTableModel::flags(index) | (editable ? Qt::ItemIsEditable : Qt::NoItemFlags);
}

bool StructureModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) return false;
  shared_.terms.setName(labelAt(index.row()), value.toString());
  return true;
}

QVariant StructureModel::tip(Column column, std::uint8_t label) const {
  const QString name = shared_.terms.nameOf(label);
  switch (column) {
    case kEye:
      if (shared_.appearance.look(label).visible && shared_.appearance.look(label).opacity <= 0)
        return tr("%1 is invisible in 3D: its opacity is 0 %. Space hides it on the slices, too").arg(name);
      return shared_.appearance.look(label).visible ? tr("Hide %1 in 3D and on the slices (Space)").arg(name)
                                                    : tr("Show %1 in 3D and on the slices (Space)").arg(name);
    case kColor:
      return tr("Color of %1 (Enter); saved with the case").arg(name);
    case kLock:
      return shared_.labeling.rules().locked.test(label) ? tr("Unlock %1, so that tools can change it (L)").arg(name)
                                                         : tr("Lock %1, so that tools cannot change it (L)").arg(name);
    case kState:
      return tr("Labeling progress of %1: %2. A click or S sets the next state")
          .arg(name, stateWord(shared_.terms.stateOf(label)));
    case kVolume:
      return isOutdated(label) ? tr("Volume of %1 in milliliters before its last change; not measured since").arg(name)
                               : tr("Volume of %1 in milliliters").arg(name);
    case kTissue:
      return tr("Tissue of %1 for ultrasound, probe and needle").arg(name);
    case kVoxels:
      return isOutdated(label) ? tr("Voxels of %1 before its last change; not counted since").arg(name)
                               : tr("Voxels of %1").arg(name);
    default:
      return isOwnLabel(label) ? tr("%1, label %2; a double click or F2 renames it").arg(name).arg(int(label))
                               : tr("%1, label %2").arg(name).arg(int(label));
  }
}

QVariant StructureModel::textOf(Column column, std::uint8_t label) const {
  const std::uint8_t tissue = tissueOf(shared_.terms.value().own, label);
  switch (column) {
    case kName:
      return shared_.terms.nameOf(label);
    case kState:
      return roomy_ ? stateWord(shared_.terms.stateOf(label)) : QString();
    case kVolume:
      return volume(label);
    case kTissue:
      return structureName(knownLabel(tissue));
    case kTerm:
      return termOf(tissue);
    case kVoxels:
      return voxels(label);
    default:
      return {};
  }
}

QVariant StructureModel::iconOf(Column column, std::uint8_t label) const {
  const StructureLook& look = shared_.appearance.look(label);
  switch (column) {
    case kEye:
      return !look.visible ? hidden_ : look.opacity > 0 ? shown_ : unseen_;
    case kLock:
      return shared_.labeling.rules().locked.test(label) ? locked_ : unlocked_;
    case kColor:
      return swatch(look.color);
    case kState:
      return states_[std::size_t(shared_.terms.stateOf(label))];
    default:
      return {};
  }
}

QVariant StructureModel::spoken(Column column, std::uint8_t label) const {
  const QString name = shared_.terms.nameOf(label);
  switch (column) {
    case kEye:
      return shared_.appearance.look(label).visible ? tr("%1 is shown").arg(name) : tr("%1 is hidden").arg(name);
    case kLock:
      return shared_.labeling.rules().locked.test(label) ? tr("%1 is locked").arg(name)
                                                         : tr("%1 is not locked").arg(name);
    case kColor:
      return tr("color %1").arg(ui::toQColor(shared_.appearance.look(label).color).name());
    case kState:
      return tr("%1: %2").arg(name, stateWord(shared_.terms.stateOf(label)));
    case kVolume:
    case kVoxels:
      return isOutdated(label) ? tr("%1, before the last change").arg(textOf(column, label).toString())
                               : textOf(column, label);
    default:
      return textOf(column, label);
  }
}

bool StructureModel::isQuiet(Column column, std::uint8_t label) const {
  const bool isMeasured = column == kVolume || column == kVoxels;
  return !shared_.appearance.look(label).visible || (isMeasured && isOutdated(label));
}

QVariant StructureModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const auto column = Column(index.column());
  const std::uint8_t label = labelAt(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return textOf(column, label);
    case Qt::EditRole:
      return QString::fromStdString(labelName(shared_.terms.value().own, label));
    case Qt::DecorationRole:
      return iconOf(column, label);
    case Qt::TextAlignmentRole:
      return column == kVolume || column == kVoxels ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
    case Qt::ForegroundRole:
      return isQuiet(column, label) ? QVariant(ui::toQColor(views::theme::kQuiet)) : QVariant();
    case Qt::ToolTipRole:
      return tip(column, label);
    case Qt::AccessibleTextRole:
      return spoken(column, label);
    default:
      return {};
  }
}

QVariant StructureModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  const bool number = section == kVolume || section == kVoxels;
  if (role == Qt::TextAlignmentRole) return int((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kName:
      return tr("structure");
    case kState:
      return roomy_ ? tr("state") : QString();
    case kVolume:
      return tr("ml");
    case kTissue:
      return tr("tissue");
    case kTerm:
      return tr("term");
    case kVoxels:
      return tr("voxels");
    default:
      return {};
  }
}

}  // namespace insonate::prepare
