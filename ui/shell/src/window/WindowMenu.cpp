#include "WindowMenu.h"

#include "AboutDialog.h"
#include "CaseController.h"
#include "CaseExchange.h"
#include "SourceDialog.h"

#include <insonate/ui/Attempts.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/Sound.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QFileDialog>
#include <utility>
#include <vector>

namespace insonate::ui {

WindowMenu::WindowMenu(CaseController& controller, Sound& sound, Commands& commands, QWidget* window)
    : QMenu(window),
      controller_(controller),
      sound_(sound),
      commands_(commands),
      window_(window),
      recent_(new QMenu(tr("Recent"), this)) {
  setToolTipsVisible(true);
  recent_->setToolTipsVisible(true);
  addCases();
  addSeparator();
  addWindow();
  attempt_->setVisible(false);
  connect(recent_, &QMenu::aboutToShow, this, &WindowMenu::fillRecent);
  connect(&controller_, &CaseController::changed, this, &WindowMenu::refresh);
  connect(&sound_, &Sound::changed, this, &WindowMenu::showSound);
  showSound();
  refresh();
}

QAction* WindowMenu::add(const char* id, const char* iconName, const QString& text, const QString& does,
                         const QKeySequence& keys, std::function<void()> perform) {
  QAction* action = addAction(ui::icon(QLatin1String(iconName)), text);
  action->setShortcut(keys);
  connect(action, &QAction::triggered, this, std::move(perform));
  window_->addAction(action);
  commands_.add(QLatin1String(id), does, *action);
  return action;
}

void WindowMenu::addCases() {
  add("window.case.library", "folder", tr("Case library ..."), tr("lists all cases with their contents and difficulty"),
      tr("Ctrl+B"), [this] { Q_EMIT libraryRequested(); });
  add("window.case.open", "folder", tr("Open case ..."), tr("opens a case folder, or a folder of DICOM files"),
      QKeySequence::Open, [this] { chooseCase(); });
  add("window.case.import", "import", tr("Import CT ..."),
      tr("imports a folder of DICOM files, the series of one such file, or an NRRD, NIfTI or MetaImage file"),
      tr("Ctrl+I"), [this] { chooseImport(); });
  add("window.case.textbook", "neck", tr("Built-in neck"), tr("opens the built-in case, a typical neck"), tr("Ctrl+T"),
      [this] { controller_.openBuiltIn(builtInCaseNames().front()); });
  attempt_ = add("window.attempt.open", "review", tr("Open attempt ..."), tr("opens a recorded attempt to replay it"),
                 tr("Ctrl+Shift+O"), [this] { chooseAttempt(); });
  addMenu(recent_);
  reload_ = add("window.case.reload", "reload", tr("Reload"), tr("reads the open case again from its folder"),
                QKeySequence(Qt::Key_F5), [this] { controller_.reload(); });
  addSeparator();
  save_ = add("window.case.save", "save", tr("Save case"), tr("writes the changes to the case's folder"),
              QKeySequence::Save, [this] { controller_.save(); });
  saveAs_ = add("window.case.saveAs", "save", tr("Save case as ..."), tr("writes the case to a new folder"),
                tr("Ctrl+Shift+S"), [this] { controller_.saveAs(); });
  controller_.exchange().addTo(*this);
}

void WindowMenu::addWindow() {
  add("window.frame.fullScreen", "", tr("Full screen"), tr("switches full screen on and off"),
      QKeySequence(Qt::Key_F11), [this] { window_->setWindowState(window_->windowState() ^ Qt::WindowFullScreen); });
  soundSwitch_ = add("window.frame.sound", "", tr("Sound"), tr("switches the sound on and off"), tr("Ctrl+Shift+A"),
                     [this] { sound_.setOn(!sound_.isOn()); });
  soundSwitch_->setCheckable(true);
  add("window.help.page", "help", tr("Help"), tr("shows help for this view"), QKeySequence(Qt::Key_F1),
      [this] { Q_EMIT helpRequested(); });
  add("window.help.start", "help", tr("Getting started"), tr("shows the first steps for your role"), tr("Shift+F1"),
      [this] { Q_EMIT startRequested(); });
  add("window.help.glossary", "help", tr("Glossary"), tr("explains each displayed number and how it is measured"), {},
      [this] { Q_EMIT glossaryRequested(); });
  QAction* keys = add("window.help.keys", "help", tr("Keys"), tr("lists all keys"), QKeySequence(Qt::Key_Question),
                      [this] { Q_EMIT keysRequested(); });
  keys->setShortcuts({QKeySequence(Qt::Key_Question), QKeySequence(QStringLiteral("Shift+?"))});
  add("window.help.about", "help", tr("About Insonate"), tr("shows version, licenses and intended use"), {},
      [this] { (new AboutDialog(window_))->open(); });
  add("window.frame.quit", "close", tr("Quit"), tr("closes the window"), QKeySequence::Quit,
      [this] { window_->close(); });
}

void WindowMenu::showSound() {
  soundSwitch_->setChecked(sound_.isOn());
  const QString does = tr("Switches the sound on and off");
  const QString sentence = sound_.problem().isEmpty() ? does : does + QStringLiteral(". ") + sound_.problem();
  soundSwitch_->setToolTip(commands_.toolTip(sentence, QStringLiteral("window.frame.sound")));
}

void WindowMenu::setOpensAttempts(bool opens) {
  attempt_->setVisible(opens);
}

void WindowMenu::refresh() {
  const QString obstacle = !controller_.current().patient ? tr("Open a case first.")
                           : controller_.isBusy() ? tr("Wait until \"%1\" has ended.").arg(controller_.jobTitle())
                                                  : QString();
  // While a job is running, saving says why it has to wait; a disabled key would do nothing without a word.
  save_->setEnabled(controller_.isSaveUseful());
  saveAs_->setEnabled(controller_.current().patient != nullptr);
  controller_.exchange().setObstacle(obstacle);
  reload_->setEnabled(!controller_.current().folder.isEmpty());
}

void WindowMenu::fillRecent() {
  recent_->clear();
  const std::vector<RecentCase> cases = recentCases();
  for (const RecentCase& one : cases) {
    QAction* action = recent_->addAction(plainCaption(one.title));
    action->setToolTip(plainToolTip(one.folder));
    connect(action, &QAction::triggered, this, [this, folder = one.folder] { Q_EMIT openRequested(folder); });
  }
  if (cases.empty()) {
    recent_->addAction(tr("No recent cases"))->setEnabled(false);
    return;
  }
  recent_->addSeparator();
  connect(recent_->addAction(tr("Clear list")), &QAction::triggered, this, [] { forgetRecentCases(); });
}

void WindowMenu::chooseCase() {
  if (const QString folder = askForSourceFolder(window_, tr("Open a case folder, or a folder of DICOM files"));
      !folder.isEmpty())
    Q_EMIT openRequested(folder);
}

void WindowMenu::chooseImport() {
  const QString source =
      askForSourceFileOrFolder(window_, tr("Import a CT: a folder, any file of a DICOM series, or a volume file"),
                               // DICOM files from hospitals often have no extension.
                               tr("DICOM and volumes (*);;Volumes (*.nrrd *.nhdr *.nii *.nii.gz *.mha *.mhd)"));
  if (!source.isEmpty()) Q_EMIT openRequested(source);
}

void WindowMenu::chooseAttempt() {
  const QString file = QFileDialog::getOpenFileName(window_, tr("Open a recorded attempt"), attemptsFolder(),
                                                    tr("Attempts (*%1 *%1.part);;All files (*)").arg(kAttemptSuffix));
  if (!file.isEmpty()) Q_EMIT attemptRequested(file);
}

}  // namespace insonate::ui
