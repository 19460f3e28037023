#pragma once

#include <insonate/core/Result.h>

#include <QDialog>
#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace insonate::ui {

/// A dialog with a few fields and one button, whose action takes a moment and may be refused: then the reason stands
/// in the dialog, and the entries stay.
class EntryDialog : public QDialog {
  Q_OBJECT

 public:
  struct Entry {
    const char* name;  ///< of its widget
    QString label, tip;
    QString text{};
    bool secret = false;
    QStringList choices{};  ///< one of these, instead of any text
  };
  /// Performs the action and calls `done`; the dialog closes if it succeeded.
  using Action = std::function<void(const QStringList& texts, std::function<void(Result<void>)> done)>;

  EntryDialog(const QString& title, const QString& explanation, const std::vector<Entry>& entries,
              const QString& button, Action action, QWidget* parent);

 private:
  QWidget* fieldOf(const Entry& entry);
  void act();
  void refuse(const QString& why);

  std::vector<QWidget*> fields_;  ///< QLineEdit, or QComboBox where there are choices
  QLabel* trouble_;
  QPushButton* go_;
  Action action_;
};

}  // namespace insonate::ui
