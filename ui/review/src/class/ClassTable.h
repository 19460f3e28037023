#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <QStyledItemDelegate>

namespace insonate {
struct Member;
}

namespace insonate::review {

class ClassDesk;

/// The people of a class, a row each: who, whether they need help, level, attempts, and the heat map's cells.
class ClassTable final : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kName, kNeeds, kLevel, kAttempts, kLast, kFirstMetric };
  enum Role {
    kSort = Qt::UserRole,  ///< what a column is sorted by
    kPerson,               ///< Person::id
    kGround,               ///< color of a cell of the heat map; none: nothing to compare with
  };

  explicit ClassTable(const ClassDesk& desk, QObject* parent = nullptr);

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

  const ClassDesk& desk_;
};

/// A cell of the heat map: its color, and the number on it.
class HeatDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace insonate::review
