#include "LibraryWindow.h"

#include "JobThreads.h"
#include "LibraryCard.h"
#include "LibraryModel.h"
#include "LibraryReader.h"

#include <insonate/site/CaseDownload.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace insonate::ui {
namespace {

QComboBox* choice(const char* name, const QString& spoken, const QString& tip,
                  std::initializer_list<std::pair<QString, QVariant>> choices) {
  auto* box = choiceBox(name, spoken, tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  for (const auto& [words, value] : choices) box->addItem(words, value);
  return box;
}

/// Includes the cases that were opened or saved on this computer, in any folder, and those of the site's server.
QStringList knownFolders() {
  QStringList folders;
  for (const RecentCase& one : recentCases()) folders << QDir(one.folder).absolutePath();
  for (const auto& place : downloadedCases(downloadFolder().toStdString()))
    folders << QString::fromStdString(place.string());
  return folders;
}

const QString kTrain = QStringLiteral("train"), kPrepare = QStringLiteral("prepare");

QString keysFor(bool isFirst) {
  return isFirst ? LibraryWindow::tr("Enter, double click") : LibraryWindow::tr("Ctrl+Enter");
}

bool lies(const QString& place, const QString& folder) {
  return place == folder || place.startsWith(folder + QLatin1Char('/'));
}

}  // namespace

LibraryWindow::LibraryWindow(QWidget* parent, const QString& workspace)
    : QDialog(parent),
      workspace_(workspace == kPrepare ? kPrepare : kTrain),
      other_(workspace_ == kTrain ? kPrepare : kTrain),
      model_(new LibraryModel(this)),
      filter_(new LibraryFilter(*model_, this)),
      search_(new QLineEdit),
      grade_(choice("libraryGrade", tr("Difficulty"), tr("Show only cases of this difficulty"),
                    {{tr("all difficulties"), QString()},
                     {tr("easy"), QStringLiteral("easy")},
                     {tr("moderate"), QStringLiteral("moderate")},
                     {tr("hard"), QStringLiteral("hard")}})),
      fitness_(choice("libraryFitness", tr("Fitness"),
                      tr("Show only cases that are fit for training, only cases that are not, or both"),
                      {{tr("fit for training or not"), int(LibraryFilter::Fitness::All)},
                       {tr("fit for training"), int(LibraryFilter::Fitness::Fit)},
                       {tr("not fit for training"), int(LibraryFilter::Fitness::Unfit)}})),
      order_(choice("libraryOrder", tr("Order"), tr("Order of the cases"),
                    {{tr("easy first, ungraded last"), int(LibraryFilter::Order::Difficulty)},
                     {tr("by title"), int(LibraryFilter::Order::Title)},
                     {tr("newest first"), int(LibraryFilter::Order::Newest)}})),
      list_(new QListView),
      state_(new QLabel),
      empty_(new QLabel),
      train_(pushButton(
          "libraryTrain", tr("Open in Train"),
          tr("Opens the published version of the selected case for practice (%1)").arg(keysFor(workspace_ == kTrain)))),
      prepare_(pushButton(
          "libraryPrepare", tr("Open in Prepare"),
          tr("Opens the selected case in its current state for editing (%1)").arg(keysFor(workspace_ == kPrepare)))),
      add_(pushButton("libraryAdd", tr("Add folder ..."),
                      tr("Adds the cases in a folder and its subfolders to this list"))),
      remove_(pushButton("libraryRemove", tr("Remove folder"),
                         tr("Removes the selected case's folder from this list; the disk is not changed"))) {
  setWindowTitle(tr("Case library"));
  setAttribute(Qt::WA_DeleteOnClose);
  arrange();
  connectAll();
  look();
}

LibraryWindow::~LibraryWindow() {
  *stopped_ = true;
}

void LibraryWindow::arrange() {
  search_->setObjectName(QStringLiteral("librarySearch"));
  search_->setPlaceholderText(tr("Search title, structures, difficulty"));
  search_->setAccessibleName(tr("Search"));
  search_->setToolTip(tr("Words to find in title, description, structures or difficulty"));
  search_->setClearButtonEnabled(true);
  search_->installEventFilter(this);
  list_->setObjectName(QStringLiteral("libraryList"));
  list_->setAccessibleName(tr("Cases"));
  list_->setModel(filter_);
  list_->setItemDelegate(new LibraryCard(*filter_, list_));
  list_->setUniformItemSizes(true);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->installEventFilter(this);
  empty_->setWordWrap(true);
  empty_->setObjectName(QStringLiteral("libraryEmpty"));
  state_->setObjectName(QStringLiteral("libraryState"));
  for (QLabel* words : {state_, empty_}) setRole(words, "quiet");
  setRole(workspace_ == kTrain ? train_ : prepare_, "primary");

  auto* first = new QHBoxLayout;
  first->setSpacing(kGap);
  first->addWidget(search_, 1);
  for (QWidget* one : {grade_, fitness_, order_}) first->addWidget(one);
  auto* last = new QHBoxLayout;
  last->setSpacing(kGap);
  last->addWidget(add_);
  last->addWidget(remove_);
  last->addWidget(state_, 1);
  // The primary button is the last one.
  last->addWidget(workspace_ == kTrain ? prepare_ : train_);
  last->addWidget(workspace_ == kTrain ? train_ : prepare_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kLargeGap, kLargeGap, kLargeGap, kLargeGap);
  column->setSpacing(kGap);
  column->addLayout(first);
  column->addWidget(list_, 1);
  column->addWidget(empty_);
  column->addLayout(last);
  resize(980, 640);
}

void LibraryWindow::connectAll() {
  connect(search_, &QLineEdit::textChanged, this, [this](const QString& words) {
    filter_->setWords(words);
    showState();
  });
  connect(grade_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    filter_->setGrade(grade_->currentData().toString());
    showState();
  });
  connect(fitness_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    filter_->setFitness(LibraryFilter::Fitness(fitness_->currentData().toInt()));
    showState();
  });
  connect(order_, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this] { filter_->setOrder(LibraryFilter::Order(order_->currentData().toInt())); });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] { showState(); });
  connect(list_, &QListView::doubleClicked, this, [this] { openChosen(workspace_); });
  connect(train_, &QPushButton::clicked, this, [this] { openChosen(kTrain); });
  connect(prepare_, &QPushButton::clicked, this, [this] { openChosen(kPrepare); });
  connect(add_, &QPushButton::clicked, this, &LibraryWindow::addFolder);
  connect(remove_, &QPushButton::clicked, this, &LibraryWindow::removeFolder);
}

bool LibraryWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const auto& key = *static_cast<QKeyEvent*>(event);
  if (key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter) {
    openChosen(key.modifiers() & Qt::ControlModifier ? other_ : workspace_);
    return true;
  }
  if (watched == search_ && (key.key() == Qt::Key_Down || key.key() == Qt::Key_Up)) {
    list_->setFocus();
    QCoreApplication::sendEvent(list_, event);
    return true;
  }
  return QDialog::eventFilter(watched, event);
}

void LibraryWindow::setFolders(const QStringList& folders) {
  setLibraryFolders(folders);
  look();
}

/// Titles first, then one case after the other.
void LibraryWindow::look() {
  if (stopped_) *stopped_ = true;
  stopped_ = std::make_shared<std::atomic<bool>>(false);
  done_ = false;
  const auto tell = [self = QPointer(this), stopped = stopped_](std::function<void(LibraryWindow&)> what) {
    QMetaObject::invokeMethod(qApp, [self, stopped, what = std::move(what)] {
      if (self && !*stopped) what(*self);
    });
  };
  runInBackground([tell, stopped = stopped_, folders = libraryFolders() + knownFolders(), builtIn = builtInCaseNames(),
                   cache = libraryCache()] {
    std::vector<LibraryEntry> listed;
    // The user's cases first: a built-in neck may have to be computed, which takes seconds.
    for (const QString& folder : casesIn(folders)) listed.push_back(listedCase(folder, false));
    for (const QString& name : builtIn) listed.push_back(listedCase(name, true));
    tell([listed](LibraryWindow& window) { window.take(listed); });
    const Progress goOn = [stopped](std::string_view, double) { return !*stopped; };
    for (const LibraryEntry& one : listed) {
      if (*stopped) return;
      tell([known = knownCase(one, cache, goOn)](LibraryWindow& window) {
        window.model_->update(known);
        --window.left_;
        window.showState();
      });
    }
    tell([](LibraryWindow& window) {
      window.done_ = true;
      window.showState();
    });
  });
  showState();
}

void LibraryWindow::take(std::vector<LibraryEntry> listed) {
  left_ = int(listed.size());
  model_->setEntries(std::move(listed));
  list_->setCurrentIndex(filter_->index(0, 0));
  showState();
}

const LibraryEntry* LibraryWindow::chosen() const {
  const QModelIndex index = list_->currentIndex();
  return index.isValid() ? &filter_->entry(index) : nullptr;
}

void LibraryWindow::showState() {
  const LibraryEntry* one = chosen();
  const bool opens = one && one->state != LibraryEntry::State::Broken;
  train_->setEnabled(opens);
  prepare_->setEnabled(opens);
  const QStringList all = libraryFolders();
  remove_->setEnabled(one && std::ranges::any_of(all, [&](const QString& folder) { return lies(one->place, folder); }));
  const int shown = filter_->rowCount(), count = model_->rowCount();
  QString words = shown == count ? tr("%1 cases").arg(count) : tr("%1 of %2 cases").arg(shown).arg(count);
  if (left_ > 0) words += tr("; %1 of %2 are read").arg(count - left_).arg(count);
  state_->setText(words);
  const bool none = shown == 0 && count > 0, onlyBuiltIn = all.isEmpty();
  empty_->setVisible(none || onlyBuiltIn);
  empty_->setText(
      none ? tr("No case matches. Use fewer search words, or show cases of all difficulties, also cases "
                "that are not fit for training.")
           : tr("This list contains the built-in cases and the cases that you opened recently. Add the folder that "
                "contains your own cases."));
}

void LibraryWindow::addFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Add a folder with cases"), QDir::homePath());
  if (folder.isEmpty()) return;
  QStringList all = libraryFolders();
  if (!all.contains(folder)) setFolders(all << folder);
}

void LibraryWindow::removeFolder() {
  const LibraryEntry* one = chosen();
  if (!one) return;
  QStringList all = libraryFolders();
  all.erase(std::remove_if(all.begin(), all.end(), [&](const QString& folder) { return lies(one->place, folder); }),
            all.end());
  setFolders(all);
}

void LibraryWindow::openChosen(const QString& workspace) {
  const LibraryEntry* one = chosen();
  if (!one || one->state == LibraryEntry::State::Broken) return;
  Q_EMIT caseChosen(one->place, workspace);
  close();
}

}  // namespace insonate::ui
