#pragma once

#include <insonate/core/Result.h>

#include <QDialog>
#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;

namespace insonate::ui {

/// A dialog with a few fields and one button. The button's action takes a moment and may fail. After a failure the
/// dialog stays open with the entries and shows the reason.
class EntryDialog : public QDialog {
  Q_OBJECT

 public:
  struct Entry {
    const char* name;  ///< object name of the field's widget
    QString label, tip;
    QString text{};
    bool secret = false;
    QStringList choices{};  ///< choices from which the user selects a value; empty: the user types a text
  };
  using Done = std::function<void(Result<void>)>;
  /// Function that performs the action and then calls `done`. The dialog closes if the action has succeeded.
  using Action = std::function<void(const QStringList& texts, Done done)>;

  EntryDialog(const QString& title, const QString& explanation, const std::vector<Entry>& entries,
              const QString& button, Action action, QWidget* parent);

  /// Adds a button that closes the dialog and calls `instead`. `name`: object name of the button.
  void offer(const char* name, const QString& text, const QString& tip, std::function<void()> instead);
  /// Like offer(), and Enter presses this button instead of the dialog's own one, which may do harm.
  void offerAsDefault(const char* name, const QString& text, const QString& tip, std::function<void()> instead);

 private:
  QPushButton* addOffer(const char* name, const QString& text, const QString& tip, std::function<void()> instead);
  QWidget* fieldOf(const Entry& entry);
  void act();
  void refuse(const QString& why);

  std::vector<QWidget*> fields_;  ///< a QLineEdit, or a QComboBox if the entry has choices
  QLabel* error_;
  QPushButton* go_;
  QHBoxLayout* buttons_;
  Action action_;
};

}  // namespace insonate::ui
