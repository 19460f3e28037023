#pragma once

#include <QKeySequence>
#include <QMenu>
#include <functional>

class QAction;

namespace insonate::ui {

class CaseController;
class Commands;
class Sound;

/// The menu of the window's own commands: opening, saving and exporting cases, help, full screen, sound, quit. Adds
/// them to the window's commands as "window.case.open" and so on; their keys work while the menu is closed.
class WindowMenu : public QMenu {
  Q_OBJECT

 public:
  WindowMenu(CaseController& controller, Sound& sound, Commands& commands, QWidget* window);

  /// Shows the entry that opens a recorded attempt.
  void setOpensAttempts(bool opens);

 Q_SIGNALS:
  /// Emitted when the user has selected a folder or a file.
  void openRequested(const QString& path);
  void attemptRequested(const QString& file);
  void libraryRequested();
  void helpRequested();
  void startRequested();
  void glossaryRequested();
  void keysRequested();

 private:
  QAction* add(const char* id, const char* iconName, const QString& text, const QString& does, const QKeySequence& keys,
               std::function<void()> perform);
  void addCases();
  void addWindow();
  void showSound();
  void fillRecent();
  void refresh();
  void chooseCase();
  void chooseImport();
  void chooseAttempt();

  CaseController& controller_;
  Sound& sound_;
  Commands& commands_;
  QWidget* window_;
  QMenu* recent_;
  QAction *attempt_ = nullptr, *soundSwitch_ = nullptr, *reload_ = nullptr, *save_ = nullptr, *saveAs_ = nullptr;
};

}  // namespace insonate::ui
