#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <QStyledItemDelegate>

namespace insonate {
struct Member;
}

namespace insonate::review {

class ClassController;

/// Table model with one row per person of a class: name, need for help, level, attempts, and the heat map's cells.
class ClassTable final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kNeeds, kLevel, kAttempts, kLast, kFirstMetric };
  enum Role {
    kSort = Qt::UserRole,  ///< Qt item role: value by which a column is sorted
    kPerson,               ///< Qt item role: Person::id
    kGround,               ///< Qt item role: color of a heat map cell; empty if there is nothing to compare with
  };

  explicit ClassTable(const ClassController& controller, QObject* parent = nullptr);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  void renew();
  void renewPerson(const QString& person);

 private:
  QVariant aboutPerson(const Member& member, int column, int role) const;
  QVariant aboutMetric(const Member& member, std::size_t metric, int role) const;
  QString levelOf(const Member& member) const;

  const ClassController& controller_;
};

/// Paints a cell of the heat map: the cell's color, and the value on this color.
class HeatDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace insonate::review
