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

/// A case that came into the window.
struct LoadedCase {
  std::shared_ptr<const PatientCase> patient;
  QString folder;     ///< where it is kept; empty for one that was imported and not saved yet
  QStringList notes;  ///< what was missing or changed on the way, one sentence each
  bool builtIn = false;
  QString versionOf{};    ///< as in CaseOrigin
  std::string content{};  ///< CaseVersion::content in its folder, as it was read or written here
};

/// A case that was written.
struct SavedCase {
  QString folder;
  std::shared_ptr<const PatientCase> patient;  ///< the same object as was given where there were no edits
  std::string content;                         ///< CaseVersion::content of it
  bool overAnother = false;  ///< another user had saved there meanwhile; theirs stays as an earlier version
};

/// Brings cases into the window without holding it: from a case folder, from DICOM, NRRD, NIfTI or MetaImage (asking
/// which series, where there is a choice), or the built-in neck. One at a time: what comes later cancels what came
/// before. Each open ends in exactly one of loaded(), failed() and cancelled().
class CaseLoader : public QObject {
  Q_OBJECT

 public:
  /// `dialogParent` is the window; the task bar belongs to it.
  CaseLoader(TaskBar& tasks, QWidget* dialogParent);
  ~CaseLoader() override;

  /// Opens a folder or a file of any kind.
  void open(const QString& path);
  /// A built-in neck (cases/Phantom.h). It is made once and kept in the user's cache, so that the next start is quick.
  void openBuiltIn(const QString& variant);
  /// Writes a case to a folder, a copy with these edits where there are any; ends in saved(), failed() or cancelled().
  /// `content` is LoadedCase's where the case is kept in this folder; none for another one.
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

/// Blocks while a built-in neck that was made is being written for the next start.
void waitForBuiltInCache();

/// The folder of the case that a path means: the folder itself or, for one of its files, the folder it lies in. Empty
/// when there is no case.
QString caseFolderOf(const QString& path);

}  // namespace insonate::ui
