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
  QString versionOf{};    ///< folder of the case of which this is an earlier or published version; else empty
                          ///< (CaseOrigin::versionOf)
  QString readFrom{};     ///< folder from which the case was read (CaseOrigin::readFrom)
  std::string content{};  ///< CaseVersion::content when this program read or wrote the case
};

/// A case that was saved.
struct SavedCase {
  QString folder;
  std::shared_ptr<const PatientCase> patient;  ///< the saved case; the same object as before if there were no edits
  std::string content;                         ///< CaseVersion::content of the saved case
  /// true: another user has saved to this folder since the case was read. The case of that user is kept as an earlier
  /// version.
  bool overwroteOther = false;
};

/// Loads and saves cases on a background thread. Sources are case folders, DICOM, NRRD, NIfTI and MetaImage (if there
/// are several series, the user is asked), and the built-in necks. Only one case is loaded at a time: a later call
/// cancels the earlier one. Each call of open() or openBuiltIn() ends with exactly one of loaded(), failed() and
/// cancelled().
class CaseLoader : public QObject {
  Q_OBJECT

 public:
  /// `dialogParent` is the window; it also owns the task bar.
  CaseLoader(TaskBar& tasks, QWidget* dialogParent);
  ~CaseLoader() override;

  /// Opens a folder or a file of any supported kind.
  void open(const QString& path);
  /// Opens a built-in neck (cases/Phantom.h). The neck is generated at the first call and stored in the user's cache,
  /// from which later calls read it.
  void openBuiltIn(const QString& variant);
  /// Applies `edits` to a copy of a case and writes the copy to a folder. Ends with saved(), failed() or cancelled().
  /// `content`: LoadedCase::content if the case was loaded from this folder, else empty.
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

/// Waits until the generated built-in necks have been written to the cache.
void waitForBuiltInCache();

/// Returns the case folder to which a path leads: the path itself, or the folder of the file. Empty if the path leads
/// to no case.
QString caseFolderOf(const QString& path);

}  // namespace insonate::ui
