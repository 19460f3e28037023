#pragma once

#include "../model/LabelTerms.h"

#include <QAbstractTableModel>
#include <QIcon>
#include <array>

namespace insonate::prepare {

struct PrepareModel;

/// Table model with one row per structure. Names of the author's own structures can be edited.
class StructureModel : public QAbstractTableModel {
 public:
  enum Column { kEye, kLock, kColor, kName, kState, kVolume, kTissue, kTerm, kVoxels, kColumns };

  StructureModel(PrepareModel& shared, QObject* parent);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  std::uint8_t labelAt(int row) const;
  int rowOf(std::uint8_t label) const;
  /// Sets whether the states' words are shown beside their symbols, for which a wide table has space.
  void setRoomy(bool roomy);

 private:
  QVariant textOf(Column column, std::uint8_t label) const;
  QVariant iconOf(Column column, std::uint8_t label) const;
  QVariant spoken(Column column, std::uint8_t label) const;
  QVariant tip(Column column, std::uint8_t label) const;
  QString volume(std::uint8_t label) const;
  QString voxels(std::uint8_t label) const;
  /// Returns a measured value with an ellipsis before it if the label was edited since.
  QString marked(const QString& value, std::uint8_t label) const;
  bool isOutdated(std::uint8_t label) const;
  bool isQuiet(Column column, std::uint8_t label) const;

  PrepareModel& shared_;
  QIcon locked_, unlocked_;
  QIcon shown_, unseen_, hidden_;  ///< unseen_: icon of a structure that is visible but has the opacity 0
  std::array<QIcon, std::size(kLabelStates)> states_;
  bool roomy_ = false;
};

}  // namespace insonate::prepare
