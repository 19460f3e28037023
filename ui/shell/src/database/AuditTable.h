#pragma once

#include <insonate/curriculum/AuditLog.h>

#include <QWidget>
#include <map>
#include <string>
#include <vector>

class QLineEdit;
class QPushButton;
class QTableWidget;

namespace insonate::ui {

class Account;

/// The audit log, newest entries first, read from the store in parts. A text restricts the table to the entries that
/// contain the text.
class AuditTable : public QWidget {
  Q_OBJECT

 public:
  explicit AuditTable(Account& account, QWidget* parent = nullptr);

  /// Reads the newest entries.
  void read();

 Q_SIGNALS:
  void failed(const QString& why);

 private:
  struct Part {
    std::vector<AuditEntry> entries;
    std::map<std::string, std::string> names;  ///< names of people and classes by id
  };
  void readBefore(std::int64_t number);
  void add(const Part& part);
  void filter();

  Account& account_;
  QLineEdit* search_;
  QTableWidget* table_;
  QPushButton* earlier_;
  std::int64_t oldest_ = 0;  ///< number of the oldest entry that is shown; 0: none
};

}  // namespace insonate::ui
