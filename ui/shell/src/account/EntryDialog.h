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

/// A few lines to fill in, and one button that does something with them, which takes a moment and may be
/// refused: then the reason stands in the dialog, and what was filled in stays.
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
  /// Tells `done` when it is over; it closes where that was well.
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
