#pragma once

#include "LibraryEntry.h"

#include <QAbstractListModel>
#include <QSortFilterProxyModel>
#include <vector>

namespace insonate::ui {

/// List model of the library's cases, in the order in which they were found.
class LibraryModel final : public QAbstractListModel {
 public:
  using QAbstractListModel::QAbstractListModel;

  void setEntries(std::vector<LibraryEntry> entries);
  /// Replaces the entry with the same place; no effect if there is none.
  void update(const LibraryEntry& entry);
  const LibraryEntry& entry(int row) const { return entries_[std::size_t(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  std::vector<LibraryEntry> entries_;
};

/// Filters the entries by search words and grade, and sorts them in the selected order.
class LibraryFilter final : public QSortFilterProxyModel {
 public:
  enum class Order { Difficulty, Title, Newest };
  enum class Fitness { All, Fit, Unfit };

  explicit LibraryFilter(LibraryModel& model, QObject* parent);

  /// Sets the search words. Each word must occur in title, description, grade or structures.
  void setWords(const QString& words);
  /// Sets the grade to show: "easy", "moderate" or "hard"; empty: all.
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
