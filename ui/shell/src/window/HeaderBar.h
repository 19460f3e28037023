#pragma once

#include <QFrame>
#include <QString>

class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QMenu;

namespace insonate::ui {

class AccountMenu;
class Commands;

/// The window's top line: product name, workspaces, case, menu and account.
class HeaderBar : public QFrame {
  Q_OBJECT

 public:
  /// Adds the keys of the menus to the window's commands.
  HeaderBar(QMenu* viewMenu, QMenu* caseMenu, AccountMenu* accountMenu, Commands& commands, QWidget* parent = nullptr);

  void addTab(const QString& title, const QString& iconName, const QString& tip);
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
