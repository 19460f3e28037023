#pragma once

#include "KeptFolder.h"

#include <insonate/cases/UnsavedWork.h>
#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/Recipe.h>

#include <QStringList>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace insonate::prepare {

/// Unsaved work of a program that has ended without saving it.
struct KeptWork {
  std::shared_ptr<KeptFolder> folder;
  UnsavedWork work;
  bool isHere = false;      ///< belongs to the open case
  bool wasChanged = false;  ///< the open case was saved again since the work was kept
};

/// Case for which kept work is searched.
struct KeptWorkQuery {
  std::filesystem::path root;  ///< folder of UnsavedKeeper::keepIn()
  std::string caseFolder;      ///< folder of the open case (folderOf()); empty for none
  std::shared_ptr<const PatientCase> patient;
  bool alsoOthers = false;  ///< also finds work on cases that are not open
};

struct KeptWorkResult {
  std::optional<KeptWork> latest;  ///< the latest work on the open case; without any, the latest work on another case
  QStringList problems;            ///< sentences about work that cannot be restored and was set aside
};

/// Finds kept work that no program uses. Takes some tenths of a second if there is work on the open case.
KeptWorkResult findKeptWork(const KeptWorkQuery& query);

/// Labels and steps of kept work, ready for LabelSession::restore().
struct KeptLabels {
  std::shared_ptr<const LabelMap> labels;  ///< null if the work does not change labels
  LabelChange change;
  Recipe recipe;
};
Result<KeptLabels> labelsOf(const UnsavedWork& work, const PatientCase& patient);

/// Returns the parts that the work changes, for a sentence: "3 brush strokes, places".
QString partsText(const UnsavedWork& work);

}  // namespace insonate::prepare
