#pragma once

#include <QAbstractTableModel>
#include <QIcon>

namespace insonate::prepare {

class PrepareSession;

/// The structures of a case as rows: an eye, a colour, a name, a volume, a lock.
class StructureModel : public QAbstractTableModel {
 public:
  enum Column { kEye, kColour, kName, kVolume, kLock, kColumns };

  StructureModel(PrepareSession& session, QObject* parent);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  std::uint8_t labelAt(int row) const;
  int rowOf(std::uint8_t label) const;

 private:
  QVariant tip(Column column, std::uint8_t label) const;
  QString volume(std::uint8_t label) const;

  PrepareSession& session_;
  QIcon locked_, unlocked_;
  QIcon shown_, unseen_, hidden_;  ///< unseen: shown, but of no opacity
};

}  // namespace insonate::prepare
