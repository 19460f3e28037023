#include "CaseController.h"

#include "CaseExchange.h"

#include <insonate/ui/RecentCases.h>
#include <insonate/ui/TaskBar.h>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QTimer>
#include <optional>
#include <utility>

namespace insonate::ui {
namespace {

const QString kLastTarget = QStringLiteral("lastTarget");

/// A name that is valid in every file system.
QString folderNameFor(const std::string& title) {
  QString name;
  for (const QChar c : QString::fromStdString(title).simplified())
    if (c.isLetterOrNumber() || c == QLatin1Char(' ')) name += c;
  return name.isEmpty() ? CaseController::tr("Case") : name.left(60);
}

}  // namespace

CaseController::CaseController(TaskBar& tasks, QWidget* window)
    : QObject(window),
      tasks_(tasks),
      window_(window),
      loader_(new CaseLoader(tasks, window)),
      exchange_(new CaseExchange(
          tasks,
          [this] {
            return OpenCase{case_.patient, unsavedEdits()};
          },
          window)) {
  connectLoader();
  connect(exchange_, &CaseExchange::made, this,
          [this](const std::shared_ptr<const PatientCase>& patient, const QString& sentence) {
            confirmDiscard(LostBy::Cropping, [this, patient, sentence] {
              take(patient);
              Q_EMIT statusMessage(sentence, {});
            });
          });
  connect(exchange_, &CaseExchange::labelsReplaced, this,
          [this](const std::shared_ptr<const PatientCase>& patient, const QString& sentence) {
            const auto go = [this, patient, sentence] {
              takeLabeled(patient);
              Q_EMIT statusMessage(sentence, {});
            };
            // The case holds all edits: the window asks only about work that ends with the case.
            loss(LostBy::Opening).ending.isEmpty() ? go() : confirmDiscard(LostBy::Opening, go);
          });
  connect(exchange_, &CaseExchange::written, this, &CaseController::statusMessage);
  connect(exchange_, &CaseExchange::failed, this, &CaseController::failed);
  connect(&tasks_, &TaskBar::runningChanged, this, &CaseController::changed);
}

void CaseController::connectLoader() {
  connect(loader_, &CaseLoader::loaded, this, &CaseController::takeLoaded);
  connect(loader_, &CaseLoader::saved, this, &CaseController::takeSaved);
  connect(loader_, &CaseLoader::failed, this,
          [this](const QString& what, const QString& advice, const QString& details) {
            afterSaving_ = {};
            Q_EMIT failed(what, advice, details);
            Q_EMIT loadFailed(what);
          });
  connect(loader_, &CaseLoader::cancelled, this, [this] {
    afterSaving_ = {};
    Q_EMIT statusMessage(tr("Canceled; nothing was changed."), {});
  });
}

void CaseController::addWorkspace(Workspace& workspace) {
  workspaces_.push_back(&workspace);
  connect(&workspace, &Workspace::caseMade, this, &CaseController::take);
  connect(&workspace, &Workspace::editsChanged, this, &CaseController::changed);
  connect(&workspace, &Workspace::saveRequested, this, &CaseController::save);
}

bool CaseController::isChanged() const {
  return labelsReplaced_ || !unsavedEdits().empty();
}

bool CaseController::isSaveUseful() const {
  return case_.patient && (case_.folder.isEmpty() || isChanged() || !quietEdits().empty());
}

bool CaseController::isBusy() const {
  return tasks_.isUserWaiting();
}

QString CaseController::jobTitle() const {
  return tasks_.title();
}

bool CaseController::isWithoutFolder() const {
  return case_.patient && case_.folder.isEmpty() && !case_.builtIn && case_.versionOf.isEmpty();
}

void CaseController::open(const QString& path) {
  confirmDiscard(LostBy::Opening, [this, path] { loader_->open(path); });
}

void CaseController::openBuiltIn(const QString& variant) {
  confirmDiscard(LostBy::Opening, [this, variant] { loader_->openBuiltIn(variant); });
}

void CaseController::reload() {
  if (!case_.folder.isEmpty()) open(case_.folder);
}

void CaseController::takeLoaded(const LoadedCase& loaded) {
  case_ = loaded;
  labelsReplaced_ = false;
  const QString title = QString::fromStdString(case_.patient->manifest.title);
  const QString& home = case_.versionOf.isEmpty() ? case_.folder : case_.versionOf;
  if (!home.isEmpty() && !origin().isDownloaded()) rememberCase({home, title});
  handOut();
  Q_EMIT statusMessage(case_.notes.isEmpty() ? tr("Opened %1.").arg(title) : case_.notes.join(QLatin1Char(' ')), {});
}

void CaseController::take(std::shared_ptr<const PatientCase> patient) {
  case_.patient = std::move(patient);
  labelsReplaced_ = false;
  case_.folder.clear();
  case_.builtIn = false;
  case_.versionOf.clear(), case_.readFrom.clear();
  handOut();
}

void CaseController::takeLabeled(std::shared_ptr<const PatientCase> patient) {
  if (case_.folder.isEmpty() || origin().isDownloaded()) return take(std::move(patient));
  case_.patient = std::move(patient);
  labelsReplaced_ = true;
  handOut();
}

CaseOrigin CaseController::origin() const {
  return {case_.folder, case_.notes, case_.builtIn, case_.versionOf, case_.readFrom, labelsReplaced_};
}

void CaseController::handOut() {
  for (Workspace* workspace : workspaces_) {
    workspace->setOrigin(origin());
    workspace->setCase(case_.patient);
  }
  Q_EMIT changed();
  Q_EMIT replaced();
}

std::vector<CaseEdit> CaseController::unsavedEdits() const {
  std::vector<CaseEdit> edits;
  for (const Workspace* workspace : workspaces_)
    if (CaseEdit edit = workspace->unsavedEdit()) edits.push_back(std::move(edit));
  return edits;
}

std::vector<CaseEdit> CaseController::quietEdits() const {
  std::vector<CaseEdit> edits;
  for (const Workspace* workspace : workspaces_)
    if (CaseEdit edit = workspace->unpromptedEdit()) edits.push_back(std::move(edit));
  return edits;
}

void CaseController::tellBusy() {
  afterSaving_ = {};
  Q_EMIT statusMessage(tr("Not saved: wait until \"%1\" has ended, then save again.").arg(tasks_.title()), {});
}

void CaseController::save() {
  if (!case_.patient) return;
  if (isBusy()) return tellBusy();
  if (case_.folder.isEmpty())
    saveAs();
  else
    saveTo(case_.folder);
}

void CaseController::saveAs() {
  if (isBusy()) return tellBusy();
  QFileDialog dialog(window_, tr("Save the case to a new folder"),
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

void CaseController::saveTo(const QString& folder) {
  std::vector<CaseEdit> edits = unsavedEdits();
  for (CaseEdit& edit : quietEdits()) edits.push_back(std::move(edit));
  const bool kept = folder == case_.folder;
  loader_->save(case_.patient, folder, std::move(edits), kept ? std::optional(case_.content) : std::nullopt);
}

void CaseController::takeSaved(const SavedCase& saved) {
  case_.folder = saved.folder;
  labelsReplaced_ = false;
  case_.builtIn = false;
  case_.versionOf.clear();
  case_.readFrom = saved.folder;
  case_.content = saved.content;
  const bool edited = saved.patient != std::exchange(case_.patient, saved.patient);
  rememberCase({saved.folder, QString::fromStdString(saved.patient->manifest.title)});
  for (Workspace* workspace : workspaces_) {
    workspace->setOrigin(origin());
    if (edited) workspace->caseSaved(saved.patient);
  }
  Q_EMIT changed();
  const QString also =
      tr(" Another user had saved the case in the meantime; the other user's version is kept as a previous version.");
  Q_EMIT statusMessage(tr("Saved to %1.").arg(saved.folder) + (saved.overwroteOther ? also : QString()), {});
  if (const auto go = std::exchange(afterSaving_, {})) QTimer::singleShot(0, this, go);
}

Loss CaseController::loss(LostBy by) const {
  Loss loss;
  if (tasks_.asksWhenClosed()) loss.job = tasks_.title();
  for (const Workspace* workspace : workspaces_) {
    if (loss.ending.isEmpty()) loss.ending = workspace->interruptionWarning();
    if (loss.ending.isEmpty() && by == LostBy::Closing) loss.ending = workspace->windowCloseWarning();
  }
  loss.nowhere = isWithoutFolder();
  if (loss.nowhere || isChanged()) loss.title = QString::fromStdString(case_.patient->manifest.title);
  return loss;
}

void CaseController::confirmDiscard(LostBy by, std::function<void()> go) {
  const Loss lost = loss(by);
  if (!lost) return go();
  if (auto* asked = window_->findChild<DiscardPrompt*>()) return asked->raise();
  auto* question = new DiscardPrompt(lost, by, window_);
  // After the dialog has closed, since the window must not delete it during its own close event.
  connect(question, &DiscardPrompt::continueChosen, this, [this, go] { QTimer::singleShot(0, this, go); });
  connect(question, &DiscardPrompt::saveChosen, this, [this, go] {
    afterSaving_ = go;
    save();
  });
  // The situation has changed: asks again if other work would be lost now, for example an import.
  connect(&tasks_, &TaskBar::runningChanged, question, [this, question, by, go] {
    if (!question->isVisible()) return;
    question->reject();
    QTimer::singleShot(0, this, [this, by, go] {
      if (loss(by)) confirmDiscard(by, go);
    });
  });
  question->open();
}

}  // namespace insonate::ui
