#pragma once

#include <QFrame>
#include <QString>

class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QMenu;

namespace insonate::ui {

class AccountMenu;

/// The window's top line: product name, workspaces, case, menu and account.
class HeaderBar : public QFrame {
  Q_OBJECT

 public:
  explicit HeaderBar(QMenu* viewMenu, QMenu* caseMenu, AccountMenu* accountMenu, QWidget* parent = nullptr);

  void addTab(const QString& title, const QString& iconName, const QString& keys);
  void setTab(int index);
  /// Shows the case's title; `hint` is the tooltip.
  void setCaseTitle(const QString& title, const QString& hint);
  QString caseTitle() const;

 Q_SIGNALS:
  void tabChosen(int index);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();

  QButtonGroup* tabs_;
  QHBoxLayout* tabRow_;
  QLabel* case_;
  QString title_;
};

}  // namespace insonate::ui
