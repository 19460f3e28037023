#pragma once

#include "LibraryEntry.h"

#include <QAbstractListModel>
#include <QSortFilterProxyModel>
#include <vector>

namespace insonate::ui {

/// The cases of the library, in the order in which they were found.
class LibraryModel final : public QAbstractListModel {
 public:
  using QAbstractListModel::QAbstractListModel;

  void setEntries(std::vector<LibraryEntry> entries);
  /// Replaces the entry of the same place; no effect if it is gone.
  void update(const LibraryEntry& entry);
  const LibraryEntry& entry(int row) const { return entries_[std::size_t(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<LibraryEntry> entries_;
};

/// The entries that match the search, in the chosen order.
class LibraryFilter final : public QSortFilterProxyModel {
 public:
  enum class Order { Difficulty, Title, Newest };
  enum class Fitness { All, Fit, Unfit };

  explicit LibraryFilter(LibraryModel& model, QObject* parent);

  /// Words, each of which must be in title, description, grade or structures.
  void setWords(const QString& words);
  /// "easy", "moderate", "hard"; empty for all.
  void setGrade(const QString& grade);
  void setFitness(Fitness fitness);
  void setOrder(Order order);
  const LibraryEntry& entry(const QModelIndex& index) const { return model_.entry(mapToSource(index).row()); }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  LibraryModel& model_;
  QStringList words_;
  QString grade_;
  Fitness fitness_ = Fitness::All;
  Order order_ = Order::Difficulty;
};

}  // namespace insonate::ui
