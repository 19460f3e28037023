// The part of the window that opens and exports cases.
#include "AboutDialog.h"
#include "CaseExchange.h"
#include "HeaderBar.h"
#include "HelpWindow.h"
#include "LibraryWindow.h"
#include "LossQuestion.h"
#include "SourceDialog.h"
#include "StatusStrip.h"

#include <insonate/ui/Attempts.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QDir>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QSettings>
#include <utility>
#include <vector>

namespace insonate::ui {
namespace {

const QString kLastTarget = QStringLiteral("lastTarget");

/// The first local file or folder of a drag; empty if there is none.
QString carriedPath(const QMimeData* data) {
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) return url.toLocalFile();
  return {};
}

/// A name that is valid in every file system.
QString folderNameFor(const std::string& title) {
  QString name;
  for (const QChar c : QString::fromStdString(title).simplified())
    if (c.isLetterOrNumber() || c == QLatin1Char(' ')) name += c;
  return name.isEmpty() ? MainWindow::tr("Case") : name.left(60);
}

}  // namespace

void MainWindow::makeActions() {
  const auto make = [this](const char* iconName, const QString& text, const QString& tip, const QKeySequence& keys) {
    auto* action = new QAction(icon(QLatin1String(iconName)), text, this);
    action->setShortcut(keys);
    action->setToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys.toString()));
    addAction(action);
    return action;
  };
  open_ =
      make("folder", tr("Open case ..."), tr("Opens a case folder, or a folder of DICOM files"), QKeySequence::Open);
  import_ =
      make("import", tr("Import file ..."),
           tr("Imports the whole DICOM series of any of its files, or an NRRD, NIfTI or MetaImage file"), tr("Ctrl+I"));
  textbook_ = make("neck", tr("Built-in neck"), tr("Opens the textbook neck that comes with Insonate"), tr("Ctrl+T"));
  library_ = make("folder", tr("Case library ..."), tr("Lists all cases with contents and difficulty"), tr("Ctrl+B"));
  attempt_ = make("review", tr("Open attempt ..."), tr("Opens a recorded attempt to replay it"), tr("Ctrl+Shift+O"));
  attempt_->setVisible(false);
  reload_ = make("reload", tr("Reload"), tr("Reads the case from its folder again"), QKeySequence(Qt::Key_F5));
  save_ = make("save", tr("Save case"), tr("Writes the changes to the case's folder"), QKeySequence::Save);
  saveAs_ = make("save", tr("Save case as ..."), tr("Writes the case to a new folder"), tr("Ctrl+Shift+S"));
  for (QAction* action : {reload_, save_, saveAs_}) action->setEnabled(false);
  auto* quit = make("close", tr("Quit"), tr("Closes the window"), QKeySequence::Quit);
  auto* page = make("help", tr("Help"), tr("Help for this view"), QKeySequence(Qt::Key_F1));
  auto* keys = make("help", tr("Keys"), tr("All keys"), QKeySequence(Qt::Key_Question));
  auto* glossary = make("help", tr("Glossary"), tr("What each number means and how it is measured"), {});
  keys->setShortcuts({QKeySequence(Qt::Key_Question), QKeySequence(QStringLiteral("Shift+?"))});
  auto* full = make("", tr("Full screen"), tr("Switches full screen on and off"), QKeySequence(Qt::Key_F11));
  for (QAction* action : {library_, open_, import_, textbook_, attempt_}) menu_->addAction(action);
  menu_->addMenu(recent_);
  menu_->addAction(reload_);
  menu_->addSeparator();
  menu_->addAction(save_);
  menu_->addAction(saveAs_);
  exchange_->addTo(*menu_);
  menu_->addSeparator();
  auto* about = make("help", tr("About Insonate"), tr("Version, licenses and intended use"), {});
  for (QAction* action : {full, page, glossary, keys, about, quit}) menu_->addAction(action);
  menu_->setToolTipsVisible(true);
  recent_->setToolTipsVisible(true);

  connect(open_, &QAction::triggered, this, &MainWindow::chooseCase);
  connect(import_, &QAction::triggered, this, &MainWindow::chooseImport);
  connect(library_, &QAction::triggered, this, &MainWindow::showLibrary);
  connect(textbook_, &QAction::triggered, this, &MainWindow::openTextbook);
  connect(attempt_, &QAction::triggered, this, &MainWindow::chooseAttempt);
  connect(reload_, &QAction::triggered, this, &MainWindow::reload);
  connect(save_, &QAction::triggered, this, &MainWindow::saveCase);
  connect(saveAs_, &QAction::triggered, this, &MainWindow::chooseTarget);
  connect(quit, &QAction::triggered, this, &QWidget::close);
  connect(full, &QAction::triggered, this, [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  connect(page, &QAction::triggered, this, [this] { showHelp(false); });
  connect(about, &QAction::triggered, this, [this] { (new AboutDialog(this))->open(); });
  connect(keys, &QAction::triggered, this, [this] { showHelp(true); });
  connect(glossary, &QAction::triggered, this, [this] {
    showHelp(false);
    help_->showPage(QStringLiteral("glossary"));
  });
}

void MainWindow::showLibrary() {
  if (auto* shown = findChild<LibraryWindow*>()) return shown->raise();
  auto* library = new LibraryWindow(this);
  connect(library, &LibraryWindow::caseChosen, this, [this](const QString& place, const QString& workspace) {
    showWorkspace(workspace);
    if (builtInNames().contains(place)) return openBuiltIn(place);
    open(workspace == QLatin1String("train") ? placeForTraining(place) : place);
  });
  library->show();
}

void MainWindow::fillRecent() {
  recent_->clear();
  const std::vector<RecentCase> cases = recentCases();
  for (const RecentCase& one : cases) {
    QAction* action = recent_->addAction(plainCaption(one.title));
    action->setToolTip(plainToolTip(one.folder));
    connect(action, &QAction::triggered, this, [this, folder = one.folder] { open(folder); });
  }
  if (cases.empty()) {
    recent_->addAction(tr("No recent cases"))->setEnabled(false);
    return;
  }
  recent_->addSeparator();
  connect(recent_->addAction(tr("Clear list")), &QAction::triggered, this, [] { forgetRecentCases(); });
}

void MainWindow::chooseCase() {
  if (const QString folder = askForSourceFolder(this, tr("Open a case folder, or a folder of DICOM files"));
      !folder.isEmpty())
    open(folder);
}

void MainWindow::chooseImport() {
  const QString file =
      askForSourceFile(this, tr("Import a CT: any file of a DICOM series, or a volume file"),
                       // DICOM files from hospitals often have no extension.
                       tr("DICOM and volumes (*);;Volumes (*.nrrd *.nhdr *.nii *.nii.gz *.mha *.mhd)"));
  if (!file.isEmpty()) open(file);
}

void MainWindow::chooseAttempt() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a recorded attempt"), attemptsFolder(),
                                                    tr("Attempts (*%1 *%1.part);;All files (*)").arg(kAttemptSuffix));
  if (!file.isEmpty()) openAttempt(file);
}

const MainWindow::Room* MainWindow::attemptRoom() const {
  for (const Room& room : rooms_)
    if (room.workspace->opensAttempts()) return &room;
  return nullptr;
}

void MainWindow::openAttempt(const QString& file) {
  const Room* room = attemptRoom();
  if (!room) return;
  const auto go = [this, room, file] {
    showWorkspace(room->id);
    room->workspace->openAttempt(file);
  };
  // An unsaved case is at risk only if the attempt belongs to another case; the window asks then.
  tasks_->asksWhenClosed() ? confirmDiscard(LostBy::Opening, go) : go();
}

void MainWindow::chooseTarget() {
  QFileDialog dialog(this, tr("Save the case to a new folder"),
                     QSettings().value(kLastTarget, QDir::homePath()).toString());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setOption(QFileDialog::ShowDirsOnly);
  dialog.setLabelText(QFileDialog::FileName, tr("New folder:"));
  dialog.selectFile(folderNameFor(case_.patient->manifest.title));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) {
    afterSaving_ = {};
    return;
  }
  const QString folder = dialog.selectedFiles().first();
  QSettings().setValue(kLastTarget, QFileInfo(folder).absolutePath());
  saveTo(folder);
}

void MainWindow::take(const LoadedCase& loaded) {
  case_ = loaded;
  const QString title = QString::fromStdString(case_.patient->manifest.title);
  const QString& home = case_.versionOf.isEmpty() ? case_.folder : case_.versionOf;
  if (!home.isEmpty()) rememberCase({home, title});
  handOut();
  if (!case_.notes.isEmpty())
    status_->say(case_.notes.join(QLatin1Char(' ')));
  else
    status_->say(tr("Opened %1.").arg(title));
}

void MainWindow::takeMade(std::shared_ptr<const PatientCase> patient) {
  case_.patient = std::move(patient);
  case_.folder.clear();
  case_.builtIn = false;
  case_.versionOf.clear();
  handOut();
}

/// Without a case, the running job will open one.
void MainWindow::showOpening() {
  if (case_.patient) return;
  const QString what = tasks_->isRunning() ? tasks_->title() : QString();
  const QString title = what.isEmpty() ? QString() : what + QStringLiteral(" ...");
  header_->setCaseTitle(title, {});
  setWindowTitle(title.isEmpty() ? QStringLiteral("Insonate") : QStringLiteral("%1 - Insonate").arg(title));
  for (const Room& room : rooms_) room.workspace->setOpening(what);
}

CaseOrigin MainWindow::origin() const {
  return {case_.folder, case_.notes, case_.builtIn, case_.versionOf};
}

void MainWindow::handOut() {
  for (const Room& room : rooms_) {
    room.workspace->setOrigin(origin());
    room.workspace->setCase(case_.patient);
  }
  showTitle();
  updateStatus();
  Q_EMIT readyChanged();
}

void MainWindow::showHelp(bool keys) {
  if (!help_) help_ = new HelpWindow(this);
  ShortcutGroup everywhere{tr("Everywhere"), {}};
  for (const QAction* action : actions())
    if (!action->shortcut().isEmpty())
      everywhere.shortcuts.push_back({action->shortcut().toString(QKeySequence::NativeText), action->text()});
  everywhere.shortcuts.push_back({tr("Alt+C, Alt+V"), tr("Case and View menus")});
  everywhere.shortcuts.push_back({tr("Esc"), tr("cancel a job, close a message")});
  const ShortcutGroup views{tr("In every view"), {{tr("M, double click"), tr("maximize this view, and restore it")}}};
  std::vector<ShortcutGroup> groups{std::move(everywhere), views};
  for (const Room& room : rooms_) {
    // Commands of the current workspace come first.
    auto place = room.workspace == currentWorkspace() ? groups.begin() : groups.end();
    for (ShortcutGroup section : room.workspace->commands().shortcuts()) {
      section.place = section.place.isEmpty() ? room.title : tr("%1: %2").arg(room.title, section.place);
      place = std::next(groups.insert(place, std::move(section)));
    }
    if (auto shortcuts = room.workspace->shortcuts(); !shortcuts.empty())
      groups.insert(place, {room.title, std::move(shortcuts)});
  }
  help_->setShortcuts(groups);
  if (keys)
    help_->showKeys();
  else
    help_->showPage(currentWorkspace()->helpPage());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QString path = carriedPath(event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  status_->setStanding(tr("Drop to open %1.").arg(QFileInfo(path).fileName()));
}

void MainWindow::dragLeaveEvent(QDragLeaveEvent*) {
  updateStatus();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QString path = carriedPath(event->mimeData());
  updateStatus();
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  open(path);
}

}  // namespace insonate::ui
