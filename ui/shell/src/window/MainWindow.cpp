#include "AccountMenu.h"
#include "CaseExchange.h"
#include "HeaderBar.h"
#include "LossQuestion.h"
#include "StatusStrip.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/ErrorPanel.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/SiteExchange.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Theme.h>

#include <QCloseEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMenu>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::ui {
namespace {

const QString kGeometry = QStringLiteral("window/geometry");
/// A screen of 1366 x 768 at a scale of 1.5, minus its bars.
constexpr QSize kLeast{880, 460};
const QString kWorkspace = QStringLiteral("window/workspace");

}  // namespace

MainWindow::MainWindow() : MainWindow(std::make_unique<Account>()) {}

MainWindow::MainWindow(std::unique_ptr<Account> account)
    : account_(std::move(account)),
      menu_(new QMenu(this)),
      recent_(new QMenu(tr("Recent"), this)),
      view_(new QMenu(this)),
      site_(new SiteExchange(*account_, this)),
      accountMenu_(new AccountMenu(*account_, *site_, this)),
      header_(new HeaderBar(view_, menu_, accountMenu_)),
      tasks_(new TaskBar),
      errors_(new ErrorPanel),
      stack_(new QStackedWidget),
      status_(new StatusStrip),
      loader_(new CaseLoader(*tasks_, this)),
      exchange_(new CaseExchange(
          *tasks_,
          [this] {
            return OpenCase{case_.patient, unsavedEdits()};
          },
          this)) {
  setWindowTitle(QStringLiteral("Insonate"));
  setAcceptDrops(true);
  makeActions();
  arrange();
  connectAll();
  header_->setCaseTitle({}, {});
}

MainWindow::~MainWindow() {
  // Hiding notifies a workspace, which must happen while the window exists.
  for (const Room& room : rooms_) room.workspace->disconnect(this);
  // Workspaces may still have to write data of the user.
  delete takeCentralWidget();
}

void MainWindow::arrange() {
  auto* centre = new QWidget;
  auto* column = new QVBoxLayout(centre);
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
  setCentralWidget(centre);
  setMinimumSize(kLeast);
  const QSize screen = QGuiApplication::primaryScreen() ? QGuiApplication::primaryScreen()->availableSize() : QSize();
  resize(QSize(1600, 1000).boundedTo(screen * 0.9).expandedTo(minimumSize()));
}

void MainWindow::connectAll() {
  connect(header_, &HeaderBar::tabChosen, this, &MainWindow::switchTo);
  connect(account_.get(), &Account::changed, this, &MainWindow::readyChanged);
  connect(accountMenu_, &AccountMenu::said, this, [this](const QString& sentence) { status_->say(sentence); });
  connect(status_, &StatusStrip::helpWanted, this, [this] { showHelp(false); });
  connect(recent_, &QMenu::aboutToShow, this, &MainWindow::fillRecent);
  connect(view_, &QMenu::aboutToShow, this, &MainWindow::fillView);
  connect(loader_, &CaseLoader::loaded, this, &MainWindow::take);
  connect(loader_, &CaseLoader::failed, this,
          [this](const QString& what, const QString& advice, const QString& details) {
            afterSaving_ = {};
            fail(what, advice, details);
            Q_EMIT caseFailed(what);
          });
  connect(loader_, &CaseLoader::cancelled, this, [this] {
    afterSaving_ = {};
    status_->say(tr("Cancelled; nothing was changed."));
  });
  connect(loader_, &CaseLoader::saved, this, &MainWindow::showSaved);
  connect(exchange_, &CaseExchange::made, this,
          [this](const std::shared_ptr<const PatientCase>& patient, const QString& sentence, bool whole) {
            const auto go = [this, patient, sentence] {
              takeMade(patient);
              status_->say(sentence);
            };
            // If the case holds all edits, the window asks only about work that ends with the case; the files stay.
            whole&& loss().ending.isEmpty() ? go() : confirmDiscard(LostBy::Opening, go);
          });
  connect(exchange_, &CaseExchange::written, this,
          [this](const QString& sentence, const QString& folder) { status_->say(sentence, folder); });
  connect(exchange_, &CaseExchange::failed, this, &MainWindow::fail);
  connect(tasks_, &TaskBar::runningChanged, this, [this](bool running) {
    if (running) errors_->dismiss();
    showTitle();
    showOpening();
    Q_EMIT readyChanged();
  });
}

void MainWindow::addWorkspace(const QString& id, const QString& title, const QString& iconName, Workspace* workspace) {
  const int index = int(rooms_.size());
  const QString keys = QStringLiteral("Ctrl+%1").arg(index + 1);
  rooms_.push_back({id, title, workspace});
  workspace->setTasks(*tasks_);
  workspace->setAccount(*account_);
  connect(workspace, &Workspace::written, this,
          [this](const QString& sentence, const QString& folder) { status_->say(sentence, folder); });
  stack_->addWidget(workspace);
  header_->addTab(title, iconName, keys);
  auto* choose = new QAction(title, this);
  choose->setShortcut(QKeySequence(keys));
  connect(choose, &QAction::triggered, this, [this, index] { switchTo(index); });
  addAction(choose);
  connect(workspace, &Workspace::statusChanged, this, &MainWindow::updateStatus);
  connect(workspace, &Workspace::readyChanged, this, &MainWindow::readyChanged);
  connect(workspace, &Workspace::failed, this, &MainWindow::fail);
  connect(workspace, &Workspace::caseMade, this, &MainWindow::takeMade);
  connect(workspace, &Workspace::caseWanted, this,
          [this](const QString& place) { builtInNames().contains(place) ? openBuiltIn(place) : open(place); });
  connect(workspace, &Workspace::attemptWanted, this, &MainWindow::openAttempt);
  attempt_->setVisible(attemptRoom() != nullptr);
  connect(workspace, &Workspace::editsChanged, this, &MainWindow::showTitle);
  connect(workspace, &Workspace::saveWanted, this, &MainWindow::saveCase);
  if (index == 0) header_->setTab(0);
}

void MainWindow::switchTo(int index) {
  const int now = stack_->currentIndex();
  if (const QString why = index == now ? QString() : currentWorkspace()->blocksWorkspaceChange(); !why.isEmpty()) {
    header_->setTab(now);
    return status_->say(why);
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
  return case_.patient && !tasks_->isRunning() && currentWorkspace() && currentWorkspace()->isReady();
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
  if (!sure_ && loss()) {
    event->ignore();
    return confirmDiscard(LostBy::Closing, [this] { closeAtOnce(); });
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

void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && tasks_->isRunning())
    tasks_->cancel();
  else if (event->key() == Qt::Key_Escape && errors_->isVisible())
    errors_->dismiss();
  else if (!passKey(*event))
    QMainWindow::keyPressEvent(event);
}

}  // namespace insonate::ui
