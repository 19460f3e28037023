#include "AccountMenu.h"
#include "CaseController.h"
#include "DatabaseWindow.h"
#include "HandsDialog.h"
#include "HeaderBar.h"
#include "HelpWindow.h"
#include "LibraryWindow.h"
#include "StatusStrip.h"
#include "WindowMenu.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/ErrorPanel.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/SiteExchange.h>
#include <insonate/ui/Sound.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>

#include <QAction>
#include <QCloseEvent>
#include <QDialog>
#include <QDropEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>
#include <utility>

namespace insonate::ui {
namespace {

const QString kGeometry = QStringLiteral("window/geometry");
/// A screen of 1366 x 768 at a scale of 1.5, minus its bars.
constexpr QSize kLeast{880, 460};
const QString kWorkspace = QStringLiteral("window/workspace");

/// The first local file or folder of a drag; empty if there is none.
QString carriedPath(const QMimeData* data) {
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) return url.toLocalFile();
  return {};
}

/// The window's commands, which its parts add below one heading.
Commands* windowCommands(QObject* window) {
  auto* commands = new Commands(window);
  commands->beginSection(MainWindow::tr("Everywhere"));
  commands->addListed(MainWindow::tr("Esc"), MainWindow::tr("cancels a job, or closes a message"));
  commands->beginSection(MainWindow::tr("Keys of every view"));
  commands->addListed(MainWindow::tr("M, double click"), MainWindow::tr("maximizes this view, or restores it"));
  commands->beginSection(MainWindow::tr("Everywhere"));
  return commands;
}

}  // namespace

MainWindow::MainWindow() : MainWindow(std::make_unique<Account>()) {}

MainWindow::MainWindow(std::unique_ptr<Account> account)
    : account_(std::move(account)),
      commands_(windowCommands(this)),
      site_(new SiteExchange(*account_, this)),
      accountMenu_(new AccountMenu(*account_, *site_, *commands_, this)),
      tasks_(new TaskBar),
      controller_(new CaseController(*tasks_, this)),
      sound_(new Sound(this)),
      menu_(new WindowMenu(*controller_, *sound_, *commands_, this)),
      view_(new QMenu(this)),
      header_(new HeaderBar(view_, menu_, accountMenu_, *commands_)),
      errors_(new ErrorPanel),
      stack_(new QStackedWidget),
      status_(new StatusStrip) {
  setWindowTitle(QStringLiteral("Insonate"));
  setAcceptDrops(true);
  view_->setToolTipsVisible(true);
  arrange();
  connectParts();
  connectController();
  header_->setCaseTitle({}, {});
}

MainWindow::~MainWindow() {
  // Hiding notifies a workspace, which must happen while the window exists.
  for (const Room& room : rooms_) {
    room.workspace->disconnect(this);
    room.workspace->disconnect(controller_);
  }
  controller_->disconnect();
  // Workspaces may still have to write data of the user.
  delete takeCentralWidget();
}

void MainWindow::arrange() {
  auto* center = new QWidget;
  auto* column = new QVBoxLayout(center);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(header_);
  column->addWidget(errors_);
  column->addWidget(stack_, 1);
  // A long job is shown beside the status line, so that nothing moves when it appears and disappears.
  auto* foot = new QWidget;
  foot->setObjectName(QStringLiteral("foot"));
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(status_, 1);
  row->addWidget(tasks_);
  foot->setFixedHeight(std::max(status_->sizeHint().height(), tasks_->sizeHint().height()));
  column->addWidget(foot);
  setCentralWidget(center);
  setMinimumSize(kLeast);
  const QSize screen = QGuiApplication::primaryScreen() ? QGuiApplication::primaryScreen()->availableSize() : QSize();
  resize(QSize(1600, 1000).boundedTo(screen * 0.9).expandedTo(minimumSize()));
}

void MainWindow::connectParts() {
  connect(header_, &HeaderBar::tabChosen, this, &MainWindow::switchTo);
  connect(account_.get(), &Account::changed, this, &MainWindow::readyChanged);
  connect(accountMenu_, &AccountMenu::firstAsked, this, [this] { askHands(); });
  connect(accountMenu_, &AccountMenu::databaseRequested, this,
          [this] { (new DatabaseWindow(*account_, *tasks_, this))->show(); });
  connect(accountMenu_, &AccountMenu::authoringChosen, this, [this] {
    showWorkspace(QStringLiteral("prepare"));
    help().showPage(startPage());
  });
  connect(accountMenu_, &AccountMenu::statusMessage, this,
          [this](const QString& sentence) { status_->showMessage(sentence); });
  connect(accountMenu_, &AccountMenu::helpRequested, this, [this](const QString& page) { help().showPage(page); });
  connect(status_, &StatusStrip::helpRequested, this, [this] { help().showPage(currentWorkspace()->helpPage()); });
  connect(view_, &QMenu::aboutToShow, this, &MainWindow::fillView);
  connect(menu_, &WindowMenu::openRequested, this, &MainWindow::open);
  connect(menu_, &WindowMenu::attemptRequested, this, &MainWindow::openAttempt);
  connect(menu_, &WindowMenu::libraryRequested, this, &MainWindow::showLibrary);
  connect(menu_, &WindowMenu::helpRequested, this, [this] { help().showPage(currentWorkspace()->helpPage()); });
  connect(menu_, &WindowMenu::startRequested, this, [this] { help().showPage(startPage()); });
  connect(menu_, &WindowMenu::glossaryRequested, this, [this] { help().showPage(QStringLiteral("glossary")); });
  connect(menu_, &WindowMenu::keysRequested, this, [this] { help().showKeys(); });
}

void MainWindow::connectController() {
  connect(controller_, &CaseController::changed, this, &MainWindow::showTitle);
  connect(controller_, &CaseController::replaced, this, [this] {
    updateStatus();
    Q_EMIT readyChanged();
  });
  connect(controller_, &CaseController::statusMessage, status_, &StatusStrip::showMessage);
  connect(controller_, &CaseController::failed, this, &MainWindow::fail);
  connect(controller_, &CaseController::loadFailed, this, &MainWindow::caseFailed);
  connect(tasks_, &TaskBar::runningChanged, this, [this](bool running) {
    if (running) errors_->dismiss();
    showOpening();
    Q_EMIT readyChanged();
  });
}

void MainWindow::addWorkspace(const QString& id, const QString& title, const QString& iconName, Workspace* workspace) {
  const int index = int(rooms_.size());
  rooms_.push_back({id, title, workspace});
  workspace->setTasks(*tasks_);
  workspace->setSound(*sound_);
  workspace->setAccount(*account_);
  connect(workspace, &Workspace::written, this,
          [this](const QString& sentence, const QString& folder) { status_->showMessage(sentence, folder); });
  stack_->addWidget(workspace);
  auto* choose = new QAction(title, this);
  choose->setShortcut(QKeySequence(QStringLiteral("Ctrl+%1").arg(index + 1)));
  commands_->add(QStringLiteral("window.tab.") + id, tr("shows %1").arg(title), *choose);
  header_->addTab(title, iconName, choose->toolTip());
  connect(choose, &QAction::triggered, this, [this, index] { switchTo(index); });
  addAction(choose);
  connect(workspace, &Workspace::statusChanged, this, &MainWindow::updateStatus);
  connect(workspace, &Workspace::readyChanged, this, &MainWindow::readyChanged);
  connect(workspace, &Workspace::failed, this, &MainWindow::fail);
  connect(workspace, &Workspace::caseRequested, this,
          [this](const QString& place) { builtInCaseNames().contains(place) ? openBuiltIn(place) : open(place); });
  connect(workspace, &Workspace::attemptRequested, this, &MainWindow::openAttempt);
  menu_->setOpensAttempts(attemptRoom() != nullptr);
  controller_->addWorkspace(*workspace);
  if (index == 0) header_->setTab(0);
}

void MainWindow::switchTo(int index) {
  const int now = stack_->currentIndex();
  if (const QString why = index == now ? QString() : currentWorkspace()->workspaceChangeBlocker(); !why.isEmpty()) {
    header_->setTab(now);
    return status_->showMessage(why);
  }
  header_->setTab(index);
  stack_->setCurrentIndex(index);
  currentWorkspace()->setFocus();
  updateStatus();
  Q_EMIT readyChanged();
}

bool MainWindow::showWorkspace(const QString& id) {
  for (std::size_t i = 0; i < rooms_.size(); ++i) {
    if (rooms_[i].id != id) continue;
    switchTo(int(i));
    return true;
  }
  return false;
}

Workspace* MainWindow::currentWorkspace() const {
  return rooms_.empty() ? nullptr : rooms_[std::size_t(stack_->currentIndex())].workspace;
}

QString MainWindow::currentId() const {
  return rooms_.empty() ? QString() : rooms_[std::size_t(stack_->currentIndex())].id;
}

void MainWindow::updateStatus() {
  const Workspace* workspace = currentWorkspace();
  if (!workspace) return;
  status_->setStanding(workspace->statusText());
  status_->setEngine(workspace->engineText(), workspace->engineNote());
}

bool MainWindow::isReady() const {
  return controller_->current().patient && !tasks_->isRunning() && currentWorkspace() && currentWorkspace()->isReady();
}

bool MainWindow::isComplete() const {
  return isReady() && account_->state() != Account::State::Opening && currentWorkspace()->isComplete();
}

void MainWindow::fail(const QString& what, const QString& advice, const QString& details) {
  errors_->showError(what, advice, details);
}

QString MainWindow::statusText() const {
  return status_->text();
}

QString MainWindow::caseTitle() const {
  return header_->caseTitle();
}

void MainWindow::askAtFirstStart() {
  accountMenu_->askAtFirstStart();
}

/// Asks with which hands the user trains, once no other dialog is open. An author needs no hands.
void MainWindow::askHands() {
  if (currentId() == QStringLiteral("prepare")) return;
  for (QDialog* other : findChildren<QDialog*>())
    if (other->isVisible()) {
      connect(other, &QDialog::finished, this, [this] { QTimer::singleShot(0, this, [this] { askHands(); }); });
      return;
    }
  auto* dialog = new HandsDialog(this);
  connect(dialog, &HandsDialog::chosen, this, &MainWindow::handsChosen);
  dialog->open();
}

void MainWindow::restoreLayout() {
  QSettings settings;
  restoreGeometry(settings.value(kGeometry).toByteArray());
  for (const Room& room : rooms_) {
    settings.beginGroup(room.id);
    room.workspace->restoreLayout(settings);
    settings.endGroup();
  }
  showWorkspace(settings.value(kWorkspace).toString());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!sure_ && controller_->loss(LostBy::Closing)) {
    event->ignore();
    return controller_->confirmDiscard(LostBy::Closing, [this] { closeAtOnce(); });
  }
  QSettings settings;
  settings.setValue(kGeometry, saveGeometry());
  settings.setValue(kWorkspace, currentId());
  for (const Room& room : rooms_) {
    settings.beginGroup(room.id);
    room.workspace->saveLayout(settings);
    settings.endGroup();
  }
  // The window is hidden at once; running work is stopped, and the program waits for it in the background.
  hide();
  tasks_->cancel();
  for (const Room& room : rooms_) room.workspace->stop();
  event->accept();
  QMainWindow::closeEvent(event);
}

void MainWindow::closeAtOnce() {
  sure_ = true;
  close();
}

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && tasks_->isUserWaiting())
    tasks_->cancel();
  else if (event->key() == Qt::Key_Escape && errors_->isVisible())
    errors_->dismiss();
  else if (!passKey(*event))
    QMainWindow::keyPressEvent(event);
}

bool MainWindow::passKey(QKeyEvent& event) {
  // Space freezes wherever the keyboard focus is. Keys that the workspace does not use return to the window.
  Workspace* workspace = currentWorkspace();
  if (passing_ || !workspace || workspace->isAncestorOf(focusWidget()) || focusWidget() == workspace) return false;
  passing_ = true;
  QCoreApplication::sendEvent(workspace, &event);
  passing_ = false;
  return event.isAccepted();
}

void MainWindow::fillView() {
  view_->clear();
  view_->addActions(currentWorkspace()->actions());
  if (view_->isEmpty()) view_->addAction(tr("No actions in this tab"))->setEnabled(false);
}

const LoadedCase& MainWindow::current() const {
  return controller_->current();
}

void MainWindow::open(const QString& path) {
  attemptRoom() && isAttemptFile(path) ? openAttempt(path) : controller_->open(path);
}

void MainWindow::openTextbook() {
  openBuiltIn(builtInCaseNames().front());
}

void MainWindow::openBuiltIn(const QString& variant) {
  controller_->openBuiltIn(variant);
}

void MainWindow::reload() {
  controller_->reload();
}

void MainWindow::saveCase() {
  controller_->save();
}

void MainWindow::showLibrary() {
  if (auto* shown = findChild<LibraryWindow*>()) return shown->raise();
  auto* library = new LibraryWindow(this, currentId());
  connect(library, &LibraryWindow::caseChosen, this, [this](const QString& place, const QString& workspace) {
    showWorkspace(workspace);
    if (builtInCaseNames().contains(place)) return openBuiltIn(place);
    open(workspace == QLatin1String("train") ? trainingLocation(place) : place);
  });
  library->show();
}

const MainWindow::Room* MainWindow::attemptRoom() const {
  const auto found = std::ranges::find_if(rooms_, [](const Room& room) { return room.workspace->canOpenAttempts(); });
  return found == rooms_.end() ? nullptr : &*found;
}

void MainWindow::openAttempt(const QString& file) {
  const Room* room = attemptRoom();
  if (!room) return;
  const auto go = [this, room, file] {
    showWorkspace(room->id);
    room->workspace->openAttempt(file);
  };
  // An unsaved case is at risk only if the attempt belongs to another case; the window asks then.
  tasks_->asksWhenClosed() ? controller_->confirmDiscard(LostBy::Opening, go) : go();
}

void MainWindow::showTitle() {
  if (!current().patient) return;
  const CaseManifest& manifest = current().patient->manifest;
  QString title = QString::fromStdString(manifest.title), hint = QString::fromStdString(manifest.description);
  if (controller_->isWithoutFolder())
    title += tr(" (not saved)");
  else if (controller_->isChanged())
    title += tr(" (changed)");
  if (!current().folder.isEmpty()) hint += (hint.isEmpty() ? QString() : QStringLiteral("\n")) + current().folder;
  header_->setCaseTitle(title, hint);
  setWindowTitle(QStringLiteral("%1 - Insonate").arg(title));
}

/// Without a case, the running job will open one.
void MainWindow::showOpening() {
  if (current().patient) return;
  const QString what = tasks_->isRunning() ? tasks_->title() : QString();
  const QString title = what.isEmpty() ? QString() : what + QStringLiteral(" ...");
  header_->setCaseTitle(title, {});
  setWindowTitle(title.isEmpty() ? QStringLiteral("Insonate") : QStringLiteral("%1 - Insonate").arg(title));
  for (const Room& room : rooms_) room.workspace->setOpeningText(what);
}

std::vector<ShortcutGroup> MainWindow::keyList() const {
  std::vector<ShortcutGroup> groups = commands_->shortcuts();
  for (const Room& room : rooms_) {
    // Commands of the current workspace come first.
    auto place = room.workspace == currentWorkspace() ? groups.begin() : groups.end();
    for (ShortcutGroup section : room.workspace->commands().shortcuts()) {
      section.place = section.place.isEmpty() ? room.title : tr("%1: %2").arg(room.title, section.place);
      place = std::next(groups.insert(place, std::move(section)));
    }
  }
  return groups;
}

/// The page of the user's first steps. An author is no role of the store, and one person who trains alone is the
/// administrator, so the workspace decides, too.
QString MainWindow::startPage() const {
  if (currentId() == QStringLiteral("prepare")) return QStringLiteral("first-case");
  const Role role = account_->isSignedIn() ? account_->person().role : Role::Trainee;
  const bool teaches =
      role == Role::Instructor ||
      (role == Role::Administrator && (currentId() == QStringLiteral("review") || accountMenu_->hasSetUpClass()));
  return teaches ? QStringLiteral("first-class") : QStringLiteral("first-line");
}

/// The help window with the present list of keys.
HelpWindow& MainWindow::help() {
  if (!help_) help_ = new HelpWindow(this);
  help_->setShortcuts(keyList());
  return *help_;
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QString path = carriedPath(event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  status_->setStanding(tr("Release the mouse button to open %1.").arg(QFileInfo(path).fileName()));
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
