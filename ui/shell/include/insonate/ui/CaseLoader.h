#pragma once

#include <insonate/cases/Import.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/ui/Workspace.h>

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate::ui {

class SeriesDialog;
struct ImportChoice;
class TaskBar;

/// A case that was opened.
struct LoadedCase {
  std::shared_ptr<const PatientCase> patient;
  QString folder;     ///< folder of the case; empty if it was imported and not saved yet
  QStringList notes;  ///< sentences about what was missing or changed during loading
  bool builtIn = false;
  QString versionOf{};    ///< as in CaseOrigin
  std::string content{};  ///< CaseVersion::content when the case was read or written here
};

/// A case that was saved.
struct SavedCase {
  QString folder;
  std::shared_ptr<const PatientCase> patient;  ///< the saved case; the same object as before if there were no edits
  std::string content;                         ///< CaseVersion::content of the saved case
  /// Another user had saved to this folder meanwhile; that user's case stays as an earlier version.
  bool overAnother = false;
};

/// Loads cases without blocking the window: from a case folder, from DICOM, NRRD, NIfTI or MetaImage (asking for the
/// series if there are several), or a built-in neck. One case at a time: a later call cancels the earlier one. Each
/// open ends in exactly one of loaded(), failed() and cancelled().
class CaseLoader : public QObject {
  Q_OBJECT

 public:
  /// `dialogParent` is the window; it also owns the task bar.
  CaseLoader(TaskBar& tasks, QWidget* dialogParent);
  ~CaseLoader() override;

  /// Opens a folder or a file of any supported kind.
  void open(const QString& path);
  /// Opens a built-in neck (cases/Phantom.h). It is generated once and kept in the user's cache, so that the next start
  /// is quick.
  void openBuiltIn(const QString& variant);
  /// Writes a case, with `edits` applied to a copy, to a folder; ends in saved(), failed() or cancelled(). `content` is
  /// LoadedCase::content if the case was loaded from this folder, else empty.
  void save(std::shared_ptr<const PatientCase> patient, const QString& folder, std::vector<CaseEdit> edits = {},
            const std::optional<std::string>& content = {});

 Q_SIGNALS:
  void loaded(const insonate::ui::LoadedCase& loaded);
  void saved(const insonate::ui::SavedCase& written);
  void failed(const QString& what, const QString& advice, const QString& details);
  void cancelled();

 private:
  void readFolder(const QString& folder);
  void list(const QString& path);
  void choose(const QString& path, std::shared_ptr<const SeriesListing> listing);
  void import(const QString& path, const ImportChoice& choice);
  void refuse(const Error& error, const QString& advice);

  TaskBar& tasks_;
  QWidget* dialogParent_;
  QPointer<SeriesDialog> dialog_;
};

/// Blocks until generated built-in necks are written to the cache.
void waitForBuiltInCache();

/// Returns the case folder for a path: the folder itself or, for one of its files, the folder that contains it. Empty
/// if the path leads to no case.
QString caseFolderOf(const QString& path);

}  // namespace insonate::ui
