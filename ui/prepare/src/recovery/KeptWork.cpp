#include "KeptWork.h"

#include <insonate/ui/Text.h>

#include <system_error>
#include <utility>

namespace insonate::prepare {
namespace fs = std::filesystem;
namespace {

/// Checks the work on the open case. Sums are computed only if they are needed.
class OpenCaseCheck {
 public:
  explicit OpenCaseCheck(const PatientCase& patient) : patient_(patient) {}

  bool hasSameCt(const UnsavedWork& work) { return sums().hasSameCt(work.sums); }
  bool wasChanged(const UnsavedWork& work) {
    if (!isUnchanged(work, patient_.manifest, patient_.colors)) return true;
    // Labels that were imported meanwhile are not those of the folder.
    return !work.hasAllLabels && sums().labels != work.sums.labels;
  }

 private:
  const CaseSums& sums() {
    if (!sums_) sums_ = sumsOf(patient_);
    return *sums_;
  }

  const PatientCase& patient_;
  std::optional<CaseSums> sums_;
};

/// The order in which work is offered: the open case first, then the latest.
bool precedes(const KeptWork& a, const KeptWork& b) {
  return std::pair(a.isHere, a.work.time_s) > std::pair(b.isHere, b.work.time_s);
}

QString setAside(KeptFolder& folder, const QString& why) {
  const fs::path aside = folder.setAside();
  return tr("%1 Nothing was changed. The file was set aside in %2.").arg(why, ui::qt(aside.string()));
}

}  // namespace

KeptWorkResult findKeptWork(const KeptWorkQuery& query) {
  KeptWorkResult result;
  OpenCaseCheck check(*query.patient);
  for (const fs::path& path : KeptFolder::foldersIn(query.root)) {
    KeptWork kept{KeptFolder::take(path), {}};
    if (!kept.folder) continue;
    std::error_code error;
    if (!fs::exists(kept.folder->workFile(), error)) {  // the program ended before it had written anything
      kept.folder->remove();
      continue;
    }
    auto work = readUnsavedWork(kept.folder->workFile());
    if (!work) {
      result.problems << setAside(*kept.folder, ui::qt(work.error().message));
      continue;
    }
    kept.work = std::move(*work);
    kept.isHere = !query.caseFolder.empty() && kept.work.folder == query.caseFolder;
    if (!kept.isHere && !query.alsoOthers) continue;
    if (kept.isHere && !check.hasSameCt(kept.work)) {
      result.problems << setAside(*kept.folder, tr("Unsaved work was kept for another case that was in the folder %1, "
                                                   "with another CT.")
                                                    .arg(ui::qt(query.caseFolder)));
      continue;
    }
    kept.wasChanged = kept.isHere && check.wasChanged(kept.work);
    if (!result.latest || precedes(kept, *result.latest)) result.latest = std::move(kept);
  }
  return result;
}

Result<KeptLabels> labelsOf(const UnsavedWork& work, const PatientCase& patient) {
  KeptLabels kept;
  if (!work.recipe.empty()) {
    auto recipe = readRecipe(work.recipe);
    if (!recipe) return tl::unexpected(recipe.error());
    kept.recipe = std::move(*recipe);
  }
  if (work.runs.empty()) return kept;
  auto labels = withUnsavedLabels(work, patient.labels);
  if (!labels) return tl::unexpected(labels.error());
  kept.change.box = boxOf(labels->geometry);
  const auto &before = patient.labels.voxels, &after = labels->voxels;
  for (std::size_t n = 0; n < after.size(); ++n) {
    if (before[n] == after[n]) continue;
    kept.change.labels.set(before[n]), kept.change.labels.set(after[n]);
    ++kept.change.voxels;
  }
  kept.labels = std::make_shared<const LabelMap>(std::move(*labels));
  return kept;
}

QString partsText(const UnsavedWork& work) {
  const UnsavedParts parts = partsOf(work);
  QStringList texts;
  if (work.strokes > 0) texts << (work.strokes == 1 ? tr("1 brush stroke") : tr("%1 brush strokes").arg(work.strokes));
  if (work.steps > 0) texts << (work.steps == 1 ? tr("1 labeling step") : tr("%1 labeling steps").arg(work.steps));
  if (work.hasAllLabels) texts << tr("imported labels");
  if (parts.labels && texts.isEmpty()) texts << tr("labels");
  if (parts.title) texts << tr("title");
  if (parts.places) texts << tr("places");
  if (parts.terms) texts << tr("names and states of structures");
  if (parts.colors) texts << tr("colors");
  if (parts.shown) texts << tr("visibility");
  if (work.folder.empty()) texts << tr("the CT, since the case was never saved");
  return texts.join(QStringLiteral(", "));
}

}  // namespace insonate::prepare
